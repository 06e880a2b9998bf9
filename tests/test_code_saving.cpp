// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/code_session.h"

#include "full_disk.h"
#include "git_home.h"
#include "model/files/file_io.h"

#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <cstdio>

using namespace cradle;

namespace {

constexpr int keyPause = 10; ///< ms: nobody types faster
constexpr int mostLost = 50; ///< keys: 0.5 s of them
constexpr int killings = 50;

Lab oneStep()
{
    Lab lab;
    lab.id = QStringLiteral("lab-x");
    for (const char *id : {"A", "B"}) {
        Task task;
        task.id = QLatin1String(id);
        task.starter = QStringLiteral("-- start\n");
        lab.tasks.push_back(task);
    }
    return lab;
}

void open(CodeSession &session, const QString &folder)
{
    Workspace workspace(folder);
    (void)workspace.begin(oneStep());
    session.setWorkspace(std::move(workspace));
    session.open(oneStep(), 0);
}

/// Types without a pause until it is killed, and tells of every key.
int typeForEver(const QString &folder)
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, folder);
    int keys = 0;
    QTimer typing;
    QObject::connect(&typing, &QTimer::timeout, &session, [&] {
        ++keys;
        session.edit(QStringLiteral("-- %1\n").arg(keys));
        std::printf("%d\n", keys);
        std::fflush(stdout);
    });
    typing.start(keyPause);
    return QCoreApplication::exec();
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

/// The program of the open step is saved as it is typed, whatever becomes of the window or the
/// disk.
class TestCodeSaving final : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void typingWithoutAPauseIsSaved();
    void killedWindowsLoseLittle();
    void fullDiskKeepsTheText();
    void stepIsLeftOnAFullDisk();
    void readOnlyDiskIsCalledSo();
    void someMinutesOfTypingKeepAVersion();
    void leavingAStepKeepsAVersion();
    void replacingKeepsAVersion();
    void outsideEditIsTaken();
    void outsideEditWhileTypingIsKept();
    void secondWindowCannotType();
    void otherProcessIsNamedAndEnds();

private:
    [[nodiscard]] QString path(const char *name = "w") const
    {
        return m_folder->filePath(QLatin1String(name));
    }
    GitHome m_home;
    std::unique_ptr<QTemporaryDir> m_folder;
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
    for (int run = 0; run < killings; ++run) {
        const QString folder = path(QByteArray("w") + QByteArray::number(run));
        QProcess process;
        process.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--type"), folder});
        int keys = 0;
        // Another number of keys each time, so that it dies at another moment of saving.
        while (keys < 15 + run && process.waitForReadyRead(30'000)) {
            while (process.canReadLine())
                keys = process.readLine().trimmed().toInt();
        }
        process.kill();
        QVERIFY(process.waitForFinished());
        for (const QByteArray &line : process.readAll().split('\n'))
            keys = std::max(keys, line.trimmed().toInt());
        QVERIFY(keys > 0);
        const QByteArray saved = contentOf(folder + QStringLiteral("/steps/A.lua"));
        const int known = saved.isEmpty() ? 0 : saved.mid(3).trimmed().toInt();
        QVERIFY2(saved.isEmpty() || known > 0, saved.constData());
        worst = std::max(worst, keys - known);
        // The next window finds all as it should be.
        Workspace workspace(folder);
        QVERIFY(!workspace.begin(oneStep(), QStringLiteral("A")));
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
    QCOMPARE(contentOf(path("w/steps/A.lua")), QByteArray("-- mine\n"));
    // It is tried again by itself.
    QTRY_VERIFY_WITH_TIMEOUT(session.isSaved(), 20'000);
    QCOMPARE(savedAgain.size(), 1);
    QCOMPARE(contentOf(path("w/steps/A.lua")), longText.toUtf8());
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
        session.open(oneStep(), 1);
        QVERIFY(!session.isSaved());
        session.open(oneStep(), 0);
        QCOMPARE(session.text(), longText);
    }
    session.save();
    QVERIFY(session.isSaved());
    QCOMPARE(contentOf(path("w/steps/A.lua")), longText.toUtf8());
}

void TestCodeSaving::readOnlyDiskIsCalledSo()
{
    // Nobody may make a folder there, whoever runs the tests.
    Workspace workspace(QStringLiteral("/proc/self/cradle"));
    const auto error = workspace.begin(oneStep());
    QVERIFY(error);
    QVERIFY2(!error->message.contains(QLatin1String("Unknown")), qPrintable(error->message));
    QCOMPARE(wordsForFault(EROFS), QStringLiteral("the disk is read-only"));
}

void TestCodeSaving::someMinutesOfTypingKeepAVersion()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    session.setKeepDelay(std::chrono::milliseconds(1));
    open(session, path());
    const auto versions = [&] {
        return session.workspace().history()->versions(QStringLiteral("A"));
    };
    // What is not changed makes none.
    QTest::qWait(20);
    QVERIFY(versions().empty());
    for (std::size_t count = 1; count <= 3; ++count) {
        session.edit(QStringLiteral("-- %1\n").arg(count));
        QTRY_COMPARE_WITH_TIMEOUT(versions().size(), count, 20'000);
        QCOMPARE(versions()[0].note.reason, VersionReason::Typed);
        QVERIFY(!versions()[0].note.passed);
        QCOMPARE(*session.workspace().history()->textOf(versions()[0]),
                 QByteArray("-- %1\n").replace("%1", QByteArray::number(qulonglong(count))));
    }
}

void TestCodeSaving::leavingAStepKeepsAVersion()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    session.edit(QStringLiteral("-- mine\n"));
    session.open(oneStep(), 1);
    const auto versions = session.workspace().history()->versions(QStringLiteral("A"));
    QCOMPARE(versions.size(), std::size_t(1));
    QCOMPARE(versions[0].note.reason, VersionReason::Typed);
    // Nothing was changed since.
    session.open(oneStep(), 0);
    session.open(oneStep(), 1);
    QCOMPARE(session.workspace().history()->versions(QStringLiteral("A")).size(), std::size_t(1));
}

