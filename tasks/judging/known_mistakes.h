// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/measured_laws.h"
#include "tasks/submission.h"

namespace cradle {

/// What a student's program does otherwise, to be found among the mistakes of the lab.
struct MistakeQuery {
    const Lab &lab;
    const Task &task;
    const Ground &ground; ///< with the step's own preset, in which mistakes are measured
    const Submission &submission;
    const MeasuredLaws &own;
    const MeasuredLaws &right;
    Aspect aspect;
    const std::vector<LawDeviation> &deviations; ///< of that aspect
};

/// Whether two programs follow the same law in \p aspect, where \p ground asks for it.
[[nodiscard]] bool isLike(const MeasuredLaws &a, const MeasuredLaws &b, Aspect aspect,
                          const Ground &ground);

/// The mistake of the step, or else of an earlier one, that follows the student's law in that
/// aspect and the reference's in all aspects before it; null if there is none.
[[nodiscard]] const KnownScript *knownMistake(const MistakeQuery &query);

} // namespace cradle
