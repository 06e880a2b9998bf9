// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report/report_json.h"
#include "tasks/report/report_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace cradle;

/// The report that graders read: its keys are a promise.
class TestReportJson : public QObject
{
    Q_OBJECT
private slots:
    void keysAreAlwaysThere_data();
    void keysAreAlwaysThere();
    void keysOfACheckAreAlwaysThere_data();
    void keysOfACheckAreAlwaysThere();
    void valuesAreThoseOfTheReport();
    void failedCheckSaysWhere();
    void whatIsUnknownIsNull();
    void numbersReadBack_data();
    void numbersReadBack();
    void pointsAreToldWhereTheyDiffer();
    void verdictSaysHowFarAProgramCame();
    void textsSurvive();
    void textReportListsEveryCheck();

private:
    static QJsonObject read(const CheckReport &report);
};

namespace {

CheckOutcome failed()
{
    return {.id = QStringLiteral("circle1-euler"),
            .title = QStringLiteral("Circle 1 still moves by Euler"),
            .passed = false,
            .message = QStringLiteral("At step 1 circle 1 moved"),
            .expected = -0.002725,
            .observed = 0.0,
            .unit = QStringLiteral("m"),
            .step = 1,
            .variant = QStringLiteral("preset")};
}

CheckReport report(bool passed)
{
    CheckReport made{.labId = QStringLiteral("lab-4.2"),
                     .labHash = QStringLiteral("0123abcd"),
                     .taskId = QStringLiteral("L42T5"),
                     .seed = 7,
                     .passed = passed,
                     .commit = QStringLiteral("L42T5 Integrating"),
                     .elapsedMs = 12};
    made.checks.push_back(
        {.id = QStringLiteral("walls"), .title = QStringLiteral("Walls"), .passed = true});
    if (!passed)
        made.checks.push_back(failed());
    return made;
}

} // namespace

QJsonObject TestReportJson::read(const CheckReport &report)
{
    QJsonParseError fault;
    const QJsonDocument document = QJsonDocument::fromJson(writeReport(report), &fault);
    if (fault.error != QJsonParseError::NoError)
        qWarning("%s", qPrintable(fault.errorString()));
    return document.object();
}

void TestReportJson::keysAreAlwaysThere_data()
{
    QTest::addColumn<bool>("passed");
    QTest::newRow("passed") << true;
    QTest::newRow("failed") << false;
}

void TestReportJson::keysAreAlwaysThere()
{
    QFETCH(bool, passed);
    const QJsonObject json = read(report(passed));
    for (const char *key : {"format", "lab", "lab_hash", "task", "seed", "passed", "checks",
                            "diagnosis", "remarks", "error", "elapsed_ms"})
        QVERIFY2(json.contains(QLatin1String(key)), key);
}

void TestReportJson::keysOfACheckAreAlwaysThere_data()
{
    QTest::addColumn<int>("index");
    QTest::newRow("passed") << 0;
    QTest::newRow("failed") << 1;
}

void TestReportJson::keysOfACheckAreAlwaysThere()
{
    QFETCH(int, index);
    const QJsonObject check =
        read(report(false)).value(QStringLiteral("checks")).toArray().at(index).toObject();
    for (const char *key :
         {"id", "title", "passed", "message", "expected", "observed", "unit", "step", "variant"})
        QVERIFY2(check.contains(QLatin1String(key)), key);
}

void TestReportJson::valuesAreThoseOfTheReport()
{
    const QJsonObject json = read(report(true));
    QCOMPARE(json.value(QStringLiteral("format")), QJsonValue(1));
    QCOMPARE(json.value(QStringLiteral("lab")), QJsonValue(QStringLiteral("lab-4.2")));
    QCOMPARE(json.value(QStringLiteral("lab_hash")), QJsonValue(QStringLiteral("0123abcd")));
    QCOMPARE(json.value(QStringLiteral("task")), QJsonValue(QStringLiteral("L42T5")));
    QCOMPARE(json.value(QStringLiteral("seed")), QJsonValue(7));
    QCOMPARE(json.value(QStringLiteral("passed")), QJsonValue(true));
    QCOMPARE(json.value(QStringLiteral("elapsed_ms")), QJsonValue(12));
    QCOMPARE(json.value(QStringLiteral("checks")).toArray().size(), 1);
    QVERIFY(json.value(QStringLiteral("diagnosis")).isNull());
    QVERIFY(json.value(QStringLiteral("error")).isNull());
    QVERIFY(json.value(QStringLiteral("remarks")).isArray());
}

