// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/unit.h"
#include "speed_question.h"
#include "tasks/grading/judging_request.h"
#include "tasks/questions/answers.h"

#include <QJsonArray>
#include <QTest>

#include <numbers>

using namespace cradle;

/// Answers to questions that count beside the checks, judged.
class TestQuestions : public QObject
{
    Q_OBJECT
private slots:
    void unitsAreWhatTheyAreMadeOf_data();
    void unitsAreWhatTheyAreMadeOf();
    void numberIsJudgedWithItsUnit_data();
    void numberIsJudgedWithItsUnit();
    void answerIsToldInTheUnitThatIsAskedFor();
    void choicesAndOrdersAreJudged_data();
    void choicesAndOrdersAreJudged();
    void orderIsNeverShownRight();
};

void TestQuestions::unitsAreWhatTheyAreMadeOf_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("known");
    QTest::addColumn<double>("scale");
    QTest::addColumn<QList<int>>("powers"); // of m, kg and s
    QTest::newRow("none") << QStringLiteral("") << true << 1.0 << QList<int>{0, 0, 0};
    QTest::newRow("km/h") << QStringLiteral("km/h") << true << 1000.0 / 3600.0
                          << QList<int>{1, 0, -1};
    QTest::newRow("raised") << QStringLiteral("m/s\u00b2") << true << 1.0 << QList<int>{1, 0, -2};
    QTest::newRow("caret") << QStringLiteral("m s^-2") << true << 1.0 << QList<int>{1, 0, -2};
    QTest::newRow("newton second")
        << QStringLiteral("N\u00b7s") << true << 1.0 << QList<int>{1, 1, -1};
    QTest::newRow("momentum") << QStringLiteral("kg*m/s") << true << 1.0 << QList<int>{1, 1, -1};
    QTest::newRow("gram") << QStringLiteral("mg") << true << 1e-6 << QList<int>{0, 1, 0};
    QTest::newRow("minute, not milli-inch")
        << QStringLiteral("min") << true << 60.0 << QList<int>{0, 0, 1};
    QTest::newRow("two slashes") << QStringLiteral("J/kg/s") << true << 1.0 << QList<int>{2, 0, -3};
    QTest::newRow("degree") << QStringLiteral("\u00b0") << true << std::numbers::pi / 180.0
                            << QList<int>{0, 0, 0};
    QTest::newRow("no unit") << QStringLiteral("furlong") << false << 0.0 << QList<int>{};
    QTest::newRow("half a unit") << QStringLiteral("m/") << false << 0.0 << QList<int>{};
    QTest::newRow("empty power") << QStringLiteral("m^") << false << 0.0 << QList<int>{};
}

void TestQuestions::unitsAreWhatTheyAreMadeOf()
{
    QFETCH(QString, text);
    QFETCH(bool, known);
    const auto unit = unitFrom(text);
    QCOMPARE(unit.has_value(), known);
    if (!known)
        return;
    QTEST(unit->scale, "scale");
    QTEST(QList<int>(unit->powers.begin(), unit->powers.end()), "powers");
}

void TestQuestions::numberIsJudgedWithItsUnit_data()
{
    QTest::addColumn<QString>("answer");
    QTest::addColumn<QString>("said"); // empty: right
    QTest::newRow("right") << QStringLiteral("20 m/s") << QStringLiteral("");
    QTest::newRow("within the tolerance") << QStringLiteral("19.91m/s") << QStringLiteral("");
    QTest::newRow("beyond it") << QStringLiteral("19.89 m/s")
                               << QStringLiteral("19.89 m/s is not right");
    QTest::newRow("comma") << QStringLiteral("20,05 m/s") << QStringLiteral("");
    QTest::newRow("other unit, converted") << QStringLiteral("72 km/h") << QStringLiteral("");
    QTest::newRow("right number, other scale")
        << QStringLiteral("20 km/h") << QStringLiteral("the number is right, but not in km/h");
    QTest::newRow("right number, no unit")
        << QStringLiteral("20") << QStringLiteral("the number is right; its unit is missing");
    QTest::newRow("right number, other kind")
        << QStringLiteral("20 m")
        << QStringLiteral(
               "the number is right, but not its unit: what is asked for is not measured in m");
    QTest::newRow("wrong number, other kind")
        << QStringLiteral("3 m") << QStringLiteral("is not measured in m");
    QTest::newRow("wrong number, no unit")
        << QStringLiteral("3") << QStringLiteral("3 is not right, and its unit is missing");
    QTest::newRow("unknown unit") << QStringLiteral("20 knots")
                                  << QStringLiteral("is no unit that is known");
    QTest::newRow("no number") << QStringLiteral("fast")
                               << QStringLiteral("is no number with a unit");
    QTest::newRow("nothing") << QStringLiteral("  ") << QStringLiteral("not answered yet");
}

