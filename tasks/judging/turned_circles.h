// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/step_deviations.h"

namespace cradle {

/// Whether only what looks too far ahead for walls changes the velocities of fast circles far from
/// them: that is no fault of the motion.
[[nodiscard]] bool isTurnedAhead(const MeasuredLaws &laws, const Ground &ground,
                                 const StepDeviations &deviations);

/// Whether the one thing that is wrong with the motion is that a wall turns a circle in the first
/// step of the own scene, far from where it should: that is no fault of the motion.
[[nodiscard]] bool isTurnedFar(const MeasuredLaws &laws, const Ground &ground,
                               const StepDeviations &deviations);

/// Whether a wall is known that changes the velocity of that circle: the own scene shows one only.
[[nodiscard]] bool isTurnedByAWall(int circle, const MeasuredLaws &laws);

/// Whether a hit that is thrown changes it.
[[nodiscard]] bool isPushed(int circle, const MeasuredLaws &laws);

} // namespace cradle
