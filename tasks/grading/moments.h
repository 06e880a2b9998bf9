// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/student_result.h"
#include "tasks/lab/lab.h"

namespace cradle {

/// No more moments of a step are kept.
inline constexpr std::size_t mostMoments = 3;

/// The moments at which what \p report found went wrong: of the checks in which findings show, in
/// the order of the findings, else of the first check that failed. Runs the program again in those
/// scenes, so it belongs where judgeTask() is called, and nowhere else; what draws the pictures
/// then runs nothing.
/// \param program  of the student; null where the laws of the scene were judged
[[nodiscard]] std::vector<StepMoment> momentsOf(const CheckReport &report, const Task &task,
                                                const QString *program);

} // namespace cradle
