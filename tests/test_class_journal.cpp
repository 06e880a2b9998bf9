// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_journal.h"
#include "tasks/grading/class_merge.h"

#include "model/files/json_schema.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

/// The index of the results of a class, and how those of several machines are put together.
class TestClassJournal : public QObject
{
    Q_OBJECT
private slots:
    void manifestIsReadBack();
    void whatIsNoManifestIsRefused_data();
    void whatIsNoManifestIsRefused();
    void whatCannotBeReadIsRefused();
    void journalTellsWhatIsDone();
    void folderHasOneWriter();
    void shardsMakeAClass();
    void whatIsMissingIsTold();
    void otherResultsAreRefused_data();
    void otherResultsAreRefused();
    void betterVerdictIsTaken_data();
    void betterVerdictIsTaken();
    void changedFileIsLeftOut();
    void nothingIsNoClass();

private:
    QTemporaryDir m_folder;

    /// A folder of its own.
    [[nodiscard]] QString folder(const QString &name) const
    {
        return m_folder.filePath(QString::fromLatin1(QTest::currentTestFunction())
                                 + QString::fromLatin1(QTest::currentDataTag()) + name);
    }
};

namespace {

Manifest manifestOf(int shard = 1, int shards = 1)
{
    Manifest made;
    made.version = {.cradle = QStringLiteral("Cradle 9"),
                    .labId = QStringLiteral("lab"),
                    .labVersion = QStringLiteral("2.1"),
                    .labHash = QStringLiteral("aa"),
                    .secretHash = QStringLiteral("bb"),
                    .language = QStringLiteral("de")};
    made.shard = {shard, shards};
    made.className = QStringLiteral("Physics 1");
    made.platform = Platform::Canvas;
    made.isolation = QStringLiteral("seccomp");
    made.missing = {{.id = QStringLiteral("z"),
                     .name = QStringLiteral("Zed"),
                     .number = QStringLiteral("26"),
                     .email = QStringLiteral("z@example.org")}};
    made.remarks = {QStringLiteral("one"), QStringLiteral("two")};
    made.classIds = {QStringLiteral("ada"), QStringLiteral("bob"), QStringLiteral("cy")};
    return made;
}

/// One more student in a folder of results.
void keep(ClassJournal &journal, const char *id, const QByteArray &result,
          const DoneStudent &done = {})
{
    QVERIFY(!journal.keep(QString::fromLatin1(id), result, done));
}

/// A folder of results of one shard, with its students.
void judge(const QString &folder, const Manifest &manifest,
           const std::vector<std::tuple<const char *, QByteArray, DoneStudent>> &students,
           bool ends = true)
{
    auto journal = ClassJournal::open(folder);
    QVERIFY(journal.ok());
    QVERIFY(!journal->begin(manifest));
    for (const auto &[id, result, done] : students)
        keep(*journal, id, result, done);
    if (ends)
        QVERIFY(!journal->finish(true));
}

} // namespace

void TestClassJournal::manifestIsReadBack()
{
    for (const int shards : {1, 3}) {
        Manifest written = manifestOf(shards, shards);
        written.complete = shards == 3;
        written.students[QStringLiteral("ada")] = {QStringLiteral("w"), QStringLiteral("r"), 1, 2};
        written.students[QStringLiteral("bob")] = {QStringLiteral("x"), QStringLiteral("s"), 0, 4};
        const auto read = manifestFrom(bytesOf(written), {});
        QVERIFY(read.ok());
        QVERIFY(read->version == written.version);
        QVERIFY(read->shard == written.shard);
        QCOMPARE(read->complete, written.complete);
        QCOMPARE(read->className, written.className);
        QVERIFY(read->platform == Platform::Canvas);
        QCOMPARE(read->isolation, written.isolation);
        QCOMPARE(read->missing.size(), std::size_t{1});
        QCOMPARE(read->missing[0].id, QStringLiteral("z"));
        QCOMPARE(read->missing[0].name, QStringLiteral("Zed"));
        QCOMPARE(read->missing[0].number, QStringLiteral("26"));
        QCOMPARE(read->missing[0].email, QStringLiteral("z@example.org"));
        QCOMPARE(read->remarks, written.remarks);
        QCOMPARE(read->classIds, written.classIds);
        QVERIFY(read->students == written.students);
        // Older ones did not say the language.
        QByteArray old = bytesOf(written);
        old.replace("\"language\": \"de\"", "\"other\": 1");
        QCOMPARE(manifestFrom(old, {})->version.language, QStringLiteral("en"));
    }
}

