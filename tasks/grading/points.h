// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/student_result.h"
#include "tasks/lab/lab.h"

namespace cradle {

/// What lateness costs. Days that have begun count whole.
struct LateRule {
    double percentPerDay = 0.0; ///< of the points that were earned, 0 to 100
    double mostPercent = 100.0; ///< never more is taken

    friend bool operator==(const LateRule &, const LateRule &) = default;
};

/// Points and what of them could be had.
struct Points {
    std::optional<double> earned{}; ///< nothing if there is no verdict
    double most = 0.0;
};

/// What a step can bring: what the lab says it is worth, else the points of its checks and
/// questions; of those that the teacher reads none, which the teacher gives.
[[nodiscard]] double mostPoints(const Task &task);

/// What a point of a check counts in the class, where the lab says what the step is worth.
[[nodiscard]] double pointScale(const Task &task);

/// What the check or question with that id is worth, before pointScale(); 0 if the step has none
/// or the teacher gives its points.
[[nodiscard]] double pointsInside(const Task &task, const QString &id);

/// What a step brought: the points of the checks that passed; nothing handed in, no points.
[[nodiscard]] Points pointsOf(const StepResult &step, const Task &task);

/// What all steps brought, less what lateness costs. Nothing is earned before every step that was
/// handed in has a verdict: a sum without them would be untrue.
[[nodiscard]] Points pointsOf(const StudentResult &student, const Lab &lab,
                              const LateRule &rule = {});

/// The part of the points that stays, 0 to 1.
[[nodiscard]] double keptWhenLate(double lateDays, const LateRule &rule);

/// Points to the hundredth, halves up, as every gradebook has them: "3", "2.5", "0.33".
[[nodiscard]] double roundedPoints(double points);
[[nodiscard]] QString pointsText(double points);

/// "passed", "failed", "missing" and "not_graded".
[[nodiscard]] QString statusName(StepResult::Status status);
[[nodiscard]] std::optional<StepResult::Status> statusFromName(const QString &name);

/// The student's result of a step; one that is missing if there is none.
[[nodiscard]] const StepResult &resultOf(const StudentResult &student, const Task &task);

} // namespace cradle
