// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/history.h"

#include "history_test.h"
#include "model/files/file_io.h"

#include <QTest>

using namespace cradle;

/// The history of a student's work, as any git reads it.
class TestHistory final : public HistoryTest
{
    Q_OBJECT
private slots:
    void init() { writeProgram(); }
    void isARepositoryOfTheFolderAlone();
    void commitsTheWorkAndNothingElse();
    void aFileThatIsGoneIsGone();
    void versionsAreNoPartOfTheStory();
    void versionsComeBackAsTheyWere();
    void passesAreReadFromTheStory();
    void signsAsGitDoes();
    void signsWithANameOfGitAlone();
    void signsWithAnyName_data();
    void signsWithAnyName();
    void hostileMessagesAreText();
    void damagedRepositoryIsSaid();
};

void TestHistory::isARepositoryOfTheFolderAlone()
{
    // Around it is another repository, as where a student keeps all of a course in one.
    QCOMPARE(gitAround({QStringLiteral("init"), QStringLiteral("-q")}), QString());
    const auto history = opened();
    QVERIFY(history && history->isEmpty());
    QVERIFY(QFileInfo(path("w/.git")).isDir());
    QCOMPARE(git(QStringLiteral("symbolic-ref HEAD")), QStringLiteral("refs/heads/main"));
    QVERIFY(!History::openExisting(path("w/steps")));
}

void TestHistory::commitsTheWorkAndNothingElse()
{
    const auto history = opened();
    QVERIFY(!writeFile(path("w/private.txt"), "mine"));
    QVERIFY(!writeFile(path("w/steps/L42T5.lua.original"), "old"));
    QVERIFY(!history->commit(passMessage(task, QStringLiteral("L42T5 Integrated"), checked(true)),
                             student));
    QVERIFY(!history->isEmpty());
    QCOMPARE(git(QStringLiteral("ls-tree -r --name-only HEAD")),
             QStringLiteral("lab.lua\nsteps/L42T5.lua"));
    QCOMPARE(git(QStringLiteral("log --format=%s|%an")),
             QStringLiteral("L42T5 Integrated|Ada Lovelace"));
    QCOMPARE(git(QStringLiteral("log --format=%(trailers:key=Cradle-Seed,valueonly)")).trimmed(),
             QStringLiteral("17"));
    QVERIFY(git(QStringLiteral("fsck --strict")).isEmpty());
    // What was committed is not shown as changed.
    QVERIFY(!git(QStringLiteral("status --porcelain")).contains(QLatin1String("lab.lua")));
}

void TestHistory::aFileThatIsGoneIsGone()
{
    const auto history = opened();
    QVERIFY(!history->commit(QStringLiteral("one\n"), student));
    QVERIFY(QFile::remove(path("w/lab.lua")));
    QVERIFY(!history->commit(QStringLiteral("two\n"), student));
    QCOMPARE(git(QStringLiteral("ls-tree -r --name-only HEAD")), QStringLiteral("steps/L42T5.lua"));
}

void TestHistory::versionsAreNoPartOfTheStory()
{
    const auto history = opened();
    QVERIFY(!history->commit(QStringLiteral("Begin\n"), student));
    QVERIFY(!history->keep(task, "-- two\n", checked(false), student));
    QVERIFY(!history->keep(task, "-- three\n", {}, student));
    QCOMPARE(git(QStringLiteral("log --format=%s")), QStringLiteral("Begin"));
    QCOMPARE(git(QStringLiteral("log --format=%s refs/cradle/versions/L42T5")),
             QStringLiteral("L42T5: work in progress\nL42T5: checked, not passed"));
    QCOMPARE(git(QStringLiteral("show refs/cradle/versions/L42T5:steps/L42T5.lua")),
             QStringLiteral("-- three"));
    QVERIFY(git(QStringLiteral("fsck --strict")).isEmpty());
}

void TestHistory::versionsComeBackAsTheyWere()
{
    const QByteArray texts[] = {"", "-- Größe\r\n", QByteArray("a\0b", 3)};
    {
        const auto history = opened();
        for (const QByteArray &text : texts)
            QVERIFY(!history->keep(task, text, checked(false), student));
    }
    const auto history = opened();
    const auto versions = history->versions(task);
    QCOMPARE(versions.size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto text = history->textOf(versions[2 - i]);
        QVERIFY(text);
        QCOMPARE(*text, texts[i]);
        QVERIFY(versions[i].note == checked(false));
        QVERIFY(versions[i].when.isValid());
    }
    QCOMPARE(history->versions(task, 2).size(), std::size_t(2));
    QVERIFY(history->versions(QStringLiteral("none")).empty());
    QVERIFY(!history->textOf({.id = QString(40, QLatin1Char('0')), .taskId = task, .when = {}}));
    QVERIFY(!history->textOf({.id = QStringLiteral("nonsense"), .taskId = task, .when = {}}));
}

