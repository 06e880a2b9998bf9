// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/platform_names.h"
#include "tasks/lab/check_report.h"
#include "tasks/lab_report/drawn_moment.h"

#include <QString>

#include <optional>
#include <vector>

namespace cradle {

/// The scene at the moment when a check first went wrong.
struct StepMoment {
    QString check{}; ///< its id
    DrawnMoment scene{};

    friend bool operator==(const StepMoment &, const StepMoment &) = default;
};

/// What became of one step of one student.
struct StepResult {
    enum class Status {
        Passed,
        Failed,    ///< judged, or not to be read as a program at all: \c report says which
        Missing,   ///< nothing was handed in
        NotGraded, ///< no verdict could be reached, for which the student is not to blame
    };

    QString taskId;
    Status status = Status::Missing;
    QString reason{};                    ///< why it was not graded
    std::optional<CheckReport> report{}; ///< if it was judged
    std::vector<StepMoment> moments{};   ///< when it went wrong, see momentsOf()
    QString program{};                   ///< its text, where it could be read
    int attempts = 0;                    ///< checks in the history that was handed in; 0: none told
    double minutes = 0.0;                ///< of work on it that the history shows
    QString drawnBy{};   ///< the number by which values were drawn, where the lab draws any
    QString ownNumber{}; ///< that stands in what was handed in, in such a lab

    /// Whether what was handed in has a number that is not the student's by the roster.
    [[nodiscard]] bool hasForeignNumber() const;

    friend bool operator==(const StepResult &, const StepResult &) = default;
};

/// What became of all steps of one student, the steps in the lab's order; a plain value. One file,
/// students/ID.json, holds it.
struct StudentResult {
    QString id;       ///< unlike all others of the class; fit for the name of a file
    QString name{};   ///< of the person, as the roster or the folder has it
    QString number{}; ///< of the learning platform or the university; may be empty
    QString email{};
    Platform platform = Platform::None; ///< that gave out the number; none: the university
    qint64 seed = 1;                    ///< of this student's scenes
    double lateDays = 0.0;
    QString remark{}; ///< what is strange about what was handed in; plain text
    std::vector<StepResult> steps{};

    friend bool operator==(const StudentResult &, const StudentResult &) = default;
};

} // namespace cradle
