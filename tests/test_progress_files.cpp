// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_test.h"
#include "tasks/workspace/progress.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace cradle;

/// Files of progress that are broken, too large, or of other sense are kept, and do no harm.
class TestProgressFiles : public ProgressTest
{
    Q_OBJECT
private slots:
    void init() { takeNewFolder(); }
    void movesABrokenFileAside_data();
    void movesABrokenFileAside();
    void keepsEveryBrokenFile();
    void keepsAFileThatIsTooLarge();
    void keepsWhatBreaksMeanwhile();
    void writesNothingThatIsEmpty();
    void takesNoMoreThanIsRight_data();
    void takesNoMoreThanIsRight();
    void leavesAnImpossibleSceneOut();
};

void TestProgressFiles::movesABrokenFileAside_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("why");
    const auto add = [](const char *name, const QByteArray &text, const char *why) {
        QTest::newRow(name) << text << QString::fromUtf8(why);
    };
    add("empty", {}, "this is not JSON");
    add("cut off", R"({"format": 1, "labs": {"lab-4.2": {"cur)", "this is not JSON");
    add("a list", "[]", "right would be an object with format and labs");
    add("no format", "{}", "\"format\" is missing");
    add("format as a text", R"({"format": "1"})", "right would be 1, the format that this");
    add("a later format", R"({"format": 2, "labs": {}})", "needs a newer Cradle: format 2");
    add("binary", QByteArray("\x00\xff\xfe\x01", 4), "this is not JSON");
}

void TestProgressFiles::movesABrokenFileAside()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, why);
    write(text);
    ProgressStore store(path());
    const auto error = store.load();
    QVERIFY(error);
    QVERIFY2(error->message.contains(why), qPrintable(error->message));
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
void TestProgressFiles::keepsEveryBrokenFile()
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

void TestProgressFiles::keepsAFileThatIsTooLarge()
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

/// The file was read well, and somebody else has broken it since.
void TestProgressFiles::keepsWhatBreaksMeanwhile()
{
    ProgressStore store(path());
    QVERIFY(!store.load());
    store.lab(lab).tasks[QStringLiteral("L42T1")].passed = true;
    write("broken meanwhile");
    QVERIFY(!store.save());
    QCOMPARE(content(path() + QStringLiteral(".unreadable")), QByteArray("broken meanwhile"));
    ProgressStore again(path());
    QVERIFY(!again.load());
    QVERIFY(again.isPassed(lab, QStringLiteral("L42T1")));
}

void TestProgressFiles::writesNothingThatIsEmpty()
{
    ProgressStore store(path());
    store.lab(lab).tasks[QStringLiteral("L42T1")].hintsOpened = 1;
    QVERIFY(!store.save());
    const QJsonObject all = QJsonDocument::fromJson(content(path())).object();
    const QJsonObject task =
        all[QStringLiteral("labs")][lab][QStringLiteral("tasks")][QStringLiteral("L42T1")]
            .toObject();
    QCOMPARE(task.keys(), (QStringList{QStringLiteral("hints"), QStringLiteral("passed")}));
    QVERIFY(!store.isPassed(lab, QStringLiteral("L42T1")));
    QVERIFY(!store.isPassed(lab, QStringLiteral("nowhere")));
}

void TestProgressFiles::takesNoMoreThanIsRight_data()
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

void TestProgressFiles::takesNoMoreThanIsRight()
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

void TestProgressFiles::leavesAnImpossibleSceneOut()
{
    write(R"({"format": 1, "labs": {"lab-4.2": {"current": "L42T1", "tasks": {"L42T1":
             {"passed": true, "preset": {"format": 1, "circles": [{"position": [0]}]}}}}}})");
    ProgressStore store(path());
    QVERIFY(!store.load());
    const TaskProgress &task = store.lab(lab).tasks[QStringLiteral("L42T1")];
    QVERIFY(task.passed);
    QVERIFY(!task.edited);
}

QTEST_GUILESS_MAIN(TestProgressFiles)
#include "test_progress_files.moc"
