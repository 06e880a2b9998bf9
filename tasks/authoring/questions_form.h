// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/question.h"
#include "tasks/lab_files/lab_files.h"

#include <QJsonObject>

namespace cradle {

// The questions of a step as a form edits them, with their texts in other languages.

/// What a change in one language, from \p before to \p after, makes of \p own, the same in the
/// lab's own: what counts, and how many answers there are, is that of \p after; the texts stay.
[[nodiscard]] std::vector<Question> withTextsOf(const std::vector<Question> &own,
                                                const std::vector<Question> &before,
                                                const std::vector<Question> &after);

/// The translations of a step after that change: texts follow the question that they belong to,
/// also if its id changes; an answer that comes or goes does so in all of them.
[[nodiscard]] Result<LabFiles> withQuestionsFollowing(const LabFiles &files, const QString &step,
                                                      const std::vector<Question> &before,
                                                      const std::vector<Question> &after);

/// Writes the texts of \p after that differ from \p before into the translation \p path.
[[nodiscard]] Result<LabFiles> withQuestionTexts(const LabFiles &files, const QString &path,
                                                 const std::vector<Question> &before,
                                                 const std::vector<Question> &after);

} // namespace cradle
