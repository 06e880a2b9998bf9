// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/prediction_form.h"

#include "tasks/authoring/lab_json.h"

namespace cradle {

namespace {

const QString questionKey = QStringLiteral("question");
const QString answersKey = QStringLiteral("answers");
const QString rightKey = QStringLiteral("right");
const QString outcomeKey = QStringLiteral("outcome");

Prediction textsFrom(const QJsonObject &json)
{
    return {.question = json.value(questionKey).toString(),
            .answers = toStrings(json.value(answersKey)),
            .right = 0,
            .outcome = json.value(outcomeKey).toString()};
}

QJsonObject textsOf(const Prediction &prediction)
{
    return {{questionKey, prediction.question},
            {answersKey, toJson(prediction.answers)},
            {outcomeKey, prediction.outcome}};
}

bool sameTexts(const std::optional<Prediction> &a, const std::optional<Prediction> &b)
{
    return a.has_value() == b.has_value() && (!a || textsOf(*a) == textsOf(*b));
}

} // namespace

QStringList followed(QStringList answers, const QStringList &before, const QStringList &after)
{
    if (answers.size() != before.size())
        return answers;
    qsizetype at = 0;
    while (at < before.size() && at < after.size() && before[at] == after[at])
        ++at;
    if (after.size() == before.size() + 1)
        answers.insert(at, after[at]);
    else if (after.size() + 1 == before.size())
        answers.removeAt(at);
    return answers;
}

std::optional<Prediction> predictionFrom(const QJsonObject &task)
{
    const QJsonObject json = task.value(predictionKey()).toObject();
    if (json.isEmpty())
        return std::nullopt;
    Prediction prediction = textsFrom(json);
    prediction.right = json.value(rightKey).toInt() - 1;
    return prediction;
}

QJsonObject jsonFrom(const Prediction &prediction)
{
    QJsonObject json = textsOf(prediction);
    json.insert(rightKey, prediction.right + 1);
    return json;
}

std::optional<Prediction> translated(const std::optional<Prediction> &prediction,
                                     const QJsonObject &words)
{
    Prediction texts = textsFrom(words.value(predictionKey()).toObject());
    if (!prediction || texts.answers.size() != prediction->answers.size())
        return prediction;
    texts.right = prediction->right;
    return texts;
}

std::optional<Prediction> withTextsOf(const std::optional<Prediction> &own,
                                      const std::optional<Prediction> &before,
                                      const std::optional<Prediction> &after)
{
    if (!own || !before || !after)
        return after;
    Prediction result = *own;
    result.right = after->right;
    result.answers = followed(own->answers, before->answers, after->answers);
    return result;
}

Result<LabFiles> withAnswersFollowing(const LabFiles &files, const QString &path,
                                      const std::optional<Prediction> &before,
                                      const std::optional<Prediction> &after)
{
    const Result<QJsonObject> json = jsonOf(files, path, translationSchema);
    if (!json || !before || !json->contains(predictionKey()))
        return files; // one that cannot be read is told elsewhere
    const QJsonValue gone(QJsonValue::Undefined);
    if (!after)
        return withMember(files, path, translationSchema, predictionKey(), gone);
    Prediction texts = textsFrom(json->value(predictionKey()).toObject());
    texts.answers = followed(texts.answers, before->answers, after->answers);
    return withMember(files, path, translationSchema, predictionKey(), textsOf(texts));
}

Result<LabFiles> withPredictionTexts(const LabFiles &files, const QString &path,
                                     const std::optional<Prediction> &before,
                                     const std::optional<Prediction> &after)
{
    if (sameTexts(before, after))
        return files;
    const QJsonValue texts =
        after ? QJsonValue(textsOf(*after)) : QJsonValue(QJsonValue::Undefined);
    return withMember(files, path, translationSchema, predictionKey(), texts);
}

} // namespace cradle
