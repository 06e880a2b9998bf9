// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace.h"

#include "model/files/file_io.h"
#include "tests/workspace_test.h"

#include <QDir>
#include <QTest>

using namespace cradle;

/// What other programs do to the files of a workspace is found, and nothing of it is lost.
class TestWorkspaceOutside final : public WorkspaceTest
{
    Q_OBJECT
private slots:
    void init() { takeNewFolder(); }
    void foreignFilesAreNeverReplaced_data();
    void foreignFilesAreNeverReplaced();
    void foreignLabFileIsKeptBeforeItIsReplaced();
    void foreignFileCanBeConverted();
    void foreignFileCanBeSetAside();
    void outsideEditsAreFound();
    void fileThatComesBackIsAnEdit();
    void fileThatCouldNotBeWrittenIsNoEdit();
    void outsideEditsAreKept();
    void labFileEditedInBetweenIsTaken();
    void olderLabFileIsNotTaken();
};

void TestWorkspaceOutside::foreignFilesAreNeverReplaced_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("NUL") << QByteArray("x = 1\0\n", 7);
    QTest::newRow("UTF-16") << QByteArray("\xff\xfex\0 \0=\0", 8);
    QTest::newRow("Latin-1") << QByteArray("-- Gr\xf6\xdf"
                                           "e\n");
    QTest::newRow("long") << QByteArray(600 * 1024, 'x');
}

void TestWorkspaceOutside::foreignFilesAreNeverReplaced()
{
    QFETCH(QByteArray, bytes);
    QVERIFY(!makeFolder(path("w/steps")));
    QVERIFY(!writeFile(path("w/steps/A.lua"), bytes));
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab(), first));
    const auto text = workspace.textOf(lab(), 0);
    QVERIFY(!text);
    QCOMPARE(text.error().file, path("w/steps/A.lua"));
    QVERIFY(!text.error().message.isEmpty());
    // The step after it starts from the lab, not from that.
    QCOMPARE(*workspace.textOf(lab(), 1), QStringLiteral("-- starter of B\n"));
    QCOMPARE(content(path("w/steps/A.lua")), bytes);
}

/// Another editor has written lab.lua in UTF-16 while no window was open.
void TestWorkspaceOutside::foreignLabFileIsKeptBeforeItIsReplaced()
{
    {
        Workspace workspace(path());
        QVERIFY(!workspace.begin(lab()));
        QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    }
    const QByteArray bytes("\xff\xfex\0=\0"
                           "1\0\n\0",
                           10);
    QVERIFY(!writeFile(path("w/lab.lua"), bytes));
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab(), first));
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- mine\n"));
    const auto edits = workspace.outsideEdits(first);
    QCOMPARE(edits.size(), std::size_t(1));
    QVERIFY(!edits[0].text);
    const auto kept = workspace.keepOutside(first, edits[0]);
    QVERIFY(kept);
    QCOMPARE(*kept, path("w/lab.lua.original"));
    QVERIFY(!workspace.save(first, QStringLiteral("-- mine, and a key\n")));
    QCOMPARE(content(path("w/lab.lua.original")), bytes);
    const auto versions = workspace.history()->versions(first);
    QCOMPARE(*workspace.history()->textOf(versions.front()), QByteArray("x=1\n"));
}

void TestWorkspaceOutside::foreignFileCanBeConverted()
{
    QVERIFY(!makeFolder(path("w/steps")));
    const QByteArray bytes("\xff\xfex\0=\0"
                           "1\0\n\0",
                           10);
    QVERIFY(!writeFile(path("w/steps/A.lua"), bytes));
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(workspace.canConvert(first));
    QVERIFY(!workspace.replaceForeign(lab(), 0, true));
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("x=1\n"));
    QCOMPARE(content(path("w/steps/A.lua.original")), bytes);
}

void TestWorkspaceOutside::foreignFileCanBeSetAside()
{
    QVERIFY(!makeFolder(path("w/steps")));
    const QByteArray bytes(600 * 1024, 'x');
    QVERIFY(!writeFile(path("w/steps/A.lua.original"), "an earlier one"));
    QVERIFY(!writeFile(path("w/steps/A.lua"), bytes));
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(!workspace.canConvert(first));
    QVERIFY(!workspace.replaceForeign(lab(), 0, false));
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- starter of A\n"));
    QCOMPARE(content(path("w/steps/A.lua.original-2")), bytes);
    QCOMPARE(content(path("w/steps/A.lua.original")), QByteArray("an earlier one"));
}

