// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/pile_ends.h"
#include "model/world/world.h"

namespace cradle {

/// How fast the circles of a pile are at the end of a step.
struct PileRebound {
    std::vector<Vec2> velocities; ///< of each circle, m/s
    std::vector<double> impulses; ///< of each contact, N s
};

/// The velocities after the step where contacts throw back what they met faster than gravity alone
/// brings two together (2 e u > g h): such contacts part at e u, all others do not close; and only
/// so far as there is energy for it, −gained(). \p ends learns whom the rebounds push.
[[nodiscard]] PileRebound findRebound(const Pile &pile, const PileMotion &motion, PileEnds &ends);

/// What was met in a step whose end has the time and number of \p world; each has the moment at
/// which the two would have met, and the speeds of that moment.
void reportHits(const Pile &pile, const PileMotion &motion, const PileRebound &rebound,
                const World &world, std::vector<Hit> &hits);

} // namespace cradle
