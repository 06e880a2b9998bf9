// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/proof/verified_task.h"

namespace cradle {

/// Judges the lab itself: every starter fails by a check, not by an error; every solution passes
/// with all seeds; every mistake fails and is diagnosed as itself, and has the values of the
/// solution; every remark passes and is recognised; every check is failed by a mistake; no
/// tolerance is nearly used up by the solution itself. Measures how wrong a run must just be for
/// each check. Warns of checks that add nothing: duplicates, and those without which every mistake
/// would still fail, with what they repeat. Where a step has a solution-preset.json, the laws of
/// that scene pass, too. Where values are drawn for each student, those of studentsTried() are
/// tried. Uses all processors.
/// \param only   the id of one step; empty for all
/// \param hooks  called from other threads, never two at once
/// \param seeds  with how many each solution must pass, at least 1
/// \return nothing if it was cancelled
[[nodiscard]] std::vector<VerifiedTask> verifyLab(const Lab &lab, const QString &only = {},
                                                  const JudgeHooks &hooks = {}, int seeds = 5);

/// The numbers of the students whose values verifyLab() tries: at least ten, and more, up to 24,
/// where those do not draw every value. Empty if the lab draws none.
[[nodiscard]] QStringList studentsTried(const Lab &lab);
} // namespace cradle
