// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/student_result.h"
#include "tasks/lab/lab.h"

#include <QByteArray>

namespace cradle {

/// No result is larger; what is, is refused unread.
inline constexpr qint64 mostResultBytes = 32 * 1024 * 1024;

/// The result as students/ID.json (format 1): all that is needed to write pages and gradebooks
/// later, and nothing that varies from run to run. A step's report is that of
/// `cradle-cli check --format json` without its times; of the scenes of checks that failed, the
/// moments stay.
[[nodiscard]] QByteArray writeStudentResult(const StudentResult &result, const Lab &lab);

/// \p result with no text about the student longer than a result may hold: names and tables may
/// have any, and what cannot be read back would leave the class without its pages.
[[nodiscard]] StudentResult cutToFit(StudentResult result);

/// Reads it back without trust: whatever wrote it, what comes is a result whose texts and lists are
/// of bounded length and whose pictures can be drawn. The points in it are not read: they follow
/// from the checks. \param source  the file's name for messages
Result<StudentResult> readStudentResult(const QByteArray &text, const QString &source);

} // namespace cradle
