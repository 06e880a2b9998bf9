// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_labs.h"
#include "tests/lab_with_values.h"

#include "model/files/expression.h"
#include "model/files/unit.h"
#include "tasks/questions/answers.h"

#include <QJsonArray>
#include <QTest>

using namespace cradle;
using approved::u;
using approved::verifyLabs;

/// What expressions with units are worth, how answers are judged, and which values each student
/// gets, whole: tests/approved/labs.
class TestApprovedNumbers : public QObject
{
    Q_OBJECT
private slots:
    void numbersAreAsApproved();
    void answersAreAsApproved();
    void drawnValuesAreAsApproved();
};

namespace {

QString shortest(double value)
{
    return QString::number(value, 'g', 12);
}

} // namespace

void TestApprovedNumbers::numbersAreAsApproved()
{
    QString all;
    const QMap<QString, double> values{{u("k"), 0.75}, {u("mass"), 2.0}};
    const QStringList lines = approved::read(QStringLiteral("labs/expressions.txt"))
                                  .split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QVERIFY(lines.size() > 60);
    for (const QString &line : lines) {
        const QString text = line.section(u(" in "), 0, 0);
        const auto value = evaluated(text, values, line.section(u(" in "), 1));
        const auto quantity = quantityFrom(text);
        const auto unit = unitFrom(text);
        all += line + QStringLiteral(" = ") + (value ? shortest(*value) : value.error().toString());
        if (quantity)
            all += QStringLiteral(" | %1 %2").arg(shortest(quantity->number), quantity->unit);
        if (unit)
            all += QStringLiteral(" | %1 m%2 kg%3 s%4")
                       .arg(shortest(unit->scale))
                       .arg(unit->powers[0])
                       .arg(unit->powers[1])
                       .arg(unit->powers[2]);
        all += QLatin1Char('\n');
    }
    verifyLabs("numbers.txt", all);
}

void TestApprovedNumbers::answersAreAsApproved()
{
    using Kind = Question::Kind;
    const std::vector<Question> questions{
        {.id = u("speed"),
         .kind = Kind::Number,
         .title = u("Speed"),
         .text = {},
         .number = 20.0,
         .tolerance = 0.1,
         .unit = u("m/s")},
        {.id = u("share"),
         .kind = Kind::Number,
         .title = u("Share"),
         .text = {},
         .number = 0.5,
         .tolerance = 0.01},
        {.id = u("one"),
         .kind = Kind::One,
         .title = u("One"),
         .text = {},
         .answers = {u("a"), u("b"), u("c")},
         .chosen = {1}},
        {.id = u("several"),
         .kind = Kind::Several,
         .title = u("Several"),
         .text = {},
         .answers = {u("a"), u("b"), u("c")},
         .chosen = {0, 2}},
        {.id = u("order"),
         .kind = Kind::Order,
         .title = u("Order"),
         .text = {},
         .answers = {u("a"), u("b"), u("c")}},
        {.id = u("text"), .kind = Kind::Text, .title = u("Text"), .text = {}, .points = 3.0}};
    const QJsonArray given{QJsonObject(),
                           rightAnswers(questions),
                           QJsonObject{{u("speed"), u("72 km/h")},
                                       {u("share"), u("50 %")},
                                       {u("one"), 3},
                                       {u("several"), QJsonArray{1}},
                                       {u("order"), QJsonArray{2, 1, 3}},
                                       {u("text"), u("because")}},
                           QJsonObject{{u("speed"), u("20.1 m/s")},
                                       {u("share"), u("0.512")},
                                       {u("one"), 0},
                                       {u("several"), QJsonArray{1, 2, 3}},
                                       {u("order"), QJsonArray{1, 2}},
                                       {u("text"), u("")}},
                           QJsonObject{{u("speed"), u("20.11 m/s")},
                                       {u("share"), u("0,49")},
                                       {u("one"), u("b")},
                                       {u("several"), QJsonArray{3, 1}},
                                       {u("order"), QJsonArray{3, 2, 1}},
                                       {u("text"), u("x\ny")}},
                           QJsonObject{{u("speed"), u("20 kg")},
                                       {u("share"), u("0.5 m")},
                                       {u("one"), 2},
                                       {u("several"), u("a")},
                                       {u("order"), 5},
                                       {u("text"), 7}},
                           QJsonObject{{u("speed"), u("20")},
                                       {u("share"), u("half")},
                                       {u("one"), 4},
                                       {u("several"), QJsonArray{4}},
                                       {u("order"), QJsonArray{1, 2, 9}}}};
    QString all;
    for (const QJsonValue &each : given) {
        for (const CheckOutcome &outcome : judgeAnswers(questions, each.toObject()))
            all += QStringLiteral("%1 %2 %3 %4 %5 | %6\n")
                       .arg(outcome.id)
                       .arg(int(outcome.passed))
                       .arg(outcome.points)
                       .arg(int(outcome.forTeacher))
                       .arg(outcome.unit, outcome.message);
        for (const Question &question : questions)
            all += answerText(question, each.toObject().value(question.id)) + QLatin1Char('\n');
    }
    verifyLabs("answers.txt", all);
}

void TestApprovedNumbers::drawnValuesAreAsApproved()
{
    const LabFiles files =
        labWith(values({{u("k"), range},
                        {u("n"), QJsonObject{{u("from"), 1}, {u("to"), 6}, {u("step"), 1}}},
                        {u("both"), u("k * n + 1")}}),
                "k is {{k}}, n is {{n}}, both are {{both}}, once {{ k }}.\n");
    QString all;
    for (int student = 0; student < 40; ++student) {
        const QString number = student == 0 ? QString() : QString::number(1000 + 37 * student);
        std::vector<Error> faults;
        const Values drawn = valuesOf(files, u("S1"), number, &faults);
        for (auto it = drawn.cbegin(); it != drawn.cend(); ++it)
            all += QStringLiteral("%1 %2; ").arg(it.key(), shortest(it.value()));
        all += textOf(withValues(files, number, &faults), u("S1/instructions.md"));
        for (const Error &fault : faults)
            all += fault.toString() + QLatin1Char('\n');
    }
    verifyLabs("drawn.txt", all);
}

QTEST_GUILESS_MAIN(TestApprovedNumbers)
#include "test_approved_numbers.moc"
