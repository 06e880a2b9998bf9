// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/measured_laws.h"

namespace cradle {

/// What is said of an aspect.
struct ConditionedAspect {
    std::vector<LawDeviation> deviations{};
    bool isOfPlace = false; ///< it counts where the circles are
};

/// What was \p found of an aspect in short runs, made true for long ones: what comes out right at
/// times is said to do so, and in place of what was seen at the start of a run alone.
/// \param shown  where a check failed
[[nodiscard]] ConditionedAspect conditioned(Aspect aspect, std::vector<LawDeviation> found,
                                            const MeasuredLaws &own, const MeasuredLaws &right,
                                            const Ground &ground, const Moment &shown);

} // namespace cradle
