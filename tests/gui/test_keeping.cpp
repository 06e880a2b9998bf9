// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "app/named_opening.h"
#include "keeping_fixture.h"

#include "model/files/file_io.h"
#include "tests/patience.h"
#include "views/code/versions_pane.h"

#include <QInputDialog>
#include <QTreeWidget>

using namespace cradle;
using namespace cradle::windows;

/// What the window says and offers about the student's files.
class TestKeeping final : public QObject, private KeepingFixture
{
    Q_OBJECT
private slots:
    void init();
    void secondWindowSaysWhoWorks();
    void foreignFileIsExplained();
    void damagedProgramComesBackFromItsVersions();
    void outsideEditIsSaid();
    void brokenProgressIsSaidWithAStep();
    void jumpingAheadShowsNoSolution();
    void nameIsAskedOnce();
    void foreignLabFileIsSaid();
};

void TestKeeping::init()
{
    begin();
}

void TestKeeping::secondWindowSaysWhoWorks()
{
    OpenWindow first(folder());
    inCode(first);
    type(first, QStringLiteral("-- first\n"));
    OpenWindow second(folder());
    inCode(second);
    QVERIFY(second.window.notice().text().contains(QStringLiteral("Another window")));
    QVERIFY(second.window.codePane().editor().isReadOnly());
    second.click(QStringLiteral("Take over"));
    QVERIFY(!second.window.codePane().editor().isReadOnly());
    type(second, QStringLiteral("-- second\n"));
    QCOMPARE(content(work() + QStringLiteral("/lab.lua")), QByteArray("-- second\n"));
    // The first finds out when it would save, and loses nothing.
    type(first, QStringLiteral("-- too late\n"));
    QVERIFY(first.window.notice().text().contains(QStringLiteral("another window")));
    QVERIFY(first.window.codePane().editor().isReadOnly());
    QCOMPARE(content(work() + QStringLiteral("/lab.lua")), QByteArray("-- second\n"));
}

void TestKeeping::foreignFileIsExplained()
{
    const QByteArray bytes("\xff\xfex\0=\0"
                           "1\0\n\0",
                           10);
    QVERIFY(!makeFolder(work() + QStringLiteral("/steps")));
    QVERIFY(!writeFile(work() + QStringLiteral("/steps/L42T1.lua"), bytes));
    OpenWindow open(folder());
    inCode(open);
    open.bench.openTaskAt(0);
    QVERIFY2(open.window.notice().text().contains(QStringLiteral("UTF-16")),
             qPrintable(open.window.notice().text()));
    QVERIFY(open.window.codePane().editor().isReadOnly());
    type(open, QStringLiteral("-- a key\n"));
    QCOMPARE(content(work() + QStringLiteral("/steps/L42T1.lua")), bytes);
    open.click(QStringLiteral("Make a program of it"));
    QCOMPARE(open.window.codePane().editor().text(), QStringLiteral("x=1\n"));
    QVERIFY(!open.window.codePane().editor().isReadOnly());
    QCOMPARE(content(work() + QStringLiteral("/steps/L42T1.lua.original")), bytes);
}

void TestKeeping::damagedProgramComesBackFromItsVersions()
{
    {
        OpenWindow open(folder());
        inCode(open);
        type(open, QStringLiteral("-- mine\n"));
        check(open);
    }
    for (const char *file : {"/steps/L42T1.lua", "/lab.lua"})
        QVERIFY(!writeFile(work() + QLatin1String(file), QByteArray(8, '\0')));
    OpenWindow open(folder());
    inCode(open);
    open.bench.openTaskAt(0);
    open.click(QStringLiteral("Back to the newest version"));
    QCOMPARE(open.window.codePane().editor().text(), QStringLiteral("-- mine\n"));
    QVERIFY(!open.window.codePane().editor().isReadOnly());
    QCOMPARE(content(work() + QStringLiteral("/steps/L42T1.lua")), QByteArray("-- mine\n"));
    QCOMPARE(content(work() + QStringLiteral("/steps/L42T1.lua.original")), QByteArray(8, '\0'));
}

