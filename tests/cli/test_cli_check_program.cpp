// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/program_run.h"
#include "tests/patience.h"
#include "tests/test_paths.h"

#include <QJsonDocument>
#include <QJsonObject>

using namespace cradle::programs;

/// cradle-cli check with a student's program.
class TestCliCheckProgram : public QObject
{
    Q_OBJECT
private slots:
    void programIsJudged_data();
    void programIsJudged();
    void stepOfTheOtherLabNeedsNoFolder();
    void programThatStopsIsAnError_data();
    void programThatStopsIsAnError();
    void programThatIsNotThereIsRefused_data();
    void programThatIsNotThereIsRefused();
    void unreadableProgramGetsAReport_data();
    void unreadableProgramGetsAReport();
    void programMayComeFromStandardInput();
    void everyFormatIsWritten_data();
    void everyFormatIsWritten();
    void programRunsInTheGivenScene();

private:
    QTemporaryDir m_folder;
};

namespace {

QString step1(const char *file)
{
    return cradle::sourcePath("tasks/labs/lab-4.2/L42T1/") + QLatin1String(file);
}

QJsonObject reportOf(const Outcome &outcome)
{
    return QJsonDocument::fromJson(outcome.out.toUtf8()).object();
}

} // namespace

void TestCliCheckProgram::programIsJudged_data()
{
    QTest::addColumn<QByteArray>("program");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("mistake");
    QTest::newRow("right") << contentOf(step1("solution.lua")) << 0 << QString();
    QTest::newRow("empty") << QByteArray() << 1 << QString();
    QTest::newRow("known mistake")
        << QByteArray("function on_load() circle1.velocity = vec(2, 0) end\n"
                      "function on_update(timestep)\n"
                      "  circle1.position = circle1.position + 2 * circle1.velocity * timestep\n"
                      "end\n")
        << 1 << text("moved-twice");
}

void TestCliCheckProgram::programIsJudged()
{
    QFETCH(QByteArray, program);
    QFETCH(int, code);
    QFETCH(QString, mistake);
    const Outcome outcome =
        runCli({text("check"), text("L42T1"), written(m_folder, "lab.lua", program),
                text("--format"), text("json")});
    VERIFY_CODE(outcome, code);
    QVERIFY(outcome.error.isEmpty());
    const QJsonObject report = reportOf(outcome);
    QCOMPARE(report.value(text("passed")), QJsonValue(code == 0));
    QVERIFY(report.value(text("error")).isNull());
    if (!mistake.isEmpty())
        QCOMPARE(report.value(text("diagnosis"))[u"mistake"].toString(), mistake);
}

/// Its id says which of the shipped labs is meant.
void TestCliCheckProgram::stepOfTheOtherLabNeedsNoFolder()
{
    const QString solution = cradle::sourcePath("tasks/labs/bouncing-ball/BALL2/solution.lua");
    const Outcome outcome =
        runCli({text("check"), text("BALL2"), solution, text("--format"), text("json")});
    VERIFY_CODE(outcome, 0);
    QCOMPARE(reportOf(outcome).value(text("lab")).toString(), text("bouncing-ball"));
    VERIFY_CODE(runCli({text("check"), text("BALL9"), solution}), 2);
}

void TestCliCheckProgram::programThatStopsIsAnError_data()
{
    QTest::addColumn<QByteArray>("program");
    QTest::addColumn<QString>("kind");
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("step");
    const auto row = [](const char *name, const QByteArray &program, const char *kind, int line,
                        int step) { QTest::newRow(name) << program << text(kind) << line << step; };
    row("syntax", "function on_update(dt)\n  local x = = 1\nend\n", "syntax", 2, 0);
    row("in the file itself", "\n\nlocal x = nil + 1\n", "runtime", 3, 0);
    row("in on_load", "function on_load()\n  speed = mass.x\nend\n", "runtime", 2, 0);
    row("in the first step", "function on_update(dt)\n  error(\"no\")\nend\n", "runtime", 2, 1);
    row("in a later step",
        "function on_load() circle1.velocity = vec(2, 0) end\n"
        "function on_update(dt)\n"
        "  circle1.position = circle1.position + circle1.velocity * dt\n"
        "  if step > 20 then\n    error(\"no\")\n  end\nend\n",
        "runtime", 5, 22);
    row("endless", "function on_update(dt)\n  while true do end\nend\n", "time", 2, 1);
    row("memory", "t = {}\nfor i = 1, 1e9 do t[i] = {i} end\n", "memory", 2, 0);
}

void TestCliCheckProgram::programThatStopsIsAnError()
{
    QFETCH(QByteArray, program);
    QFETCH(QString, kind);
    QFETCH(int, line);
    QFETCH(int, step);
    const QString path = written(m_folder, "lab.lua", program);
    const Outcome outcome =
        runCli({text("check"), text("L42T1"), path, text("--format"), text("json")});
    VERIFY_CODE(outcome, 1);
    const QJsonObject report = reportOf(outcome);
    QCOMPARE(report.value(text("passed")), QJsonValue(false));
    QVERIFY(report.value(text("diagnosis")).isNull());
    const QJsonObject error = report.value(text("error")).toObject();
    QCOMPARE(error.value(text("kind")).toString(), kind);
    if (kind != QLatin1String("memory")) // any line may be the one too many
        QCOMPARE(error.value(text("line")).toInt(), line);
    QCOMPARE(error.value(text("step")).toInt(), step);
    const QString message = error.value(text("message")).toString();
    QVERIFY(!message.isEmpty());
    QVERIFY2(outcome.error.startsWith(path + text(":")) && outcome.error.contains(message),
             outcome.toText().constData());
}

