// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/run_pictures.h"
#include "tasks/lab_report/set_formulas.h"
#include "tasks/text/line_diff.h"
#include "tasks/work/student_work.h"

#include <QDateTime>

#include <atomic>
#include <functional>

namespace cradle {

/// What became of a step, judged anew.
enum class StepVerdict { NotDone, Passed, NotPassed, Stopped };

/// The name of a verdict in a manifest: "passed", "not passed", "stopped", "not done".
[[nodiscard]] QString nameOf(StepVerdict verdict);

/// What is told about one step.
struct StepReport {
    /// Something that was found wrong on the way.
    struct Met {
        QString headline{};
        int times = 0;

        friend bool operator==(const Met &, const Met &) = default;
    };

    QString id{};
    QString title{};
    QString asked{}; ///< what was asked, in a sentence; plain text
    StepVerdict verdict = StepVerdict::NotDone;
    QString explanation{}; ///< why it did not pass; plain text
    bool byProgram = false;
    std::vector<DiffHunk> change{}; ///< of the program, against that of the step before
    QString moment{};               ///< what the picture shows
    QByteArray scene{};             ///< SVG; empty: nothing to be seen
    QByteArray momentum{};          ///< SVG
    QByteArray energy{};            ///< SVG
    QString question{};             ///< of the prediction; Markdown; empty: there is none
    QString expected{};             ///< what the student answered; empty: nothing
    QString right{};                ///< what comes true; plain text
    bool wasRight = false;
    int attempts = 0; ///< checks that the history knows
    std::vector<Met> met{};
    QString note{}; ///< Markdown
};

/// What is told about all the work in a lab.
struct LabReport {
    QString labTitle{};
    QString labVersion{};
    QString student{};
    QString studentId{};
    QDateTime when{};
    QString noteToTeacher{};
    std::vector<StepReport> steps{};
    QByteArray energies{};  ///< of all steps, SVG; empty if none has any
    SetFormulas formulas{}; ///< of what is Markdown; those that are not there become plain text

    [[nodiscard]] int passedCount() const;
};

/// A step with what its report needs for the whole.
struct ToldStep {
    StepReport report{};
    EnergyCurve curve{};
};

/// Judges step \p index of \p lab anew and tells it. Runs the student's program.
[[nodiscard]] ToldStep tellStep(const Lab &lab, const StudentWork &work, int index, qint64 seed);

/// Puts together what was told of all steps, in the lab's order.
[[nodiscard]] LabReport reportOf(const Lab &lab, const StudentWork &work, const QDateTime &when,
                                 std::vector<ToldStep> told);

/// Judges all steps of \p work anew and makes their report, on all cores.
/// \param progress   after every step, from any thread
/// \param cancelled  if it becomes true, the steps that are left are not told
[[nodiscard]] LabReport makeLabReport(const Lab &lab, const StudentWork &work, qint64 seed,
                                      const QDateTime &when,
                                      const std::function<void(int done, int total)> &progress = {},
                                      const std::atomic_bool *cancelled = nullptr);

/// The headline of a message: its first line, as plain text.
[[nodiscard]] QString headlineOf(const QString &message);

} // namespace cradle
