// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_rebound_words.h"

#include "tasks/checks/figures.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Names what a wall adds to the part of a velocity along its normal, or takes from it.
class LossNamer : WallComparison
{
public:
    explicit LossNamer(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    [[nodiscard]] std::optional<ReboundWords> ofSlant(const std::vector<std::size_t> &odd) const
    {
        for (const std::size_t i : odd) {
            const WallHit &hit = m_own.hits[i];
            const auto other =
                std::find_if(m_own.slanted.begin(), m_own.slanted.end(),
                             [&](const WallHit &one) { return isOnlySlanted(one, hit); });
            if (other == m_own.slanted.end() || isNear(other->back, hit.back) || hangsOnSpeed(hit))
                continue;
            return ReboundWords{
                WallText::tr("At the %walls the part along the wall comes into the rebound of "
                             "%who"),
                WallText::tr("With %1 m/s into the wall and %2 m/s along it, %3 times the part "
                             "into it comes back; with %4 m/s along it %5 times. The part along a "
                             "wall should not count there.")
                        .arg(brief(partInto(hit)), brief(partAlong(hit)), brief(hit.back),
                             brief(partAlong(*other)), brief(other->back))
                    + QLatin1Char(' ')
                    + WallText::tr("Look at what the new velocity is worked out from."),
                true, false};
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<ReboundWords> ofAmount(const std::vector<std::size_t> &odd) const
    {
        const QString look =
            QLatin1Char(' ')
            + WallText::tr("A wall turns the speed round; no fixed amount is added "
                           "to it or taken from it.");
        if (const auto lost = amount(odd, rebounds()))
            return ReboundWords{headline(*lost),
                                (*lost > 0.0 ? WallText::tr("From every speed tried it leaves with "
                                                            "about %1 m/s too little.")
                                             : WallText::tr("From every speed tried it leaves with "
                                                            "about %1 m/s too much."))
                                        .arg(brief(std::abs(*lost)))
                                    + look,
                                true, false};
        const auto lost = rebounds() ? amount(odd, false) : std::nullopt;
        if (!lost)
            return std::nullopt;
        return ReboundWords{headline(*lost),
                            (*lost > 0.0
                                 ? WallText::tr("From every speed and with every e tried it "
                                                "leaves with about %1 m/s less than it came "
                                                "with.")
                                 : WallText::tr("From every speed and with every e tried it "
                                                "leaves with about %1 m/s more than it came "
                                                "with."))
                                    .arg(brief(std::abs(*lost)))
                                + look,
                            true, false};
    }

private:
    static QString headline(double lost)
    {
        return lost > 0.0
                   ? WallText::tr("Hits at the %walls take a fixed amount of speed from %who")
                   : WallText::tr("Hits at the %walls add a fixed amount of speed to %who");
    }

    /// How much is missing after all of them, and after others of another slant, m/s: of e times
    /// the speed, or of all of it; nothing where that differs, or is little, or they came with one
    /// speed.
    [[nodiscard]] std::optional<double> amount(const std::vector<std::size_t> &odd,
                                               bool isOfE) const
    {
        const WallHit &first = m_own.hits[odd.front()];
        const auto missing = [&](const WallHit &hit) {
            return ((isOfE ? hit.restitution : 1.0) - hit.back) * partInto(hit);
        };
        const double lost = missing(first);
        const auto isSo = [&](const WallHit &hit) {
            const double fall = hit.stage.preset.timestep * length(hit.stage.preset.gravity);
            const double slack = 1e-3 + 1.1 * fall;
            return hit.back >= 0.0 && std::abs(lost) >= 3.0 * slack
                   && std::abs(missing(hit) - lost) <= slack;
        };
        bool several = false;
        for (const std::size_t i : odd) {
            const WallHit &hit = m_own.hits[i];
            if (!isSo(hit))
                return std::nullopt;
            several |= std::abs(partInto(hit) / partInto(first) - 1.0) > 0.1;
            for (const WallHit &one : m_own.slanted) {
                if (isOnlySlanted(one, hit) && !isSo(one))
                    return std::nullopt;
            }
        }
        return several ? std::optional(lost) : std::nullopt;
    }

    static double partInto(const WallHit &hit) { return dot(hit.came, outwardNormal(hit.wall)); }
    static double partAlong(const WallHit &hit)
    {
        return std::abs(dot(hit.came, perpendicular(outwardNormal(hit.wall))));
    }

    static bool isOnlySlanted(const WallHit &one, const WallHit &hit)
    {
        return one.circle == hit.circle && one.wall == hit.wall && one.turned && hit.turned
               && one.restitution == hit.restitution && one.radius == hit.radius
               && std::abs(partInto(one) - partInto(hit)) < 1e-6 * partInto(hit)
               && partAlong(one) > 1.5 * partAlong(hit);
    }

    /// Whether a slower hit like it, of the same slant, gives another share: then both parts may
    /// count.
    [[nodiscard]] bool hangsOnSpeed(const WallHit &hit) const
    {
        return std::any_of(m_own.slower.begin(), m_own.slower.end(), [&](const WallHit &one) {
            return one.circle == hit.circle && one.wall == hit.wall && one.turned
                   && one.restitution == hit.restitution && !isNear(one.back, hit.back);
        });
    }
};

} // namespace

std::optional<ReboundWords> slantWords(const WallComparison &walls,
                                       const std::vector<std::size_t> &odd)
{
    return LossNamer(walls).ofSlant(odd);
}

std::optional<ReboundWords> fixedLossWords(const WallComparison &walls,
                                           const std::vector<std::size_t> &odd)
{
    return LossNamer(walls).ofAmount(odd);
}

} // namespace cradle
