// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/ground.h"

namespace cradle {

/// A circle whose velocity nothing changes in the student's own scene, though it comes to a wall
/// and to another circle there: one sentence for walls and hits. Its moment names the circle.
[[nodiscard]] std::optional<LawDeviation> unchangedVelocity(const QString *program,
                                                            const Ground &ground);

/// A circle that first moves as its velocity says, then against it for some steps, and whose
/// velocity is still that of the start: the program turns a velocity of its own. What walls and
/// hits make of the circle's velocity then says nothing of them.
/// \param isFlightRight  else a part of the way alone may be made by another circle's velocity, and
///                       what only one part shows is not told
[[nodiscard]] std::optional<LawDeviation>
unwrittenVelocity(const QString *program, const Ground &ground, bool isFlightRight);

} // namespace cradle
