// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/lab_at_hand.h"

#include "tasks/grading/judging_request.h"
#include "tasks/grading/lockdown.h"
#include "tasks/grading/server_process.h"

namespace cradle::cli {

/// A verdict, and what kept its program from anything else.
struct JudgedApart {
    CheckReport report{};
    Isolation isolation{};
};

/// Judges the one step that \p request names in a worker, see Workers.
/// \param requireIsolation  refuse to do with less than all isolation that there is
/// \return an error if there is no verdict, which is no fault of the program
/// Begins the process in which judgeApart() judges; it takes as long to start as a lab to read.
[[nodiscard]] ServerProcess beginApart(const QString &language);

Result<JudgedApart> judgeApart(const LabAtHand &lab, const JudgingRequest &request,
                               bool requireIsolation, ServerProcess begun);

/// The bytes of a program's file, or of standard input ("-"); of one that is too long no more than
/// shows that.
Result<QByteArray> readProgramBytes(const QString &path);

} // namespace cradle::cli
