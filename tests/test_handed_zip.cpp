// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/made_class.h"
#include "tests/zip_maker.h"

#include "tasks/script/script_limits.h"

using namespace cradle;
using namespace cradle::classes;
using cradle::authoring::ZipMaker;

/// A zip inside of what a student handed in counts like the folder that it holds.
class TestHandedZip : public QObject
{
    Q_OBJECT
private slots:
    void zipCountsLikeItsFolder_data();
    void zipCountsLikeItsFolder();
    void workAndHistoryAreFound();
    void whatIsNoWorkIsPassedOver();
    void folderGoesBeforeZip();
    void entryThatLeadsOutIsTold_data();
    void entryThatLeadsOutIsTold();
    void linkIsNotFollowed();
    void zipInZipIsTold();
    void bombIsCutAndCostsNoMemory();
    void sizesMayBeLies();
    void muchOfAllIsRefused();
    void zipThatIsTooLargeIsTold();
    void zipOfManyFilesIsRefused();
    void brokenZipIsTold_data();
    void brokenZipIsTold();
    void encryptedProgramIsTold();
    void nameThatIsThereTwiceIsTold();
    void zipOfAClassIsNoStudents();
};

namespace {

const QByteArray moodle = "Ada Lovelace_12_assignsubmission_file_/";

ZipMaker::Entry entry(const QByteArray &name, const QByteArray &content = "x = 1\n")
{
    return {.name = name, .content = content};
}

/// What one student with the zip \p bytes is taken to have handed in.
HandedIn handedIn(const QByteArray &bytes)
{
    const Made made;
    made.file(moodle + "work.zip", bytes);
    return handedInBy(made.read(), 0);
}

HandedIn handedIn(const ZipMaker &zip)
{
    return handedIn(zip.toBytes());
}

ZipMaker steps(const QByteArray &folder = {})
{
    ZipMaker zip;
    zip.add(entry(folder + "steps/L1.lua", "one")).add(entry(folder + "steps/L2.lua", "two"));
    return zip;
}

const QStringList bothSteps{QStringLiteral("steps/L1.lua"), QStringLiteral("steps/L2.lua")};

} // namespace

void TestHandedZip::zipCountsLikeItsFolder_data()
{
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QByteArray>("zip");
    QTest::addColumn<QStringList>("files");
    const QByteArray flat = steps().toBytes();
    QTest::newRow("Moodle") << moodle + "my work.ZIP" << flat << bothSteps;
    QTest::newRow("Moodle, without folders")
        << QByteArray("Ada_12_assignsubmission_file_work.zip") << flat << bothSteps;
    QTest::newRow("Canvas") << QByteArray("lovelaceada_10_20_work-1.zip") << flat << bothSteps;
    QTest::newRow("Blackboard") << QByteArray("Lab_ada_attempt_2026-05-01-12-00-00_work.zip")
                                << flat << bothSteps;
    QTest::newRow("a zip a student") << QByteArray("ada.zip") << flat << bothSteps;
    QTest::newRow("a folder in it")
        << QByteArray("ada/work.zip") << steps("lab/my lab/").toBytes() << bothSteps;
    QTest::newRow("backslashes") << QByteArray("ada/work.zip")
                                 << ZipMaker().add(entry("a\\steps\\L1.lua")).toBytes()
                                 << bothSteps.mid(0, 1);
    QTest::newRow("loose programs")
        << QByteArray("ada/work.zip") << ZipMaker().add(entry("L2 (1).lua")).toBytes()
        << bothSteps.mid(1);
    QTest::newRow("one program") << QByteArray("ada/work.zip")
                                 << ZipMaker().add(entry("caf\xe9.lua")).toBytes()
                                 << QStringList{QStringLiteral("lab.lua")};
}

void TestHandedZip::zipCountsLikeItsFolder()
{
    QFETCH(QByteArray, path);
    QFETCH(QByteArray, zip);
    QFETCH(QStringList, files);
    const Made made;
    made.file(path, zip);
    made.file("zoe/steps/L1.lua"); // else a folder of one is gone into
    const ClassFolder found = made.read();
    QCOMPARE(found.students.size(), std::size_t(2));
    const int ada = found.students[0].id == QLatin1String("zoe") ? 1 : 0;
    QCOMPARE(filesOf(found, ada), files);
    QCOMPARE(handedInBy(found, ada).remark, QString());
}

