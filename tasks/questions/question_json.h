// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"
#include "tasks/lab/question.h"

#include <QJsonObject>

namespace cradle {

/// The questions of a task.json that fits its schema.
/// \param words  of task.LANGUAGE.json: its texts, where it has as many answers
[[nodiscard]] std::vector<Question> readQuestions(const QJsonObject &task,
                                                  const QJsonObject &words = {});

/// One of them, as it stands there, and back.
[[nodiscard]] Question questionFrom(const QJsonObject &json);
[[nodiscard]] QJsonObject jsonFrom(const Question &question);

/// Its texts as a translation has them, and \p question with such texts.
[[nodiscard]] QJsonObject textsOf(const Question &question);
[[nodiscard]] Question withTexts(Question question, const QJsonObject &texts);

/// What is wrong with the questions of a task.json that the schema lets pass, each with its place
/// (\c pointer); ids are those of no check, either.
[[nodiscard]] std::vector<Error> questionFaults(const QJsonObject &task);
/// What is wrong with one; empty if nothing.
[[nodiscard]] QString faultOf(const Question &question);

} // namespace cradle
