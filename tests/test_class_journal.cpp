// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_journal.h"
#include "tests/class_results.h"

#include "model/files/json_schema.h"

#include <QDir>
#include <QFile>

using namespace cradle;
using namespace cradle::results;

/// The index of the results of a class.
class TestClassJournal : public ResultFolders
{
    Q_OBJECT
private slots:
    void manifestIsReadBack();
    void whatIsNoManifestIsRefused_data();
    void whatIsNoManifestIsRefused();
    void whatCannotBeReadIsRefused();
    void journalTellsWhatIsDone();
    void folderHasOneWriter();
};

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

QTEST_GUILESS_MAIN(TestClassJournal)
#include "test_class_journal.moc"
