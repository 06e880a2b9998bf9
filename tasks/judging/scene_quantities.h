// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/world.h"

#include <QString>

namespace cradle {

/// Which quantities are right.
enum class Known {
    Any,
    Squared, ///< also the square of a distance
    Normal,  ///< normals, and what is across them
    Reduced, ///< of masses not their sum
    Push,    ///< not what has a mass too few
};

/// A function in Lua, `known(a, b, v)`, to stand before a program: it stops the run where v, in one
/// step, is none of the quantities of the scene that a right program works out, nor what a function
/// of the vectors or numbers a and b makes of these alone. The quantities are ways, normals, parts
/// of velocities, masses, pushes and what they make of the circles, also for circles that are only
/// written down at the end of a step.
/// \param step  from 0
/// \param timestep  s
/// \param before  the circles before that step
/// \param isStrict  whether 0 is none: much is so by chance
[[nodiscard]] QString knownQuantities(Known known, qint64 step, double timestep,
                                      const World &before, bool isStrict);

} // namespace cradle