void TestReportJson::failedCheckSaysWhere()
{
    const QJsonObject json = read(report(false));
    QCOMPARE(json.value(QStringLiteral("passed")), QJsonValue(false));
    const QJsonObject check = json.value(QStringLiteral("checks")).toArray().at(1).toObject();
    const QJsonObject wanted{
        {QStringLiteral("id"), QStringLiteral("circle1-euler")},
        {QStringLiteral("title"), QStringLiteral("Circle 1 still moves by Euler")},
        {QStringLiteral("passed"), false},
        {QStringLiteral("message"), QStringLiteral("At step 1 circle 1 moved")},
        {QStringLiteral("expected"), -0.002725},
        {QStringLiteral("observed"), 0.0},
        {QStringLiteral("unit"), QStringLiteral("m")},
        {QStringLiteral("step"), 1},
        {QStringLiteral("variant"), QStringLiteral("preset")}};
    for (auto key = wanted.begin(); key != wanted.end(); ++key)
        QCOMPARE(check.value(key.key()), key.value());
}

void TestReportJson::whatIsUnknownIsNull()
{
    CheckReport unknown = report(false);
    unknown.checks[1].expected.reset();
    unknown.checks[1].observed.reset();
    unknown.checks[1].step = -1;
    const QJsonObject check =
        read(unknown).value(QStringLiteral("checks")).toArray().at(1).toObject();
    for (const char *key : {"expected", "observed", "step"})
        QVERIFY2(check.value(QLatin1String(key)).isNull(), key);
}

void TestReportJson::numbersReadBack_data()
{
    QTest::addColumn<double>("number");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("tenth") << 0.1 << QByteArray("0.1");
    QTest::newRow("whole") << 3.0 << QByteArray("3");
    QTest::newRow("third") << 1.0 / 3.0 << QByteArray("0.3333333333333333");
    QTest::newRow("sum") << 0.1 + 0.2 << QByteArray("0.30000000000000004");
    QTest::newRow("small") << -0.002725 << QByteArray("-0.002725");
}

void TestReportJson::numbersReadBack()
{
    QFETCH(double, number);
    QFETCH(QByteArray, text);
    CheckReport made = report(false);
    made.checks[1].expected = number;
    QVERIFY2(writeReport(made).contains("\"expected\": " + text + ","), writeReport(made));
}

void TestReportJson::pointsAreToldWhereTheyDiffer()
{
    CheckReport made = report(false);
    const QByteArray alike = writeReport(made);
    QVERIFY(!alike.contains("points") && !alike.contains("score"));
    made.checks[0].points = 2.5;
    double all = 0.0;
    double reached = 0.0;
    for (const CheckOutcome &check : made.checks) {
        all += check.points;
        reached += check.passed ? check.points : 0.0;
    }
    const QJsonObject json = read(made);
    QCOMPARE(json.value(QStringLiteral("max_score")).toDouble(), all);
    QCOMPARE(json.value(QStringLiteral("score")).toDouble(), reached);
    QVERIFY(reached > 0.0 && reached < all);
    QCOMPARE(json.value(QStringLiteral("checks"))
                 .toArray()
                 .at(0)
                 .toObject()
                 .value(QStringLiteral("points"))
                 .toDouble(),
             2.5);
    QVERIFY(verdictOf(made).endsWith(QStringLiteral("(%1 of %2 points)").arg(reached).arg(all)));
}

void TestReportJson::verdictSaysHowFarAProgramCame()
{
    CheckReport made = report(false);
    made.error = ProgramError{.message = QStringLiteral("y is nothing"), .line = 2};
    QVERIFY(
        verdictOf(made).endsWith(QStringLiteral(": the program stopped before its first step")));
    made.error->step = 1;
    QVERIFY(verdictOf(made).endsWith(QStringLiteral(": the program stopped")));
    made.error->step = 0;
    made.error->kind = ProgramError::Kind::Syntax;
    QVERIFY(verdictOf(made).endsWith(QStringLiteral(": the program does not load")));
}

void TestReportJson::textsSurvive()
{
    const QString text = QStringLiteral("„größer“ \"quoted\" \\ \n\t −e · x₀ 🎱 </script>");
    CheckReport made = report(false);
    made.checks[1].message = text;
    const QJsonObject check = read(made).value(QStringLiteral("checks")).toArray().at(1).toObject();
    QCOMPARE(check.value(QStringLiteral("message")).toString(), text);
}

void TestReportJson::textReportListsEveryCheck()
{
    CheckReport made = report(false);
    made.checks[1].variant = QStringLiteral("throw 3");
    const QString text = describeReport(made);
    for (const char *part : {"Walls", "Circle 1 still moves by Euler", "At step 1 circle 1 moved",
                             "throw 3", "L42T5 did not pass"})
        QVERIFY2(text.contains(QLatin1String(part)), part);
    QVERIFY(describeReport(report(true)).contains(QStringLiteral("L42T5 passed")));
    QVERIFY(text.endsWith(QLatin1Char('\n')));
}

QTEST_APPLESS_MAIN(TestReportJson)
#include "test_report_json.moc"
