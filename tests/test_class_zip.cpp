// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_zip.h"
#include "tests/text.h"
#include "tests/zip_maker.h"

#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;
using cradle::authoring::ZipMaker;

/// The zip of a class that a learning platform gives out, which anybody may have written.
class TestClassZip : public QObject
{
    Q_OBJECT
private slots:
    void filesAreUnpackedWithTheirFolders();
    void whatIsNoFileIsLeftOut_data();
    void whatIsNoFileIsLeftOut();
    void filesUpTo32MebibytesAreUnpacked();
    void whatIsNoZipIsRefused();
    void regularFilesOfThatNameAreZips();

private:
    /// Unpacks a zip into a folder of its own. \return what was left out
    QStringList leftOut(const ZipMaker &zip)
    {
        m_place = std::make_unique<QTemporaryDir>();
        const QString path = m_folder.filePath(text("class.zip"));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(zip.toBytes()) < 0)
            return {text("not written")};
        file.close();
        const auto unpacked = unpackClass(QFile::encodeName(path), m_place->path());
        return unpacked ? *unpacked : QStringList{unpacked.error().toString()};
    }
    /// Paths and sizes of what lies there.
    [[nodiscard]] QStringList files() const
    {
        QStringList found;
        QDirIterator each(m_place->path(), QDir::Files | QDir::Hidden | QDir::System,
                          QDirIterator::Subdirectories);
        while (each.hasNext()) {
            const QString path = each.next();
            found.append(QStringLiteral("%1 %2")
                             .arg(QDir(m_place->path()).relativeFilePath(path))
                             .arg(each.fileInfo().size()));
        }
        found.sort();
        return found;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<QTemporaryDir> m_place{};
};

void TestClassZip::filesAreUnpackedWithTheirFolders()
{
    ZipMaker zip;
    zip.add({.name = "ada/", .mode = 040755});
    zip.add({.name = "ada/steps/deep/L1.lua", .content = "12345"});
    zip.add({.name = "ada/steps/L2.lua", .content = "1234", .deflate = true});
    zip.add({.name = "b", .content = ""});
    QCOMPARE(leftOut(zip), QStringList());
    QCOMPARE(files(), (QStringList{text("ada/steps/L2.lua 4"), text("ada/steps/deep/L1.lua 5"),
                                   text("b 0")}));
}

void TestClassZip::whatIsNoFileIsLeftOut_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<quint32>("mode");
    QTest::addColumn<bool>("broken");
    QTest::newRow("above") << QByteArray("../L1.lua") << quint32(0100644) << false;
    QTest::newRow("from the root") << QByteArray("/L1.lua") << quint32(0100644) << false;
    QTest::newRow("a link") << QByteArray("L1.lua") << quint32(0120777) << false;
    QTest::newRow("below a file") << QByteArray("first/L1.lua") << quint32(0100644) << false;
    QTest::newRow("twice") << QByteArray("first") << quint32(0100644) << false;
    QTest::newRow("too long a name") << QByteArray(300, 'x') << quint32(0100644) << false;
    QTest::newRow("broken") << QByteArray("L1.lua") << quint32(0100644) << true;
}

void TestClassZip::whatIsNoFileIsLeftOut()
{
    QFETCH(QByteArray, name);
    QFETCH(quint32, mode);
    QFETCH(bool, broken);
    ZipMaker zip;
    zip.add({.name = "first", .content = "1"});
    ZipMaker::Entry odd{.name = name, .content = "x = 1", .mode = mode};
    if (broken)
        odd.declaredSize = 9;
    zip.add(odd);
    zip.add({.name = "last", .content = "333"});
    QCOMPARE(leftOut(zip), QStringList{QString::fromUtf8(name)});
    QCOMPARE(files(), (QStringList{text("first 1"), text("last 3")}));
}

void TestClassZip::filesUpTo32MebibytesAreUnpacked()
{
    constexpr qsizetype most = 32 * 1024 * 1024;
    ZipMaker zip;
    zip.add({.name = "fits", .content = QByteArray(most, ' '), .deflate = true});
    zip.add({.name = "no", .content = QByteArray(most + 1, ' '), .deflate = true});
    QCOMPARE(leftOut(zip), QStringList{text("no")});
    QCOMPARE(files(), QStringList{QStringLiteral("fits %1").arg(most)});
}

void TestClassZip::whatIsNoZipIsRefused()
{
    const QString path = m_folder.filePath(text("none.zip"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no zip") == 6);
    file.close();
    const auto unpacked = unpackClass(QFile::encodeName(path), m_folder.path());
    QVERIFY(!unpacked);
    QCOMPARE(unpacked.error().file, path);
}

void TestClassZip::regularFilesOfThatNameAreZips()
{
    QVERIFY(QDir(m_folder.path()).mkdir(text("folder.zip")));
    for (const char *name : {"a.zip", "b.ZIP", "c.zi"})
        QVERIFY(QFile(m_folder.filePath(text(name))).open(QIODevice::WriteOnly));
    const auto isZip = [&](const char *name) {
        return isClassZip(QFile::encodeName(m_folder.filePath(text(name))));
    };
    QVERIFY(isZip("a.zip"));
    QVERIFY(isZip("b.ZIP"));
    QVERIFY(!isZip("c.zi"));
    QVERIFY(!isZip("folder.zip"));
    QVERIFY(!isZip("nowhere.zip"));
}

QTEST_GUILESS_MAIN(TestClassZip)
#include "test_class_zip.moc"
