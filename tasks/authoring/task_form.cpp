// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/task_form.h"

#include "tasks/authoring/lab_json.h"
#include "tasks/authoring/prediction_form.h"
#include "tasks/authoring/questions_form.h"
#include "tasks/questions/question_json.h"

#include <algorithm>

namespace cradle {

namespace {

std::vector<int> circlesFrom(const QJsonValue &list)
{
    std::vector<int> circles;
    for (const QJsonValue &circle : list.toArray())
        circles.push_back(circle.toInt() - 1);
    return circles;
}

void putCircles(QJsonObject &json, const std::vector<int> &circles)
{
    QJsonArray list;
    for (const int circle : circles)
        list.append(circle + 1);
    if (!list.isEmpty())
        json.insert(QStringLiteral("circles"), list);
}

void putObject(QJsonObject &json, const QString &key, const QJsonObject &object)
{
    if (!object.isEmpty())
        json.insert(key, object);
}

void putList(QJsonObject &json, const QString &key, const QStringList &list)
{
    if (!list.isEmpty())
        json.insert(key, toJson(list));
}

CheckForm checkFrom(const QJsonObject &json)
{
    const auto text = [&](const char *key) { return json.value(QLatin1String(key)).toString(); };
    return {.id = text("id"),
            .kind = text("kind"),
            .title = text("title"),
            .circles = circlesFrom(json.value(QStringLiteral("circles"))),
            .parameters = json.value(QStringLiteral("parameters")).toObject(),
            .scene = json.value(QStringLiteral("scene")).toObject(),
            .points = json.value(QStringLiteral("points")).toDouble(1.0)};
}

QJsonObject jsonFrom(const CheckForm &check)
{
    QJsonObject json{{QStringLiteral("id"), check.id},
                     {QStringLiteral("kind"), check.kind},
                     {QStringLiteral("title"), check.title}};
    putCircles(json, check.circles);
    putObject(json, QStringLiteral("parameters"), check.parameters);
    putObject(json, QStringLiteral("scene"), check.scene);
    if (check.points != 1.0)
        json.insert(QStringLiteral("points"), check.points);
    return json;
}

RemarkForm remarkFrom(const QJsonObject &json)
{
    return {.id = json.value(QStringLiteral("id")).toString(),
            .compare = json.value(QStringLiteral("compare")).toString(),
            .circles = circlesFrom(json.value(QStringLiteral("circles"))),
            .scene = json.value(QStringLiteral("scene")).toObject()};
}

QJsonObject jsonFrom(const RemarkForm &remark)
{
    QJsonObject json{{QStringLiteral("id"), remark.id},
                     {QStringLiteral("compare"), remark.compare}};
    putCircles(json, remark.circles);
    putObject(json, QStringLiteral("scene"), remark.scene);
    return json;
}

/// task.json as far as a form knows it.
QJsonObject jsonFrom(const TaskForm &form)
{
    QJsonArray checks;
    for (const CheckForm &check : form.checks)
        checks.append(jsonFrom(check));
    QJsonArray remarks;
    for (const RemarkForm &remark : form.remarks)
        remarks.append(jsonFrom(remark));
    QJsonObject json{
        {QStringLiteral("format"), 1},           {QStringLiteral("id"), form.id},
        {QStringLiteral("title"), form.title},   {QStringLiteral("commit"), form.commit},
        {QStringLiteral("preset"), form.preset}, {QStringLiteral("hints"), toJson(form.hints)},
        {QStringLiteral("checks"), checks}};
    putList(json, QStringLiteral("code_hints"), form.codeHints);
    putList(json, QStringLiteral("locked"), form.locked);
    if (!remarks.isEmpty())
        json.insert(QStringLiteral("remarks"), remarks);
    if (!form.moves.isEmpty())
        json.insert(QStringLiteral("moves"), form.moves);
    if (form.extra)
        json.insert(QStringLiteral("extra"), true);
    if (form.points)
        json.insert(QStringLiteral("points"), *form.points);
    if (form.prediction)
        json.insert(predictionKey(), jsonFrom(*form.prediction));
    QJsonArray questions;
    for (const Question &question : form.questions)
        questions.append(jsonFrom(question));
    if (!questions.isEmpty())
        json.insert(QStringLiteral("questions"), questions);
    return json;
}

/// The translation as far as a form knows it; but for the prediction, which is translated as a
/// whole or not at all.
QJsonObject textsOf(const TaskForm &form)
{
    QJsonObject titles;
    for (const CheckForm &check : form.checks)
        titles.insert(check.id, check.title);
    QJsonObject json{{QStringLiteral("title"), form.title}};
    putList(json, QStringLiteral("hints"), form.hints);
    putList(json, QStringLiteral("code_hints"), form.codeHints);
    putObject(json, QStringLiteral("checks"), titles);
    return json;
}

TaskForm formFrom(const QJsonObject &json)
{
    const auto text = [&](const char *key) { return json.value(QLatin1String(key)).toString(); };
    TaskForm form{.id = text("id"),
                  .title = text("title"),
                  .commit = text("commit"),
                  .preset = text("preset"),
                  .hints = toStrings(json.value(QStringLiteral("hints"))),
                  .codeHints = toStrings(json.value(QStringLiteral("code_hints"))),
                  .checks = {},
                  .remarks = {},
                  .moves = text("moves"),
                  .extra = json.value(QStringLiteral("extra")).toBool(),
                  .locked = toStrings(json.value(QStringLiteral("locked"))),
                  .prediction = predictionFrom(json),
                  .questions = readQuestions(json)};
    if (json.contains(QStringLiteral("points")))
        form.points = json.value(QStringLiteral("points")).toDouble();
    for (const QJsonValue &check : json.value(QStringLiteral("checks")).toArray())
        form.checks.push_back(checkFrom(check.toObject()));
    for (const QJsonValue &remark : json.value(QStringLiteral("remarks")).toArray())
        form.remarks.push_back(remarkFrom(remark.toObject()));
    return form;
}

/// Puts the texts of a translation where it has them.
void translate(TaskForm &form, const QJsonObject &texts)
{
    const auto value = [&](const char *key) { return texts.value(QLatin1String(key)); };
    form.title = value("title").toString(form.title);
    if (texts.contains(QStringLiteral("hints")))
        form.hints = toStrings(value("hints"));
    if (texts.contains(QStringLiteral("code_hints")))
        form.codeHints = toStrings(value("code_hints"));
    const QJsonObject titles = value("checks").toObject();
    for (CheckForm &check : form.checks)
        check.title = titles.value(check.id).toString(check.title);
    form.prediction = translated(form.prediction, texts);
    const QJsonObject questions = value("questions").toObject();
    for (Question &question : form.questions)
        question = withTexts(question, questions.value(question.id).toObject());
}

const CheckForm *find(const TaskForm &form, const QString &id)
{
    const auto found = std::find_if(form.checks.begin(), form.checks.end(),
                                    [&](const CheckForm &check) { return check.id == id; });
    return found == form.checks.end() ? nullptr : &*found;
}

/// What a check became: its own id, another at the same place, or empty if it is gone.
QString newIdOf(const TaskForm &before, const TaskForm &after, std::size_t index)
{
    const QString &id = before.checks[index].id;
    if (find(after, id))
        return id;
    if (before.checks.size() != after.checks.size())
        return {};
    const QString &there = after.checks[index].id;
    return find(before, there) ? QString() : there;
}

/// \p form with the texts of the lab's own language: those of \p own, or for a new check its own.
/// \param before  what \p form was, in its language
TaskForm withOwnTexts(TaskForm form, const TaskForm &own, const TaskForm &before)
{
    form.prediction = withTextsOf(own.prediction, before.prediction, form.prediction);
    form.questions = withTextsOf(own.questions, before.questions, form.questions);
    form.title = own.title;
    form.hints = own.hints;
    form.codeHints = own.codeHints;
    for (std::size_t i = 0; i < own.checks.size(); ++i) {
        const QString id = newIdOf(own, form, i);
        for (CheckForm &check : form.checks) {
            if (check.id == id)
                check.title = own.checks[i].title;
        }
    }
    return form;
}

} // namespace

Result<TaskForm> taskForm(const LabFiles &files, const QString &step, const QString &language)
{
    const Result<QJsonObject> json = jsonOf(files, taskPath(step), taskSchema);
    if (!json)
        return json.error();
    TaskForm form = formFrom(*json);
    const QString translation = translatedPath(taskPath(step), language);
    if (isTranslation(files, language) && files.contents.contains(translation)) {
        const Result<QJsonObject> texts = jsonOf(files, translation, translationSchema);
        if (!texts)
            return texts.error();
        translate(form, *texts);
    }
    return form;
}

Result<LabFiles> withTask(const LabFiles &files, const QString &step, const TaskForm &form,
                          const QString &language)
{
    const Result<TaskForm> own = taskForm(files, step);
    const Result<TaskForm> before = taskForm(files, step, language);
    if (!own || !before)
        return own ? before.error() : own.error();
    const bool translated = isTranslation(files, language);
    const TaskForm wanted = translated ? withOwnTexts(form, *own, *before) : form;
    Result<LabFiles> result =
        withPatch(files, taskPath(step), taskSchema, jsonFrom(*own), jsonFrom(wanted));
    if (!result)
        return result;
    for (std::size_t i = 0; i < own->checks.size(); ++i) {
        const QString &id = own->checks[i].id;
        if (const QString newId = newIdOf(*own, form, i); newId != id)
            result = withTranslatedKey(*result, step, QStringLiteral("checks"), id, newId);
    }
    const auto goOn = [&result](const auto &with, const auto &...what) {
        if (result)
            result = with(*result, what...);
    };
    const QString translation = translatedPath(taskPath(step), language);
    for (const QString &path : translationsOf(files, step)) {
        if (!translated || path != translation)
            goOn(withAnswersFollowing, path, before->prediction, form.prediction);
    }
    if (translated) {
        goOn(withPatch, translation, translationSchema, textsOf(*before), textsOf(form));
        goOn(withPredictionTexts, translation, before->prediction, form.prediction);
    }
    goOn(withQuestionsFollowing, step, before->questions, form.questions);
    if (translated)
        goOn(withQuestionTexts, translation, before->questions, form.questions);
    return result;
}

} // namespace cradle
