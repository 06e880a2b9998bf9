// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/lab/lab.h"
#include "tasks/runs/submission.h"

#include <optional>

namespace cradle {

/// That the walls of its own scene give another share of the speed back than e, where a failed
/// check of walls shows that scene: what is right in other scenes keeps an old value. \param checks
/// what became of the checks
[[nodiscard]] std::optional<LawDeviation> ownWallShare(const Task &task,
                                                       const Submission &submission,
                                                       const std::vector<CheckOutcome> &checks);

} // namespace cradle
