// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/lab/lab.h"
#include "tasks/runs/submission_runs.h"

#include <optional>

namespace cradle {

/// That walls of its own scene give another share of the speed back than e, where a failed check of
/// walls shows that scene. Where all give the same share, and other scenes are right, an old value
/// is kept.
/// \param runs    of the work; those that were made for the checks are looked at again
/// \param checks  what became of the checks
[[nodiscard]] std::optional<LawDeviation> ownWallShare(const Task &task, SubmissionRuns &runs,
                                                       const std::vector<CheckOutcome> &checks);

/// That a circle of the own scene turns round at the walls where the radius would bring it that it
/// had before the program set another, in all hits far from other circles, where a failed check of
/// walls shows that scene and other scenes are right.
[[nodiscard]] std::optional<LawDeviation> ownWallRadius(const Task &task, SubmissionRuns &runs,
                                                        const std::vector<CheckOutcome> &checks);

} // namespace cradle
