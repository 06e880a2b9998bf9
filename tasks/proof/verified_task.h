// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/judgement.h"
#include "tasks/proof/sensitivity.h"

namespace cradle {

/// What became of one program that a step of a lab knows.
struct VerifiedProgram {
    enum class Role { Starter, Solution, Mistake, Remark };

    Role role = Role::Mistake;
    QString name;
    std::vector<CheckReport> reports{}; ///< one for each seed
};

/// Something about a lab that is not as it should be.
struct LabFinding {
    enum class Kind {
        NoSolution,             ///< the step has no solution.lua
        ProgramErrs,            ///< a program does not load or stops with an error
        StarterPasses,          ///< it should fail by a check
        SolutionFails,          ///< by \c check with \c seed
        MistakePasses,          ///< it should fail by a check
        MistakeNotRecognised,   ///< it fails, and nothing is said of it
        MistakeTakenForAnother, ///< it gets the diagnosis of another
        MistakeDiffersInMore,   ///< it has another value than the solution beside its mistake
        RemarkFails,            ///< work that gets a remark should pass
        RemarkNotRecognised,    ///< it passes, and nothing is said of it
        CheckNeverFails,        ///< no mistake fails \c check
        CheckStops,             ///< \c check itself stops with an error on \c program
        ValueFails,             ///< what some student draws is no number somewhere
        ToleranceTooTight,      ///< the solution itself nearly uses up that of \c check
        CheckIsDuplicate,       ///< \c check asks for the same as one before it
        CheckNeverAlone,        ///< no mistake is seen by \c check alone
        QuestionEndless,        ///< it asks for a number that nobody can write down
        TextUnfinished          ///< a half translation, or a text left from the template
    };

    Kind kind = Kind::ProgramErrs;
    QString task;      ///< id of the step
    QString program{}; ///< "starter", "mistakes/NAME": its file in the step's folder without the
                       ///< ending; "solution-preset" is a scene; empty if it is about none
    QString check{};   ///< id of the check; empty if it is about none
    qint64 seed = 1;   ///< with which it shows
    QString message{}; ///< what is wrong and what would be right
};

/// A step of a lab with what its programs showed of it.
struct VerifiedTask {
    QString id;
    QString title;
    QStringList checks{}; ///< ids
    std::vector<VerifiedProgram> programs{};
    std::vector<LabFinding> findings{};
    std::vector<std::optional<Sensitivity>> sensitivity{}; ///< of each check
    std::vector<LabFinding> warnings{}; ///< what may well be so, and yet deserves a look
};

/// "mistakes/NAME", "starter": the file of a program in its step without the ending.
[[nodiscard]] QString programPath(const VerifiedProgram &program);

/// Takes back the warnings of checks that something fails alone: some mutations of the solution,
/// see mutations.h. \param alone  the ids of such checks
void dropNeeded(VerifiedTask &verified, const QStringList &alone);

} // namespace cradle
