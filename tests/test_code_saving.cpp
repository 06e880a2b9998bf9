// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/code_session.h"

#include "code_in_folder.h"
#include "full_disk.h"
#include "git_folder_test.h"
#include "model/files/file_io.h"
#include "tests/patience.h"
#include "tests/typist.h"

#include <QProcess>
#include <QSignalSpy>
#include <QTest>

#include <cerrno>

using namespace cradle;

namespace {

constexpr int killings = 50;
constexpr int atOnce = 10;

/// The program of a step, which is typed without a pause until it is killed.
int typeProgram(const QString &folder)
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, folder);
    return typeForEver([&](int key) { session.edit(QStringLiteral("-- %1\n").arg(key)); });
}

} // namespace

/// The program of the open step is saved as it is typed, whatever becomes of the window or the
/// disk.
class TestCodeSaving final : public GitFolderTest
{
    Q_OBJECT
private slots:
    void init() { takeNewFolder(); }
    void typingWithoutAPauseIsSaved();
    void killedWindowsLoseLittle();
    void fullDiskKeepsTheText();
    void stepIsLeftOnAFullDisk();
    void readOnlyDiskIsCalledSo();
    void secondWindowCannotType();
    void otherProcessIsNamedAndEnds();
};

void TestCodeSaving::typingWithoutAPauseIsSaved()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    // Keys come faster than any pause after which one could save.
    int keys = 0;
    while (keys < 100 && !QFile::exists(path("w/steps/A.lua"))) {
        session.edit(QStringLiteral("-- %1\n").arg(++keys));
        QTest::qWait(keyPause);
    }
    QVERIFY2(keys <= mostLost, qPrintable(QString::number(keys)));
}

void TestCodeSaving::killedWindowsLoseLittle()
{
    int worst = 0;
    QStringList folders;
    for (int run = 0; run < killings; ++run)
        folders.append(path(QByteArray("w") + QByteArray::number(run)));
    std::vector<std::unique_ptr<QProcess>> typists;
    for (int run = 0; run < killings; ++run) {
        if (run % atOnce == 0)
            typists = typistsIn(folders.mid(run, atOnce));
        const QString &folder = folders[run];
        // Another number of keys each time, so that it dies at another moment of saving.
        const int keys =
            keysUntilKilled(*typists[static_cast<std::size_t>(run % atOnce)], 15 + run);
        QVERIFY(keys > 0);
        const QString program = folder + QStringLiteral("/steps/A.lua");
        const QByteArray saved = QFile::exists(program) ? content(program) : QByteArray();
        const int known = saved.isEmpty() ? 0 : saved.mid(3).trimmed().toInt();
        QVERIFY2(saved.isEmpty() || known > 0, saved.constData());
        worst = std::max(worst, keys - known);
        // The next window finds all as it should be.
        Workspace workspace(folder);
        QVERIFY(!workspace.begin(twoSteps(), QStringLiteral("A")));
        QVERIFY(workspace.mayWrite());
        const QDir steps(folder + QStringLiteral("/steps"));
        QVERIFY(steps.entryList(QDir::Files | QDir::Hidden).size() <= 1);
    }
    QVERIFY2(worst <= mostLost, qPrintable(QStringLiteral("%1 keys were lost").arg(worst)));
}

void TestCodeSaving::fullDiskKeepsTheText()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    session.edit(QStringLiteral("-- mine\n"));
    session.save();
    QVERIFY(session.isSaved());
    QSignalSpy failed(&session, &CodeSession::failed);
    QSignalSpy savedAgain(&session, &CodeSession::savedAgain);
    const QString longText = QStringLiteral("-- a line of a program\n").repeated(100);
    {
        const FullDisk full(512);
        session.edit(longText);
        session.save();
        session.save();
    }
    QCOMPARE(failed.size(), 1); // and not with every key
    QVERIFY(!session.isSaved());
    QCOMPARE(session.text(), longText);
    QCOMPARE(content(path("w/steps/A.lua")), QByteArray("-- mine\n"));
    // It is tried again by itself.
    QTRY_VERIFY(session.isSaved());
    QCOMPARE(savedAgain.size(), 1);
    QCOMPARE(content(path("w/steps/A.lua")), longText.toUtf8());
}

void TestCodeSaving::stepIsLeftOnAFullDisk()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    const QString longText = QStringLiteral("-- a line of a program\n").repeated(100);
    {
        const FullDisk full(512);
        session.edit(longText);
        session.open(twoSteps(), 1);
        QVERIFY(!session.isSaved());
        session.open(twoSteps(), 0);
        QCOMPARE(session.text(), longText);
    }
    session.save();
    QVERIFY(session.isSaved());
    QCOMPARE(content(path("w/steps/A.lua")), longText.toUtf8());
}

void TestCodeSaving::readOnlyDiskIsCalledSo()
{
    // Nobody may make a folder there, whoever runs the tests.
    Workspace workspace(QStringLiteral("/proc/self/cradle"));
    const auto error = workspace.begin(twoSteps());
    QVERIFY(error);
    QVERIFY2(!error->message.contains(QLatin1String("Unknown")), qPrintable(error->message));
    QCOMPARE(wordsForFault(EROFS), QStringLiteral("the disk is read-only"));
}

void TestCodeSaving::secondWindowCannotType()
{
    Simulation simulation{Preset{}};
    CodeSession one(simulation);
    open(one, path());
    Simulation other{Preset{}};
    CodeSession two(other);
    open(two, path());
    QVERIFY(one.isEditable() && !two.isEditable());
    two.edit(QStringLiteral("-- two\n"));
    QCOMPARE(two.text(), QStringLiteral("-- start\n"));
    two.takeOver(twoSteps(), 0);
    QVERIFY(two.isEditable());
    two.edit(QStringLiteral("-- two\n"));
    two.save();
    QSignalSpy failed(&one, &CodeSession::failed);
    one.edit(QStringLiteral("-- one\n"));
    one.save();
    QCOMPARE(failed.size(), 1);
    QVERIFY(!one.isEditable());
    QCOMPARE(content(path("w/steps/A.lua")), QByteArray("-- two\n"));
}

void TestCodeSaving::otherProcessIsNamedAndEnds()
{
    QProcess other;
    other.start(ownProgram(), {QStringLiteral("--type"), path()});
    QVERIFY(other.waitForReadyRead(patience));
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    QVERIFY(!session.isEditable());
    QCOMPARE(session.workspace().holder()->process, other.processId());
    session.edit(QStringLiteral("-- mine\n"));
    session.save();
    QVERIFY(content(path("w/steps/A.lua")) != "-- mine\n");
    // Its lock dies with it.
    other.kill();
    QVERIFY(other.waitForFinished(patience));
    open(session, path());
    QVERIFY(session.isEditable());
    session.edit(QStringLiteral("-- mine\n"));
    session.save();
    QCOMPARE(content(path("w/steps/A.lua")), QByteArray("-- mine\n"));
}

int main(int argc, char **argv)
{
    const QCoreApplication app(argc, argv);
    if (const QStringList arguments = QCoreApplication::arguments();
        arguments.value(1) == QLatin1String("--type"))
        return typeProgram(arguments.value(2));
    TestCodeSaving test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_code_saving.moc"
