// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/question.h"

#include <algorithm>

// What the form of questions knows of them, with the bounds of task.schema.json.
namespace cradle::questions {

inline constexpr int mostAnswers = 8;
inline constexpr int fewestAnswers = 2;
inline constexpr int longestAnswer = 200;
inline constexpr int mostQuestions = 20;

/// In the order of the list.
inline constexpr Question::Kind kinds[] = {Question::Kind::Number, Question::Kind::One,
                                           Question::Kind::Several, Question::Kind::Order,
                                           Question::Kind::Text};

[[nodiscard]] inline bool hasAnswers(Question::Kind kind)
{
    using enum Question::Kind;
    return kind == One || kind == Several || kind == Order;
}

/// Whether the answer, from 0, is among the right ones.
[[nodiscard]] inline bool isChosen(const Question &question, int answer)
{
    return std::find(question.chosen.begin(), question.chosen.end(), answer)
           != question.chosen.end();
}

} // namespace cradle::questions
