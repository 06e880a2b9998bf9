// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/student_result.h"
#include "tasks/lab/lab.h"

namespace cradle {

/// Appends to a student's page what \p report says of \p step: where the program stopped, what was
/// found with the line and the moment, remarks, and the checks where not all pass.
void writeReport(QString &html, const Task &task, const StepResult &step,
                 const CheckReport &report);

} // namespace cradle
