// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/lab/lab.h"
#include "tasks/runs/submission_runs.h"

namespace cradle {

/// The remarks that fit work that passes: put into the student's own states, the remark's program
/// does what the student's does where the reference solution does something else.
/// \param runs  of the work; those that were made for the checks are looked at again
[[nodiscard]] std::vector<Remark> remarksOn(const Task &task, SubmissionRuns &runs, qint64 seed);

} // namespace cradle
