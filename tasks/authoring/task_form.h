// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "tasks/lab/prediction.h"
#include "tasks/lab/question.h"
#include "tasks/lab_files/lab_files.h"

#include <QJsonObject>

namespace cradle {

/// A check as a form edits it: what stands in task.json, in its words.
struct CheckForm {
    QString id;
    QString kind;               ///< see tasks/checks/check_library.h
    QString title;              ///< in the form's language
    std::vector<int> circles{}; ///< from 0; empty: not written, which means the first
    QJsonObject parameters{};
    QJsonObject scene{};
    double points = 1.0; ///< 1 is not written

    friend bool operator==(const CheckForm &, const CheckForm &) = default;
};

/// A remark as a form edits it; its program is remarks/ID.lua.
struct RemarkForm {
    QString id;
    QString compare = QStringLiteral("velocities"); ///< velocities, positions or fields
    std::vector<int> circles{};                     ///< from 0; empty: the first
    QJsonObject scene{};

    friend bool operator==(const RemarkForm &, const RemarkForm &) = default;
};

/// task.json as a form edits it; what else stands there is kept as it is.
struct TaskForm {
    QString id;
    QString title;                                  ///< in the form's language
    QString commit;                                 ///< the commit message without the id
    QString preset = QStringLiteral("preset.json"); ///< the file of the scene
    QStringList hints{};                            ///< in the form's language
    QStringList codeHints{};                        ///< in the form's language
    std::vector<CheckForm> checks{};
    std::vector<RemarkForm> remarks{};
    QString moves{}; ///< who moves the circles: program, laws or either; empty: either
    bool extra = false;
    std::optional<double> points{};         ///< what the step is worth; none: its checks together
    QStringList locked{};                   ///< fields of the scene that the student may not change
    std::optional<Prediction> prediction{}; ///< in the form's language; right may be none of them
    std::vector<Question> questions{};      ///< in the form's language

    friend bool operator==(const TaskForm &, const TaskForm &) = default;
};

/// Reads STEP/task.json, and for another \p language than the lab's own the texts of
/// STEP/task.LANGUAGE.json where it has them.
[[nodiscard]] Result<TaskForm> taskForm(const LabFiles &files, const QString &step,
                                        const QString &language = {});

/// Writes back what differs from taskForm(): title, hints, prediction, questions and titles of
/// checks into STEP/task.LANGUAGE.json for another \p language, all else into STEP/task.json. Texts
/// in other languages follow the check that they belong to, also if its id changes; an answer that
/// is added or removed is so in all languages.
[[nodiscard]] Result<LabFiles> withTask(const LabFiles &files, const QString &step,
                                        const TaskForm &form, const QString &language = {});

} // namespace cradle
