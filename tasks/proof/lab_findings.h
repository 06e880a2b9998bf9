// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/proof/tolerance_margin.h"
#include "tasks/proof/verified_task.h"

namespace cradle {

/// Fills in the findings and warnings of \p verified, whose programs have been judged.
/// \param gaps  of the lab's texts, see textGaps()
void findProblems(const Lab &lab, const Task &task, const std::vector<Error> &gaps,
                  VerifiedTask &verified);

/// That a check stopped with an error of its own on \p program; nullopt if none did.
[[nodiscard]] std::optional<LabFinding>
stoppedCheck(const Task &task, const VerifiedProgram &program, const CheckReport &report);

/// The finding about a tolerance that the solution nearly uses up.
[[nodiscard]] LabFinding tooTight(const Task &task, const CheckSpec &check,
                                  const TightTolerance &tight);

} // namespace cradle
