// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/pile_motion.h"
#include "model/world/world.h"

namespace cradle {

/// A step of a large pile under gravity, whose circles rebound slower than they meet: all its
/// contacts at once, for moment by moment each of them would cost as much as all.
///
///  1. Motion. Velocities w = v + g h + Σ J n / m, at which no contact closes faster than its gap
///     allows, 0 ≤ J ⊥ gap/h − (closing speed of w) ≥ 0. Pushed circles move evenly at w and so
///     cannot overlap, for discs are convex. That takes ½ m |w − v|² + Σ J gap/h of energy.
///  2. Rebound. Where contacts were met faster than gravity alone brings them together, the same
///     with −e times the speed at which they were met in place of gap/h gives the velocities
///     after the step; if their energy were more than there was, they are taken only that far.
///  3. Circles that nothing pushes fly on as their integrators have it.
///
/// A hit has the time at which the two would have met. Pushes are found to a share of a radius in
/// a step, from those of the step before; circles come to rest that much apart from each other.
/// Between steps only these pushes are kept.
/// Source: Moreau, Unilateral contact and dry friction in finite freedom dynamics, 1988.
class PileStep
{
public:
    /// Forgets the pushes of earlier steps.
    void clear() { m_pushes.clear(); }

    /// Moves \p world on by \p dt s; its time and step are those after the step. \p ids are the
    /// circles' names, by which their pushes are known in the next step. \p rules has their
    /// integrators.
    void run(const Rules &rules, World &world, std::span<const std::uint32_t> ids, double dt,
             std::vector<Hit> &hits);

    /// Pairs that pushed each other in the latest step.
    [[nodiscard]] const std::vector<std::pair<int, int>> &pushingPairs() const { return m_pairs; }

private:
    PilePushes m_pushes;
    PileMotion m_motion; ///< of the latest step: its lists need no new memory
    std::vector<std::pair<int, int>> m_pairs;
};

} // namespace cradle