void TestQuestions::numberIsJudgedWithItsUnit()
{
    QFETCH(QString, answer);
    QFETCH(QString, said);
    const auto outcome = judgeAnswers({speed()}, {{QStringLiteral("speed"), answer}}).front();
    QCOMPARE(outcome.passed, said.isEmpty());
    QVERIFY2(outcome.message.contains(said), qPrintable(outcome.message));
    QVERIFY(!outcome.expected); // what is right is not told
    QVERIFY(outcome.question && !outcome.forTeacher);
}

void TestQuestions::answerIsToldInTheUnitThatIsAskedFor()
{
    Question question = speed();
    question.unit = QStringLiteral("km/h");
    question.number = 72.0;
    const auto outcome =
        judgeAnswers({question}, {{QStringLiteral("speed"), QStringLiteral("20 m/s")}}).front();
    QVERIFY2(outcome.passed, qPrintable(outcome.message));
    QVERIFY(outcome.observed && std::abs(*outcome.observed - 72.0) < 1e-9);
    QCOMPARE(outcome.unit, QStringLiteral("km/h"));
}

void TestQuestions::choicesAndOrdersAreJudged_data()
{
    using Kind = Question::Kind;
    QTest::addColumn<int>("kind");
    QTest::addColumn<QJsonValue>("answer");
    QTest::addColumn<QString>("said");
    QTest::newRow("the one") << int(Kind::One) << QJsonValue(1) << QStringLiteral("");
    QTest::newRow("another") << int(Kind::One) << QJsonValue(2) << QStringLiteral("is not right");
    QTest::newRow("none there is")
        << int(Kind::One) << QJsonValue(9) << QStringLiteral("not answered yet");
    QTest::newRow("all") << int(Kind::Several) << QJsonValue(QJsonArray{3, 1})
                         << QStringLiteral("");
    QTest::newRow("twice the same") << int(Kind::Several) << QJsonValue(QJsonArray{1, 1})
                                    << QStringLiteral("not all that is right is chosen");
    QTest::newRow("one too many") << int(Kind::Several) << QJsonValue(QJsonArray{1, 2, 3})
                                  << QStringLiteral("one that is chosen is not right");
    QTest::newRow("wrong and missing") << int(Kind::Several) << QJsonValue(QJsonArray{2, 3})
                                       << QStringLiteral("and a right one is missing");
    QTest::newRow("in order") << int(Kind::Order) << QJsonValue(QJsonArray{1, 2, 3})
                              << QStringLiteral("");
    QTest::newRow("end swapped") << int(Kind::Order) << QJsonValue(QJsonArray{1, 3, 2})
                                 << QStringLiteral("right up to number 1");
    QTest::newRow("reversed") << int(Kind::Order) << QJsonValue(QJsonArray{3, 2, 1})
                              << QStringLiteral("does not begin");
    QTest::newRow("text") << int(Kind::Text) << QJsonValue(QStringLiteral("Because."))
                          << QStringLiteral(
                                 "for the teacher to read, who may give up to 1 points: Because.");
    QTest::newRow("no text") << int(Kind::Text) << QJsonValue(QStringLiteral(""))
                             << QStringLiteral("not answered yet");
}

void TestQuestions::choicesAndOrdersAreJudged()
{
    QFETCH(int, kind);
    QFETCH(QJsonValue, answer);
    QFETCH(QString, said);
    Question question{.id = QStringLiteral("q"),
                      .kind = static_cast<Question::Kind>(kind),
                      .title = QStringLiteral("Q"),
                      .text = {},
                      .answers = {QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")}};
    question.chosen = {0};
    if (question.kind == Question::Kind::Several)
        question.chosen = {0, 2};
    const auto outcome = judgeAnswers({question}, {{QStringLiteral("q"), answer}}).front();
    const bool forTeacher = question.kind == Question::Kind::Text;
    QCOMPARE(outcome.passed,
             said.isEmpty() || (forTeacher && answer.toString() != QStringLiteral("")));
    QCOMPARE(outcome.forTeacher, forTeacher);
    QVERIFY2(outcome.message.contains(said), qPrintable(outcome.message));
}

void TestQuestions::orderIsNeverShownRight()
{
    for (int i = 0; i < 50; ++i) {
        const Question question{.id = QString::number(i),
                                .kind = Question::Kind::Order,
                                .title = {},
                                .text = {},
                                .answers = {QStringLiteral("a"), QStringLiteral("b")}};
        QCOMPARE(shownOrder(question), (std::vector<int>{1, 0}));
    }
}

QTEST_GUILESS_MAIN(TestQuestions)

#include "test_questions.moc"
