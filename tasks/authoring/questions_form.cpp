// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/questions_form.h"

#include "tasks/authoring/lab_json.h"
#include "tasks/authoring/prediction_form.h"
#include "tasks/questions/question_json.h"

#include <algorithm>

namespace cradle {

namespace {

const QString questionsKey = QStringLiteral("questions");
const QString questionAnswersKey = QStringLiteral("answers");

const Question *find(const std::vector<Question> &questions, const QString &id)
{
    const auto found = std::find_if(questions.begin(), questions.end(),
                                    [&](const Question &each) { return each.id == id; });
    return found == questions.end() ? nullptr : &*found;
}

/// What became of the question at \p index: itself, one with another id in its place, or nothing.
const Question *heirOf(const std::vector<Question> &before, const std::vector<Question> &after,
                       std::size_t index)
{
    if (const Question *same = find(after, before[index].id))
        return same;
    if (before.size() != after.size() || find(before, after[index].id))
        return nullptr;
    return &after[index];
}

/// Where \p id stands; as many as there are if it does not.
std::size_t indexOf(const std::vector<Question> &questions, const QString &id)
{
    std::size_t index = 0;
    while (index < questions.size() && questions[index].id != id)
        ++index;
    return index;
}

} // namespace

std::vector<Question> withTextsOf(const std::vector<Question> &own,
                                  const std::vector<Question> &before,
                                  const std::vector<Question> &after)
{
    std::vector<Question> result = after;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const std::size_t shown = indexOf(before, own[i].id);
        const Question *heir = shown < before.size() ? heirOf(before, after, shown) : nullptr;
        if (!heir)
            continue;
        Question &kept = result[indexOf(result, heir->id)];
        kept.title = own[i].title;
        kept.text = own[i].text;
        kept.answers = followed(own[i].answers, before[shown].answers, heir->answers);
    }
    return result;
}

Result<LabFiles> withQuestionsFollowing(const LabFiles &files, const QString &step,
                                        const std::vector<Question> &before,
                                        const std::vector<Question> &after)
{
    Result<LabFiles> result = files;
    for (const QString &path : translationsOf(files, step)) {
        const Result<QJsonObject> json = jsonOf(files, path, translationSchema);
        if (!json || !json->contains(questionsKey))
            continue; // one that cannot be read is told elsewhere
        const QJsonObject texts = json->value(questionsKey).toObject();
        QJsonObject kept;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Question *heir = heirOf(before, after, i);
            if (!heir || !texts.contains(before[i].id))
                continue;
            QJsonObject words = texts.value(before[i].id).toObject();
            const QStringList answers = followed(toStrings(words.value(questionAnswersKey)),
                                                 before[i].answers, heir->answers);
            if (words.contains(questionAnswersKey))
                words.insert(questionAnswersKey, toJson(answers));
            kept.insert(heir->id, words);
        }
        const QJsonValue value =
            kept.isEmpty() ? QJsonValue(QJsonValue::Undefined) : QJsonValue(kept);
        if (result && kept != texts)
            result = withMember(*result, path, translationSchema, questionsKey, value);
    }
    return result;
}

Result<LabFiles> withQuestionTexts(const LabFiles &files, const QString &path,
                                   const std::vector<Question> &before,
                                   const std::vector<Question> &after)
{
    const Result<QJsonObject> json = jsonOf(files, path, translationSchema);
    const QJsonObject texts = json ? json->value(questionsKey).toObject() : QJsonObject();
    QJsonObject changed = texts;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Question *heir = heirOf(before, after, i);
        if (heir && textsOf(*heir) != textsOf(before[i]))
            changed.insert(heir->id, textsOf(*heir));
    }
    return changed == texts ? Result<LabFiles>(files)
                            : withMember(files, path, translationSchema, questionsKey, changed);
}

} // namespace cradle
