// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "worked_folder.h"

#include "model/files/file_io.h"
#include "tasks/work/work_archive.h"
#include "tests/patience.h"

#include <QDir>
#include <QProcess>

#include <unistd.h>

using namespace cradle;
using namespace cradle::programs;

/// cradle-cli hand-in: a student's folder becomes a file.
class TestCliHandIn final : public WorkedFolderTest
{
    Q_OBJECT
private slots:
    void initTestCase() { solveTwoSteps(); }
    void handsInAPlainFolder();
    void wrongUsageIsSaid_data();
    void wrongUsageIsSaid();
    void reportsOnWhatWasHandedIn();
    void programsRunInCells();
    void unwritableIsExitThree();
};

void TestCliHandIn::handsInAPlainFolder()
{
    const QString file = path("ada.cradle-work");
    const Outcome outcome = runCli({QStringLiteral("hand-in"), path("w"), QStringLiteral("--name"),
                                    QStringLiteral("Ada"), QStringLiteral("--id"),
                                    QStringLiteral("s1"), QStringLiteral("--output"), file});
    VERIFY_CODE(outcome, 1); // the third step is not done
    const auto files = readWorkArchive(file);
    QVERIFY2(files, files ? "" : qPrintable(files.error().toString()));
    const auto manifest = manifestOf(*files);
    QVERIFY(manifest);
    QCOMPARE(manifest->student, QStringLiteral("Ada"));
    QCOMPARE(manifest->studentId, QStringLiteral("s1"));
    QCOMPARE(manifest->steps.size(), std::size_t(3));
    QCOMPARE(manifest->steps[0].verdict, QStringLiteral("passed"));
    QCOMPARE(manifest->steps[2].verdict, QStringLiteral("not done"));
    QVERIFY(files->value(QStringLiteral("report.pdf")).startsWith("%PDF-1."));
}

void TestCliHandIn::wrongUsageIsSaid_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::newRow("no folder") << "hand-in --output x.cradle-work";
    QTest::newRow("no output") << "hand-in WORK";
    QTest::newRow("another name") << "hand-in WORK --output x.zip";
    QTest::newRow("nowhere") << "hand-in /nowhere --output x.cradle-work";
    QTest::newRow("report of nothing") << "report /nowhere --output x.html";
    QTest::newRow("report without a name") << "report WORK";
    QTest::newRow("report as a text") << "report WORK --output x.txt";
    QTest::newRow("no lab") << "report WORK --lab /nowhere --output x.html";
    QTest::newRow("no language") << "report WORK --language xx --output x.html";
}

void TestCliHandIn::wrongUsageIsSaid()
{
    QFETCH(QString, arguments);
    QStringList words = arguments.split(QLatin1Char(' '));
    words.replaceInStrings(QStringLiteral("WORK"), path("w"));
    const Outcome outcome = runCli(words);
    VERIFY_CODE(outcome, 2);
    QVERIFY(!outcome.error.isEmpty());
}

void TestCliHandIn::reportsOnWhatWasHandedIn()
{
    const QString file = path("again.cradle-work");
    VERIFY_CODE(runCli({QStringLiteral("hand-in"), path("w"), QStringLiteral("--name"),
                        QStringLiteral("Ada"), QStringLiteral("--output"), file}),
                1);
    VERIFY_CODE(
        runCli({QStringLiteral("report"), file, QStringLiteral("--output"), path("a.html")}), 1);
    QVERIFY(contentOf(path("a.html")).contains("Ada"));
    // What was changed after that is no work that was handed in.
    QByteArray bytes = contentOf(file);
    bytes.chop(30);
    QVERIFY(!writeFile(file, bytes));
    VERIFY_CODE(
        runCli({QStringLiteral("report"), file, QStringLiteral("--output"), path("a.html")}), 2);
}

/// A program that takes its time is found in a process that may open no file.
void TestCliHandIn::programsRunInCells()
{
    QVERIFY(!makeFolder(path("c/steps")));
    QVERIFY(!writeFile(path("c/steps/BALL1.lua"),
                       "function on_update() for i = 1, 1000000 do local x = i end end\n"));
    QVERIFY(!writeFile(path("c/cradle.json"), R"({"format": 1, "lab": "bouncing-ball"})"));
    QProcess process;
    process.start(cliProgram(), {QStringLiteral("report"), path("c"), QStringLiteral("--output"),
                                 path("c.html")});
    QVERIFY(process.waitForStarted());
    bool found = false;
    while (!found && !process.waitForFinished(1)) {
        const QByteArray group =
            QByteArray::number(getpgid(static_cast<pid_t>(process.processId())));
        for (const QString &each :
             QDir(QStringLiteral("/proc")).entryList({QStringLiteral("[0-9]*")})) {
            const QString of = QStringLiteral("/proc/") + each;
            found = found
                    || (contentOf(of + QStringLiteral("/comm")).startsWith("cradle-cli")
                        && getpgid(each.toInt()) == group.toInt()
                        && contentOf(of + QStringLiteral("/limits"))
                               .contains("Max processes             0 "));
        }
    }
    QVERIFY(found);
    QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished(patience));
}

void TestCliHandIn::unwritableIsExitThree()
{
    VERIFY_CODE(runCli({QStringLiteral("report"), path("w"), QStringLiteral("--output"),
                        path("none/r.html")}),
                3);
    VERIFY_CODE(runCli({QStringLiteral("hand-in"), path("w"), QStringLiteral("--output"),
                        path("none/a.cradle-work")}),
                3);
}

QTEST_GUILESS_MAIN(TestCliHandIn)
#include "test_cli_hand_in.moc"
