// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/lab/question.h"

#include <QJsonObject>

#include <map>

namespace cradle {

/// What a student answers in a step, by the question's id: a number as it was typed, with its unit
/// ("9.9 m/s"); of a choice the number of an answer from 1, or a list of them; of an order all of
/// them; a text.
using Answers = QJsonObject;

/// Judges the answers to \p questions, each as a check: a right number in a wrong unit is told as
/// that, what is right is never told. What the teacher reads passes if there is something to read.
[[nodiscard]] std::vector<CheckOutcome> judgeAnswers(const std::vector<Question> &questions,
                                                     const Answers &answers);

/// The answers that are right; to a text any.
[[nodiscard]] Answers rightAnswers(const std::vector<Question> &questions);

/// How a student's answer is told to the teacher; plain text, empty if there is none.
[[nodiscard]] QString answerText(const Question &question, const QJsonValue &answer);

/// All answers of a lab as answers.json, by the step's id, and back. Anybody may have written it.
[[nodiscard]] QByteArray answersText(const std::map<QString, Answers> &answers);
[[nodiscard]] std::map<QString, Answers> answersFrom(const QByteArray &text);

} // namespace cradle
