// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report/report_formats.h"
#include "tasks/report/report_text.h"
#include "tests/reports.h"
#include "tests/test_paths.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

using namespace cradle;
using namespace cradle::reports;

/// What people and graders read of a verdict.
class TestReportFormats : public QObject
{
    Q_OBJECT
private slots:
    void everyFormatHasAName();
    void explanationComesFirst_data();
    void explanationComesFirst();
    void remarksAreShown_data();
    void remarksAreShown();
    void textFitsTheTerminal_data();
    void textFitsTheTerminal();
    void textSaysWhereTheProgramStopped();
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

struct Run {
    int code = -1;
    QString out{};
};

Run runTool(const QString &program, const QStringList &arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    const bool ended = process.waitForFinished();
    return {ended && process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAll())};
}

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

void addReports()
{
    QTest::addColumn<CheckReport>("report");
    QTest::newRow("passed") << passed();
    QTest::newRow("passed with a remark") << remarked();
    QTest::newRow("failed") << failed();
    QTest::newRow("diagnosed") << diagnosed();
    QTest::newRow("does not load") << unloadable();
    QTest::newRow("stopped") << stopped();
    QTest::newRow("odd letters") << odd();
}

void addFormats()
{
    QTest::addColumn<QString>("format");
    for (const QString &name : reportFormatNames()) {
        if (name != QLatin1String("json"))
            QTest::newRow(qPrintable(name)) << name;
    }
}

QByteArray inFormat(const CheckReport &report, const QString &name)
{
    return writeReport(report, reportFormatFromName(name).value(), QStringLiteral("ada/lab.lua"));
}

} // namespace

void TestReportFormats::everyFormatHasAName()
{
    QCOMPARE(reportFormatNames().join(QLatin1Char(' ')),
             QStringLiteral("text json junit tap gradescope exercism github"));
    for (const QString &name : reportFormatNames())
        QVERIFY(!inFormat(failed(), name).isEmpty());
    QVERIFY(!reportFormatFromName(QStringLiteral("JSON")));
}

void TestReportFormats::explanationComesFirst_data()
{
    addFormats();
}

void TestReportFormats::explanationComesFirst()
{
    QFETCH(QString, format);
    const QByteArray text = inFormat(diagnosed(), format);
    const auto explanation = text.indexOf("Both circles switched");
    QVERIFY2(explanation >= 0, text);
    // Everything that only follows from it: the finding of the check.
    QVERIFY2(text.indexOf("At step 1") > explanation, text);
    const QByteArray broken = inFormat(unloadable(), format);
    QVERIFY2(broken.contains("lab.lua:3: "), broken);
    QVERIFY2(broken.indexOf("lab.lua:3: ") < broken.indexOf("not judged"), broken);
}

void TestReportFormats::remarksAreShown_data()
{
    addFormats();
}

void TestReportFormats::remarksAreShown()
{
    QFETCH(QString, format);
    const QByteArray text = inFormat(remarked(), format);
    QVERIFY2(text.contains("Your 4/3 is 1") && text.contains("Δt²"), text);
}

void TestReportFormats::textFitsTheTerminal_data()
{
    addReports();
}

void TestReportFormats::textFitsTheTerminal()
{
    QFETCH(CheckReport, report);
    const QString text = describeReport(report);
    for (const QString &line : text.split(QLatin1Char('\n'))) {
        QVERIFY2(line.size() <= terminalColumns, qPrintable(line));
        QVERIFY2(!line.endsWith(QLatin1Char(' ')), qPrintable(line));
    }
    QVERIFY(text.endsWith(QLatin1Char('\n')) && !text.startsWith(QLatin1Char('\n')));
}

void TestReportFormats::textSaysWhereTheProgramStopped()
{
    const QString text = describeReport(stopped(), QStringLiteral("ada/lab.lua"));
    QVERIFY2(text.startsWith(QStringLiteral("  ada/lab.lua:12: `speed` is nil")), qPrintable(text));
    for (const char *part : {"in step 40, at 0.65 s", "with dt = 0.0166667", "  ok    Walls",
                             "  error Circle 1", "L42T5 did not pass: the program stopped"})
        QVERIFY2(text.contains(QLatin1String(part)), part);
}

void TestReportFormats::junitFitsTheSchema_data()
{
    addReports();
}

void TestReportFormats::junitFitsTheSchema()
{
    QFETCH(CheckReport, report);
    const QString file = written(m_folder, "report.xml", writeJUnit(report, {}));
    const Run run =
        runTool(QStringLiteral("xmllint"), {QStringLiteral("--noout"), QStringLiteral("--schema"),
                                            fixturePath("junit-10.xsd"), file});
    QVERIFY2(run.code == 0, qPrintable(run.out));
}

void TestReportFormats::junitCountsAndRepeatsTheMessage()
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

void TestReportFormats::junitErrorIsNoFailure()
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

void TestReportFormats::proveReadsTap_data()
{
    addReports();
}

void TestReportFormats::proveReadsTap()
{
    QFETCH(CheckReport, report);
    const QByteArray tap = writeTap(report, {});
    QVERIFY2(tap.startsWith("TAP version 13\n1..2\n"), tap);
    const QString file = written(m_folder, "report.tap", tap);
    const Run run =
        runTool(QStringLiteral("prove"),
                {QStringLiteral("--comments"), QStringLiteral("-e"), QStringLiteral("cat"), file});
    QVERIFY2(run.code == (report.passed ? 0 : 1), qPrintable(run.out));
    QVERIFY2(!run.out.contains(QStringLiteral("Parse errors")), qPrintable(run.out));
    QVERIFY2(run.out.contains(QStringLiteral("Tests=2,")), qPrintable(run.out));
    const qsizetype failures = 2 - passedCount(report);
    if (failures > 0)
        QVERIFY2(run.out.contains(QStringLiteral("Failed: %1)").arg(failures)),
                 qPrintable(run.out));
}

void TestReportFormats::tapTitleIsNoDirective()
{
    // "# TODO" would turn a failure into something that is expected.
    CheckReport report = failed();
    report.checks[1].title = QStringLiteral("Circle # TODO later\nok 3");
    const QByteArray tap = writeTap(report, {});
    QVERIFY2(tap.contains("not ok 2 - Circle \\# TODO later ok 3\n"), tap);
    QVERIFY2(tap.contains("  expected: -0.002725\n  observed: 0\n  unit: \"m\"\n"), tap);
}

void TestReportFormats::gradescopeGivesAPointForEachCheck()
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

void TestReportFormats::exercismFollowsItsVersion3_data()
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

void TestReportFormats::exercismFollowsItsVersion3()
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

QTEST_APPLESS_MAIN(TestReportFormats)
#include "test_report_formats.moc"
