// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report/report_formats.h"
#include "tasks/report/report_text.h"
#include "tests/reports.h"
#include "tests/test_paths.h"
#include "tests/tool_run.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

using namespace cradle;
using namespace cradle::reports;

/// What graders read of a verdict; each is read back by a program of its kind.
class TestGraderReports : public QObject
{
    Q_OBJECT
private slots:
    void junitFitsTheSchema_data();
    void junitFitsTheSchema();
    void junitCountsAndRepeatsTheMessage();
    void junitErrorIsNoFailure();
    void proveReadsTap_data();
    void proveReadsTap();
    void tapTitleIsNoDirective();
    void gradescopeGivesAPointForEachCheck();
    void exercismFollowsItsVersion3_data();
    void exercismFollowsItsVersion3();

private:
    QTemporaryDir m_folder;
};

namespace {

QString written(const QTemporaryDir &folder, const char *name, const QByteArray &text)
{
    QFile file(folder.filePath(QLatin1String(name)));
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? file.fileName()
                                                                              : QString();
}

QJsonObject parsed(const QByteArray &text)
{
    return QJsonDocument::fromJson(text).object();
}

/// The failed and broken test cases of a JUnit file: element, type, message, text.
struct Case {
    QString name{};
    QString element{};
    QString type{};
    QString message{};
    QString text{};
};

std::vector<Case> casesOf(const QByteArray &xml)
{
    std::vector<Case> cases;
    for (QXmlStreamReader reader(xml); !reader.atEnd();) {
        if (!reader.readNextStartElement() && !reader.isStartElement())
            continue;
        const QXmlStreamAttributes attributes = reader.attributes();
        if (reader.name() == u"testcase")
            cases.push_back({.name = attributes.value(QLatin1String("name")).toString()});
        if (reader.name() != u"failure" && reader.name() != u"error")
            continue;
        cases.back().element = reader.name().toString();
        cases.back().type = attributes.value(QLatin1String("type")).toString();
        cases.back().message = attributes.value(QLatin1String("message")).toString();
        cases.back().text = reader.readElementText();
    }
    return cases;
}

} // namespace

void TestGraderReports::junitFitsTheSchema_data()
{
    addReports();
}

void TestGraderReports::junitFitsTheSchema()
{
    QFETCH(CheckReport, report);
    const QString file = written(m_folder, "report.xml", writeJUnit(report, {}));
    const ToolRun run =
        runTool(QStringLiteral("xmllint"), {QStringLiteral("--noout"), QStringLiteral("--schema"),
                                            fixturePath("junit-10.xsd"), file});
    QVERIFY2(run.code == 0, run.out);
}

void TestGraderReports::junitCountsAndRepeatsTheMessage()
{
    const QByteArray xml = writeJUnit(failed(), {});
    QVERIFY2(xml.contains(R"(name="L42T5" tests="2" failures="1" errors="0" time="0.012")"), xml);
    const std::vector<Case> cases = casesOf(xml);
    QCOMPARE(cases.size(), std::size_t{2});
    QCOMPARE(cases[0].name, QStringLiteral("Walls"));
    QVERIFY(cases[0].element.isEmpty());
    QCOMPARE(cases[1].element, QStringLiteral("failure"));
    QCOMPARE(cases[1].type, QStringLiteral("circle1-euler"));
    QVERIFY(cases[1].message.startsWith(QStringLiteral("At step 1 circle 1 moved")));
    QCOMPARE(cases[1].text, cases[1].message);
}

void TestGraderReports::junitErrorIsNoFailure()
{
    const QByteArray xml = writeJUnit(unloadable(), QStringLiteral("lab.lua"));
    QVERIFY2(xml.contains(R"(failures="0" errors="2")"), xml);
    const std::vector<Case> cases = casesOf(xml);
    QCOMPARE(cases.size(), std::size_t{2});
    for (const Case &broken : cases) {
        QCOMPARE(broken.element, QStringLiteral("error"));
        QCOMPARE(broken.type, QStringLiteral("syntax"));
        QCOMPARE(broken.text, broken.message);
    }
    QVERIFY(cases[0].message.startsWith(QStringLiteral("lab.lua:3: unexpected symbol")));
    // What passed before the program stopped, passed.
    const std::vector<Case> later = casesOf(writeJUnit(stopped(), {}));
    QVERIFY(later[0].element.isEmpty());
    QCOMPARE(later[1].message, QStringLiteral("lab.lua:12: `speed` is nil, not a number"));
}

void TestGraderReports::proveReadsTap_data()
{
    addReports();
}

