// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/lab/lab.h"
#include "tasks/runs/submission_runs.h"

#include <functional>
#include <optional>

namespace cradle {

/// Of a check that the machine could not do in so many seconds.
[[nodiscard]] ProgramError stoppedByMachine(qint64 seconds);

/// How a judgement is watched and stopped; both may be left empty.
struct JudgeHooks {
    std::function<void(int done, int total)> progress{}; ///< after every scene
    std::function<bool()> cancelled{};                   ///< asked all the time
    /// Whether the line at fault is proven by mending it, which takes some tenths of a second; else
    /// it is the one that last changed what is wrong.
    bool provesLines = true;
};

/// Judges \p submission by all checks of \p task, in scenes drawn from \p seed, and says which
/// known mistake explains a failure. The result depends on nothing else: programs are stopped by
/// what they do, not by the clock, but for an error of the kind Machine, which is no verdict.
/// \return nullopt if it was cancelled
[[nodiscard]] std::optional<CheckReport> judgeTask(const Lab &lab, const Task &task,
                                                   const Submission &submission, qint64 seed,
                                                   const JudgeHooks &hooks = {});
/// The same of runs.submission(), with what has run already for other seeds.
[[nodiscard]] std::optional<CheckReport> judgeTask(const Lab &lab, const Task &task,
                                                   SubmissionRuns &runs, qint64 seed,
                                                   const JudgeHooks &hooks = {});

/// Work of the lab itself, to whose step's questions the right answers are given.
[[nodiscard]] Submission answered(const Task &task, Submission submission);

} // namespace cradle
