// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

/// The files of a student's programs.
class TestWorkspace final : public QObject
{
    Q_OBJECT
private slots:
    void stepStartsFromTheLab();
    void stepStartsFromTheStepBefore();
    void jumpingAheadNeverShowsASolution();
    void ownTextIsKept();
    void filesHaveTheirPlaces();
    void withoutFolderAllIsKeptInMemory();
    void whatCannotBeSavedIsSaid();

private:
    static Lab lab();
};

Lab TestWorkspace::lab()
{
    Lab lab;
    for (const char *id : {"A", "B", "C"}) {
        Task task;
        task.id = QLatin1String(id);
        task.starter = QStringLiteral("-- starter of %1\n").arg(task.id);
        task.solution = QStringLiteral("-- solution of %1\n").arg(task.id);
        lab.tasks.push_back(task);
    }
    return lab;
}

void TestWorkspace::stepStartsFromTheLab()
{
    const QTemporaryDir folder;
    const Workspace workspace(folder.filePath(QStringLiteral("w")));
    QCOMPARE(*workspace.textOf(lab(), 1), QStringLiteral("-- starter of B\n"));
    // Reading writes nothing.
    QVERIFY(!QDir(workspace.folder()).exists());
}

void TestWorkspace::stepStartsFromTheStepBefore()
{
    const QTemporaryDir folder;
    Workspace workspace(folder.path());
    QVERIFY(!workspace.save(QStringLiteral("A"), QStringLiteral("-- mine\n")));
    QCOMPARE(*workspace.textOf(lab(), 1), QStringLiteral("-- mine\n"));
    QCOMPARE(*workspace.textOf(lab(), 2), QStringLiteral("-- mine\n"));
    QVERIFY(!workspace.save(QStringLiteral("A"), QStringLiteral("-- better\n")));
    QCOMPARE(*workspace.textOf(lab(), 2), QStringLiteral("-- better\n"));
}

/// Steps that build on each other start from what the student has; that a step starts from the
/// solution of the one before is for who has done it.
void TestWorkspace::jumpingAheadNeverShowsASolution()
{
    Lab steps = lab();
    steps.tasks[1].starter = steps.tasks[0].solution;
    steps.tasks[2].starter = steps.tasks[1].solution;
    Workspace workspace;
    QCOMPARE(*workspace.textOf(steps, 2), QStringLiteral("-- starter of A\n"));
    QCOMPARE(*workspace.textOf(steps, 1), QStringLiteral("-- starter of A\n"));
    QVERIFY(!workspace.save(QStringLiteral("A"), QStringLiteral("-- mine\n")));
    QCOMPARE(*workspace.textOf(steps, 2), QStringLiteral("-- mine\n"));
    // A step that begins anew does so.
    steps.tasks[2].starter = QStringLiteral("-- something else\n");
    QCOMPARE(*Workspace().textOf(steps, 2), QStringLiteral("-- something else\n"));
}

void TestWorkspace::ownTextIsKept()
{
    const QTemporaryDir folder;
    Workspace workspace(folder.path());
    QVERIFY(!workspace.save(QStringLiteral("A"), QStringLiteral("-- a\n")));
    QVERIFY(!workspace.save(QStringLiteral("B"), QString::fromUtf8("-- Größe\n")));
    QCOMPARE(*workspace.textOf(lab(), 1), QString::fromUtf8("-- Größe\n"));
    QCOMPARE(workspace.startOf(lab(), 1), QStringLiteral("-- a\n"));
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- a\n"));
    // Another object reads the same files.
    QCOMPARE(*Workspace(folder.path()).textOf(lab(), 1), QString::fromUtf8("-- Größe\n"));
}

void TestWorkspace::filesHaveTheirPlaces()
{
    const QTemporaryDir folder;
    Workspace workspace(folder.path());
    QVERIFY(!workspace.save(QStringLiteral("B"), QStringLiteral("-- b\n")));
    for (const char *name : {"lab.lua", "steps/B.lua"}) {
        QFile file(folder.filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("-- b\n"));
    }
}

void TestWorkspace::withoutFolderAllIsKeptInMemory()
{
    Workspace workspace;
    QVERIFY(!workspace.save(QStringLiteral("A"), QStringLiteral("-- a\n")));
    QCOMPARE(*workspace.textOf(lab(), 0), QStringLiteral("-- a\n"));
}

void TestWorkspace::whatCannotBeSavedIsSaid()
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("steps")));
    QVERIFY(file.open(QIODevice::WriteOnly)); // in the place of the folder
    file.close();
    Workspace workspace(folder.path());
    const auto error = workspace.save(QStringLiteral("A"), QStringLiteral("-- a\n"));
    QVERIFY(error);
    QVERIFY(error->file.endsWith(QLatin1String("steps/A.lua")));
    QVERIFY(error->message.contains(QLatin1String("cannot be saved")));
}

QTEST_APPLESS_MAIN(TestWorkspace)
#include "test_workspace.moc"
