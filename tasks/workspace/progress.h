// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "tasks/lab/prediction.h"

#include <QDateTime>
#include <QJsonObject>
#include <QString>

#include <map>
#include <optional>

namespace cradle {

/// What is left of the check that a step last passed, after the report is gone.
struct Pass {
    QDateTime when{}; ///< UTC, whole seconds; invalid if the file did not say
    QString commit{}; ///< the commit message

    friend bool operator==(const Pass &, const Pass &) = default;
};

/// How far a student has come with one step.
struct TaskProgress {
    bool passed = false;
    int hintsOpened = 0;
    std::optional<Preset> edited{}; ///< what the student has made of the step's scene
    Pass pass{};                    ///< if passed
    Guess guess{};                  ///< if the step asks for a prediction
    QJsonObject answers{};          ///< to its questions, see tasks/questions/answers.h

    friend bool operator==(const TaskProgress &, const TaskProgress &) = default;
};

/// How far a student has come with one lab.
struct LabProgress {
    QString currentTask;
    std::map<QString, TaskProgress> tasks{}; ///< by the step's id

    friend bool operator==(const LabProgress &, const LabProgress &) = default;
};

/// The student's progress in all labs, kept in one file that survives a crash while writing.
/// Several windows share it, each for the lab that it has open. It proves nothing: anybody may
/// write it, and where it matters a program is judged again.
class ProgressStore
{
public:
    /// \param path  of the file; it need not be there yet; empty to keep nothing
    explicit ProgressStore(QString path);

    /// Reads the file. A broken one is moved aside, never overwritten.
    /// \return what was wrong with it
    std::optional<Error> load();
    /// Writes the file, whole or not at all: what lab() was asked for as it is here, other labs as
    /// they are in the file by now. A step that was passed there stays so.
    /// \return what kept it from being written
    [[nodiscard]] std::optional<Error> save() const;

    LabProgress &lab(const QString &labId);
    /// The answers to that step's questions.
    [[nodiscard]] QJsonObject answersOf(const QString &labId, const QString &taskId) const;
    /// Whether that step was passed once.
    [[nodiscard]] bool isPassed(const QString &labId, const QString &taskId) const;

private:
    [[nodiscard]] const TaskProgress *find(const QString &labId, const QString &taskId) const;

    QString m_path;
    std::map<QString, LabProgress> m_read; ///< as the file had them
    std::map<QString, LabProgress> m_labs; ///< those that were asked for
};

} // namespace cradle
