// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/wall_comparison.h"
#include "tasks/judging/wall_lengths.h"

#include <optional>
#include <set>
#include <vector>

namespace cradle {

/// Where the walls of a program turn circles.
class WallReach : protected WallComparison
{
protected:
    explicit WallReach(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    /// Where a wall turns the centre of a circle, however large this is.
    struct Distance {
        std::set<double> radii; ///< tried, m; two at least
        double nearest = 0.0;   ///< to the wall, m
        double farthest = 0.0;  ///< m
    };

    /// Whether a wall answers a circle elsewhere than at its rim. One that is put far off and keeps
    /// its velocity has not been turned.
    [[nodiscard]] static bool isElsewhere(const WallHit &hit);
    /// In place of \p hit, one that shows where the wall turns circles: who is turned before it
    /// has flown a step does not.
    [[nodiscard]] const WallHit &tellingOf(const WallHit &hit) const;
    /// Whether a circle is turned before it has flown a step, and by secondsAhead().
    [[nodiscard]] bool looksAhead(int circle) const;
    /// The hits from far off by which a circle turns where its velocity, without the timestep,
    /// takes its rim to the wall; empty if one of them does not, or there are fewer than two.
    [[nodiscard]] std::vector<const WallHit *> secondsAhead(int circle) const;
    /// How many hits of these circles do not come where their rims are.
    [[nodiscard]] int shownBy(const std::vector<int> &circles) const;
    /// The walls at which a circle turns elsewhere than at its rim.
    [[nodiscard]] std::set<Wall> wrongWalls(int circle) const;
    /// The walls at which a circle turns elsewhere: together where one length is known by which it
    /// does at all of them, or none of any; else wall by wall.
    [[nodiscard]] std::vector<std::set<Wall>> wallsOfOneLength(int circle) const;
    /// All lengths by which a circle may turn at these walls.
    [[nodiscard]] std::vector<WallLength> fittingLengths(int circle,
                                                         const std::set<Wall> &walls) const;
    /// The one distance at which its centre may be turned with every radius; empty if none is.
    [[nodiscard]] std::optional<Distance> oneDistance(int circle,
                                                      const std::set<Wall> &walls) const;

private:
    /// Whether a circle may turn there at these walls.
    [[nodiscard]] bool fitsAll(const WallLength &reach, int circle,
                               const std::set<Wall> &walls) const;
};

} // namespace cradle
