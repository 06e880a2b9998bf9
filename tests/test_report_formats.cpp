// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report/report_formats.h"
#include "tasks/report/report_text.h"
#include "tests/reports.h"

#include <QTest>

using namespace cradle;
using namespace cradle::reports;

/// What people read of a verdict.
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
    void firstLineAndStartAreNamed_data();
    void firstLineAndStartAreNamed();
    void firstStepIsOneThatRan();
};

namespace {

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

/// Lines count from 1 and steps from 0, the start: neither is "nowhere".
void TestReportFormats::firstLineAndStartAreNamed_data()
{
    QTest::addColumn<QString>("format");
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("step");
    QTest::addColumn<QByteArray>("part");
    QTest::addColumn<bool>("named");
    const auto row = [](const char *format, int line, int step, const char *part, bool named) {
        QTest::addRow("%s, line %d, step %d: %s", format, line, step, part)
            << QString::fromLatin1(format) << line << step << QByteArray(part) << named;
    };
    row("text", 1, 0, "last assigned in that step by ada/lab.lua:1\n", true);
    row("text", 0, 0, "last assigned", false);
    row("text", 1, 0, "Look at ada/lab.lua:1\n", true);
    row("text", 0, 0, "Look at", false);
    row("tap", 1, 0, "  line: 1\n", true);
    row("tap", 0, 0, "  line:", false);
    row("tap", 1, 0, "  step: 0\n", true);
    row("tap", 1, -1, "  step:", false);
    row("json", 1, 0, "\"line\": 1,", true);
    row("json", 0, 0, "\"line\": 0,", false);
    row("json", 1, 0, "\"step\": 0,", true);
    row("json", 1, -1, "\"step\": -1,", false);
}

void TestReportFormats::firstLineAndStartAreNamed()
{
    QFETCH(QString, format);
    QFETCH(int, line);
    QFETCH(int, step);
    QFETCH(QByteArray, part);
    QFETCH(bool, named);
    CheckReport report = diagnosed();
    report.checks[1].line = line;
    report.checks[1].step = step;
    report.findings[0].line = line;
    const QByteArray text = inFormat(report, format);
    QVERIFY2(text.contains(part) == named, text);
}

/// The start is step 0: who stops there has not begun, or did not load.
void TestReportFormats::firstStepIsOneThatRan()
{
    CheckReport report = stopped();
    report.error->step = 1;
    QVERIFY(describeReport(report).contains(QStringLiteral("in step 1, at")));
    QVERIFY(verdictOf(report).endsWith(QStringLiteral("the program stopped")));
    report.error->step = 0;
    QVERIFY(!describeReport(report).contains(QStringLiteral("in step")));
    QVERIFY(verdictOf(report).endsWith(QStringLiteral("stopped before its first step")));
    report.error->kind = ProgramError::Kind::Syntax;
    QVERIFY(verdictOf(report).endsWith(QStringLiteral("the program does not load")));
}

QTEST_APPLESS_MAIN(TestReportFormats)
#include "test_report_formats.moc"
