// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/program_run.h"
#include "tests/test_paths.h"

#include <QFileInfo>

using namespace cradle::programs;
using cradle::sourcePath;

/// cradle-cli export: a lab as one file, whole or for students.
class TestCliExport : public QObject
{
    Q_OBJECT
private slots:
    void studentsGetALabThatJudges();
    void wholeLabStaysWhole();
    void wrongUsageIsSaid();
};

namespace {

QString ball()
{
    return sourcePath("tasks/labs/bouncing-ball");
}

} // namespace

void TestCliExport::studentsGetALabThatJudges()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(text("ball.cradle"));
    const Outcome written =
        runCli({text("export"), ball(), text("--students"), text("--output"), file});
    VERIFY_CODE(written, 0);
    QVERIFY2(written.error.contains(text("BALL3")), qPrintable(written.error)); // a check in Lua
    const auto check = [&](const char *program) {
        return runCli({text("check"), text("BALL1"), ball() + text("/BALL1/") + text(program),
                       text("--lab"), file});
    };
    VERIFY_CODE(check("solution.lua"), 0);
    // The same word as a measured law, for its author's own words stayed at home.
    const Outcome failed = check("starter.lua");
    VERIFY_CODE(failed, 1);
    QVERIFY(!failed.out.contains(text("Nothing pulls the ball down")));
    VERIFY_CODE(runCli({text("verify"), file}), 2);
}

void TestCliExport::wholeLabStaysWhole()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(text("ball.cradle"));
    VERIFY_CODE(runCli({text("export"), ball(), text("--output"), file}), 0);
    VERIFY_CODE(runCli({text("verify"), file, text("--task"), text("BALL1")}), 0);
}

void TestCliExport::wrongUsageIsSaid()
{
    const Outcome outcome = runCli({text("export"), ball()});
    VERIFY_CODE(outcome, 2);
    QVERIFY(outcome.error.contains(text("--output")));
    VERIFY_CODE(runCli({text("export"), text("/nowhere"), text("--output"), text("x.cradle")}), 2);
}

QTEST_GUILESS_MAIN(TestCliExport)
#include "test_cli_export.moc"
