// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/hand_in/hand_in.h"

#include "hand_in_test.h"
#include "model/files/file_io.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/workspace/workspace.h"

#include <QDir>
#include <QTest>

using namespace cradle;

/// What is handed in is read without trust.
class TestHandInRefused final : public HandInTest
{
    Q_OBJECT
private slots:
    void initTestCase() { readTheLab(); }
    void init() { workOnTheLab(); }
    void forgedPassesAreNotBelieved();
    void changedFilesAreRefused_data();
    void changedFilesAreRefused();
    void hostileHistoryIsOnlyText();
    void longHistoryOpensSoon();
};

/// A commit, a version or a file that says "passed" is only that: something it says.
void TestHandInRefused::forgedPassesAreNotBelieved()
{
    const QString id = QStringLiteral("BALL2");
    const VersionNote passed{.reason = VersionReason::Checked, .passed = true};
    auto history = History::open(path("w"));
    QVERIFY(history);
    QVERIFY(!(*history)->commit(passMessage(id, QStringLiteral("BALL2 done"), passed), {}));
    QVERIFY(!(*history)->keep(id, "-- nothing\n", passed, {}));
    QVERIFY(!writeFile(path("w/progress.json"),
                       R"({"format": 1, "labs": {"bouncing-ball": {"tasks": {"BALL2":
                          {"passed": true}, "BALL3": {"passed": true}}}}})"));
    const HandIn handIn = gathered();
    QCOMPARE(handIn.report.passedCount(), 1);
    QCOMPARE(handIn.manifest.steps[1].verdict, QStringLiteral("stopped"));
    QCOMPARE(handIn.manifest.steps[2].verdict, QStringLiteral("not done"));
}

void TestHandInRefused::changedFilesAreRefused_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("content"); // null: removed
    QTest::addColumn<QString>("words");
    QTest::newRow("a better program")
        << "steps/BALL1.lua" << QByteArray("-- better") << "was changed";
    QTest::newRow("another report") << "report.pdf" << QByteArray("%PDF2") << "was changed";
    QTest::newRow("one more file")
        << "steps/BALL3.lua" << QByteArray("-- more") << "not in the manifest";
    QTest::newRow("a file less") << "lab.lua" << QByteArray() << "is missing";
    QTest::newRow("no manifest") << "manifest.json" << QByteArray("{}") << "manifest.json";
    QTest::newRow("a later format")
        << "manifest.json" << QByteArray(R"({"format": 2})") << "format 1";
    QTest::newRow("a broken manifest") << "manifest.json" << QByteArray("[[[[") << "manifest.json";
    QTest::newRow("a manifest of nothing")
        << "manifest.json" << QByteArray(R"({"format": 1})") << "not in the manifest";
    QTest::newRow("hashes are numbers")
        << "manifest.json" << QByteArray(R"({"format": 1, "files": {"lab.lua": 5}})") << "manifest";
}

void TestHandInRefused::changedFilesAreRefused()
{
    QFETCH(QString, file);
    QFETCH(QByteArray, content);
    QFETCH(QString, words);
    WorkFiles files = *unpackWork(packed(), {});
    if (content.isNull())
        files.remove(file);
    else
        files[file] = content;
    const auto archive = *packFiles(files);
    const auto work = unpackWork(archive, QStringLiteral("ada.cradle-work"));
    QVERIFY(!work);
    QCOMPARE(work.error().file, QStringLiteral("ada.cradle-work"));
    QVERIFY2(work.error().message.contains(words), qPrintable(work.error().message));
    QVERIFY(!writeFile(path("ada.cradle-work"), archive));
    QVERIFY(!openHandIn(path("ada.cradle-work"), path("opened")));
    QVERIFY(QDir(path("opened")).isEmpty());
}

/// Names of steps that would be other references, dates that are none, programs that are long.
void TestHandInRefused::hostileHistoryIsOnlyText()
{
    HandIn handIn = gathered();
    handIn.files[QStringLiteral("history.json")] =
        R"([{"step": "../../heads/main", "program": "x", "when": "never"},
            {"step": "a..b", "program": "x"}, {"step": "", "program": "x"}, 5, null,
            {"step": "BALL1", "program": "-- kept", "message": 7, "when": "2026-01-01T00:00:00Z"}])";
    QVERIFY(!writeFile(path("ada.cradle-work"), *packHandIn(handIn, reportName, "%PDF")));
    const auto folder = openHandIn(path("ada.cradle-work"), path("opened"));
    if (!folder) // refused is as well
        return;
    QCOMPARE(GitHome::git(*folder, {QStringLiteral("log"), QStringLiteral("--format=%s")}),
             QStringLiteral("Handed in"));
    Workspace workspace(*folder);
    workspace.beginReading();
    QCOMPARE(workspace.history()->versions(QStringLiteral("BALL1")).size(), std::size_t(1));
}

/// Fifty thousand bytes that took minutes to open: each version waited for the disk.
void TestHandInRefused::longHistoryOpensSoon()
{
    HandIn handIn = gathered();
    std::vector<KeptProgram> programs;
    for (int i = 0; i < 5000; ++i)
        programs.push_back({{.id = {},
                             .taskId = QStringLiteral("BALL%1").arg(i % 3 + 1),
                             .when = m_when,
                             .note = {.reason = VersionReason::Checked, .passed = true}},
                            QStringLiteral("-- %1\n").arg(i)});
    handIn.files[QStringLiteral("history.json")] = historyText(programs);
    QVERIFY(!writeFile(path("ada.cradle-work"), *packHandIn(handIn, reportName, "%PDF")));
    const auto folder = openHandIn(path("ada.cradle-work"), path("opened"));
    QVERIFY(folder);
    Workspace workspace(*folder);
    workspace.beginReading();
    QCOMPARE(workspace.history()->versions(QStringLiteral("BALL1"), 5000).size(),
             std::size_t(1667));
}

QTEST_GUILESS_MAIN(TestHandInRefused)
#include "test_hand_in_refused.moc"