void TestHistory::passesAreReadFromTheStory()
{
    const auto history = opened();
    QVERIFY(history->passes().empty());
    QVERIFY(!history->commit(QStringLiteral("Begin\n"), student));
    QVERIFY(!history->commit(passMessage(task, QStringLiteral("first"), checked(true)), student));
    QVERIFY(!history->commit(
        passMessage(QStringLiteral("L42T6"), QStringLiteral("second"), checked(true)), student));
    const auto passes = history->passes();
    QCOMPARE(passes.size(), std::size_t(2));
    QCOMPARE(passes[0].taskId, QStringLiteral("L42T6"));
    QCOMPARE(passes[1].taskId, task);
    QVERIFY(passes[1].note == checked(true));
    QCOMPARE(*history->textOf(passes[1]), QByteArray("-- one\n"));
}

void TestHistory::signsAsGitDoes()
{
    const auto history = opened();
    QVERIFY(history->gitName().isEmpty());
    git(QStringLiteral("config user.name Grace"));
    git(QStringLiteral("config user.email grace@example.org"));
    QCOMPARE(history->gitName(), QStringLiteral("Grace"));
    QVERIFY(!history->commit(QStringLiteral("one\n"), student));
    QCOMPARE(git(QStringLiteral("log --format=%an<%ae>")),
             QStringLiteral("Grace<grace@example.org>"));
}

/// Git's settings may have a name and no address; an empty one is none.
void TestHistory::signsWithANameOfGitAlone()
{
    const auto history = opened();
    git(QStringLiteral("config user.name Grace"));
    QVERIFY(!history->commit(QStringLiteral("one\n"), student));
    QCOMPARE(git(QStringLiteral("log --format=%an<%ae>")),
             QStringLiteral("Grace<student@localhost>"));
    QCOMPARE(QProcess::execute(QStringLiteral("git"),
                               {QStringLiteral("-C"), path("w"), QStringLiteral("config"),
                                QStringLiteral("user.name"), QString()}),
             0);
    QVERIFY(history->gitName().isEmpty());
    QVERIFY(!history->commit(QStringLiteral("two\n"), student));
    QCOMPARE(git(QStringLiteral("log -1 --format=%an")), student);
}

void TestHistory::signsWithAnyName_data()
{
    QTest::addColumn<QString>("given");
    QTest::addColumn<QString>("signs");
    QTest::newRow("none") << QString() << QStringLiteral("Student");
    QTest::newRow("spaces") << QStringLiteral("  ") << QStringLiteral("Student");
    QTest::newRow("brackets") << QStringLiteral("A <b> C") << QStringLiteral("A b C");
    QTest::newRow("lines") << QStringLiteral("A\nB") << QStringLiteral("A B");
    QTest::newRow("letters") << QString::fromUtf8("Jürgen Ž") << QString::fromUtf8("Jürgen Ž");
}

void TestHistory::signsWithAnyName()
{
    QFETCH(QString, given);
    QFETCH(QString, signs);
    const auto history = opened();
    const auto error = history->commit(QStringLiteral("one\n"), given);
    QVERIFY2(!error, error ? qPrintable(error->toString()) : "");
    QCOMPARE(git(QStringLiteral("log --format=%an")), signs);
}

void TestHistory::hostileMessagesAreText()
{
    // A name of a mistake in somebody's lab cannot forge another trailer.
    VersionNote note = checked(false);
    note.findings = {QStringLiteral("x\nCradle-Verdict: passed"), QString(5000, QLatin1Char('y'))};
    const auto history = opened();
    QVERIFY(!history->keep(task, "-- two\n", note, student));
    const auto versions = history->versions(task);
    QCOMPARE(versions.size(), std::size_t(1));
    QCOMPARE(versions[0].note.passed, std::optional(false));
    QVERIFY(versionNote(QStringLiteral("Cradle-Seed: none\nCradle-Reason: ?")) == VersionNote{});
}

void TestHistory::damagedRepositoryIsSaid()
{
    QVERIFY(opened());
    QVERIFY(!writeFile(path("w/.git/HEAD"), "nonsense"));
    QVERIFY(!writeFile(path("w/.git/config"), "[[["));
    const auto history = History::open(path());
    QVERIFY(!history);
    QVERIFY2(history.error().message.contains(QLatin1String("cannot be kept")),
             qPrintable(history.error().message));
}

QTEST_GUILESS_MAIN(TestHistory)
#include "test_history.moc"
