// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/lab/lab.h"
#include "tasks/runs/submission_runs.h"

namespace cradle {

/// What is wrong with a submission that failed \p checks, in the order in which a teacher would
/// take it. The laws that it follows are measured in scenes of their own, aspect by aspect, each
/// by the laws measured before it, and compared with those of the step's reference where a failed
/// check asks for them. A mistake of this step or an earlier one that follows the same law gives
/// the words, else they are made from what was measured.
/// \param runs         of the submission, of which those for the checks were made already
/// \param provesLines  whether lines at fault are proven; see JudgeHooks
/// \return nothing where the step has no reference program, or nothing was found
[[nodiscard]] std::vector<Finding> findingsOf(const Task &task, SubmissionRuns &runs,
                                              const std::vector<CheckOutcome> &checks,
                                              bool provesLines);

} // namespace cradle
