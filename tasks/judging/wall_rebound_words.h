// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/wall_comparison.h"

namespace cradle {

/// What is said of hits at walls, with %who and %walls.
struct ReboundWords {
    QString headline;
    QString why;
    bool isLaw = true;    ///< one for all of them, not what differs from hit to hit
    bool isOfAll = true;  ///< of those that came out right at the same walls, too
    bool isRange = false; ///< it tells between which two values all of them are
};

/// How the velocities of hits at walls go with e.
class WallRebounds : protected WallComparison
{
protected:
    explicit WallRebounds(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    /// Whether the ratio \p part is \p law of the restitution in all hits by those circles and at
    /// those walls of which some are at \p odd.
    template <class Part, class Law>
    bool follows(const std::vector<std::size_t> &odd, Part part, Law law) const
    {
        return std::all_of(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
            const bool isMeant = std::any_of(odd.begin(), odd.end(), [&](std::size_t i) {
                return m_own.hits[i].circle == hit.circle && m_own.hits[i].wall == hit.wall;
            });
            return !isMeant || hit.isLeap() || !(hit.turned || hit.held)
                   || isNear(part(hit), law(hit.restitution));
        });
    }
};

/// What walls make of the velocities in hits that come out wrong.
/// \param odd    these hits, by their numbers in \p walls; not empty
/// \param shown  the one of them that is quoted
[[nodiscard]] ReboundWords reboundWords(const WallComparison &walls,
                                        const std::vector<std::size_t> &odd, std::size_t shown);
/// The same, where the part along the wall comes out right.
[[nodiscard]] ReboundWords backWords(const WallComparison &walls,
                                     const std::vector<std::size_t> &odd, std::size_t shown);
/// That the part along a wall counts in what comes back of that into it.
[[nodiscard]] std::optional<ReboundWords> slantWords(const WallComparison &walls,
                                                     const std::vector<std::size_t> &odd);
/// That the same speed is missing after every hit, or is too much, however fast it came.
[[nodiscard]] std::optional<ReboundWords> fixedLossWords(const WallComparison &walls,
                                                         const std::vector<std::size_t> &odd);

} // namespace cradle
