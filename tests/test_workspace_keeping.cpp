// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace.h"

#include "full_disk.h"
#include "git_home.h"
#include "model/files/file_io.h"
#include "tasks/script/script_limits.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

/// A workspace that is a repository, has one writer, and loses nothing that others do to it.
class TestWorkspaceKeeping final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void takesOverAPlainFolder();
    void beginningAgainChangesNothing();
    void passIsACommitOfTheLabsMessage();
    void theSecondMayNotWrite();
    void whoWasTakenOverWritesNoMore();
    void aLockThatIsGoneIsTakenAgain();
    void aKilledHolderHoldsNothing();
    void locksOfAKilledHolderHoldUpNothing();
    void foreignFilesAreNeverReplaced_data();
    void foreignFilesAreNeverReplaced();
    void foreignLabFileIsKeptBeforeItIsReplaced();
    void foreignFileCanBeConverted();
    void foreignFileCanBeSetAside();
    void outsideEditsAreFound();
    void outsideEditsAreKept();
    void labFileEditedInBetweenIsTaken();
    void olderLabFileIsNotTaken();
    void namesAreKept();
    void notesAreKept();
    void notesHaveVersions();
    void notesOfOtherProgramsAreNeverReplaced_data();
    void notesOfOtherProgramsAreNeverReplaced();
    void aFolderThatCannotBeMadeIsSaid();
    void damagedRepositoryKeepsNobodyFromSaving();

private:
    static Lab lab();
    [[nodiscard]] QString path(const char *name = "w") const
    {
        return m_folder->filePath(QLatin1String(name));
    }
    static QByteArray content(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
    }
    [[nodiscard]] QString git(const QString &arguments) const
    {
        return GitHome::git(path(), arguments.split(QLatin1Char(' ')));
    }

    GitHome m_home;
    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

const QString first = QStringLiteral("A");
const QString second = QStringLiteral("B");

/// Puts the time of a file a while away from now, s.
void setAge(const QString &path, int seconds)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-seconds),
                             QFileDevice::FileModificationTime));
}

} // namespace

Lab TestWorkspaceKeeping::lab()
{
    Lab lab;
    lab.id = QStringLiteral("lab-x");
    lab.version = QStringLiteral("1.2");
    lab.hash = QString(64, QLatin1Char('f'));
    for (const char *id : {"A", "B"}) {
        Task task;
        task.id = QLatin1String(id);
        task.starter = QStringLiteral("-- starter of %1\n").arg(task.id);
        lab.tasks.push_back(task);
    }
    return lab;
}

void TestWorkspaceKeeping::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestWorkspaceKeeping::takesOverAPlainFolder()
{
    QVERIFY(!makeFolder(path("w/steps")));
    QVERIFY(!writeFile(path("w/steps/A.lua"), "-- a\n"));
    QVERIFY(!writeFile(path("w/lab.lua"), "-- a\n"));
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab(), first));
    QVERIFY(workspace.mayWrite());
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- a\n"));
    QCOMPARE(git(QStringLiteral("log --format=%s")), QStringLiteral("Begin lab-x"));
    QCOMPARE(git(QStringLiteral("ls-tree -r --name-only HEAD")),
             QStringLiteral("cradle.json\nlab.lua\nsteps/A.lua"));
    QVERIFY(git(QStringLiteral("status --porcelain")).isEmpty());
    const auto info = readWorkspaceInfo(path());
    QVERIFY(info);
    QCOMPARE(info->labId, QStringLiteral("lab-x"));
    QCOMPARE(info->labVersion, QStringLiteral("1.2"));
}

void TestWorkspaceKeeping::beginningAgainChangesNothing()
{
    {
        Workspace workspace(path());
        QVERIFY(!workspace.begin(lab()));
        QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    }
    const QString before = git(QStringLiteral("rev-parse HEAD"));
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab(), first));
    QCOMPARE(git(QStringLiteral("rev-parse HEAD")), before);
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- mine\n"));
    QVERIFY(!QFile::exists(path("w/.cradle-unfinished-x")));
}

