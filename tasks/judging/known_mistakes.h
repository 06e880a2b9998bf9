// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/task_laws.h"
#include "tasks/runs/submission.h"

namespace cradle {

/// What a student's program does otherwise, to be found among the mistakes of the lab.
struct MistakeQuery {
    const Task &task;
    const TaskLaws &known; ///< of that step
    const Submission &submission;
    const MeasuredLaws &own;
    Aspect aspect;
    const std::vector<LawDeviation> &deviations; ///< of that aspect
};

/// Whether two programs follow the same law in \p aspect, where \p ground asks for it.
[[nodiscard]] bool isLike(const MeasuredLaws &a, const MeasuredLaws &b, Aspect aspect,
                          const Ground &ground);

/// The mistake of the step, by its index, that follows the student's law in that aspect and the
/// reference's in all aspects before it; nothing if there is none.
[[nodiscard]] std::optional<std::size_t> knownMistake(const MistakeQuery &query);

} // namespace cradle
