// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/check_report.h"
#include "tasks/lab.h"
#include "tasks/observation.h"
#include "tasks/submission.h"

namespace cradle {

/// A failed check with what the student's program did in its scenes.
struct FailedCheck {
    const CheckSpec *check = nullptr;
    std::vector<Variant> scenes{};   ///< as they were before the program ran
    std::vector<Observation> runs{}; ///< one for each; the first is where it failed
};

/// The known mistake that explains the failures best: on the steps where the reference solution,
/// put into the student's state, disagrees with the student, the mistake agrees with him; of
/// several that do, the one that agrees best on the other steps.
/// \return nullopt if none explains them
[[nodiscard]] std::optional<Finding> diagnose(const Task &task,
                                                const std::vector<FailedCheck> &failed);

/// The remarks that fit work that passes, recognised in the same way.
[[nodiscard]] std::vector<Remark> remarksOn(const Task &task, const Submission &submission,
                                            qint64 seed);

} // namespace cradle
