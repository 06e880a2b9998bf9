// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/grade_request.h"
#include "app/cli/lab_at_hand.h"

#include "tasks/grading/class_folder.h"

namespace cradle::cli {

/// Judges the class \p found into the folder of \p journal, going on where a run before was.
ExitCode gradeClass(const GradeRequest &request, const LabAtHand &lab, const ClassFolder &found,
                    ClassJournal &journal);

/// Tells how the folder was understood (--dry-run), and judges nothing.
ExitCode tellClass(const GradeRequest &request, const Lab &lab, const ClassFolder &found);

/// Puts the results of shards together (--merge).
ExitCode mergeClass(const GradeRequest &request);

} // namespace cradle::cli
