// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"

namespace cradle {

/// Letters in a line of a terminal.
inline constexpr int terminalColumns = 80;

/// The report as lines for a terminal of 80 columns: what stopped the program, all findings,
/// every check, remarks, the verdict.
/// \param program  the name of the program's file, for "FILE:LINE"
[[nodiscard]] QString describeReport(const CheckReport &report, const QString &program = {});

/// "syntax", "runtime", "time", "memory" or "machine"; and back.
[[nodiscard]] QString kindName(ProgramError::Kind kind);
[[nodiscard]] std::optional<ProgramError::Kind> kindFromName(const QString &name);

/// "FILE:LINE: message", with "lab.lua" for a program without a name.
[[nodiscard]] QString placedMessage(const ProgramError &error, const QString &program);

/// Whether a check has no verdict because the program stopped.
[[nodiscard]] bool wasStopped(const CheckReport &report, const CheckOutcome &check);

/// What a failed check found, where: its message (where the program stopped, with its place), the
/// scene if it is not the student's own, and the line of the program. One text for each.
[[nodiscard]] QStringList observationsOf(const CheckReport &report, const CheckOutcome &check,
                                         const QString &program);

/// The names of the known mistakes that the report names.
[[nodiscard]] QStringList mistakesOf(const CheckReport &report);

/// What explains the whole verdict: all findings, or what stopped the program; as plain text.
/// Empty if nothing does.
[[nodiscard]] QString explanationOf(const CheckReport &report, const QString &program);

/// What the student reads of check \p index: the explanation where it is the first that failed,
/// then its findings. Empty if it passed.
[[nodiscard]] QString feedbackOn(const CheckReport &report, std::size_t index,
                                 const QString &program);

/// How many checks passed.
[[nodiscard]] int passedCount(const CheckReport &report);

/// Whether some of what was judged is an answer to a question.
[[nodiscard]] bool hasQuestions(const CheckReport &report);

/// Whether some check is worth something else than 1 point: then scores are told.
[[nodiscard]] bool isScored(const CheckReport &report);
/// The points of the checks that passed, and of all.
[[nodiscard]] double scoreOf(const CheckReport &report);
[[nodiscard]] double fullScoreOf(const CheckReport &report);

/// "L42T5 passed", or why not.
[[nodiscard]] QString verdictOf(const CheckReport &report);

} // namespace cradle
