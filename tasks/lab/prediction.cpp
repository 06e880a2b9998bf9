// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab/prediction.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonObject>

namespace cradle {

namespace {

struct PredictionText {
    Q_DECLARE_TR_FUNCTIONS(LabReader)
};

QJsonObject partOf(const QJsonObject &json)
{
    return json.value(QStringLiteral("prediction")).toObject();
}

Prediction textsOf(const QJsonObject &part)
{
    Prediction texts;
    texts.question = part.value(QStringLiteral("question")).toString();
    texts.outcome = part.value(QStringLiteral("outcome")).toString();
    for (const QJsonValue &answer : part.value(QStringLiteral("answers")).toArray())
        texts.answers.append(answer.toString());
    return texts;
}

} // namespace

QString predictionFault(const QJsonObject &json)
{
    const QJsonObject part = partOf(json);
    const auto answers = part.value(QStringLiteral("answers")).toArray().size();
    const int right = part.value(QStringLiteral("right")).toInt();
    if (part.isEmpty() || (right >= 1 && right <= answers))
        return {};
    return PredictionText::tr("a number from 1 to %1, for there are so many answers, is right")
        .arg(answers);
}

QString translationFault(const QJsonObject &json, const QJsonObject &words)
{
    const QJsonObject part = partOf(words);
    const auto answers = partOf(json).value(QStringLiteral("answers")).toArray().size();
    const auto translated = part.value(QStringLiteral("answers")).toArray().size();
    if (part.isEmpty() || answers == translated)
        return {};
    return PredictionText::tr("%1 answers, as many as the task.json has, are right, not %2; the "
                              "question is shown untranslated")
        .arg(answers)
        .arg(translated);
}

std::optional<Prediction> readPrediction(const QJsonObject &json, const QJsonObject &words)
{
    const QJsonObject part = partOf(json);
    if (part.isEmpty() || !predictionFault(json).isEmpty())
        return std::nullopt;
    Prediction prediction = textsOf(part);
    prediction.right = part.value(QStringLiteral("right")).toInt() - 1;
    Prediction translated = textsOf(partOf(words));
    const bool complete = !translated.question.isEmpty() && !translated.outcome.isEmpty()
                          && translated.answers.size() == prediction.answers.size();
    if (!complete)
        return prediction;
    translated.right = prediction.right;
    return translated;
}

} // namespace cradle