void TestKeeping::outsideEditIsSaid()
{
    OpenWindow open(folder());
    inCode(open);
    type(open, QStringLiteral("-- mine\n"));
    QVERIFY(!writeFile(work() + QStringLiteral("/lab.lua"), "-- theirs\n"));
    QTRY_VERIFY(
        open.window.notice().text().contains(QStringLiteral("Another program has changed")));
    QCOMPARE(open.window.codePane().editor().text(), QStringLiteral("-- theirs\n"));
    auto *list = open.window.versions().findChild<QTreeWidget *>();
    QCOMPARE(list->topLevelItemCount(), 2);
    QCOMPARE(list->topLevelItem(0)->text(1), QStringLiteral("By another program"));
}

void TestKeeping::brokenProgressIsSaidWithAStep()
{
    QVERIFY(!writeFile(path("progress.json"), "no progress"));
    QSettings settings(path("settings.ini"), QSettings::IniFormat);
    Workbench bench(path("progress.json"));
    MainWindow window(bench, settings, ThemeChoice::Light);
    QVERIFY(!openNamed(bench, {}, QStringLiteral("L42T1"), path("labs")));
    window.show();
    QVERIFY2(window.notice().text().contains(QStringLiteral("progress")),
             qPrintable(window.notice().text()));
}

void TestKeeping::jumpingAheadShowsNoSolution()
{
    OpenWindow open(folder());
    inCode(open);
    const QString starter = open.bench.code().text();
    for (int i = 0; i < 4; ++i)
        open.bench.openNextTask();
    QCOMPARE(open.bench.current(), 4);
    QCOMPARE(open.bench.code().text(), starter);
    QVERIFY(open.window.notice().text().contains(QStringLiteral("your own program")));
    // Who wants the solution of the step before asks for it.
    open.click(QStringLiteral("Begin with the solution of"));
    QCOMPARE(open.bench.code().text(), open.bench.task()->starter);
    QVERIFY(open.bench.code().text() != starter);
}

void TestKeeping::nameIsAskedOnce()
{
    const QString offer = QStringLiteral("Give your name");
    OpenWindow open(folder());
    inCode(open);
    type(open, open.bench.task()->solution);
    check(open);
    QVERIFY(open.bench.check().report()->passed);
    QVERIFY(open.button(offer));
    QTimer::singleShot(0, &open.window, [&open] {
        auto *dialog = open.window.findChild<QInputDialog *>();
        QVERIFY(dialog);
        dialog->setTextValue(QStringLiteral("Ada"));
        dialog->accept();
    });
    open.click(offer);
    QCOMPARE(open.bench.code().workspace().info().student, QStringLiteral("Ada"));
    QVERIFY(!open.button(offer));
    check(open);
    QCOMPARE(GitHome::git(work(), {QStringLiteral("log"), QStringLiteral("-1"),
                                   QStringLiteral("--format=%an")}),
             QStringLiteral("Ada"));
    QVERIFY(!open.bench.code().workspace().setStudent({}, {}));
    check(open);
    QVERIFY(!open.button(offer));
}

void TestKeeping::foreignLabFileIsSaid()
{
    {
        OpenWindow open(folder());
        inCode(open);
        type(open, QStringLiteral("-- mine\n"));
    }
    const QByteArray bytes("\xff\xfex\0=\0"
                           "1\0\n\0",
                           10);
    QVERIFY(!writeFile(work() + QStringLiteral("/lab.lua"), bytes));
    OpenWindow open(folder());
    inCode(open);
    type(open, QStringLiteral("-- mine, and a key\n"));
    QVERIFY2(open.window.notice().text().contains(QStringLiteral("lab.lua.original")),
             qPrintable(open.window.notice().text()));
    QCOMPARE(content(work() + QStringLiteral("/lab.lua.original")), bytes);
}

QTEST_MAIN(TestKeeping)
#include "test_keeping.moc"
