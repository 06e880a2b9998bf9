// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/lab/lab.h"
#include "tasks/runs/submission.h"

#include <optional>

namespace cradle {

/// In what a submission starts otherwise than the checks of \p task ask: the values of circles
/// that failed, gravity and restitution of the own scene.
/// \param checks  what became of the checks
[[nodiscard]] std::vector<LawDeviation> startDeviations(const Task &task,
                                                        const Submission &submission,
                                                        const std::vector<CheckOutcome> &checks);

/// That its own scene has another e than a failed check asks for, or one with which the solution
/// fails a check: proven by running that.
[[nodiscard]] std::optional<LawDeviation> otherRestitution(const Task &task,
                                                           const Submission &submission,
                                                           const std::vector<CheckOutcome> &checks);

} // namespace cradle
