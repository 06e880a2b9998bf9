// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/lab/lab.h"
#include "tasks/runs/submission_runs.h"

#include <optional>

namespace cradle {

/// That circles 1 and 2 of its own scene never meet, where a failed check waits for their hit; they
/// fly and turn at walls as they should.
/// \param runs    of the work; those that were made for the checks are looked at again
/// \param checks  what became of the checks
/// \return nothing if they meet, or if something away from walls changes a velocity or a place
[[nodiscard]] std::optional<LawDeviation> missedMeeting(const Task &task, SubmissionRuns &runs,
                                                        const std::vector<CheckOutcome> &checks);

} // namespace cradle
