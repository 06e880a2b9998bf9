// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/result.h"
#include "tests/test_paths.h"

#include <QDir>
#include <QFile>
#include <QMap>
#include <QMimeDatabase>
#include <QTemporaryDir>
#include <QTest>

/// What a desktop needs so that a double click on a lab opens it.
class TestDesktopFiles : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void labHasATypeOfItsOwn();
    void desktopFileOpensThatType();
    void installPutsThemWhereDesktopsLook_data();
    void installPutsThemWhereDesktopsLook();

private:
    QTemporaryDir m_data;
};

namespace {

const QString desktopFolder = cradle::sourcePath("resources/desktop/");

QString text(const char *latin)
{
    return QString::fromLatin1(latin);
}

QString contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The keys of the one group that there is.
QMap<QString, QString> entriesOf(const QString &desktopFile)
{
    QMap<QString, QString> entries;
    for (const QString &line : contentOf(desktopFile).split(QLatin1Char('\n'))) {
        if (!line.startsWith(QLatin1Char('#')) && line.contains(QLatin1Char('=')))
            entries.insert(line.section(QLatin1Char('='), 0, 0), line.section(QLatin1Char('='), 1));
    }
    return entries;
}

} // namespace

void TestDesktopFiles::initTestCase()
{
    const QString packages = m_data.filePath(text("mime/packages"));
    QVERIFY(QDir().mkpath(packages));
    QVERIFY(QFile::copy(desktopFolder + text("cradle.xml"), packages + text("/cradle.xml")));
    // Before the database of types is asked for the first time.
    qputenv("XDG_DATA_HOME", QFile::encodeName(m_data.path()));
}

void TestDesktopFiles::labHasATypeOfItsOwn()
{
    const QMimeDatabase types;
    const QMimeType type =
        types.mimeTypeForFile(text("Lab 4.2.cradle"), QMimeDatabase::MatchExtension);
    QCOMPARE(type.name(), text("application/x-cradle-lab"));
    QVERIFY(type.inherits(text("application/zip")));
    QCOMPARE(type.preferredSuffix(), text("cradle"));
    QCOMPARE(type.iconName(), text("cradle"));
}

void TestDesktopFiles::desktopFileOpensThatType()
{
    const QMap<QString, QString> entries = entriesOf(desktopFolder + text("cradle.desktop"));
    QCOMPARE(entries.value(text("Exec")), text("cradle %f"));
    QCOMPARE(entries.value(text("MimeType")),
             text("application/x-cradle-lab;application/x-cradle-work;"));
    QCOMPARE(entries.value(text("Type")), text("Application"));
    QCOMPARE(entries.value(text("Icon")), text("cradle"));
    for (const char *key : {"Name", "Comment", "Comment[de]"})
        QVERIFY2(!entries.value(text(key)).isEmpty(), key);
    QVERIFY(contentOf(desktopFolder + text("cradle.svg")).contains(text("<svg")));
}

void TestDesktopFiles::installPutsThemWhereDesktopsLook_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("folder");
    QTest::newRow("desktop file") << text("cradle.desktop") << text("/applications");
    QTest::newRow("type") << text("cradle.xml") << text("/mime/packages");
    QTest::newRow("icon") << text("cradle.svg") << text("/icons/hicolor/scalable/apps");
}

void TestDesktopFiles::installPutsThemWhereDesktopsLook()
{
    QFETCH(QString, file);
    QFETCH(QString, folder);
    // As CMake wrote the rules for this build.
    const QString rules = contentOf(cradle::buildPath("cmake_install.cmake"));
    const qsizetype at = rules.indexOf(text("resources/desktop/") + file);
    QVERIFY(at > 0);
    const qsizetype rule = rules.lastIndexOf(text("file(INSTALL DESTINATION"), at);
    QVERIFY2(rules.mid(rule, at - rule).contains(text("/share") + folder),
             qPrintable(rules.mid(rule, at - rule)));
}

QTEST_GUILESS_MAIN(TestDesktopFiles)
#include "test_desktop_files.moc"
