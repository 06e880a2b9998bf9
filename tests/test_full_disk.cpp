// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "full_disk.h"

#include "model/files/preset_json.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/runs/run_tables.h"
#include "tasks/workspace/progress.h"
#include "tasks/workspace/workspace.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <functional>

#include <seccomp.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace cradle;

using Writer = std::function<std::optional<Error>(const QString &folder)>;
/// On a full disk everything that is saved stays as it was, and that it was not saved is said.
class TestFullDisk final : public QObject
{
    Q_OBJECT
private slots:
    void keepsWhatWasSaved_data();
    void keepsWhatWasSaved();
    void believesWhatTheDiskSaysAtTheEnd_data();
    void believesWhatTheDiskSaysAtTheEnd();
};

namespace {

/// More than a block, and more than any buffer that could hide that nothing was written.
const QString longText = QStringLiteral("-- a line of a program\n").repeated(2000);

LabFiles labOf(const QByteArray &text)
{
    LabFiles files;
    files.contents[QStringLiteral("lab.json")] = R"({"format": 1})";
    files.contents[QStringLiteral("S1/instructions.md")] = text;
    return files;
}

/// Bytes that no archive makes smaller.
QByteArray noise()
{
    QByteArray bytes(20'000, Qt::Uninitialized);
    quint32 state = 1;
    for (char &byte : bytes) {
        state = state * 1664525u + 1013904223u;
        byte = static_cast<char>(state >> 24);
    }
    return bytes;
}

QMap<QString, QByteArray> contentsOf(const QString &folder)
{
    QMap<QString, QByteArray> contents;
    const auto files = readLabFiles(folder);
    return files ? files->contents : contents;
}

Preset crowd(int count)
{
    Preset preset;
    preset.circles.resize(static_cast<std::size_t>(count));
    return preset;
}

} // namespace

void TestFullDisk::keepsWhatWasSaved_data()
{
    QTest::addColumn<Writer>("first");
    QTest::addColumn<Writer>("second");
    const auto program = [](const QString &text) -> Writer {
        return [text](const QString &folder) {
            return Workspace(folder).save(QStringLiteral("A"), text);
        };
    };
    QTest::newRow("program") << program(QStringLiteral("-- mine\n")) << program(longText);
    const auto progress = [](int steps) -> Writer {
        return [steps](const QString &folder) {
            ProgressStore store(folder + QStringLiteral("/progress.json"));
            for (int i = 0; i < steps; ++i)
                store.lab(QStringLiteral("lab")).tasks[QString::number(i)].passed = true;
            return store.save();
        };
    };
    QTest::newRow("progress") << progress(1) << progress(500);
    const auto scene = [](int count) -> Writer {
        return [count](const QString &folder) {
            return savePreset(crowd(count), folder + QStringLiteral("/scene.json"));
        };
    };
    QTest::newRow("scene") << scene(1) << scene(300);
    const auto table = [](int count) -> Writer {
        return [count](const QString &folder) {
            Recording recording;
            recording.append(initialWorld(crowd(count)));
            return saveRunTable(RunTable::States, recording, crowd(count),
                                folder + QStringLiteral("/states.csv"));
        };
    };
    QTest::newRow("table of a run") << table(1) << table(300);
    const auto archive = [](const QByteArray &text) -> Writer {
        return [text](const QString &folder) {
            return exportLab(labOf(text), folder + QStringLiteral("/lab.cradle"));
        };
    };
    QTest::newRow("lab as one file") << archive("# One") << archive(noise());
    const auto lab = [](const QByteArray &text) -> Writer {
        return [text](const QString &folder) {
            return saveLabFiles(labOf(text), {}, folder, OnConflict::Overwrite);
        };
    };
    QTest::newRow("lab") << lab("# One") << lab(longText.toUtf8());
}

void TestFullDisk::keepsWhatWasSaved()
{
    QFETCH(Writer, first);
    QFETCH(Writer, second);
    const QTemporaryDir folder;
    QVERIFY(!first(folder.path()));
    const auto before = contentsOf(folder.path());
    QVERIFY(!before.isEmpty());
    std::optional<Error> error;
    {
        const FullDisk full(4096);
        error = second(folder.path());
    }
    QVERIFY(error);
    QVERIFY2(error->message.contains(QLatin1String("so large")), qPrintable(error->message));
    QCOMPARE(contentsOf(folder.path()), before);
    // There is room again: nothing else is in the way.
    QVERIFY(!second(folder.path()));
    QVERIFY(contentsOf(folder.path()) != before);
}

void TestFullDisk::believesWhatTheDiskSaysAtTheEnd_data()
{
    QTest::addColumn<int>("fault");
    QTest::addColumn<bool>("isSaved");
    QTest::newRow("it could not write") << EIO << false;
    QTest::newRow("it is full after all") << ENOSPC << false;
    QTest::newRow("nothing of it can be waited for") << EINVAL << true;
}

/// A disk may take what is written, and say only when it is asked to finish that it failed.
void TestFullDisk::believesWhatTheDiskSaysAtTheEnd()
{
    QFETCH(int, fault);
    QFETCH(bool, isSaved);
    const QTemporaryDir folder;
    Workspace workspace(folder.path());
    QVERIFY(!workspace.save(QStringLiteral("A"), QStringLiteral("-- mine\n")));
    const auto before = contentsOf(folder.path());
    // In a process of its own: a filter stays for ever.
    constexpr int noFilter = 3;
    const pid_t child = fork();
    if (child == 0) {
        const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
        seccomp_rule_add(filter, SCMP_ACT_ERRNO(static_cast<unsigned>(fault)), SCMP_SYS(fsync), 0);
        if (seccomp_load(filter) != 0)
            _exit(noFilter);
        _exit(workspace.save(QStringLiteral("A"), QStringLiteral("-- other\n")) ? 1 : 0);
    }
    int status = 0;
    QCOMPARE(waitpid(child, &status, 0), child);
    QVERIFY(WIFEXITED(status));
    if (WEXITSTATUS(status) == noFilter)
        QSKIP("this kernel has no seccomp");
    QCOMPARE(WEXITSTATUS(status), isSaved ? 0 : 1);
    QCOMPARE(contentsOf(folder.path()) == before, !isSaved);
}

QTEST_APPLESS_MAIN(TestFullDisk)
#include "test_full_disk.moc"