void TestWorkspaceKeeping::passIsACommitOfTheLabsMessage()
{
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    CheckReport report;
    report.taskId = first;
    report.passed = true;
    report.seed = 5;
    report.labHash = lab().hash;
    report.commit = QStringLiteral("A Set it moving");
    QVERIFY(!workspace.commitPass(report, std::nullopt, Preset{}));
    QCOMPARE(git(QStringLiteral("log --format=%s")),
             QStringLiteral("A Set it moving\nBegin lab-x"));
    QVERIFY(git(QStringLiteral("log -1 --format=%b"))
                .contains(QStringLiteral("Cradle-Verdict: passed\nCradle-Seed: 5\n"
                                         "Cradle-Lab-Hash: %1")
                              .arg(lab().hash)));
    QVERIFY(QFile::exists(path("w/presets/A.json")));
    QVERIFY(git(QStringLiteral("status --porcelain")).isEmpty());
    QCOMPARE(workspace.history()->passes().size(), std::size_t(1));
    // In the lab's own scene again: the other one is no longer part of the work.
    QVERIFY(!workspace.commitPass(report, std::nullopt, std::nullopt));
    QVERIFY(!QFile::exists(path("w/presets/A.json")));
    QVERIFY(git(QStringLiteral("fsck --strict")).isEmpty());
}

void TestWorkspaceKeeping::theSecondMayNotWrite()
{
    Workspace one(path());
    QVERIFY(!one.begin(lab()));
    QVERIFY(!one.save(first, QStringLiteral("-- one\n")));
    Workspace two(path());
    QVERIFY(!two.begin(lab()));
    QVERIFY(!two.mayWrite());
    QVERIFY(two.holder());
    QCOMPARE(two.holder()->process, qint64(QCoreApplication::applicationPid()));
    QVERIFY(two.holder()->since.isValid());
    QVERIFY(two.save(first, QStringLiteral("-- two\n")));
    QCOMPARE(content(path("w/steps/A.lua")), QByteArray("-- one\n"));
}

void TestWorkspaceKeeping::whoWasTakenOverWritesNoMore()
{
    Workspace one(path());
    QVERIFY(!one.begin(lab()));
    {
        Workspace two(path());
        QVERIFY(!two.begin(lab()));
        two.takeOver();
        QVERIFY(two.mayWrite() && !two.holder());
        QVERIFY(!two.save(first, QStringLiteral("-- two\n")));
        const auto error = one.save(first, QStringLiteral("-- one, a moment too late\n"));
        QVERIFY(error);
        QVERIFY2(error->message.contains(QLatin1String("another window")),
                 qPrintable(error->message));
        QVERIFY(!one.mayWrite());
    }
    QCOMPARE(content(path("w/steps/A.lua")), QByteArray("-- two\n"));
    // And yet it is not lost.
    const auto versions = one.history()->versions(first);
    QCOMPARE(versions.size(), std::size_t(1));
    QCOMPARE(versions[0].note.reason, VersionReason::Unsaved);
    QCOMPARE(*one.history()->textOf(versions[0]), QByteArray("-- one, a moment too late\n"));
}

void TestWorkspaceKeeping::aKilledHolderHoldsNothing()
{
    QVERIFY(!makeFolder(path()));
    // Numbers of processes end far below; "since" and "token" are as a window writes them.
    QVERIFY(
        !writeFile(path("w/.cradle-lock"), "{\"host\": \"" + QSysInfo::machineHostName().toUtf8()
                                               + "\", \"process\": 99999999, \"token\": \"x\"}"));
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(workspace.mayWrite());
    // The same number, but a process that began at another time.
    QVERIFY(!writeFile(path("w/.cradle-lock"),
                       "{\"host\": \"" + QSysInfo::machineHostName().toUtf8() + "\", \"process\": "
                           + QByteArray::number(QCoreApplication::applicationPid())
                           + ", \"start\": 1, \"token\": \"x\"}"));
    Workspace again(path());
    QVERIFY(!again.begin(lab()));
    QVERIFY(again.mayWrite());
    // Another machine cannot be asked.
    QVERIFY(!writeFile(path("w/.cradle-lock"),
                       R"({"host": "elsewhere.example", "process": 1, "token": "x"})"));
    Workspace third(path());
    QVERIFY(!third.begin(lab()));
    QVERIFY(!third.mayWrite());
    QCOMPARE(third.holder()->host, QStringLiteral("elsewhere.example"));
}

/// "git clean -fdx" takes the lock away, and no other window is there.
void TestWorkspaceKeeping::aLockThatIsGoneIsTakenAgain()
{
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(QFile::remove(path("w/.cradle-lock")));
    QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    QVERIFY(workspace.mayWrite());
    QVERIFY(QFile::exists(path("w/.cradle-lock")));
    Workspace other(path());
    QVERIFY(!other.begin(lab()));
    QVERIFY(!other.mayWrite());
}