void TestClassJournal::whatIsNoManifestIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("no JSON") << QByteArray("results");
    QTest::newRow("another format") << QByteArray("{\"format\": 2}");
    QTest::newRow("a list") << QByteArray("[1]");
}

void TestClassJournal::whatIsNoManifestIsRefused()
{
    QFETCH(QByteArray, text);
    const auto read = manifestFrom(text, QStringLiteral("there"));
    QVERIFY(!read.ok());
    QCOMPARE(read.error().file, QStringLiteral("there"));
}

/// Also that of a process that was killed in the middle of a line.
void TestClassJournal::whatCannotBeReadIsRefused()
{
    const QString at = folder(QString());
    const QString manifest = at + QStringLiteral("/manifest.json");
    QVERIFY(QDir().mkpath(manifest));
    const auto read = readManifest(at);
    QVERIFY(!read.ok());
    QCOMPARE(read.error().toString(), readFile(manifest, 1000).error().toString());
}

void TestClassJournal::journalTellsWhatIsDone()
{
    const QString at = folder({});
    QVERIFY(!readManifest(at)->has_value());
    {
        auto journal = ClassJournal::open(at);
        QVERIFY(!journal->begin(manifestOf()));
        keep(*journal, "ada", "{\"a\": 1}", {.workHash = QStringLiteral("w"), .notGraded = 3});
        keep(*journal, "bob", "{}", {.notPassed = 5});
        QCOMPARE(journal->manifest().students.size(), std::size_t{2});
    }
    QFile lines(at + QStringLiteral("/manifest.journal"));
    QVERIFY(lines.open(QIODevice::Append));
    lines.write("{\"id\": \"cy\", \"wo");
    lines.close();
    const auto read = readManifest(at);
    QVERIFY(read.ok() && read->has_value());
    const Manifest &manifest = **read;
    QVERIFY(!manifest.complete);
    QCOMPARE(manifest.students.size(), std::size_t{2});
    // SHA-256 of what was written, worked out by `sha256sum`.
    const DoneStudent ada{.workHash = QStringLiteral("w"),
                          .resultHash = QStringLiteral(
                              "f9d86028c6e0d64e225186f96acb69338b2c59764df79162107f5c4bb34d1310"),
                          .notGraded = 3};
    QVERIFY(manifest.students.at(QStringLiteral("ada")) == ada);
    QCOMPARE(manifest.students.at(QStringLiteral("bob")).notPassed, 5);
    QCOMPARE(manifest.students.at(QStringLiteral("bob")).resultHash,
             QStringLiteral("44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a"));
    QFile result(at + QStringLiteral("/students/ada.json"));
    QVERIFY(result.open(QIODevice::ReadOnly));
    QCOMPARE(result.readAll(), QByteArray("{\"a\": 1}"));
    // Who goes on takes over what was done, and in the end there is no journal.
    auto next = ClassJournal::open(at);
    QVERIFY(!next->begin(manifest));
    QCOMPARE((*readManifest(at))->students.size(), std::size_t{2});
    keep(*next, "cy", "{}");
    QVERIFY(!next->finish(true));
    QVERIFY(!QFile::exists(lines.fileName()));
    QVERIFY((*readManifest(at))->complete);
    QCOMPARE((*readManifest(at))->students.size(), std::size_t{3});
}

