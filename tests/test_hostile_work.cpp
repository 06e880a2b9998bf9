// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/authoring_labs.h"
#include "tests/zip_maker.h"

#include "tasks/hand_in/hand_in.h"

#include <QCryptographicHash>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace cradle;
using namespace cradle::authoring;

/// Work that was handed in by somebody who means harm, or was damaged on its way.
class TestHostileWork final : public QObject
{
    Q_OBJECT
private slots:
    void hostileFilesAreRefused_data();
    void hostileFilesAreRefused();
    void strangeContentsAreOnlyData_data();
    void strangeContentsAreOnlyData();
    void everyFlippedByteIsRefusedOrRight();
};

namespace {

using Contents = QMap<QByteArray, QByteArray>;

/// A manifest that names those files, as an honest one would.
QByteArray manifestFor(const Contents &files)
{
    QJsonObject hashes;
    for (auto it = files.begin(); it != files.end(); ++it)
        hashes.insert(
            QString::fromUtf8(it.key()),
            QString::fromLatin1(QCryptographicHash::hash(*it, QCryptographicHash::Sha256).toHex()));
    return QJsonDocument(QJsonObject{{text("format"), 1}, {text("files"), hashes}}).toJson();
}

Contents honest()
{
    return {{"cradle.json", R"({"format": 1, "lab": "lab-4.2", "name": "Ada"})"},
            {"lab.lua", "-- mine\n"},
            {"steps/L42T1.lua", "-- mine\n"}};
}

ZipMaker zipOf(const Contents &files)
{
    ZipMaker zip;
    for (auto it = files.begin(); it != files.end(); ++it)
        zip.add({.name = it.key(), .content = *it});
    return zip;
}

QByteArray archiveOf(const Contents &files)
{
    return zipOf(files).add({.name = "manifest.json", .content = manifestFor(files)}).toBytes();
}

Contents with(const QByteArray &name, const QByteArray &content)
{
    Contents files = honest();
    files[name] = content;
    return files;
}

} // namespace

