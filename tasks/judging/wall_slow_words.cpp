// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_comparison.h"

#include "tasks/checks/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cradle {

namespace {

/// Judges slow hits of circles that are turned round when they are fast.
class SlowJudge : WallComparison
{
public:
    explicit SlowJudge(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    [[nodiscard]] std::optional<LawDeviation> early() const
    {
        auto early = slowHits([](const WallHit &hit, const WallHit &right) {
            return hit.turned && hit.reached > hit.radius + 1e-9 && right.fits(right.radius);
        });
        if (!early.empty()) {
            const Wall wall = m_own.slow[early.front()].wall;
            std::erase_if(early, [&](std::size_t i) { return m_own.slow[i].wall != wall; });
        }
        return early.empty() ? std::nullopt
                             : std::optional(slowReachDeviation(*this, m_own.slow[early.front()],
                                                                circlesOf(early)));
    }

    [[nodiscard]] std::vector<LawDeviation> answer() const
    {
        std::vector<LawDeviation> found;
        const auto open = slowHits([](const WallHit &hit, const WallHit &) { return !hit.turned; });
        for (const Whose &each : groupsOf(open, m_own.slow))
            found.push_back(openAt(firstOf(open, each), each));
        if (!found.empty())
            return found;
        const auto odd = slowHits([&](const WallHit &hit, const WallHit &right) {
            return hit.turned && !isRightFall(hit) && std::abs(hit.back - right.back) > slowBlur;
        });
        for (const Whose &each : groupsOf(odd, m_own.slow))
            found.push_back(oddAt(firstOf(odd, each), each));
        return found;
    }

private:
    /// Of the share that comes back, where what falls in the step of a slow hit counts most.
    static constexpr double slowBlur = 0.05;

    /// Whether that circle is turned at that wall when it is fast.
    [[nodiscard]] bool turnsFast(const WallHit &slow) const
    {
        return std::all_of(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &h) {
            return h.circle != slow.circle || h.wall != slow.wall || h.turned;
        });
    }

    /// The slow hits of which \p isOff is true, where the fast and the reference's are turned.
    template <class IsOff>
    [[nodiscard]] std::vector<std::size_t> slowHits(IsOff isOff) const
    {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < m_own.slow.size(); ++i) {
            const WallHit &hit = m_own.slow[i];
            if (!hit.missed && !hit.held && m_right.slow[i].turned && turnsFast(hit)
                && isOff(hit, m_right.slow[i]))
                found.push_back(i);
        }
        return found;
    }

    [[nodiscard]] std::vector<int> circlesOf(const std::vector<std::size_t> &slow) const
    {
        std::set<int> circles;
        for (const std::size_t i : slow)
            circles.insert(m_own.slow[i].circle);
        return {circles.begin(), circles.end()};
    }

    /// The first of these slow hits that is of the first of those circles.
    [[nodiscard]] std::size_t firstOf(const std::vector<std::size_t> &slow,
                                      const Whose &whose) const
    {
        return *std::find_if(slow.begin(), slow.end(), [&](std::size_t i) {
            return m_own.slow[i].circle == whose.circles.front();
        });
    }

    /// Of that circle at that wall, fast.
    [[nodiscard]] const WallHit &fastOf(const WallHit &slow) const
    {
        return *std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
            return hit.circle == slow.circle && hit.wall == slow.wall;
        });
    }

    static QString speedInto(const WallHit &h)
    {
        return brief(dot(outwardNormal(h.wall),
                         h.stage.preset.circles[static_cast<std::size_t>(h.circle)].body.velocity));
    }

    [[nodiscard]] LawDeviation openAt(std::size_t at, const Whose &whose) const
    {
        WallHit hit = m_own.slow[at];
        hit.step = m_right.slow[at].step;
        return deviation(
            WallText::tr("Slow hits at the %walls leave %who moving outward"),
            WallText::tr("Circle %1 came to the %2 with %3 m/s and went on past it; with "
                         "%4 m/s it is turned round. How fast it comes does not matter: "
                         "what counts is whether its rim is past the wall, and which way "
                         "it moves.")
                .arg(QString::number(hit.circle + 1), motion::wallName(hit.wall), speedInto(hit),
                     speedInto(fastOf(hit))),
            hit, whose, Suspect::Question);
    }

    /// That the floor was not tried as slowly as \p odd, if it is none of the \p walls; begins with
    /// a blank.
    [[nodiscard]] QString floorTold(const WallHit &odd, const std::set<Wall> &walls) const
    {
        const auto into = [](const WallHit &hit) {
            return dot(
                outwardNormal(hit.wall),
                hit.stage.preset.circles[static_cast<std::size_t>(hit.circle)].body.velocity);
        };
        if (walls.contains(Wall::Bottom) || !allOfThem().contains(Wall::Bottom))
            return {};
        double slowest = std::numeric_limits<double>::infinity();
        for (const WallHit &hit : m_own.slow) {
            if (hit.wall == Wall::Bottom)
                slowest = std::min(slowest, into(hit));
        }
        if (!std::isfinite(slowest) || slowest < 1.1 * into(odd))
            return {};
        return QLatin1Char(' ')
               + WallText::tr("At the floor, none slower than %1 m/s was tried.")
                     .arg(brief(slowest));
    }

    [[nodiscard]] LawDeviation oddAt(std::size_t at, const Whose &whose) const
    {
        const WallHit &hit = m_own.slow[at];
        return deviation(
            WallText::tr("Slow hits at the %walls give %who another share of the speed back"),
            withE(hit)
                + WallText::tr("Circle %1 came to the %2 with %3 m/s and left it with %4 times "
                               "that speed; %5 times is right, however slow it is.")
                      .arg(QString::number(hit.circle + 1), motion::wallName(hit.wall),
                           brief(dot(outwardNormal(hit.wall), hit.came)), brief(hit.back),
                           brief(m_right.slow[at].back))
                + floorTold(hit, whose.walls),
            hit, whose, Suspect::Formula);
    }
};

} // namespace

std::optional<LawDeviation> slowEarlyDeviation(const WallComparison &walls)
{
    return SlowJudge(walls).early();
}

std::vector<LawDeviation> slowAnswerDeviations(const WallComparison &walls)
{
    return SlowJudge(walls).answer();
}

} // namespace cradle
