// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/questions/question_json.h"

#include "model/files/expression.h"
#include "model/files/unit.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QJsonArray>
#include <QSet>

#include <algorithm>
#include <array>
#include <utility>

namespace cradle {

namespace {

struct QuestionText {
    Q_DECLARE_TR_FUNCTIONS(Questions)
};

using Kind = Question::Kind;

constexpr std::array kinds{std::pair{Kind::Number, "number"}, std::pair{Kind::One, "one"},
                           std::pair{Kind::Several, "several"}, std::pair{Kind::Order, "order"},
                           std::pair{Kind::Text, "text"}};

Kind kindFrom(const QString &name)
{
    for (const auto &[kind, each] : kinds) {
        if (name == QLatin1String(each))
            return kind;
    }
    return Kind::Number;
}

bool hasAnswers(Kind kind)
{
    return kind == Kind::One || kind == Kind::Several || kind == Kind::Order;
}

QStringList stringsOf(const QJsonValue &list)
{
    QStringList strings;
    for (const QJsonValue &each : list.toArray())
        strings.append(each.toString());
    return strings;
}

void readTolerance(Question &question, const QJsonValue &tolerance)
{
    question.tolerance = tolerance.toDouble();
    if (!tolerance.isString())
        return;
    question.toleranceExpression = tolerance.toString();
    const Result<double> number = evaluated(question.toleranceExpression, {}, question.unit);
    if (number)
        question.tolerance = *number;
}

void readRight(Question &question, const QJsonValue &right)
{
    if (question.kind == Kind::Number) {
        question.expression = right.toString();
        question.number = right.toDouble();
        if (const Result<double> number = evaluated(question.expression, {}, question.unit);
            right.isString() && number)
            question.number = *number;
        return;
    }
    const QJsonArray list = right.isArray() ? right.toArray() : QJsonArray{right};
    for (const QJsonValue &each : list) {
        if (each.isDouble())
            question.chosen.push_back(each.toInt() - 1);
    }
    std::sort(question.chosen.begin(), question.chosen.end());
    question.chosen.erase(std::unique(question.chosen.begin(), question.chosen.end()),
                          question.chosen.end());
}

} // namespace

QString nameOf(Question::Kind kind)
{
    const auto *found = std::find_if(kinds.begin(), kinds.end(),
                                     [&](const auto &each) { return each.first == kind; });
    return QString::fromLatin1(found->second);
}

std::vector<int> shownOrder(const Question &question)
{
    std::vector<std::pair<QByteArray, int>> keyed;
    for (int i = 0; i < static_cast<int>(question.answers.size()); ++i) {
        const QByteArray key = question.id.toUtf8() + '/' + QByteArray::number(i);
        keyed.emplace_back(QCryptographicHash::hash(key, QCryptographicHash::Sha256), i);
    }
    std::sort(keyed.begin(), keyed.end());
    std::vector<int> order;
    for (const auto &[key, index] : keyed)
        order.push_back(index);
    if (std::is_sorted(order.begin(), order.end()))
        std::reverse(order.begin(), order.end());
    return order;
}

Question questionFrom(const QJsonObject &json)
{
    const auto text = [&](const char *key) { return json.value(QLatin1String(key)).toString(); };
    Question question{.id = text("id"),
                      .kind = kindFrom(text("kind")),
                      .title = text("title"),
                      .text = text("text"),
                      .answers = stringsOf(json.value(QStringLiteral("answers"))),
                      .unit = text("unit"),
                      .points = json.value(QStringLiteral("points")).toDouble(1.0)};
    readTolerance(question, json.value(QStringLiteral("tolerance")));
    readRight(question, json.value(QStringLiteral("right")));
    return question;
}

QJsonObject jsonFrom(const Question &question)
{
    QJsonObject json = textsOf(question);
    json.insert(QStringLiteral("id"), question.id);
    json.insert(QStringLiteral("kind"), nameOf(question.kind));
    if (question.kind == Kind::Number) {
        json.insert(QStringLiteral("right"), question.expression.isEmpty()
                                                 ? QJsonValue(question.number)
                                                 : QJsonValue(question.expression));
        if (!question.toleranceExpression.isEmpty())
            json.insert(QStringLiteral("tolerance"), question.toleranceExpression);
        else if (question.tolerance != 0.0)
            json.insert(QStringLiteral("tolerance"), question.tolerance);
        if (!question.unit.isEmpty())
            json.insert(QStringLiteral("unit"), question.unit);
    } else if (question.kind == Kind::One) {
        json.insert(QStringLiteral("right"), question.chosen.empty() ? 0 : question.chosen[0] + 1);
    } else if (question.kind == Kind::Several) {
        QJsonArray right;
        for (const int each : question.chosen)
            right.append(each + 1);
        json.insert(QStringLiteral("right"), right);
    }
    if (question.points != 1.0)
        json.insert(QStringLiteral("points"), question.points);
    return json;
}

QJsonObject textsOf(const Question &question)
{
    QJsonObject json{{QStringLiteral("title"), question.title},
                     {QStringLiteral("text"), question.text}};
    if (hasAnswers(question.kind))
        json.insert(QStringLiteral("answers"), QJsonArray::fromStringList(question.answers));
    return json;
}

Question withTexts(Question question, const QJsonObject &texts)
{
    question.title = texts.value(QStringLiteral("title")).toString(question.title);
    question.text = texts.value(QStringLiteral("text")).toString(question.text);
    const QStringList answers = stringsOf(texts.value(QStringLiteral("answers")));
    if (answers.size() == question.answers.size())
        question.answers = answers;
    return question;
}

std::vector<Question> readQuestions(const QJsonObject &task, const QJsonObject &words)
{
    std::vector<Question> questions;
    const QJsonObject texts = words.value(QStringLiteral("questions")).toObject();
    for (const QJsonValue &each : task.value(QStringLiteral("questions")).toArray()) {
        const Question question = questionFrom(each.toObject());
        questions.push_back(withTexts(question, texts.value(question.id).toObject()));
    }
    return questions;
}

QString faultOf(const Question &question)
{
    const auto count = static_cast<int>(question.answers.size());
    if (hasAnswers(question.kind) && count < 2)
        return QuestionText::tr("a list of two to eight answers is right");
    const bool chosen = question.kind == Kind::One || question.kind == Kind::Several;
    if (chosen && question.chosen.empty())
        return QuestionText::tr("the right answers by their numbers from 1 are missing");
    if (chosen && (question.chosen.front() < 0 || question.chosen.back() >= count))
        return QuestionText::tr("a number from 1 to %1, for there are so many answers, is right")
            .arg(count);
    if (question.kind == Kind::One && question.chosen.size() != 1)
        return QuestionText::tr("one right answer; for more of them the kind is several");
    if (question.kind == Kind::Number && !unitFrom(question.unit))
        return QuestionText::tr("%1 is no unit; one like m/s, kg m/s, N s, J, ° or % is right")
            .arg(question.unit);
    if (question.kind == Kind::Number && question.tolerance < 0.0)
        return QuestionText::tr("Tolerance: a number from 0 is right");
    return {};
}

std::vector<Error> questionFaults(const QJsonObject &task)
{
    std::vector<Error> faults;
    QSet<QString> ids;
    for (const QJsonValue &check : task.value(QStringLiteral("checks")).toArray())
        ids.insert(check.toObject().value(QStringLiteral("id")).toString());
    const QJsonArray list = task.value(QStringLiteral("questions")).toArray();
    for (qsizetype i = 0; i < list.size(); ++i) {
        const QJsonObject json = list[i].toObject();
        const Question question = questionFrom(json);
        const QString place = QStringLiteral("/questions/%1").arg(i);
        const QJsonValue right = json.value(QStringLiteral("right"));
        if (ids.contains(question.id))
            faults.push_back({.message = QuestionText::tr("another check or question has the id %1 "
                                                          "already; an id of its own is right")
                                             .arg(question.id),
                              .pointer = place + QStringLiteral("/id")});
        ids.insert(question.id);
        const Result<double> number = evaluated(right.toString(), {}, question.unit);
        if (question.kind == Kind::Number && !right.isDouble() && !number)
            faults.push_back({.message = right.isString()
                                             ? number.error().message
                                             : QuestionText::tr("the right number is missing"),
                              .pointer = place + QStringLiteral("/right")});
        else if (const auto margin = evaluated(question.toleranceExpression, {}, question.unit);
                 !question.toleranceExpression.isEmpty() && !margin)
            faults.push_back({.message = margin.error().message,
                              .pointer = place + QStringLiteral("/tolerance")});
        else if (const QString fault = faultOf(question); !fault.isEmpty())
            faults.push_back({.message = fault, .pointer = place});
    }
    return faults;
}

} // namespace cradle
