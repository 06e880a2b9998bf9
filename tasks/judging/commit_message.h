// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/runs/submission.h"

namespace cradle {

/// The commit message of \p task, with the integrator that the submission was seen to use.
[[nodiscard]] QString commitOf(const Task &task, const Submission &submission);

} // namespace cradle
