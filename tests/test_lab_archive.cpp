// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packed_lab.h"
#include "tests/authoring_labs.h"
#include "tests/patience.h"
#include "tests/zip_maker.h"

#include "tasks/reading/lab_archive.h"

#include <QProcess>
#include <QTemporaryDir>

#include <ctime>

using namespace cradle;
using namespace cradle::authoring;

/// Labs as one file: packed, unpacked with no trust, imported whole.
class TestLabArchive : public QObject
{
    Q_OBJECT
private slots:
    void labComesBackAsItWas();
    void sameLabMakesTheSameBytes();
    void otherProgramsCanReadIt();
    void folderAroundTheLabIsTakenOff_data();
    void folderAroundTheLabIsTakenOff();
    void attributesOfOtherSystemsAreNoModes();
    void hostileArchivesAreRefused_data();
    void hostileArchivesAreRefused();
    void everyCutIsRefusedOrRight();
    void everyFlippedByteIsRefusedOrRight();
    void labThatIsNoneIsNotPacked();
    void archiveIsReadWithoutUnpackingIt();
};

void TestLabArchive::labComesBackAsItWas()
{
    LabFiles shipped;
    TAKE(shipped, readLabFiles(shippedFolder));
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("Übung 4.2.cradle"));
    QVERIFY(!exportLab(shipped, path));
    QVERIFY(isLabArchive(path));
    // A third, as texts are.
    QVERIFY(QFileInfo(path).size() < 1'000'000);
    LabFiles again;
    TAKE(again, readLabArchive(path));
    QCOMPARE(differences(shipped, again), QStringList());
}

void TestLabArchive::sameLabMakesTheSameBytes()
{
    const LabFiles lab = small();
    QByteArray archive;
    TAKE(archive, packLab(lab));
    // Every entry was made on the first day of MS-DOS: time and date, in no clock's words.
    int entries = 0;
    for (qsizetype at = archive.indexOf("PK\3\4"); at >= 0;
         at = archive.indexOf("PK\3\4", at + 1)) {
        QCOMPARE(archive.mid(at + 10, 4), QByteArray("\0\0\x21\0", 4));
        ++entries;
    }
    QCOMPARE(entries, int(lab.contents.size()));
    qputenv("TZ", "Pacific/Auckland");
    tzset();
    QByteArray again;
    TAKE(again, packLab(lab));
    QCOMPARE(again, archive);
    TAKE(again, packLab(withText(lab, text("S1/more.md"), text("More\n"))));
    QVERIFY(again != archive);
}

void TestLabArchive::otherProgramsCanReadIt()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("small.cradle"));
    QVERIFY(!exportLab(small(), path));
    QProcess unzip;
    unzip.start(text("python3"), {text("-m"), text("zipfile"), text("-t"), path});
    if (!unzip.waitForStarted())
        QSKIP("python3 is not installed");
    QVERIFY(unzip.waitForFinished(patience));
    QCOMPARE(unzip.exitCode(), 0);
}

void TestLabArchive::folderAroundTheLabIsTakenOff_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::newRow("none") << QByteArray();
    QTest::newRow("one") << QByteArray("small-1.0/");
}

void TestLabArchive::folderAroundTheLabIsTakenOff()
{
    QFETCH(QByteArray, before);
    ZipMaker zip = zipOf(small(), before);
    // Folders of their own and what systems leave are not the lab's.
    zip.add({.name = before + "S1/", .mode = 040755});
    zip.add({.name = before + ".DS_Store", .content = "x"});
    zip.add({.name = "__MACOSX/" + before + "lab.json", .content = "x"});
    LabFiles lab;
    TAKE(lab, unpackLab(zip.toBytes(), text("x.cradle")));
    QCOMPARE(differences(lab, small()), QStringList());
}

