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

/// Where all laws of a program are right: whether its checks fail by the e of its own scene alone.
/// It is proven by running them with that of the reference.
[[nodiscard]] std::optional<LawDeviation>
restitutionDeviation(const Task &task, const Submission &submission,
                     const std::vector<CheckOutcome> &checks);

/// The same beside other faults: that its own scene has another e than a failed check asks for.
[[nodiscard]] std::optional<LawDeviation> otherRestitution(const Task &task,
                                                           const Submission &submission,
                                                           const std::vector<CheckOutcome> &checks);

} // namespace cradle