void TestHostileWork::hostileFilesAreRefused_data()
{
    QTest::addColumn<QByteArray>("archive");
    const auto row = [](const char *name, const QByteArray &archive) {
        QTest::newRow(name) << archive;
    };
    for (const char *name :
         {"../evil.lua", "steps/../../evil.lua", "/etc/evil", "..\\evil.lua", "C:/evil.lua",
          "steps//evil.lua", "./evil.lua", "steps/a\nb.lua", "steps/nul.txt", "steps/gr\xf6.lua",
          ".git/config", ".git/hooks/post-checkout", "steps/.hidden.lua", "STEPS/l42t1.LUA",
          "steps", "cradle.json/x.lua"})
        row(QByteArray(name).replace('\n', "\\n").constData(), archiveOf(with(name, "text")));
    row("a long name", archiveOf(with(QByteArray(400, 'a'), "text")));
    row("deep folders", archiveOf(with(QByteArray("a/").repeated(20) + "x.lua", "text")));
    const auto add = [](const ZipMaker::Entry &entry) {
        return zipOf(honest())
            .add(entry)
            .add({.name = "manifest.json", .content = manifestFor(honest())})
            .toBytes();
    };
    row("a link", add({.name = "steps/L42T2.lua", .content = "/etc/passwd", .mode = 0120777}));
    row("a pipe", add({.name = "steps/L42T2.lua", .mode = 0010644}));
    row("encrypted", add({.name = "steps/L42T2.lua", .content = "x", .flags = 1}));
    row("unknown packing", add({.name = "steps/L42T2.lua", .content = "x", .method = 97}));
    row("wrong checksum", add({.name = "steps/L42T2.lua", .content = "x", .crc = 1}));
    row("larger than said", add({.name = "a.lua", .content = "text", .declaredSize = 2}));
    row("smaller than said", add({.name = "a.lua", .content = "text", .declaredSize = 200'000}));
    row("huge", add({.name = "a.lua", .content = "text", .declaredSize = 0xf0000000}));
    row("a bomb", add({.name = "a.lua", .content = QByteArray(30'000'000, ' '), .deflate = true}));
    row("the same name twice", add({.name = "lab.lua", .content = "-- other\n"}));
    row("not in the manifest", add({.name = "steps/L42T2.lua", .content = "-- more"}));
    row("no manifest", zipOf(honest()).toBytes());
    for (const char *manifest :
         {"", "{}", "[]", "null", "[[[[", R"({"format": 2})", R"({"format": "1"})",
          R"({"format": 1, "files": []})", R"({"format": 1, "files": {"lab.lua": null}})"})
        row(manifest,
            zipOf(honest()).add({.name = "manifest.json", .content = manifest}).toBytes());
    ZipMaker many;
    for (int i = 0; i < 10'001; ++i)
        many.add({.name = "f" + QByteArray::number(i)});
    row("too many files", many.toBytes());
    row("nothing", {});
    row("text", "This is not an archive.\n");
    row("an empty archive", ZipMaker().toBytes());
}

void TestHostileWork::hostileFilesAreRefused()
{
    QFETCH(QByteArray, archive);
    const auto files = unpackWork(archive, text("evil.cradle-work"));
    QVERIFY(!files);
    QCOMPARE(files.error().file, text("evil.cradle-work"));
    QVERIFY(!files.error().message.isEmpty() && files.error().message.size() < 500);
    const QTemporaryDir folder;
    writeTo(folder.filePath(text("evil.cradle-work")), archive);
    QVERIFY(
        !openHandIn(folder.filePath(text("evil.cradle-work")), folder.filePath(text("opened"))));
    // Nothing was left anywhere.
    QVERIFY(QDir(folder.filePath(text("opened")))
                .isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
}

/// What is well packed may still hold anything.
void TestHostileWork::strangeContentsAreOnlyData_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("program is binary")
        << QByteArray("steps/L42T1.lua") << QByteArray("\0\xff\xfe", 3);
    QTest::newRow("program is long")
        << QByteArray("steps/L42T1.lua") << QByteArray(600 * 1024, 'x');
    QTest::newRow("scene is none") << QByteArray("presets/L42T1.json") << QByteArray("[[[");
    QTest::newRow("predictions are none") << QByteArray("predictions.json") << QByteArray("7");
    QTest::newRow("answers are wild")
        << QByteArray("predictions.json")
        << QByteArray(R"({"L42T5": {"answer": 1e300}, "L42T8": [], "x": null})");
    QTest::newRow("history is none") << QByteArray("history.json") << QByteArray("{");
    QTest::newRow("history of other references")
        << QByteArray("history.json")
        << QByteArray(R"([{"step": "../../heads/main", "program": "x"}, {"step": "a b~^:?*["}])");
    QTest::newRow("bundle is none")
        << QByteArray("history.bundle") << QByteArray("# v2 git bundle");
    QTest::newRow("whose it is is unknown") << QByteArray("cradle.json") << QByteArray("\xff");
    QTest::newRow("note is a page") << QByteArray("notes/L42T1.md")
                                    << QByteArray("<script>alert(1)</script> ![x](file:///etc)");
}

void TestHostileWork::strangeContentsAreOnlyData()
{
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, content);
    const auto files = unpackWork(archiveOf(with(name, content)), {});
    QVERIFY(files);
    Lab lab;
    lab.tasks.resize(1);
    lab.tasks[0].id = text("L42T1");
    const StudentWork work = workFrom(*files, lab);
    QCOMPARE(work.steps.size(), std::size_t(1));
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("x.cradle-work"));
    writeTo(path, archiveOf(with(name, content)));
    // Opened or refused, but never outside of its place.
    (void)openHandIn(path, folder.filePath(text("opened")));
    QStringList expected{text("opened"), text("x.cradle-work")};
    QStringList there =
        QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    there.sort();
    QCOMPARE(there, expected);
}

void TestHostileWork::everyFlippedByteIsRefusedOrRight()
{
    const QByteArray archive = archiveOf(honest());
    const auto right = unpackWork(archive, {});
    QVERIFY(right);
    for (qsizetype at = 0; at < archive.size(); ++at) {
        QByteArray broken = archive;
        broken[at] = static_cast<char>(broken[at] ^ 0x55);
        const auto read = unpackWork(broken, {});
        // Of the manifest itself nobody says what it should be; the work is as it was.
        if (!read)
            continue;
        for (auto it = right->begin(); it != right->end(); ++it) {
            if (it.key() != text("manifest.json"))
                QCOMPARE(read->value(it.key()), *it);
        }
    }
}

QTEST_APPLESS_MAIN(TestHostileWork)
#include "test_hostile_work.moc"
