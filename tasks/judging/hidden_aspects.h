// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/condition_words.h"
#include "tasks/judging/step_deviations.h"

namespace cradle {

/// What a motion that is wrong hides of the aspects that come after it.

/// Whether hits cannot be seen through what is wrong with the motion.
[[nodiscard]] bool hidesHits(const ConditionedAspect &motion);

/// Whether what is shot at walls does not show what they do.
[[nodiscard]] bool hidesWalls(const ConditionedAspect &motion);

/// Whether the circles do not fly as asked; another integrator moves them almost alike.
[[nodiscard]] bool isMotionWrong(const ConditionedAspect &motion);

/// That nothing is known of walls or hits yet; empty if all that is asked for is seen.
[[nodiscard]] QString unseenText(const ConditionedAspect &motion, const MeasuredLaws &own,
                                 const MeasuredLaws &right, const Ground &ground,
                                 const StepDeviations &deviations);

} // namespace cradle