void TestHandedZip::workAndHistoryAreFound()
{
    ZipMaker zip = steps("lab/");
    zip.add(entry("lab/.git/HEAD", "ref: refs/heads/main\n"))
        .add(entry("lab/.git/objects/ab/cd", "object"))
        .add(entry("lab/.git/config", "[core]\n\tpager = evil\n"))
        .add(entry("lab/.git/hooks/post-checkout", "evil"));
    const HandedIn clone = handedIn(zip);
    QCOMPARE(clone.request.files.keys(), bothSteps);
    QCOMPARE(clone.request.repository.keys(),
             (QStringList{QStringLiteral("HEAD"), QStringLiteral("objects/ab/cd")}));
    zip.add(entry("ada-lab.cradle-work", "an archive"));
    QCOMPARE(handedIn(zip).request.archive, QByteArray("an archive"));
}

void TestHandedZip::whatIsNoWorkIsPassedOver()
{
    ZipMaker zip = steps();
    zip.add(entry("__MACOSX/steps/._L1.lua", "mac")).add(entry(".hidden/steps/L1.lua", "hidden"));
    zip.add(entry("a/b/c/d/e/f/g/steps/L1.lua", "deep")).add(entry("notes.txt"));
    const HandedIn read = handedIn(zip);
    QCOMPARE(read.request.files.value(QStringLiteral("steps/L1.lua")), QByteArray("one"));
    QCOMPARE(read.remark, QString());
}

void TestHandedZip::folderGoesBeforeZip()
{
    const Made made;
    made.file("ada/steps/L1.lua", "folder");
    made.file("ada/old.zip", steps().toBytes());
    made.file("bob/steps/L1.lua");
    const HandedIn read = handedInBy(made.read(), 0);
    QCOMPARE(read.request.files.keys(), bothSteps.mid(0, 1));
    QCOMPARE(read.request.files.first(), QByteArray("folder"));
    QCOMPARE(read.remark, text("old.zip/steps/ was passed over for steps/"));
}

void TestHandedZip::entryThatLeadsOutIsTold_data()
{
    QTest::addColumn<QByteArray>("name");
    for (const char *name : {"../steps/L1.lua", "a/../../steps/L1.lua", "/steps/L1.lua",
                             "..\\steps\\L1.lua", "./steps/L1.lua"})
        QTest::newRow(name) << QByteArray(name);
}

void TestHandedZip::entryThatLeadsOutIsTold()
{
    QFETCH(QByteArray, name);
    ZipMaker zip;
    zip.add(entry(name, "evil")).add(entry("L2.lua"));
    const HandedIn read = handedIn(zip);
    QCOMPARE(read.request.files.keys(), bothSteps.mid(1));
    QVERIFY2(read.remark.startsWith(text("work.zip: left out ")), qPrintable(read.remark));
}

void TestHandedZip::linkIsNotFollowed()
{
    ZipMaker zip;
    zip.add({.name = "steps/L1.lua", .content = "/etc/passwd", .mode = 0120777});
    zip.add(entry("steps/L2.lua"));
    const HandedIn read = handedIn(zip);
    QCOMPARE(read.request.files.keys(), bothSteps.mid(1));
    QVERIFY(read.remark.contains(text("steps/L1.lua")));
}

void TestHandedZip::zipInZipIsTold()
{
    ZipMaker zip;
    zip.add(entry("inner.zip", steps().toBytes()));
    const HandedIn read = handedIn(zip);
    QVERIFY(read.request.files.isEmpty());
    QVERIFY(read.remark.contains(text("work.zip/inner.zip is not looked into")));
}

/// Of a program no more is unpacked than shows that it is too long.
void TestHandedZip::bombIsCutAndCostsNoMemory()
{
    ZipMaker zip;
    zip.add({.name = "L1.lua", .content = QByteArray(24 * 1024 * 1024, ' '), .deflate = true});
    const HandedIn read = handedIn(zip);
    QCOMPARE(qint64(read.request.files.first().size()), qint64(limits::sourceBytes) + 1);
}

