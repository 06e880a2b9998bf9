// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/student_result.h"
#include "tasks/work/student_work.h"
#include "tasks/workspace/git_objects.h"

#include <functional>
#include <optional>

namespace cradle {

/// What is to be judged: the work of one student, as it was handed in. Nothing of it was looked
/// into yet, and anybody may have written it. A plain value.
struct JudgingRequest {
    qint64 seed = 1;
    QStringList steps{};  ///< ids, in the order in which they are judged
    WorkFiles files{};    ///< of a workspace, by their paths in it
    QByteArray archive{}; ///< a .cradle-work file in the place of files; empty if there is none
    RepositoryFiles repository{}; ///< that came with files; empty if there is none
    /// Of the student by the roster; values are drawn by the first of them, unless the work has
    /// another of them. Empty: by that of the work, which anybody may have written.
    QStringList numbers{};
    bool moments = true; ///< whether StepResult::moments are wanted

    friend bool operator==(const JudgingRequest &, const JudgingRequest &) = default;
};

/// For the way to the process that judges.
[[nodiscard]] QByteArray bytesOf(const JudgingRequest &request);
/// \return nothing if \p bytes are no request
[[nodiscard]] std::optional<JudgingRequest> requestFrom(const QByteArray &bytes);

/// Of a student's number; the rest of a longer one is not looked at.
inline constexpr qsizetype mostNumberLetters = 100;

/// Processor time that one step may take, s; then there is no verdict on it.
inline constexpr qint64 secondsPerStep = 60;

/// Judges the work that was asked for step by step. Runs the student's programs: only for a process
/// that has nothing to lose. Where the work has no program for any step, lab.lua is judged for
/// every step.
/// \param begin  before each step
/// \param done   after each step, with its result
void judgeWork(const Lab &lab, const JudgingRequest &request, const std::function<void()> &begin,
               const std::function<void(const StepResult &)> &done);

/// The report on a program that cannot be read: it says so, and no check has passed.
[[nodiscard]] CheckReport unreadableReport(const Lab &lab, const Task &task, qint64 seed,
                                           const Error &fault);

/// Does what judging any student's \p task takes, for judgeWork() in this thread or in processes
/// that are forked from it; what they find does not depend on it.
void prepareJudging(const Task &task);

} // namespace cradle
