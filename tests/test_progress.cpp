// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/progress.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <thread>
#include <vector>

using namespace cradle;

class TestProgress : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void keepsAllBetweenStarts();
    void beginsWithNothing();
    void keepsLabsApart();
    void makesTheFolderOfTheFile();
    void movesABrokenFileAside_data();
    void movesABrokenFileAside();
    void keepsEveryBrokenFile();
    void keepsAFileThatIsTooLarge();
    void takesNoMoreThanIsRight_data();
    void takesNoMoreThanIsRight();
    void leavesAnImpossibleSceneOut();
    void saysWhatKeptItFromSaving();
    void savingLeavesNothingBeside();
    void keepsNothingWithoutAPath();
    void staleWindowTakesNoPassAway();
    void windowsThatSaveAtOnceLoseNothing();

private:
    [[nodiscard]] QString path() const { return m_folder->filePath(QStringLiteral("p.json")); }
    void write(const QByteArray &text) const;
    [[nodiscard]] QByteArray content(const QString &file) const;

    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

const QString lab = QStringLiteral("lab-4.2");

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

void TestProgress::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestProgress::write(const QByteArray &text) const
{
    QFile file(path());
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
}

QByteArray TestProgress::content(const QString &file) const
{
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
}

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

void TestProgress::movesABrokenFileAside_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("cut off") << QByteArray(R"({"format": 1, "labs": {"lab-4.2": {"cur)");
    QTest::newRow("a list") << QByteArray("[]");
    QTest::newRow("no format") << QByteArray("{}");
    QTest::newRow("a later format") << QByteArray(R"({"format": 2, "labs": {}})");
    QTest::newRow("binary") << QByteArray("\x00\xff\xfe\x01", 4);
}

void TestProgress::movesABrokenFileAside()
{
    QFETCH(QByteArray, text);
    write(text);
    ProgressStore store(path());
    const auto error = store.load();
    QVERIFY(error);
    QCOMPARE(error->file, path());
    QVERIFY(!QFile::exists(path()));
    // Its place is named, and what was in it is still there.
    const QStringList left = QDir(m_folder->path()).entryList(QDir::Files);
    QCOMPARE(left.size(), 1);
    QVERIFY(error->message.contains(left[0]));
    QCOMPARE(content(m_folder->filePath(left[0])), text);
    QVERIFY(store.lab(lab) == LabProgress{});
    QVERIFY(!store.save());
    QVERIFY(!store.load());
    QCOMPARE(content(m_folder->filePath(left[0])), text);
}

/// A broken file is somebody's work, the second as well as the first.
void TestProgress::keepsEveryBrokenFile()
{
    const QByteArray texts[] = {"first, broken", "second, broken"};
    for (const QByteArray &text : texts) {
        write(text);
        ProgressStore store(path());
        QVERIFY(store.load());
    }
    QByteArrayList kept;
    for (const QString &name : QDir(m_folder->path()).entryList(QDir::Files))
        kept.append(content(m_folder->filePath(name)));
    for (const QByteArray &text : texts)
        QVERIFY2(kept.contains(text), text.constData());
}

void TestProgress::keepsAFileThatIsTooLarge()
{
    constexpr qint64 size = 65LL * 1024 * 1024;
    {
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly) && file.resize(size));
    }
    ProgressStore store(path());
    QVERIFY(store.load());
    QVERIFY(!store.save());
    bool kept = false;
    for (const QFileInfo &file : QDir(m_folder->path()).entryInfoList(QDir::Files))
        kept = kept || file.size() == size;
    QVERIFY(kept);
}

void TestProgress::takesNoMoreThanIsRight_data()
{
    QTest::addColumn<QByteArray>("labs");
    QTest::newRow("labs are a list") << QByteArray("[]");
    QTest::newRow("lab is a number") << QByteArray(R"({"lab-4.2": 5})");
    QTest::newRow("tasks are a text") << QByteArray(R"({"lab-4.2": {"tasks": "all"}})");
    QTest::newRow("task is null") << QByteArray(R"({"lab-4.2": {"tasks": {"L42T1": null}}})");
    QTest::newRow("passed is a text")
        << QByteArray(R"({"lab-4.2": {"tasks": {"L42T1": {"passed": "yes"}}}})");
    QTest::newRow("hints are many")
        << QByteArray(R"({"lab-4.2": {"tasks": {"L42T1": {"hints": -1e300}}}})");
    QTest::newRow("prediction is a list")
        << QByteArray(R"({"lab-4.2": {"tasks": {"L42T1": {"prediction": [1]}}}})");
    QTest::newRow("answer is below all")
        << QByteArray(R"({"lab-4.2": {"tasks": {"L42T1": {"prediction": {"answer": -2}}}}})");
    QTest::newRow("answer is a part of one")
        << QByteArray(R"({"lab-4.2": {"tasks": {"L42T1": {"prediction": {"answer": 0.5}}}}})");
    QTest::newRow("answer is a text")
        << QByteArray(R"({"lab-4.2": {"tasks": {"L42T1": {"prediction": {"answer": "1"}}}}})");
    QTest::newRow("no moment of passing")
        << QByteArray(R"({"lab-4.2": {"tasks": {"L42T1": {"passed_at": "yesterday"}}}})");
}

void TestProgress::takesNoMoreThanIsRight()
{
    QFETCH(QByteArray, labs);
    write("{\"format\": 1, \"labs\": " + labs + "}");
    ProgressStore store(path());
    QVERIFY(!store.load());
    for (const auto &[id, task] : store.lab(lab).tasks) {
        QVERIFY(!task.passed);
        QCOMPARE(task.hintsOpened, 0);
        QVERIFY(task.guess == Guess{});
        QVERIFY(!task.pass.when.isValid());
    }
}

void TestProgress::leavesAnImpossibleSceneOut()
{
    write(R"({"format": 1, "labs": {"lab-4.2": {"current": "L42T1", "tasks": {"L42T1":
             {"passed": true, "preset": {"format": 1, "circles": [{"position": [0]}]}}}}}})");
    ProgressStore store(path());
    QVERIFY(!store.load());
    const TaskProgress &task = store.lab(lab).tasks[QStringLiteral("L42T1")];
    QVERIFY(task.passed);
    QVERIFY(!task.edited);
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
