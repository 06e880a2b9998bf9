// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_test.h"
#include "tasks/workspace/progress.h"

#include <QDir>
#include <QTest>

#include <thread>
#include <vector>

using namespace cradle;

class TestProgress : public ProgressTest
{
    Q_OBJECT
private slots:
    void init() { takeNewFolder(); }
    void keepsAllBetweenStarts();
    void beginsWithNothing();
    void keepsLabsApart();
    void makesTheFolderOfTheFile();
    void saysWhatKeptItFromSaving();
    void savingLeavesNothingBeside();
    void keepsNothingWithoutAPath();
    void staleWindowTakesNoPassAway();
    void windowsThatSaveAtOnceLoseNothing();
};

namespace {

LabProgress someProgress()
{
    Preset edited;
    edited.name = QStringLiteral("größer");
    edited.gravity = {0.1, -9.81};
    edited.timestep = 1.0 / 3.0 / 7.0;
    edited.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous};
    edited.circles.resize(2);
    edited.circles[1].body.position = {1.0 / 3.0, 2.0};
    LabProgress progress;
    progress.currentTask = QStringLiteral("L42T5");
    progress.tasks[QStringLiteral("L42T1")] = {.passed = true, .hintsOpened = 3};
    progress.tasks[QStringLiteral("L42T5")] = {.hintsOpened = 1, .edited = edited};
    progress.tasks[QStringLiteral("L42T8")] = {
        .passed = true,
        .pass = {.when = QDateTime({2026, 11, 21}, {22, 10, 7}, Qt::UTC),
                 .commit = QStringLiteral("L42T8 größer")},
        .guess = {.answer = 2, .watched = true, .revealed = true}};
    progress.tasks[QStringLiteral("L42T9")] = {.guess = {.answer = Guess::notSure}};
    progress.tasks[QStringLiteral("L42T10")] = {.guess = {.watched = true}};
    return progress;
}

} // namespace

void TestProgress::keepsAllBetweenStarts()
{
    ProgressStore store(path());
    store.lab(lab) = someProgress();
    QVERIFY(!store.save());
    ProgressStore again(path());
    QVERIFY(!again.load());
    QVERIFY(again.lab(lab) == someProgress());
    // Writing what was read gives the same bytes.
    const QByteArray first = content(path());
    QVERIFY(!again.save());
    QCOMPARE(content(path()), first);
}

void TestProgress::beginsWithNothing()
{
    ProgressStore store(path());
    QVERIFY(!store.load());
    QVERIFY(store.lab(lab) == LabProgress{});
    QVERIFY(!QFile::exists(path()));
}

void TestProgress::keepsLabsApart()
{
    ProgressStore store(path());
    store.lab(lab) = someProgress();
    store.lab(QStringLiteral("other")).currentTask = QStringLiteral("X1");
    QVERIFY(!store.save());
    ProgressStore again(path());
    QVERIFY(!again.load());
    QVERIFY(again.lab(lab) == someProgress());
    QCOMPARE(again.lab(QStringLiteral("other")).currentTask, QStringLiteral("X1"));
}

void TestProgress::makesTheFolderOfTheFile()
{
    const QString deep = m_folder->filePath(QStringLiteral("a/b/p.json"));
    ProgressStore store(deep);
    QVERIFY(!store.save());
    QVERIFY(QFile::exists(deep));
}

void TestProgress::saysWhatKeptItFromSaving()
{
    // A folder cannot be made where a file is.
    write("in the way");
    const QString below = path() + QStringLiteral("/p.json");
    ProgressStore store(below);
    const auto error = store.save();
    QVERIFY(error);
    QCOMPARE(error->file, below);
    QVERIFY(error->message.contains(QStringLiteral("could not be saved")));
    QCOMPARE(content(path()), QByteArray("in the way"));
}

void TestProgress::savingLeavesNothingBeside()
{
    ProgressStore store(path());
    store.lab(lab) = someProgress();
    QVERIFY(!store.save());
    const QByteArray before = content(path());
    // QSaveFile writes beside the file and renames: nothing of it is left over.
    QVERIFY(!store.save());
    QCOMPARE(content(path()), before);
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 1);
}

void TestProgress::keepsNothingWithoutAPath()
{
    ProgressStore store{QString()};
    QVERIFY(!store.load());
    store.lab(lab) = someProgress();
    QVERIFY(!store.save());
}

void TestProgress::staleWindowTakesNoPassAway()
{
    ProgressStore stale(path());
    QVERIFY(!stale.load());
    stale.lab(lab).tasks[QStringLiteral("L42T1")].hintsOpened = 2;
    ProgressStore other(path());
    QVERIFY(!other.load());
    other.lab(lab).tasks[QStringLiteral("L42T1")] = {
        .passed = true, .pass = {.when = {}, .commit = QStringLiteral("L42T1 mine")}};
    other.lab(QStringLiteral("another")).tasks[QStringLiteral("A")].passed = true;
    QVERIFY(!other.save());
    QVERIFY(!stale.save());
    ProgressStore after(path());
    QVERIFY(!after.load());
    QVERIFY(after.isPassed(lab, QStringLiteral("L42T1")));
    QVERIFY(after.isPassed(QStringLiteral("another"), QStringLiteral("A")));
    QCOMPARE(after.lab(lab).tasks[QStringLiteral("L42T1")].hintsOpened, 2);
    QCOMPARE(after.lab(lab).tasks[QStringLiteral("L42T1")].pass.commit,
             QStringLiteral("L42T1 mine"));
}

void TestProgress::windowsThatSaveAtOnceLoseNothing()
{
    constexpr int windows = 4;
    constexpr int saves = 10;
    std::vector<std::thread> running;
    for (int window = 0; window < windows; ++window) {
        running.emplace_back([this, window] {
            for (int i = 0; i < saves; ++i) {
                ProgressStore store(path());
                (void)store.load();
                const QString step = QStringLiteral("%1-%2").arg(window).arg(i);
                store.lab(lab).tasks[step].passed = true;
                (void)store.save();
            }
        });
    }
    for (std::thread &each : running)
        each.join();
    ProgressStore after(path());
    QVERIFY(!after.load());
    QCOMPARE(after.lab(lab).tasks.size(), std::size_t(windows * saves));
}

QTEST_GUILESS_MAIN(TestProgress)
#include "test_progress.moc"
