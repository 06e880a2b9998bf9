// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "tasks/lab/prediction.h"
#include "tasks/lab/question.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

namespace cradle {

struct LabFiles;

/// One check of a step, as its lab wrote it: a kind from the library with its parameters.
struct CheckSpec {
    QString id;
    QString title;
    QString kind;                            ///< see tasks/checks/check_kinds.h
    std::vector<int> circles{};              ///< the circles that it looks at, from 0
    QJsonObject parameters{};                ///< of the kind
    QJsonObject scene{};                     ///< which scenes it runs, see tasks/runs/variant.h
    double points = 1.0;                     ///< what passing it is worth, 0 to 1000
    QString source{};                        ///< of a check in Lua: its program
    QString language = QStringLiteral("en"); ///< in which it speaks to the student

    friend bool operator==(const CheckSpec &, const CheckSpec &) = default;
};

/// A program that the lab knows, with what it says to the student who wrote the same.
struct KnownScript {
    QString name;
    QString source;
    QString message; ///< CommonMark: a headline, then what was observed and where to look
};

/// Work that passes and yet deserves a word.
struct RemarkSpec {
    enum class Compare { Velocities, Positions, Fields };

    KnownScript script;
    Compare compare = Compare::Velocities; ///< what gives it away
    std::vector<int> circles{0};           ///< of the scene, from 0
    QJsonObject scene{};                   ///< where it shows, see tasks/runs/variant.h
};

/// Who may move the circles in a step.
enum class Mover {
    Program, ///< of those who program; without a program, the laws of the scene
    Laws,    ///< the laws of the scene; a program may set values
    Either   ///< a program if it has on_update, else the laws
};

/// One step of a lab; a plain value.
struct Task {
    QString id;           ///< L42T1
    QString title;        ///< a few words
    QString commit;       ///< the commit message, without the id; {integrator} is filled in
    QString folder;       ///< where its files are (a path, or a resource path)
    QString instructions; ///< CommonMark with TeX
    QStringList hints{};  ///< CommonMark, from a nudge to nearly the solution
    Preset preset{};      ///< the scene that the step starts with
    std::vector<CheckSpec> checks{};
    QStringList codeHints{}; ///< the same for those who write a program
    QString starter{};       ///< what a program starts from; the solution of the step before
    QString solution{};      ///< the reference program; empty if there is none
    std::vector<KnownScript> mistakes{};
    std::vector<RemarkSpec> remarks{};
    bool extra = false;                     ///< not in the original lab
    std::optional<double> points{};         ///< what it is worth; none: its checks together
    Mover moves = Mover::Either;            ///< who moves the circles
    QStringList locked{};                   ///< what the student may not change, see locks.h
    std::optional<Prediction> prediction{}; ///< asked before the scene is watched
    std::vector<Question> questions{};      ///< that are counted beside the checks
    std::optional<Laws> laws{};             ///< that it asks for: those of the scene that passes it
    std::optional<Preset> solutionScene{};  ///< that scene
    bool forStudents = false;               ///< of an edition without solutions and mistakes
};

/// A lab; a plain value.
struct Lab {
    QString id;
    QString title;
    QString version;
    QString language;
    QString folder;
    QString hash; ///< sha256 of its files; of an edition for students, that of the whole lab
    bool forStudents = false; ///< without solutions and mistakes, see student_edition.h
    std::vector<Task> tasks{};
    std::vector<Error> findings{};           ///< what could not be read; the rest is there
    std::shared_ptr<const LabFiles> files{}; ///< what it was read from; null if it was not read
    QString readIn{};                        ///< the language in which that was
    bool drawsValues = false;                ///< for each student others, see forStudent()

    /// The index of the task with that id; -1 if there is none.
    [[nodiscard]] int indexOf(const QString &taskId) const;
};

} // namespace cradle
