// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <optional>

QT_BEGIN_NAMESPACE
class QJsonObject;
QT_END_NAMESPACE

namespace cradle {

/// What a step asks before it is watched; a plain value.
struct Prediction {
    QString question;      ///< CommonMark with TeX
    QStringList answers{}; ///< two to four plain texts
    int right = 0;         ///< the answer that comes true, from 0
    QString outcome;       ///< CommonMark with TeX: what happens, and why

    friend bool operator==(const Prediction &, const Prediction &) = default;
};

/// What a student expects, and how far it has come; a plain value.
struct Guess {
    static constexpr int notSure = -1;

    std::optional<int> answer{}; ///< from 0, or notSure; nothing before there is one
    bool watched = false;        ///< the scene has left its start
    bool revealed = false;       ///< the student knows what happens

    friend bool operator==(const Guess &, const Guess &) = default;
};

/// The prediction of a step, if it has one.
/// \param json   of task.json
/// \param words  of task.LANGUAGE.json; taken if it has every text, with as many answers
/// \return nothing also if `right` is none of the answers; see predictionFault()
[[nodiscard]] std::optional<Prediction> readPrediction(const QJsonObject &json,
                                                       const QJsonObject &words);

/// What is wrong with its translation \p words, which is then not shown; empty if nothing, or if
/// there is none.
[[nodiscard]] QString translationFault(const QJsonObject &json, const QJsonObject &words);

/// What is wrong with the prediction of a task.json that the schema lets pass; empty if nothing.
[[nodiscard]] QString predictionFault(const QJsonObject &json);

} // namespace cradle
