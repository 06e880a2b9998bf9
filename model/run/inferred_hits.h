// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/world.h"

#include <span>

namespace cradle {

/// The hits of one step of a program, which does not tell them, read from what it did: a pair
/// within reach of each other whose velocities changed by more than gravity's part, or a circle at
/// a wall whose part into the wall did. What walls explain wholly is no hit of two circles.
/// Normals are those of the line of centres before the step; time is that of the end of the step.
/// Appended to \p hits.
/// \param before  the circles at its start, \p after at its end (the same number)
/// \param dt      length of the step, s
/// \param step    its number, \p time its end, s
void inferHits(const Preset &scene, std::span<const Circle> before, std::span<const Circle> after,
               double dt, qint64 step, double time, std::vector<Hit> &hits);

} // namespace cradle