void TestWorkspaceOutside::outsideEditsAreFound()
{
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    QVERIFY(workspace.outsideEdits(first).empty());
    QVERIFY(!writeFile(path("w/steps/A.lua"), "-- theirs\n"));
    const std::vector<OutsideEdit> expected{{path("w/steps/A.lua"), QStringLiteral("-- theirs\n")}};
    QVERIFY(workspace.outsideEdits(first) == expected);
    setAge(path("w/steps/A.lua"), 60);
    QVERIFY(!writeFile(path("w/lab.lua"), "-- newer\n"));
    QCOMPARE(workspace.outsideEdits(first).size(), std::size_t(2));
    QCOMPARE(workspace.outsideEdits(first).back().path, path("w/lab.lua"));
    // What is gone is written again, and is no edit.
    QVERIFY(QFile::remove(path("w/lab.lua")));
    QCOMPARE(workspace.outsideEdits(first).size(), std::size_t(1));
    // Of another step lab.lua says nothing.
    QVERIFY(!workspace.save(second, QStringLiteral("-- b\n")));
    QVERIFY(workspace.textOf(lab(), 0));
    QVERIFY(workspace.outsideEdits(first).empty());
}

/// Where the step was opened without it, the start is what is shown.
void TestWorkspaceOutside::fileThatComesBackIsAnEdit()
{
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    QVERIFY(QFile::remove(path("w/steps/A.lua")));
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- starter of A\n"));
    QVERIFY(!writeFile(path("w/steps/A.lua"), "-- mine\n"));
    const std::vector<OutsideEdit> expected{{path("w/steps/A.lua"), QStringLiteral("-- mine\n")}};
    QVERIFY(workspace.outsideEdits(first) == expected);
}

/// What is typed is ahead of the file then; nobody else has changed that.
void TestWorkspaceOutside::fileThatCouldNotBeWrittenIsNoEdit()
{
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    QVERIFY(QFile::remove(path("w/lab.lua")));
    QVERIFY(QDir().mkdir(path("w/lab.lua")));
    QVERIFY(workspace.save(first, QStringLiteral("-- mine, and a key\n")));
    QVERIFY(QDir().rmdir(path("w/lab.lua")));
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- mine, and a key\n"));
    QVERIFY(workspace.outsideEdits(first).empty());
}

void TestWorkspaceOutside::outsideEditsAreKept()
{
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    QVERIFY(!writeFile(path("w/steps/A.lua"), "-- theirs\n"));
    QVERIFY(workspace.keepOutside(first, workspace.outsideEdits(first).front()));
    QVERIFY(workspace.outsideEdits(first).empty());
    QVERIFY(!workspace.save(first, QStringLiteral("-- mine again\n")));
    const auto versions = workspace.history()->versions(first);
    QCOMPARE(versions.front().note.reason, VersionReason::Outside);
    QCOMPARE(*workspace.history()->textOf(versions.front()), QByteArray("-- theirs\n"));
    // What is no program is kept beside it.
    QVERIFY(!writeFile(path("w/steps/A.lua"), QByteArray("a\0b", 3)));
    const auto edits = workspace.outsideEdits(first);
    QCOMPARE(edits.size(), std::size_t(1));
    QVERIFY(!edits[0].text);
    QVERIFY(workspace.keepOutside(first, edits[0]));
    QCOMPARE(content(path("w/steps/A.lua.original")), QByteArray("a\0b", 3));
}

void TestWorkspaceOutside::labFileEditedInBetweenIsTaken()
{
    {
        Workspace workspace(path());
        QVERIFY(!workspace.begin(lab()));
        QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    }
    setAge(path("w/steps/A.lua"), 60);
    QVERIFY(!writeFile(path("w/lab.lua"), "-- by another editor\n"));
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab(), first));
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- by another editor\n"));
    const auto versions = workspace.history()->versions(first);
    QCOMPARE(versions.size(), std::size_t(2));
    QCOMPARE(*workspace.history()->textOf(versions[1]), QByteArray("-- mine\n"));
}

void TestWorkspaceOutside::olderLabFileIsNotTaken()
{
    {
        Workspace workspace(path());
        QVERIFY(!workspace.begin(lab()));
        QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    }
    // A step's file was saved, and the power went.
    QVERIFY(!writeFile(path("w/lab.lua"), "-- older\n"));
    setAge(path("w/lab.lua"), 60);
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab(), first));
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- mine\n"));
}

QTEST_GUILESS_MAIN(TestWorkspaceOutside)
#include "test_workspace_outside.moc"
