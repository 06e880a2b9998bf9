// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/proof/verified_task.h"

namespace cradle {

/// A program or scene of a step before it is judged.
struct Candidate {
    VerifiedProgram::Role role = VerifiedProgram::Role::Mistake;
    QString name;
    Submission submission{};
};

/// The programs and the scene that the step knows, with the right answers to its questions.
[[nodiscard]] std::vector<Candidate> candidatesOf(const Task &task);

/// One round of verifyLab(), which has the parameters: the lab as it stands, with one set of values
/// and in one language.
[[nodiscard]] std::vector<VerifiedTask> verifyOne(const Lab &lab, const QString &only,
                                                  const JudgeHooks &hooks, int seeds);

} // namespace cradle
