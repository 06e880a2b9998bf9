// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace.h"

#include "model/files/file_io.h"
#include "tests/workspace_test.h"

#include <QTest>

using namespace cradle;

/// A workspace is a repository, and goes on where it was.
class TestWorkspaceKeeping final : public WorkspaceTest
{
    Q_OBJECT
private slots:
    void init() { takeNewFolder(); }
    void takesOverAPlainFolder();
    void beginningAgainChangesNothing();
    void passIsACommitOfTheLabsMessage();
    void namesAreKept();
    void aFolderThatCannotBeMadeIsSaid();
    void damagedRepositoryKeepsNobodyFromSaving();
};

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