/// Killed in the middle of a commit: git's own locks stay, and git refuses all that follows.
void TestWorkspaceKeeping::locksOfAKilledHolderHoldUpNothing()
{
    {
        Workspace workspace(path());
        QVERIFY(!workspace.begin(lab()));
        QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
        QVERIFY(!workspace.keep(first, QStringLiteral("-- mine\n"), {}));
    }
    const QStringList locks{path("w/.git/index.lock"), path("w/.git/refs/heads/main.lock"),
                            path("w/.git/refs/cradle/versions/A.lock")};
    for (const QString &lock : locks)
        QVERIFY(!writeFile(lock, {}));
    QVERIFY(
        !writeFile(path("w/.cradle-lock"),
                   "{\"host\": \"" + QSysInfo::machineHostName().toUtf8()
                       + "\", \"process\": 99999999, \"since\": \""
                       + QDateTime::currentDateTimeUtc().addSecs(-60).toString(Qt::ISODate).toUtf8()
                       + "\", \"token\": \"x\"}"));
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    CheckReport report;
    report.taskId = first;
    report.passed = true;
    const auto error = workspace.commitPass(report, QStringLiteral("-- mine\n"), std::nullopt);
    QVERIFY2(!error, error ? qPrintable(error->toString()) : "");
    QVERIFY(!workspace.keep(first, QStringLiteral("-- better\n"), {}));
    for (const QString &lock : locks)
        QVERIFY(!QFile::exists(lock));
    // What another program holds while no window was killed is its own.
    QVERIFY(!writeFile(locks.first(), {}));
    QVERIFY(workspace.commitPass(report, QStringLiteral("-- mine\n"), std::nullopt));
    QVERIFY(QFile::exists(locks.first()));
}

void TestWorkspaceKeeping::foreignFilesAreNeverReplaced_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("NUL") << QByteArray("x = 1\0\n", 7);
    QTest::newRow("UTF-16") << QByteArray("\xff\xfex\0 \0=\0", 8);
    QTest::newRow("Latin-1") << QByteArray("-- Gr\xf6\xdf"
                                           "e\n");
    QTest::newRow("long") << QByteArray(600 * 1024, 'x');
}

void TestWorkspaceKeeping::foreignFilesAreNeverReplaced()
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
void TestWorkspaceKeeping::foreignLabFileIsKeptBeforeItIsReplaced()
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

void TestWorkspaceKeeping::foreignFileCanBeConverted()
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

void TestWorkspaceKeeping::foreignFileCanBeSetAside()
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

void TestWorkspaceKeeping::outsideEditsAreFound()
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

void TestWorkspaceKeeping::outsideEditsAreKept()
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

void TestWorkspaceKeeping::labFileEditedInBetweenIsTaken()
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

void TestWorkspaceKeeping::olderLabFileIsNotTaken()
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

void TestWorkspaceKeeping::namesAreKept()
{
    Workspace workspace(path());
    QVERIFY(!workspace.begin(lab()));
    QVERIFY(!workspace.setStudent(QString::fromUtf8("Ada  Gräfin"), QStringLiteral("s123")));
    const auto info = readWorkspaceInfo(path());
    QCOMPARE(info->student, QString::fromUtf8("Ada Gräfin"));
    QCOMPARE(info->studentId, QStringLiteral("s123"));
    QCOMPARE(info->labId, QStringLiteral("lab-x"));
}

void TestWorkspaceKeeping::notesAreKept()
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

void TestWorkspaceKeeping::notesHaveVersions()
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

void TestWorkspaceKeeping::notesOfOtherProgramsAreNeverReplaced_data()
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

void TestWorkspaceKeeping::notesOfOtherProgramsAreNeverReplaced()
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

void TestWorkspaceKeeping::aFolderThatCannotBeMadeIsSaid()
{
    QVERIFY(!writeFile(path("w"), "a file"));
    Workspace workspace(path());
    const auto error = workspace.begin(lab());
    QVERIFY(error);
    QVERIFY2(error->message.contains(QLatin1String("cannot be saved here: a file is where")),
             qPrintable(error->message));
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- starter of A\n"));
}

void TestWorkspaceKeeping::damagedRepositoryKeepsNobodyFromSaving()
{
    QVERIFY(!makeFolder(path("w")));
    QVERIFY(!writeFile(path("w/.git"), "nonsense"));
    Workspace workspace(path());
    const auto error = workspace.begin(lab());
    QVERIFY(error);
    QVERIFY2(error->message.contains(QLatin1String("history")), qPrintable(error->message));
    QVERIFY(workspace.mayWrite());
    QVERIFY(!workspace.save(first, QStringLiteral("-- mine\n")));
    QCOMPARE(content(path("w/steps/A.lua")), QByteArray("-- mine\n"));
    QVERIFY(!workspace.keep(first, QStringLiteral("-- mine\n"), {}));
}

QTEST_GUILESS_MAIN(TestWorkspaceKeeping)
#include "test_workspace_keeping.moc"
