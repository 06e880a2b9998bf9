// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace.h"

#include "model/files/file_io.h"
#include "tests/workspace_test.h"

#include <QTest>

using namespace cradle;

/// A workspace has one writer at a time.
class TestWorkspaceWriter final : public WorkspaceTest
{
    Q_OBJECT
private slots:
    void init() { takeNewFolder(); }
    void theSecondMayNotWrite();
    void whoWasTakenOverWritesNoMore();
    void aLockThatIsGoneIsTakenAgain();
    void aKilledHolderHoldsNothing();
    void locksOfAKilledHolderHoldUpNothing();
};

void TestWorkspaceWriter::theSecondMayNotWrite()
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

void TestWorkspaceWriter::whoWasTakenOverWritesNoMore()
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

void TestWorkspaceWriter::aKilledHolderHoldsNothing()
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
void TestWorkspaceWriter::aLockThatIsGoneIsTakenAgain()
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
void TestWorkspaceWriter::locksOfAKilledHolderHoldUpNothing()
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

QTEST_GUILESS_MAIN(TestWorkspaceWriter)
#include "test_workspace_writer.moc"
