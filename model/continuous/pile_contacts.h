// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cradle {

/// A contact of two bodies of a pile.
struct PileContact {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    Vec2 normal{};      ///< unit vector from a to b
    double limit = 0.0; ///< the closing speed that is allowed, m/s
    double push = 0.0;  ///< found: impulse along the normal, on b, N s, ≥ 0; before: a guess
};

/// What the pushes move. Walls are a body, too, with the inverse mass 0.
struct PileBodies {
    std::vector<Vec2> velocities;      ///< m/s; without any push, then with all of them
    std::vector<double> inverseMasses; ///< 1/kg
};

/// Finds the pushes J of thousands of contacts, each on its bodies' velocities,
///     J ≥ 0,   limit − closing speed ≥ 0,   J·(limit − closing speed) = 0,
/// until no sweep over them changes a closing speed by more than \p tolerance (m/s), or after
/// \p mostSweeps. Sweeps go through the contacts in their order and back: where that is the order
/// of height, one carries the weight of a pile down to the floor. Between them steps along
/// conjugate directions. What remains of a wrong push does no work: all are scaled so that
/// J·(limit − closing speed) vanishes, so a rest of the error cannot give energy.
/// \return how many sweeps it took
/// Source: Silcowitz-Hansen, Niebe, Erleben: A nonsmooth nonlinear conjugate gradient method for
/// interactive contact force problems. Vis. Comput. 26 (2010) 893.
int solvePile(std::span<PileContact> contacts, PileBodies &bodies, double tolerance,
              int mostSweeps);

} // namespace cradle
