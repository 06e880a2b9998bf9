// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_window.h"

#include "app/code_session.h"
#include "tasks/authoring/lab_edits.h"
#include "tests/patience.h"
#include "views/console_view.h"

using namespace cradle;
using cradle::windows::OpenWindow;

/// A student's program that sets what the author of the step has fixed, in the window.
class TestLockedProgram final : public QObject
{
    Q_OBJECT
private slots:
    void runStopsWithTheReason();
};

void TestLockedProgram::runStopsWithTheReason()
{
    const QTemporaryDir folder;
    const LabFiles files = newLab(QStringLiteral("lab"), QStringLiteral("Lab"), {});
    const QString step = stepsOf(files).front();
    Result<TaskForm> form = taskForm(files, step);
    form->locked = {QStringLiteral("gravity")};
    const QString lab = folder.filePath(QStringLiteral("lab"));
    QVERIFY(!saveLabFiles(*withTask(files, step, *form), {}, lab));

    OpenWindow open(folder);
    QVERIFY(!open.bench.openLab(lab, QStringLiteral("en")));
    open.bench.setMode(Mode::Code);
    open.bench.code().replace(open.bench.task()->starter);
    QVERIFY(!open.simulation().programError());
    open.bench.code().replace(open.bench.task()->solution);
    QTRY_VERIFY(open.simulation().programError());
    QCOMPARE(open.simulation().programError()->line, 5);
    QVERIFY(
        open.simulation().programError()->message.contains(QStringLiteral("fixed this: gravity")));
    const auto *console = open.window.findChild<ConsoleView *>();
    QVERIFY(console->errorText().startsWith(QStringLiteral("line 5: the author")));
}

QTEST_MAIN(TestLockedProgram)
#include "test_locked_program.moc"
