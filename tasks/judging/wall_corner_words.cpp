// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"
#include "tasks/judging/wall_comparison.h"
#include "tasks/judging/wall_words.h"

namespace cradle {

namespace {

/// Judges what two walls that are hit at once make of a circle.
class CornerJudge : WallComparison
{
public:
    explicit CornerJudge(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    [[nodiscard]] std::optional<LawDeviation> judge() const
    {
        if (const auto found = shown(losesPart))
            return deviation(
                WallText::tr("In a corner only one part of the velocity of %who turns round"),
                WallText::tr("Circle %3 came with %1 m/s and left with %2 m/s. Both walls are hit "
                             "in the same step, and each must turn its own part, whichever comes "
                             "first.")
                    .arg(brief(found->hit.came), brief(found->hit.left))
                    .arg(found->hit.circle + 1),
                found->hit, {found->circles, {}});
        if (const auto found = shown(losesAll))
            return deviation(
                WallText::tr("In a corner the velocity of %who is lost"),
                WallText::tr("Circle %3 came with %1 m/s and has %2 m/s after it. Both walls are "
                             "hit in the same step, and each must turn its own part.")
                    .arg(brief(found->hit.came), brief(found->hit.left))
                    .arg(found->hit.circle + 1),
                found->hit, {found->circles, {}});
        return std::nullopt;
    }

    [[nodiscard]] std::optional<LawDeviation> late() const
    {
        if (const auto found = shown(turnsPartLate))
            return deviation(
                WallText::tr("In a corner one part of the velocity of %who turns round too late"),
                WallText::tr("Circle %1 came with %2 m/s and has %3 m/s after the step that "
                             "brought it into the corner, with its rim %4 m beyond the %5. Both "
                             "walls are hit in the same step, and each must turn its own part, "
                             "whichever comes first.")
                    .arg(QString::number(found->hit.circle + 1), brief(found->hit.came),
                         brief(found->hit.left), brief(found->hit.radius - found->hit.after),
                         motion::wallName(found->hit.wall)),
                found->hit, {found->circles, {}});
        return std::nullopt;
    }

private:
    /// One of the hits of which something is said, and whose they are.
    struct Shown {
        const WallHit &hit;
        std::vector<int> circles;
    };
    template <class Is>
    [[nodiscard]] std::optional<Shown> shown(Is is) const
    {
        std::set<int> circles;
        const WallHit *first = nullptr;
        for (std::size_t i = 0; i < m_own.corners.size(); ++i) {
            const WallHit &hit = m_own.corners[i];
            if (hit.missed || !hit.turned || !m_right.corners[i].turnsBoth
                || !is(hit, m_right.corners[i]))
                continue;
            circles.insert(hit.circle);
            first = first ? first : &hit;
        }
        return first ? std::optional(Shown{*first, {circles.begin(), circles.end()}})
                     : std::nullopt;
    }

    /// Whether it turns one part alone.
    static bool losesPart(const WallHit &hit, const WallHit &)
    {
        return !hit.turnsBoth && turnsOnePart(hit);
    }
    static bool losesAll(const WallHit &hit, const WallHit &)
    {
        return length(hit.left) <= 0.01 * length(hit.came);
    }
    /// Whether it leaves the part into its wall to a later step though its rim has been left beyond
    /// that wall, where that of the reference is not.
    static bool turnsPartLate(const WallHit &hit, const WallHit &right)
    {
        constexpr double slack = 1e-6; // m
        const Vec2 n = outwardNormal(hit.wall);
        const auto isBeyond = [&](const WallHit &each) {
            return dot(n, each.left) > 0.0 && each.after < each.radius - slack;
        };
        return hit.turnsBoth && turnsOnePart(hit) && isBeyond(hit) && !isBeyond(right);
    }

    /// Whether one part of the velocity was turned round, and the other goes on.
    static bool turnsOnePart(const WallHit &hit)
    {
        const bool x = hit.came.x * hit.left.x < 0.0;
        const bool y = hit.came.y * hit.left.y < 0.0;
        return (x && hit.came.y * hit.left.y > 0.0) || (y && hit.came.x * hit.left.x > 0.0);
    }
};

} // namespace

std::optional<LawDeviation> cornerDeviation(const WallComparison &walls)
{
    return CornerJudge(walls).judge();
}

std::optional<LawDeviation> lateInCorner(const MeasuredWalls &own, const MeasuredWalls &right,
                                         const Ground &ground)
{
    return CornerJudge({own, right, ground}).late();
}

} // namespace cradle