void TestClassJournal::folderHasOneWriter()
{
    const QString at = folder({});
    {
        const auto first = ClassJournal::open(at);
        QVERIFY(first.ok());
        const auto second = ClassJournal::open(at);
        QVERIFY(!second.ok());
        QVERIFY(second.error().message.contains(QLatin1String("another process")));
        QCOMPARE(second.error().file, at);
    }
    QVERIFY(ClassJournal::open(at).ok());
}

void TestClassJournal::shardsMakeAClass()
{
    judge(folder(QStringLiteral("1")), manifestOf(1, 2), {{"ada", "1", {}}, {"bob", "2", {}}});
    judge(folder(QStringLiteral("2")), manifestOf(2, 2), {{"bob", "2", {}}, {"cy", "3", {}}});
    const auto merged = mergeResults({folder(QStringLiteral("1")), folder(QStringLiteral("2"))});
    QVERIFY(merged.ok());
    QCOMPARE(merged->files.size(), std::size_t{3});
    QCOMPARE(merged->files.at(QStringLiteral("ada")),
             folder(QStringLiteral("1")) + QStringLiteral("/students/ada.json"));
    QCOMPARE(merged->files.at(QStringLiteral("cy")),
             folder(QStringLiteral("2")) + QStringLiteral("/students/cy.json"));
    QVERIFY(merged->lacking.isEmpty());
    QCOMPARE(merged->remarks,
             (QStringList{QStringLiteral("judged more than once, with the same result: bob")}));
    QCOMPARE(merged->manifest.students.size(), std::size_t{3});
    QVERIFY(merged->manifest.shard == Shard{});
    QVERIFY(!merged->manifest.complete);
    QCOMPARE(merged->manifest.className, QStringLiteral("Physics 1"));
}

void TestClassJournal::whatIsMissingIsTold()
{
    const QString second = folder(QStringLiteral("2"));
    Manifest elsewhere = manifestOf(2, 14);
    judge(second, elsewhere, {{"ada", "1", {}}}, false);
    // Of ten all are told.
    const auto few = manifestOf(3, 12);
    judge(folder(QStringLiteral("few")), few, {});
    judge(folder(QStringLiteral("fewer")), manifestOf(4, 12), {});
    const auto told =
        mergeResults({folder(QStringLiteral("few")), folder(QStringLiteral("fewer"))});
    QVERIFY(told.ok());
    QCOMPARE(told->remarks.value(0),
             QStringLiteral("missing of 12 shards: 1, 2, 5, 6, 7, 8, 9, 10, "
                            "11, 12"));
    elsewhere.isolation = QStringLiteral("none");
    elsewhere.shard.index = 3;
    const QString third = folder(QStringLiteral("3"));
    judge(third, elsewhere, {});
    const QString none = folder(QStringLiteral("none"));
    const auto merged = mergeResults({second, none, third});
    QVERIFY(merged.ok());
    QCOMPARE(merged->lacking, (QStringList{QStringLiteral("bob"), QStringLiteral("cy")}));
    QCOMPARE(merged->remarks,
             (QStringList{second + QStringLiteral(": shard 2 of 14 did not come to its end"),
                          none + QStringLiteral(": there are no results; its shard never began"),
                          third + QStringLiteral(": other isolation: none"),
                          QStringLiteral("missing of 14 shards: 1, 4, 5, 6, 7, 8, 9, 10, 11, 12 "
                                         "and 2 more"),
                          QStringLiteral("without results: bob, cy")}));
}

void TestClassJournal::otherResultsAreRefused_data()
{
    QTest::addColumn<QString>("what");
    QTest::newRow("version") << "another version";
    QTest::newRow("class") << "another class";
    QTest::newRow("shards") << "another number of shards";
    QTest::newRow("result") << "the results of ada differ from those in";
}

