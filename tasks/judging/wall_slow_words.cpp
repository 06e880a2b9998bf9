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

    [[nodiscard]] std::optional<LawDeviation> answer() const
    {
        const auto open = slowHits([](const WallHit &hit, const WallHit &) { return !hit.turned; });
        if (!open.empty())
            return openAt(open);
        const auto odd = slowHits([&](const WallHit &hit, const WallHit &right) {
            return hit.turned && !isRightFall(hit) && std::abs(hit.back - right.back) > slowBlur;
        });
        return odd.empty() ? std::nullopt : std::optional(oddAt(odd));
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

    [[nodiscard]] std::set<Wall> wallsOf(const std::vector<std::size_t> &slow) const
    {
        std::set<Wall> walls;
        for (const std::size_t i : slow)
            walls.insert(m_own.slow[i].wall);
        return walls;
    }

    static QString speedInto(const WallHit &h)
    {
        return brief(dot(outwardNormal(h.wall),
                         h.stage.preset.circles[static_cast<std::size_t>(h.circle)].body.velocity));
    }

    [[nodiscard]] LawDeviation openAt(const std::vector<std::size_t> &open) const
    {
        WallHit hit = m_own.slow[open.front()];
        hit.step = m_right.slow[open.front()].step;
        return deviation(
            WallText::tr("Slow hits at the %walls leave %who moving outward"),
            WallText::tr("Circle %1 came to the %2 with %3 m/s and went on past it; with "
                         "%4 m/s it is turned round. How fast it comes does not matter: "
                         "what counts is whether its rim is past the wall, and which way "
                         "it moves.")
                .arg(QString::number(hit.circle + 1), motion::wallName(hit.wall), speedInto(hit),
                     speedInto(m_own.hits.front())),
            hit, {circlesOf(open), wallsOf(open)}, Suspect::Question);
    }

    /// That the floor was not tried so slowly as the walls of \p odd, if it is none of them; begins
    /// with a blank.
    [[nodiscard]] QString floorTold(const std::vector<std::size_t> &odd) const
    {
        const auto into = [](const WallHit &hit) {
            return dot(
                outwardNormal(hit.wall),
                hit.stage.preset.circles[static_cast<std::size_t>(hit.circle)].body.velocity);
        };
        if (wallsOf(odd).contains(Wall::Bottom) || !allOfThem().contains(Wall::Bottom))
            return {};
        double slowest = std::numeric_limits<double>::infinity();
        for (const WallHit &hit : m_own.slow) {
            if (hit.wall == Wall::Bottom)
                slowest = std::min(slowest, into(hit));
        }
        if (!std::isfinite(slowest) || slowest < 1.1 * into(m_own.slow[odd.front()]))
            return {};
        return QLatin1Char(' ')
               + WallText::tr("At the floor, none slower than %1 m/s was tried.")
                     .arg(brief(slowest));
    }

    [[nodiscard]] LawDeviation oddAt(const std::vector<std::size_t> &odd) const
    {
        const WallHit &hit = m_own.slow[odd.front()];
        return deviation(
            WallText::tr("Slow hits at the %walls give %who another share of the speed back"),
            withE(hit)
                + WallText::tr("Circle %1 came to the %2 with %3 m/s and left it with %4 times "
                               "that speed; %5 times is right, however slow it is.")
                      .arg(QString::number(hit.circle + 1), motion::wallName(hit.wall),
                           brief(dot(outwardNormal(hit.wall), hit.came)), brief(hit.back),
                           brief(m_right.slow[odd.front()].back))
                + floorTold(odd),
            hit, {circlesOf(odd), wallsOf(odd)}, Suspect::Formula);
    }
};

} // namespace

std::optional<LawDeviation> slowEarlyDeviation(const WallComparison &walls)
{
    return SlowJudge(walls).early();
}

std::optional<LawDeviation> slowAnswerDeviation(const WallComparison &walls)
{
    return SlowJudge(walls).answer();
}

} // namespace cradle
