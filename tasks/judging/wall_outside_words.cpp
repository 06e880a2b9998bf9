// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_comparison.h"

#include "tasks/checks/figures.h"

#include <algorithm>

namespace cradle {

namespace {

/// Judges how far beyond a wall hits leave circles that lose speed there.
class OutsideJudge : WallComparison
{
public:
    explicit OutsideJudge(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    [[nodiscard]] std::vector<LawDeviation> find() const
    {
        const auto all = whose([&](std::size_t i) {
            return isLeftOutside(m_own.hits[i]) && !isLeftOutside(rightOf(i));
        });
        std::vector<LawDeviation> found;
        for (const Whose &each : all) {
            const WallHit &hit =
                *std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &one) {
                    return one.circle == each.circles.front() && each.walls.contains(one.wall)
                           && isLeftOutside(one);
                });
            found.push_back(deviation(
                WallText::tr("Hits at the %walls leave %who outside"),
                withE(hit)
                    + WallText::tr(
                          "After the hit the rim of circle %1 is %2 m past the %3, and "
                          "its velocity takes it back by %4 m a step: slower than it came, "
                          "it is still outside after the next one. Put it where its rim "
                          "is at the wall, or back where it came from.")
                          .arg(QString::number(hit.circle + 1), brief(depthOf(hit)),
                               motion::wallName(hit.wall), brief(wayBackOf(hit))),
                hit, each, Suspect::Answer));
        }
        return found;
    }

private:
    /// How far its rim is beyond the wall after the answer, m.
    static double depthOf(const WallHit &hit) { return hit.radius - hit.after; }
    /// What a step takes it back then, m.
    static double wayBackOf(const WallHit &hit)
    {
        return std::max(0.0, -dot(outwardNormal(hit.wall), hit.left) * hit.stage.preset.timestep);
    }
    /// Whether it loses speed, so that a step like that in which it came does not bring it back.
    static bool isLeftOutside(const WallHit &hit)
    {
        constexpr double little = 0.02; // of the way that took it there: no more than a gap
        return hit.turned && !hit.isLeap() && hit.restitution < 1.0
               && depthOf(hit) > wayBackOf(hit) + little * std::abs(hit.travel);
    }
};

} // namespace

std::vector<LawDeviation> outsideDeviations(const WallComparison &walls)
{
    return OutsideJudge(walls).find();
}

} // namespace cradle