void TestCodeSaving::replacingKeepsAVersion()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    session.edit(QStringLiteral("-- mine\n"));
    session.replace(QStringLiteral("-- other\n"));
    const auto versions = session.workspace().history()->versions(QStringLiteral("A"));
    QCOMPARE(versions.size(), std::size_t(1));
    QCOMPARE(*session.workspace().history()->textOf(versions[0]), QByteArray("-- mine\n"));
    QCOMPARE(session.text(), QStringLiteral("-- other\n"));
}

void TestCodeSaving::outsideEditIsTaken()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    session.edit(QStringLiteral("-- mine\n"));
    session.save();
    QSignalSpy outside(&session, &CodeSession::changedOutside);
    QVERIFY(!writeFile(path("w/steps/A.lua"), "-- theirs\n"));
    QTRY_COMPARE_WITH_TIMEOUT(outside.size(), 1, 20'000);
    QVERIFY(outside[0][0].toBool());
    QCOMPARE(session.text(), QStringLiteral("-- theirs\n"));
    QCOMPARE(contentOf(path("w/lab.lua")), QByteArray("-- theirs\n"));
    const auto versions = session.workspace().history()->versions(QStringLiteral("A"));
    QCOMPARE(versions.size(), std::size_t(2));
    QCOMPARE(*session.workspace().history()->textOf(versions[1]), QByteArray("-- mine\n"));
}

void TestCodeSaving::outsideEditWhileTypingIsKept()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    session.edit(QStringLiteral("-- mine\n"));
    session.save();
    session.edit(QStringLiteral("-- mine, and more\n"));
    QVERIFY(!writeFile(path("w/steps/A.lua"), "-- theirs\n"));
    QSignalSpy outside(&session, &CodeSession::changedOutside);
    session.save();
    QCOMPARE(outside.size(), 1);
    QVERIFY(!outside[0][0].toBool());
    QCOMPARE(contentOf(path("w/steps/A.lua")), QByteArray("-- mine, and more\n"));
    const auto versions = session.workspace().history()->versions(QStringLiteral("A"));
    QCOMPARE(*session.workspace().history()->textOf(versions.front()), QByteArray("-- theirs\n"));
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
    two.takeOver(oneStep(), 0);
    QVERIFY(two.isEditable());
    two.edit(QStringLiteral("-- two\n"));
    two.save();
    QSignalSpy failed(&one, &CodeSession::failed);
    one.edit(QStringLiteral("-- one\n"));
    one.save();
    QCOMPARE(failed.size(), 1);
    QVERIFY(!one.isEditable());
    QCOMPARE(contentOf(path("w/steps/A.lua")), QByteArray("-- two\n"));
}

void TestCodeSaving::otherProcessIsNamedAndEnds()
{
    QProcess other;
    other.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--type"), path()});
    QVERIFY(other.waitForReadyRead(30'000));
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    QVERIFY(!session.isEditable());
    QCOMPARE(session.workspace().holder()->process, other.processId());
    session.edit(QStringLiteral("-- mine\n"));
    session.save();
    QVERIFY(contentOf(path("w/steps/A.lua")) != "-- mine\n");
    // Its lock dies with it.
    other.kill();
    QVERIFY(other.waitForFinished());
    open(session, path());
    QVERIFY(session.isEditable());
    session.edit(QStringLiteral("-- mine\n"));
    session.save();
    QCOMPARE(contentOf(path("w/steps/A.lua")), QByteArray("-- mine\n"));
}

int main(int argc, char **argv)
{
    const QCoreApplication app(argc, argv);
    if (const QStringList arguments = QCoreApplication::arguments();
        arguments.value(1) == QLatin1String("--type"))
        return typeForEver(arguments.value(2));
    TestCodeSaving test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_code_saving.moc"
