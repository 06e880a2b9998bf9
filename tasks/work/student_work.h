// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/questions/answers.h"
#include "tasks/workspace/version.h"
#include "tasks/workspace/workspace_info.h"

#include <QMap>

#include <map>
#include <optional>
#include <vector>

namespace cradle {

/// A state of a program that was kept, with its text.
struct KeptProgram {
    Version version{};
    QString text{};

    friend bool operator==(const KeptProgram &, const KeptProgram &) = default;
};

/// What a student did in one step.
struct StepWork {
    std::optional<QString> program{}; ///< none: not worked on by a program
    QString programFault{};           ///< why the file is no program; empty if it is one
    std::optional<Preset> scene{};    ///< the student's own; none: that of the step
    QString note{};                   ///< Markdown
    Guess guess{};
    Answers answers{};                   ///< to the step's questions
    std::vector<KeptProgram> versions{}; ///< the newest first

    /// Whether nothing was ever done.
    [[nodiscard]] bool isEmpty() const
    {
        return !program && programFault.isEmpty() && !scene && answers.isEmpty();
    }
};

/// All that a student did in a lab, wherever it lies; a plain value. Anybody may have written it.
struct StudentWork {
    WorkspaceInfo info{};
    std::map<QString, StepWork> steps{}; ///< by the step's id
    QString noteToTeacher{};             ///< plain text

    [[nodiscard]] const StepWork &step(const QString &taskId) const;
};

/// The files of a workspace, by path below it.
using WorkFiles = QMap<QString, QByteArray>;

/// Reads the files of a workspace, or of a plain folder with steps/ID.lua: those of the work, none
/// larger than it may be.
Result<WorkFiles> readWorkFiles(const QString &folder);

/// Reads the work that \p files hold, for the steps of \p lab. What cannot be read is left out, but
/// a program is named as no program.
[[nodiscard]] StudentWork workFrom(const WorkFiles &files, const Lab &lab);

/// The work in a folder, with the versions of its repository, or in a file that was handed in.
Result<StudentWork> readWork(const QString &path, const Lab &lab);

/// The answers to the lab's predictions as predictions.json, and back.
[[nodiscard]] QByteArray predictionsText(const std::map<QString, Guess> &guesses);
[[nodiscard]] std::map<QString, Guess> predictionsFrom(const QByteArray &text);

/// Kept programs as history.json, and back; at most as many as a hand-in may hold.
[[nodiscard]] QByteArray historyText(const std::vector<KeptProgram> &programs);
[[nodiscard]] std::vector<KeptProgram> historyFrom(const QByteArray &text);

} // namespace cradle
