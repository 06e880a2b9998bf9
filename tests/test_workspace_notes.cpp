// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace.h"

#include "full_disk.h"
#include "model/files/file_io.h"
#include "tests/workspace_test.h"

#include <QTest>

using namespace cradle;

/// Notes on a step are kept like its program.
class TestWorkspaceNotes final : public WorkspaceTest
{
    Q_OBJECT
private slots:
    void init() { takeNewFolder(); }
    void notesAreKept();
    void notesThatAreLookedAtAreNotWritten();
    void notesHaveVersions();
    void notesOfOtherProgramsAreNeverReplaced_data();
    void notesOfOtherProgramsAreNeverReplaced();
};

void TestWorkspaceNotes::notesAreKept()
{
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QCOMPARE(workspace.noteOf(first), QString());
    QVERIFY(!workspace.saveNote(first, QStringLiteral("It *fell*.")));
    QCOMPARE(workspace.noteOf(first), QStringLiteral("It *fell*."));
    QCOMPARE(content(path("w/notes/A.md")), QByteArray("It *fell*."));
    // On a full disk it stays in memory, and is tried again.
    const QString more = QStringLiteral("It *fell*.\n").repeated(100);
    {
        const FullDisk full(512);
        QVERIFY(workspace.saveNote(first, more));
    }
    QVERIFY(workspace.hasUnsaved());
    QCOMPARE(workspace.noteOf(first), more);
    QCOMPARE(content(path("w/notes/A.md")), QByteArray("It *fell*."));
    QVERIFY(!workspace.saveUnsaved());
    QVERIFY(!workspace.hasUnsaved());
    QCOMPARE(content(path("w/notes/A.md")), more.toUtf8());
    {
        const FullDisk full(512); // What is there already is not written again.
        QVERIFY(!workspace.saveNote(first, more));
    }
    // Another window has taken over: this one changes nothing of it.
    Workspace other(path());
    QVERIFY(!other.begin(lab()));
    other.takeOver();
    QCOMPARE(other.noteOf(first), more);
    QVERIFY(!other.saveNote(first, QStringLiteral("Theirs")));
    QVERIFY(workspace.saveNote(first, QStringLiteral("Mine")));
    QVERIFY(!workspace.setStudent(QStringLiteral("Nobody"), {}));
    QCOMPARE(content(path("w/notes/A.md")), QByteArray("Theirs"));
    QVERIFY(!content(path("w/cradle.json")).contains("Nobody"));
}

void TestWorkspaceNotes::notesThatAreLookedAtAreNotWritten()
{
    {
        Workspace workspace(path());
        QVERIFY(!workspace.begin(lab()));
        QVERIFY(!workspace.saveNote(first, QStringLiteral("Theirs.")));
    }
    Workspace looking(path());
    looking.beginReading();
    QCOMPARE(looking.noteOf(first), QStringLiteral("Theirs."));
    QVERIFY(!looking.saveNote(first, QStringLiteral("Mine.")));
    QCOMPARE(looking.noteOf(first), QStringLiteral("Theirs."));
    QCOMPARE(content(path("w/notes/A.md")), QByteArray("Theirs."));
    QVERIFY(!looking.keepNote(first));
    QVERIFY(git(QStringLiteral("for-each-ref refs/cradle/notes")).isEmpty());
}

void TestWorkspaceNotes::notesHaveVersions()
{
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    for (const char *note : {"It fell.", "It *fell*.", "It *fell*."}) {
        QVERIFY(!workspace.saveNote(first, QLatin1String(note)));
        QVERIFY(!workspace.keepNote(first));
    }
    QCOMPARE(git(QStringLiteral("log --format=%s refs/cradle/notes/A")),
             QStringLiteral("A: notes\nA: notes"));
    QCOMPARE(git(QStringLiteral("show refs/cradle/notes/A~1:notes/A.md")),
             QStringLiteral("It fell."));
    QVERIFY(!workspace.keepNote(second)); // nothing was noted
    QVERIFY(git(QStringLiteral("fsck --strict")).isEmpty());
    // They go wherever the versions of the programs go.
    const auto bundle = workspace.history()->bundle();
    QVERIFY(bundle && bundle->contains(" refs/cradle/notes/A\n"));
}

void TestWorkspaceNotes::notesOfOtherProgramsAreNeverReplaced_data()
{
    QTest::addColumn<QByteArray>("theirs");
    QTest::addColumn<bool>("isText");
    QTest::newRow("text") << QByteArray("Theirs.") << true;
    QTest::newRow("UTF-16") << QByteArray("\xff\xfeI\0t\0", 6) << false;
    QTest::newRow("Latin-1") << QByteArray("Gr\xf6\xdf"
                                           "e")
                             << false;
    QTest::newRow("long") << QByteArray(300 * 1024, 'x') << false;
}

void TestWorkspaceNotes::notesOfOtherProgramsAreNeverReplaced()
{
    QFETCH(QByteArray, theirs);
    QFETCH(bool, isText);
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(!workspace.saveNote(first, QStringLiteral("Mine.")));
    QVERIFY(!writeFile(path("w/notes/A.md"), theirs));
    const auto said = workspace.saveNote(first, QStringLiteral("Mine, and more."));
    QVERIFY(said);
    QVERIFY2(said->message.contains(QLatin1String(isText ? "refs/cradle/notes/A" : ".original")),
             qPrintable(said->message));
    QVERIFY(!workspace.hasUnsaved());
    QCOMPARE(content(path("w/notes/A.md")), QByteArray("Mine, and more."));
    if (isText)
        QCOMPARE(git(QStringLiteral("show refs/cradle/notes/A:notes/A.md")).toUtf8(), theirs);
    else
        QCOMPARE(content(path("w/notes/A.md.original")), theirs);
    // Nor what was there before the window was opened.
    QVERIFY(!writeFile(path("w/notes/B.md"), theirs));
    (void)workspace.noteOf(second);
    QCOMPARE(workspace.saveNote(second, QStringLiteral("Mine.")).has_value(), !isText);
    if (!isText)
        QCOMPARE(content(path("w/notes/B.md.original")), theirs);
}

QTEST_GUILESS_MAIN(TestWorkspaceNotes)
#include "test_workspace_notes.moc"
