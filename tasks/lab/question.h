// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace cradle {

/// What a step asks beside its checks, and counts; a plain value.
struct Question {
    enum class Kind {
        Number,  ///< with a unit and a tolerance
        One,     ///< one of the answers
        Several, ///< all answers that are right, and no other
        Order,   ///< the answers, in the order in which the lab has them
        Text     ///< a short text that the teacher reads
    };

    QString id;
    Kind kind = Kind::Number;
    QString title;             ///< a few words, for reports
    QString text;              ///< what is asked; CommonMark with TeX
    QStringList answers{};     ///< CommonMark's inline marks are not read; of a choice or an order
    std::vector<int> chosen{}; ///< the right answers of a choice, from 0, in ascending order
    double number = 0.0;       ///< the right number, in \c unit
    QString expression{};      ///< as which the number was written; empty: as a number
    double tolerance = 0.0;    ///< how far off is still right, in \c unit
    QString toleranceExpression{}; ///< as which it was written; empty: as a number
    QString unit{};                ///< of a number; empty: it has none
    double points = 1.0;           ///< what a right answer is worth, 0 to 1000; of a text: what the
                                   ///< teacher may give

    friend bool operator==(const Question &, const Question &) = default;
};

/// "number", "one", "several", "order", "text".
[[nodiscard]] QString nameOf(Question::Kind kind);

/// The order in which the answers of an order are shown first: the same for everybody, and never
/// the right one. Indices into Question::answers.
[[nodiscard]] std::vector<int> shownOrder(const Question &question);

} // namespace cradle