void TestHandedZip::sizesMayBeLies()
{
    ZipMaker zip;
    zip.add({.name = "L1.lua",
             .content = QByteArray(1024 * 1024, ' '),
             .deflate = true,
             .declaredSize = 5});
    zip.add({.name = "L2.lua", .content = "x = 1\n", .declaredSize = 0x7fffffff});
    const HandedIn read = handedIn(zip);
    for (const QByteArray &file : read.request.files)
        QVERIFY(qint64(file.size()) <= qint64(limits::sourceBytes) + 1);
}

/// Each of these files may be there; all of them are more than one student has.
void TestHandedZip::muchOfAllIsRefused()
{
    ZipMaker zip;
    const QByteArray scene(1024 * 1024, ' ');
    zip.add(entry("steps/L1.lua"));
    for (int i = 0; i < 80; ++i)
        zip.add({.name = "presets/L1." + QByteArray::number(i) + ".json",
                 .content = scene,
                 .deflate = true});
    const HandedIn read = handedIn(zip);
    QVERIFY(read.remark.contains(text("absurdly much")));
}

void TestHandedZip::zipThatIsTooLargeIsTold()
{
    const Made made;
    made.file("ada/L1.lua");
    made.file("ada/large.zip");
    made.file("bob/L1.lua");
    QCOMPARE(::truncate((made.root() + "/ada/large.zip").constData(), 33 * 1024 * 1024), 0);
    const HandedIn read = handedInBy(made.read(), 0);
    QCOMPARE(read.request.files.keys(), bothSteps.mid(0, 1));
    QCOMPARE(read.remark, text("large.zip: too large to be unpacked"));
}

void TestHandedZip::zipOfManyFilesIsRefused()
{
    ZipMaker zip;
    for (int i = 0; i <= 20'000; ++i)
        zip.add(entry(QByteArray::number(i) + ".lua", {}));
    const HandedIn read = handedIn(zip);
    QVERIFY(read.request.files.isEmpty());
    QVERIFY(read.remark.contains(text("there are more than 20000 files in it")));
}

void TestHandedZip::brokenZipIsTold_data()
{
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray whole = steps().toBytes();
    QTest::newRow("no zip") << QByteArray("Rar!\x1a\x07");
    QTest::newRow("cut") << whole.left(whole.size() / 2);
}

void TestHandedZip::brokenZipIsTold()
{
    QFETCH(QByteArray, bytes);
    const HandedIn read = handedIn(bytes);
    QVERIFY(read.request.files.isEmpty());
    QVERIFY2(read.remark.startsWith(text("work.zip: this is no zip")), qPrintable(read.remark));
}

void TestHandedZip::encryptedProgramIsTold()
{
    ZipMaker zip;
    zip.add({.name = "L1.lua", .content = "secret bytes of it", .flags = 1});
    const HandedIn read = handedIn(zip);
    QVERIFY(read.request.files.isEmpty());
    QVERIFY2(read.remark.contains(text("work.zip/L1.lua: cannot be unpacked")),
             qPrintable(read.remark));
}

/// Which of the two a program takes is the choice of who reads it.
void TestHandedZip::nameThatIsThereTwiceIsTold()
{
    ZipMaker zip;
    zip.add(entry("L1.lua", "first")).add(entry("L1.lua", "second"));
    const HandedIn read = handedIn(zip);
    QCOMPARE(read.request.files.value(bothSteps.first()), QByteArray("first"));
    QVERIFY(read.remark.contains(text("more than once")));
}

void TestHandedZip::zipOfAClassIsNoStudents()
{
    ZipMaker zip;
    zip.add(entry("Ada_12_assignsubmission_file_/L1.lua"));
    zip.add(entry("Bob_13_assignsubmission_file_/L1.lua"));
    const HandedIn read = handedIn(zip);
    QVERIFY(read.request.files.isEmpty());
    QVERIFY(read.remark.contains(text("zip of a whole class")));
}

QTEST_GUILESS_MAIN(TestHandedZip)
#include "test_handed_zip.moc"
