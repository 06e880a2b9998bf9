// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/proof/verified_task.h"

namespace cradle {

/// How wrong is just wrong enough for the check at \p index, see describe(); empty if that was not
/// measured.
[[nodiscard]] QString wrongEnough(const VerifiedTask &task, qsizetype index);

/// The matrix of mistakes and checks of a step, and its problems, for a terminal.
[[nodiscard]] QString describeVerified(const VerifiedTask &task);

/// What of each range studentsTried() draw, a line each: "k: 9 of 9 values, 0.4 to 1.2".
[[nodiscard]] QString describeTried(const Lab &lab);

} // namespace cradle
