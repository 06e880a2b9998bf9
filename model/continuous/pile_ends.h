// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/pile_motion.h"

namespace cradle {

/// Where the circles of a pile are at the end of a step.
struct PileEnds {
    std::vector<Vec2> places; ///< m
    std::vector<char> pushed; ///< of each body: does not fly freely
};

/// Moves the circles: those that are pushed evenly at w, the others as their integrators have it,
/// if they then meet nothing that moves otherwise.
[[nodiscard]] PileEnds fly(const Pile &pile, const PileMotion &motion);

/// Parts what overlaps at the end because its push was not found exactly, as far as the step has
/// taken the energy for it.
void partOverlaps(const Pile &pile, const PileMotion &motion, PileEnds &ends);

/// What those that are pushed have gained of energy if they end at \p velocities (m/s), J; what the
/// others gain is their integrator's.
[[nodiscard]] double gained(const Pile &pile, const PileEnds &ends,
                            std::span<const Vec2> velocities);

} // namespace cradle
