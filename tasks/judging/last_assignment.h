// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/lab/check_report.h"
#include "tasks/lab/lab.h"
#include "tasks/runs/submission.h"

namespace cradle {

/// Marks in \p finding the assignment that last changed what is wrong at \p moment, and the calls
/// that led there; nothing where none did.
void markLastAssignment(Finding &finding, const Moment &moment, const Task &task,
                        const Submission &submission);

/// The line of the program that last changed how a circle moves in a step of a scene; the last that
/// set it, if none did; 0 without any.
/// \param step    from 1; 0 is no step
/// \param circle  from 0; any if it is negative
[[nodiscard]] int lastAssignmentLine(const Submission &submission, const Stage &scene, qint64 step,
                                     int circle);

} // namespace cradle