void TestCliCheckProgram::programThatIsNotThereIsRefused_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("place"); ///< after the path
    QTest::newRow("missing") << text("nowhere.lua") << text(": ");
    QTest::newRow("folder") << step1("") << text(": ");
}

void TestCliCheckProgram::programThatIsNotThereIsRefused()
{
    QFETCH(QString, path);
    QFETCH(QString, place);
    const Outcome outcome = runCli({text("check"), text("L42T1"), path, text("--exit-zero")});
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.startsWith(path + place), outcome.toText().constData());
    QVERIFY(outcome.out.isEmpty());
}

void TestCliCheckProgram::unreadableProgramGetsAReport_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("message");
    QTest::addColumn<int>("line");
    QTest::newRow("without end") << text("/dev/zero") << text("too long") << 0;
    QTest::newRow("Latin-1") << written(m_folder, "latin1.lua", "x = 1\n-- gr\xfc\xdf\n")
                             << text("no text in UTF-8") << 2;
    QTest::newRow("NUL") << written(m_folder, "nul.lua", QByteArray("x = 1\ny\0", 8))
                         << text("no text in UTF-8") << 2;
    QTest::newRow("UTF-16") << written(m_folder, "utf16.lua", QByteArray("x\0=\0001\0", 6))
                            << text("no text in UTF-8") << 1;
    QTest::newRow("too large") << written(m_folder, "long.lua", QByteArray(128 * 1024 + 1, '-'))
                               << text("too long") << 0;
}

/// One student must never leave a grader without results.
void TestCliCheckProgram::unreadableProgramGetsAReport()
{
    QFETCH(QString, path);
    QFETCH(QString, message);
    QFETCH(int, line);
    for (const char *format : {"json", "text", "junit", "tap", "gradescope", "exercism"}) {
        const Outcome outcome =
            runCli({text("check"), text("L42T1"), path, text("--format"), text(format)});
        VERIFY_CODE(outcome, 1);
        QVERIFY2(outcome.out.contains(message), outcome.toText().constData());
    }
    const Outcome outcome =
        runCli({text("check"), text("L42T1"), path, text("--format"), text("json")});
    const QJsonObject report = reportOf(outcome);
    QCOMPARE(report.value(text("passed")), QJsonValue(false));
    const QJsonObject error = report.value(text("error")).toObject();
    QCOMPARE(error.value(text("kind")).toString(), text("syntax"));
    QCOMPARE(error.value(text("line")).toInt(), line);
    QVERIFY2(outcome.error.startsWith(path + text(":")), outcome.toText().constData());
}

void TestCliCheckProgram::programMayComeFromStandardInput()
{
    QProcess process;
    process.start(cradle::cliProgram(), {text("check"), text("L42T1"), text("-")});
    process.write(contentOf(step1("solution.lua")));
    process.closeWriteChannel();
    QVERIFY(process.waitForFinished(patience));
    QCOMPARE(process.exitCode(), 0);
}

void TestCliCheckProgram::everyFormatIsWritten_data()
{
    QTest::addColumn<QString>("format");
    QTest::addColumn<QByteArray>("start");
    QTest::newRow("text") << text("text")
                          << QByteArray("  The velocity at the start points to the left\n");
    QTest::newRow("json") << text("json") << QByteArray("{\n");
    QTest::newRow("junit") << text("junit")
                           << QByteArray("<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
    QTest::newRow("tap") << text("tap") << QByteArray("TAP version 13\n");
    QTest::newRow("gradescope") << text("gradescope") << QByteArray("{\n");
    QTest::newRow("exercism") << text("exercism") << QByteArray("{\n");
}

void TestCliCheckProgram::everyFormatIsWritten()
{
    QFETCH(QString, format);
    QFETCH(QByteArray, start);
    const QString path = m_folder.filePath(text("report"));
    const QStringList judge{text("check"),
                            text("L42T1"),
                            step1("mistakes/moving-left.lua"),
                            text("--format"),
                            format,
                            text("--output"),
                            path};
    VERIFY_CODE(runCli(judge), 1);
    const QByteArray report = contentOf(path);
    QVERIFY2(report.startsWith(start), report);
    QVERIFY2(report.contains("points to the left"), report);
    if (format == text("gradescope")) // where it is for
        VERIFY_CODE(runCli(judge + QStringList{text("--exit-zero")}), 0);
}

/// The program needs a second circle, which the scene of the step lacks.
void TestCliCheckProgram::programRunsInTheGivenScene()
{
    const QString program = written(m_folder, "lab.lua", "assert(circle2)\n");
    const QString scene =
        written(m_folder, "scene.json",
                R"({"format": 1, "circles": [{"position": [-2, 2]}, {"position": [2, 2]}]})");
    const Outcome without =
        runCli({text("check"), text("L42T1"), program, text("--format"), text("json")});
    QVERIFY(reportOf(without).value(text("error")).isObject());
    const Outcome with = runCli({text("check"), text("L42T1"), program, text("--preset"), scene,
                                 text("--format"), text("json")});
    VERIFY_CODE(with, 1);
    QVERIFY(reportOf(with).value(text("error")).isNull());
}

QTEST_GUILESS_MAIN(TestCliCheckProgram)
#include "test_cli_check_program.moc"