/// What Unix calls a link means nothing where MS-DOS wrote it.
void TestLabArchive::attributesOfOtherSystemsAreNoModes()
{
    for (const quint8 system : {quint8{0}, quint8{3}}) {
        ZipMaker zip;
        const LabFiles files = small();
        for (auto it = files.contents.begin(); it != files.contents.end(); ++it)
            zip.add({.name = it.key().toUtf8(), .content = *it, .mode = 0120777, .system = system});
        const Result<LabFiles> lab = unpackLab(zip.toBytes(), text("x.cradle"));
        QCOMPARE(lab.ok(), system == 0);
        if (system == 0)
            QCOMPARE(differences(*lab, files), QStringList());
    }
}

void TestLabArchive::hostileArchivesAreRefused_data()
{
    QTest::addColumn<QByteArray>("archive");
    QTest::addColumn<QString>("word");
    const auto row = [](const char *name, const QByteArray &archive, const char *word) {
        QTest::newRow(name) << archive << text(word);
    };
    const auto with = [](const ZipMaker::Entry &entry) {
        ZipMaker zip = zipOf(small());
        zip.add(entry);
        return zip.toBytes();
    };
    const auto named = [&](const QByteArray &name) {
        return with({.name = name, .content = "text"});
    };
    row("path out of the lab", named("../evil.lua"), "../evil.lua");
    row("path out of the lab, inside", named("S1/../../evil.lua"), "evil.lua");
    row("absolute path", named("/etc/evil"), "/etc/evil");
    row("backslashes", named("..\\evil.lua"), "evil.lua");
    row("drive letter", named("C:/evil.lua"), "C:/evil.lua");
    row("drive letter alone", named("C:evil.lua"), "C:evil.lua");
    row("empty name in a path", named("S1//evil.lua"), "S1//evil.lua");
    row("dot in a path", named("./evil.lua"), "./evil.lua");
    row("control character", named("S1/a\nb.lua"), "control");
    row("device of Windows", named("S1/nul.txt"), "device");
    row("name that is too long", named(QByteArray(400, 'a')), "too long");
    row("folders nested too deeply", named(QByteArray("a/").repeated(20) + "x.md"), "deeply");
    row("name in Latin-1",
        named("S1/gr\xf6\xdf"
              "e.md"),
        "UTF-8");
    row("name that ends in a letter of Latin-1", named("S1/caf\xe9"), "UTF-8");
    row("the same name twice", named("S1/task.json"), "already exists");
    row("capital letters alone", named("s1/TASK.json"), "twice");
    row("file and folder of one name", named("S1"), "twice");
    row("file below a file", named("lab.json/x.md"), "twice");
    const auto both = [](const QByteArray &first, const QByteArray &second) {
        ZipMaker zip = zipOf(small());
        zip.add({.name = first, .content = "1"}).add({.name = second, .content = "2"});
        return zip.toBytes();
    };
    row("file of the name of a folder far above", both("S1/a/b/x.md", "S1/A"), "twice");
    row("file of the name of a folder above", both("S1/a/b/x.md", "S1/a/B"), "twice");
    row("file far below a file", both("S1/a", "S1/A/b/x.md"), "twice");
    row("link", with({.name = "S1/link.lua", .content = "/etc/passwd", .mode = 0120777}), "link");
    row("link that is named a folder", with({.name = "S2/", .content = "/etc", .mode = 0120777}),
        "link");
    row("pipe", with({.name = "S1/pipe", .mode = 0010644}), "special");
    row("encrypted", with({.name = "S1/secret.md", .content = "text", .flags = 1}), "encrypted");
    row("unknown way to pack", with({.name = "S1/x.md", .content = "text", .method = 97}),
        "unknown way");
    row("wrong checksum", with({.name = "S1/x.md", .content = "text", .crc = 1}), "broken");
    row("larger than declared", with({.name = "S1/x.md", .content = "text", .declaredSize = 2}),
        "");
    row("smaller than declared",
        with({.name = "S1/x.md", .content = "text", .declaredSize = 200'000}), "");
    row("huge by its own word",
        with({.name = "S1/x.md", .content = "text", .declaredSize = 0xf0000000}), "too large");
    row("zip bomb, one file",
        with({.name = "S1/x.md", .content = QByteArray(30'000'000, ' '), .deflate = true}),
        "200 times");
    ZipMaker bombs = zipOf(small());
    for (int i = 0; i < 40; ++i)
        bombs.add({.name = "S1/" + QByteArray::number(i) + ".md",
                   .content = "text",
                   .declaredSize = 30'000'000,
                   .declaredPacked = 1'000'000});
    row("too large together", bombs.toBytes(), "");
    ZipMaker many;
    for (int i = 0; i < 10'001; ++i)
        many.add({.name = "f" + QByteArray::number(i)});
    row("too many files", many.toBytes(), "10001");
    row("no lab", ZipMaker().add({.name = "readme.md", .content = "text"}).toBytes(), "lab.json");
    row("two labs", zipOf(small(), "b/").add(zipOf(small(), "a/")).toBytes(), "lab.json");
    row("empty archive", ZipMaker().toBytes(), "lab.json");
    row("empty file", QByteArray(), "lab.json");
    row("text", QByteArray("This is not an archive.\n"), "no archive");
    row("zeros", QByteArray(100'000, '\0'), "no archive");
}

void TestLabArchive::hostileArchivesAreRefused()
{
    QFETCH(QByteArray, archive);
    QFETCH(QString, word);
    const Result<LabFiles> lab = unpackLab(archive, text("evil.cradle"));
    QVERIFY(!lab);
    QCOMPARE(lab.error().file, text("evil.cradle"));
    QVERIFY2(lab.error().message.contains(word), qPrintable(lab.error().message));
    // The names in it are shown as text, in one line and not without end.
    QVERIFY(lab.error().message.size() < 500);
}

/// What is cut off while it is sent must not be half a lab.
void TestLabArchive::everyCutIsRefusedOrRight()
{
    const QByteArray archive = *packLab(small());
    for (qsizetype length = 0; length < archive.size(); length += 7)
        QVERIFY(!unpackLab(archive.left(length), text("cut.cradle")));
}

void TestLabArchive::everyFlippedByteIsRefusedOrRight()
{
    const LabFiles lab = small();
    const QByteArray archive = *packLab(lab);
    int refused = 0;
    for (qsizetype at = 0; at < archive.size(); ++at) {
        QByteArray broken = archive;
        broken[at] = static_cast<char>(broken[at] ^ 0x55);
        const Result<LabFiles> read = unpackLab(broken, text("flipped.cradle"));
        refused += read ? 0 : 1;
        // A name may be another now, a content never.
        if (read) {
            for (const QByteArray &content : read->contents)
                QVERIFY(lab.contents.values().contains(content));
        }
    }
    QVERIFY(refused > archive.size() / 2);
}

void TestLabArchive::labThatIsNoneIsNotPacked()
{
    const QTemporaryDir folder;
    QVERIFY(!packLab({}));
    const Result<QByteArray> outside = packLab(withText(small(), text("../x.md"), text("x")));
    QVERIFY(!outside);
    QCOMPARE(outside.error().file, text("../x.md"));
    QVERIFY(exportLab(small(), folder.filePath(text("no/such/folder.cradle"))));
    QVERIFY(!readLabArchive(folder.filePath(text("none.cradle"))));
}

void TestLabArchive::archiveIsReadWithoutUnpackingIt()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("small.cradle"));
    QVERIFY(!exportLab(small(), path));
    Lab lab;
    TAKE(lab, readLabOrArchive(path));
    QCOMPARE(lab.id, text("small"));
    QCOMPARE(lab.tasks.size(), std::size_t{1});
    QCOMPARE(everythingIn(folder.path()).size(), 1);
    TAKE(lab, readLabOrArchive(shippedFolder));
    QCOMPARE(lab.tasks.size(), std::size_t{17});
}

QTEST_GUILESS_MAIN(TestLabArchive)
#include "test_lab_archive.moc"
