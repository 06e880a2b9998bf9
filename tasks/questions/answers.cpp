// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/questions/answers.h"

#include "model/files/unit.h"
#include "model/world/shortest_number.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct AnswerText {
    Q_DECLARE_TR_FUNCTIONS(Questions)
};

using Kind = Question::Kind;

/// What rounding of a conversion of units may take from a number that is right.
constexpr double rounding = 1e-9;
constexpr qsizetype longestText = 2000; ///< of an answer, characters

/// The numbers of answers, from 0, each once; nothing if they are none of the question's.
std::vector<int> indicesOf(const Question &question, const QJsonValue &answer)
{
    std::vector<int> indices;
    const QJsonArray list = answer.isArray() ? answer.toArray() : QJsonArray{answer};
    for (const QJsonValue &each : list) {
        const int index = each.toInt() - 1;
        if (index >= 0 && index < static_cast<int>(question.answers.size())
            && std::find(indices.begin(), indices.end(), index) == indices.end())
            indices.push_back(index);
    }
    return indices;
}

bool isNear(double value, const Question &question)
{
    const double margin = question.tolerance + rounding * std::abs(question.number);
    return std::abs(value - question.number) <= margin;
}

/// What is wrong with a number; empty if nothing.
QString faultOfNumber(const Question &question, const QString &text, CheckOutcome &outcome)
{
    const auto typed = quantityFrom(text);
    if (!typed)
        return question.unit.isEmpty()
                   ? AnswerText::tr("“%1” is no number; one like 0.75 is asked for").arg(text)
                   : AnswerText::tr("“%1” is no number with a unit; one like 3.2 kg is asked for")
                         .arg(text);
    const auto asked = unitFrom(question.unit);
    const auto given = unitFrom(typed->unit);
    const bool numberIsRight = isNear(typed->number, question);
    if (!given)
        return AnswerText::tr("“%1” is no unit that is known").arg(typed->unit);
    if (asked->powers != given->powers) {
        if (typed->unit.isEmpty())
            return numberIsRight ? AnswerText::tr("the number is right; its unit is missing")
                                 : AnswerText::tr("%1 is not right, and its unit is missing")
                                       .arg(text.trimmed());
        return numberIsRight
                   ? AnswerText::tr("the number is right, but not its unit: what is asked for is "
                                    "not measured in %1")
                         .arg(typed->unit)
                   : AnswerText::tr("%1 is not right: what is asked for is not measured in %2")
                         .arg(text.trimmed(), typed->unit);
    }
    outcome.observed = typed->number * given->scale / asked->scale;
    outcome.unit = question.unit;
    if (isNear(*outcome.observed, question))
        return {};
    return numberIsRight ? AnswerText::tr("the number is right, but not in %1").arg(typed->unit)
                         : AnswerText::tr("%1 is not right").arg(text.trimmed());
}

QString faultOfSeveral(const Question &question, const std::vector<int> &chosen)
{
    const auto isRight = [&](int each) {
        return std::find(question.chosen.begin(), question.chosen.end(), each)
               != question.chosen.end();
    };
    const auto right = std::count_if(chosen.begin(), chosen.end(), isRight);
    const bool wrong = right != static_cast<std::ptrdiff_t>(chosen.size());
    const bool missing = right != static_cast<std::ptrdiff_t>(question.chosen.size());
    if (wrong && missing)
        return AnswerText::tr("one that is chosen is not right, and a right one is missing");
    if (wrong)
        return AnswerText::tr("one that is chosen is not right");
    return missing ? AnswerText::tr("all that is chosen is right, but not all that is right is "
                                    "chosen")
                   : QString();
}

QString faultOfOrder(const Question &question, const std::vector<int> &order)
{
    if (order.size() != static_cast<std::size_t>(question.answers.size()))
        return AnswerText::tr("not all of them are in the order");
    int right = 0;
    while (right < static_cast<int>(order.size())
           && order[static_cast<std::size_t>(right)] == right)
        ++right;
    if (right == static_cast<int>(order.size()))
        return {};
    return right == 0
               ? AnswerText::tr("it does not begin with what is first")
               : AnswerText::tr("the order is right up to number %1, and not behind it").arg(right);
}

QString faultOfAnswer(const Question &question, const QJsonValue &answer, CheckOutcome &outcome)
{
    const std::vector<int> indices = indicesOf(question, answer);
    switch (question.kind) {
    case Kind::Number:
        return faultOfNumber(question, answer.toString(), outcome);
    case Kind::One:
        return indices == question.chosen
                   ? QString()
                   : AnswerText::tr("the answer that is chosen is not right");
    case Kind::Several:
        return faultOfSeveral(question, indices);
    case Kind::Order:
        return faultOfOrder(question, indices);
    case Kind::Text:
        break;
    }
    return {};
}

CheckOutcome judgeAnswer(const Question &question, const QJsonValue &answer)
{
    CheckOutcome outcome{.id = question.id, .title = question.title, .points = question.points};
    outcome.question = true;
    outcome.forTeacher = question.kind == Kind::Text;
    const QString text = answerText(question, answer);
    if (outcome.forTeacher)
        outcome.points = 0.0; // which the teacher gives
    if (text.isEmpty()) {
        outcome.message = AnswerText::tr("not answered yet");
        return outcome;
    }
    outcome.message = faultOfAnswer(question, answer, outcome);
    outcome.passed = outcome.message.isEmpty();
    if (outcome.forTeacher)
        outcome.message =
            AnswerText::tr("for the teacher to read, who may give up to %1 points: %2")
                .arg(shortestNumber(question.points), text);
    return outcome;
}

} // namespace

std::vector<CheckOutcome> judgeAnswers(const std::vector<Question> &questions,
                                       const Answers &answers)
{
    std::vector<CheckOutcome> outcomes;
    for (const Question &question : questions)
        outcomes.push_back(judgeAnswer(question, answers.value(question.id)));
    return outcomes;
}

Answers rightAnswers(const std::vector<Question> &questions)
{
    Answers answers;
    for (const Question &question : questions) {
        QJsonArray list;
        for (const int each : question.chosen)
            list.append(each + 1);
        for (int i = 0; question.kind == Kind::Order && i < question.answers.size(); ++i)
            list.append(i + 1);
        if (question.kind == Kind::Number)
            answers.insert(
                question.id,
                (shortestNumber(question.number) + QLatin1Char(' ') + question.unit).trimmed());
        else if (question.kind == Kind::Text)
            answers.insert(question.id, question.title);
        else
            answers.insert(question.id, question.kind == Kind::One ? list.at(0) : QJsonValue(list));
    }
    return answers;
}

QString answerText(const Question &question, const QJsonValue &answer)
{
    if (question.kind == Kind::Number || question.kind == Kind::Text)
        return answer.toString().trimmed().left(longestText);
    QStringList texts;
    for (const int index : indicesOf(question, answer))
        texts.append(question.answers[index]);
    return texts.join(QStringLiteral("; "));
}

QByteArray answersText(const std::map<QString, Answers> &answers)
{
    QJsonObject json;
    for (const auto &[id, step] : answers) {
        if (!step.isEmpty())
            json.insert(id, step);
    }
    return QJsonDocument(json).toJson();
}

std::map<QString, Answers> answersFrom(const QByteArray &bytes)
{
    std::map<QString, Answers> answers;
    const QJsonObject json = QJsonDocument::fromJson(bytes).object();
    for (auto it = json.begin(); it != json.end(); ++it)
        answers[it.key()] = it.value().toObject();
    return answers;
}

} // namespace cradle