void TestGraderReports::proveReadsTap()
{
    QFETCH(CheckReport, report);
    const QByteArray tap = writeTap(report, {});
    QVERIFY2(tap.startsWith("TAP version 13\n1..2\n"), tap);
    const QString file = written(m_folder, "report.tap", tap);
    const ToolRun run =
        runTool(QStringLiteral("prove"),
                {QStringLiteral("--comments"), QStringLiteral("-e"), QStringLiteral("cat"), file});
    QVERIFY2(run.code == (report.passed ? 0 : 1), run.out);
    QVERIFY2(!run.out.contains("Parse errors"), run.out);
    QVERIFY2(run.out.contains("Tests=2,"), run.out);
    const qsizetype failures = 2 - passedCount(report);
    if (failures > 0)
        QVERIFY2(run.out.contains(QStringLiteral("Failed: %1)").arg(failures).toUtf8()), run.out);
}

void TestGraderReports::tapTitleIsNoDirective()
{
    // "# TODO" would turn a failure into something that is expected.
    CheckReport report = failed();
    report.checks[1].title = QStringLiteral("Circle # TODO later\nok 3");
    const QByteArray tap = writeTap(report, {});
    QVERIFY2(tap.contains("not ok 2 - Circle \\# TODO later ok 3\n"), tap);
    QVERIFY2(tap.contains("  expected: -0.002725\n  observed: 0\n  unit: \"m\"\n"), tap);
}

void TestGraderReports::gradescopeGivesAPointForEachCheck()
{
    const QJsonObject json = parsed(writeGradescope(diagnosed(), QStringLiteral("a/lab.lua")));
    QCOMPARE(json.value(QStringLiteral("score")), QJsonValue(1));
    QCOMPARE(json.value(QStringLiteral("output_format")).toString(), QStringLiteral("md"));
    QVERIFY(json.value(QStringLiteral("output"))
                .toString()
                .startsWith(QStringLiteral("Both circles switched")));
    const QJsonArray tests = json.value(QStringLiteral("tests")).toArray();
    QCOMPARE(tests.size(), 2);
    for (int i = 0; i < 2; ++i) {
        const QJsonObject test = tests.at(i).toObject();
        QCOMPARE(test.value(QStringLiteral("max_score")), QJsonValue(1));
        QCOMPARE(test.value(QStringLiteral("score")), QJsonValue(1 - i));
        QCOMPARE(test.value(QStringLiteral("status")).toString(),
                 i == 0 ? QStringLiteral("passed") : QStringLiteral("failed"));
        QCOMPARE(test.value(QStringLiteral("output_format")).toString(), QStringLiteral("text"));
        QVERIFY(!test.value(QStringLiteral("name")).toString().isEmpty());
        QCOMPARE(test.value(QStringLiteral("output")).toString().isEmpty(), i == 0);
    }
    CheckReport worth = diagnosed();
    worth.checks[0].points = 2.5;
    const QJsonObject scored = parsed(writeGradescope(worth, {}));
    QCOMPARE(scored.value(QStringLiteral("score")), QJsonValue(2.5));
    const QJsonObject first = scored.value(QStringLiteral("tests")).toArray().at(0).toObject();
    QCOMPARE(first.value(QStringLiteral("max_score")), QJsonValue(2.5));
    QCOMPARE(first.value(QStringLiteral("score")), QJsonValue(2.5));
    QCOMPARE(parsed(writeGradescope(unloadable(), {})).value(QStringLiteral("score")),
             QJsonValue(0));
    QCOMPARE(parsed(writeGradescope(passed(), {})).value(QStringLiteral("score")), QJsonValue(2));
}

void TestGraderReports::exercismFollowsItsVersion3_data()
{
    QTest::addColumn<CheckReport>("report");
    QTest::addColumn<QString>("status");
    QTest::addColumn<QString>("tests");
    const auto row = [](const char *name, const CheckReport &report, const char *status,
                        const char *tests) {
        QTest::newRow(name) << report << QString::fromLatin1(status) << QString::fromLatin1(tests);
    };
    row("passed", passed(), "pass", "pass pass");
    row("failed", failed(), "fail", "pass fail");
    row("stopped in the second check", stopped(), "fail", "pass error");
    row("does not load", unloadable(), "error", "error error");
}

void TestGraderReports::exercismFollowsItsVersion3()
{
    QFETCH(CheckReport, report);
    QFETCH(QString, status);
    QFETCH(QString, tests);
    const QJsonObject json = parsed(writeExercism(report, QStringLiteral("/tmp/in/lab.lua")));
    QCOMPARE(json.value(QStringLiteral("version")), QJsonValue(3));
    QCOMPARE(json.value(QStringLiteral("status")).toString(), status);
    QStringList found;
    for (const QJsonValue &test : json.value(QStringLiteral("tests")).toArray()) {
        found.append(test[u"status"].toString());
        QCOMPARE(test[u"message"].toString().isEmpty(), found.last() == QLatin1String("pass"));
    }
    QCOMPARE(found.join(QLatin1Char(' ')), tests);
    // Without the folders of the grader.
    QCOMPARE(json.value(QStringLiteral("message")).toString(),
             status == QLatin1String("error")
                 ? QStringLiteral("lab.lua:3: unexpected symbol near '='")
                 : QString());
}

QTEST_APPLESS_MAIN(TestGraderReports)
#include "test_grader_reports.moc"