void TestClassJournal::otherResultsAreRefused()
{
    QFETCH(QString, what);
    const QString first = folder(QStringLiteral("1"));
    const QString second = folder(QStringLiteral("2"));
    judge(first, manifestOf(1, 2), {{"ada", "1", {}}});
    Manifest other = manifestOf(2, 2);
    if (what.endsWith(QLatin1String("version")))
        other.version.secretHash = QStringLiteral("cc");
    else if (what.endsWith(QLatin1String("class")))
        other.classIds.append(QStringLiteral("dot"));
    else if (what.endsWith(QLatin1String("shards")))
        other.shard.count = 3;
    judge(second, other, {{"ada", what.startsWith(QLatin1String("the")) ? "2" : "1", {}}});
    const auto merged = mergeResults({first, second});
    QVERIFY(!merged.ok());
    QVERIFY2(merged.error().message.contains(what), qPrintable(merged.error().message));
    QVERIFY(merged.error().file.startsWith(second));
}

void TestClassJournal::betterVerdictIsTaken_data()
{
    QTest::addColumn<int>("first"); // steps without a verdict
    QTest::addColumn<int>("second");
    QTest::addColumn<bool>("sameWork");
    QTest::addColumn<int>("taken"); // of which of them; 0: none
    QTest::newRow("second is whole") << 2 << 0 << true << 2;
    QTest::newRow("first is whole") << 0 << 2 << true << 1;
    QTest::newRow("second is better") << 2 << 1 << true << 2;
    QTest::newRow("first is better") << 1 << 2 << true << 1;
    QTest::newRow("neither") << 2 << 2 << true << 1;
    QTest::newRow("neither, of one step") << 1 << 1 << true << 1;
    QTest::newRow("first is whole, second lacks one") << 0 << 1 << true << 1;
    QTest::newRow("both are whole") << 0 << 0 << true << 0;
    QTest::newRow("other work, better") << 2 << 0 << false << 0;
    QTest::newRow("other work, worse") << 0 << 2 << false << 0;
}

/// Of the same work with other results.
void TestClassJournal::betterVerdictIsTaken()
{
    QFETCH(int, first);
    QFETCH(int, second);
    QFETCH(bool, sameWork);
    QFETCH(int, taken);
    const QStringList at{folder(QStringLiteral("1")), folder(QStringLiteral("2"))};
    const QString other = sameWork ? QStringLiteral("w") : QStringLiteral("v");
    judge(at[0], manifestOf(1, 2),
          {{"ada", "1", {.workHash = QStringLiteral("w"), .notGraded = first}}});
    judge(at[1], manifestOf(2, 2), {{"ada", "2", {.workHash = other, .notGraded = second}}});
    const auto merged = mergeResults(at);
    QCOMPARE(merged.ok(), taken > 0);
    if (taken == 0)
        return;
    const QString id = QStringLiteral("ada");
    QCOMPARE(merged->files.at(id), at[taken - 1] + QStringLiteral("/students/ada.json"));
    QCOMPARE(merged->manifest.students.at(id).notGraded, taken == 1 ? first : second);
    QVERIFY(!merged->remarks.join(QLatin1Char('\n')).contains(QLatin1String("more than once")));
}

void TestClassJournal::changedFileIsLeftOut()
{
    const QString at = folder({});
    judge(at, manifestOf(), {{"ada", "1", {}}, {"bob", "2", {}}});
    QFile changed(at + QStringLiteral("/students/bob.json"));
    QVERIFY(changed.open(QIODevice::WriteOnly));
    changed.write("3");
    changed.close();
    const auto merged = mergeResults({at});
    QVERIFY(merged.ok());
    QCOMPARE(merged->files.size(), std::size_t{1});
    QCOMPARE(merged->remarks.front(),
             changed.fileName() + QStringLiteral(" is not as its manifest says, and is left out"));
    QCOMPARE(merged->lacking, (QStringList{QStringLiteral("bob"), QStringLiteral("cy")}));
}

void TestClassJournal::nothingIsNoClass()
{
    QVERIFY(!mergeResults({}).ok());
    QVERIFY(!mergeResults({folder({})}).ok());
}

QTEST_GUILESS_MAIN(TestClassJournal)
#include "test_class_journal.moc"
