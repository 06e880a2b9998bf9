// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/prediction.h"
#include "tasks/lab_files/lab_files.h"

#include <QJsonObject>

namespace cradle {

// The prediction of a step as a form edits it, with its texts in other languages.

/// \p answers after the change from \p before to \p after, by one answer more or one less; as they
/// are if they were never as many.
[[nodiscard]] QStringList followed(QStringList answers, const QStringList &before,
                                   const QStringList &after);

/// Where it stands in task.json and in task.LANGUAGE.json.
[[nodiscard]] inline QString predictionKey()
{
    return QStringLiteral("prediction");
}

/// That of a task.json as it stands there; `right` may be none of the answers.
[[nodiscard]] std::optional<Prediction> predictionFrom(const QJsonObject &task);
[[nodiscard]] QJsonObject jsonFrom(const Prediction &prediction);

/// \p prediction with the texts that \p words, a task.LANGUAGE.json, has of it; they count only
/// with as many answers.
[[nodiscard]] std::optional<Prediction> translated(const std::optional<Prediction> &prediction,
                                                   const QJsonObject &words);

/// What a change in one language, from \p before to \p after, makes of \p own, the same in another:
/// answers come and go in both, texts stay.
[[nodiscard]] std::optional<Prediction> withTextsOf(const std::optional<Prediction> &own,
                                                    const std::optional<Prediction> &before,
                                                    const std::optional<Prediction> &after);

/// The same with a translation in the file \p path; nothing if it has no prediction.
[[nodiscard]] Result<LabFiles> withAnswersFollowing(const LabFiles &files, const QString &path,
                                                    const std::optional<Prediction> &before,
                                                    const std::optional<Prediction> &after);

/// Writes the texts of \p after into the translation \p path if they differ from \p before.
[[nodiscard]] Result<LabFiles> withPredictionTexts(const LabFiles &files, const QString &path,
                                                   const std::optional<Prediction> &before,
                                                   const std::optional<Prediction> &after);

} // namespace cradle
