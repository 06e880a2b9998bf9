// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packed_lab.h"
#include "tests/authoring_labs.h"
#include "tests/zip_maker.h"

#include "tasks/reading/lab_archive.h"

#include <QTemporaryDir>

#include <ctime>

using namespace cradle;
using namespace cradle::authoring;

/// An archive becomes a folder among the labs of a student, once, and is updated there.
class TestLabImport : public QObject
{
    Q_OBJECT
private slots:
    void importsIntoAFolderOfItsName();
    void importsTheSameLabOnce();
    void nameThatIsTakenGetsANumber();
    void updateIsToldAndReplaces();
    void refusedArchiveLeavesNothing_data();
    void refusedArchiveLeavesNothing();
};

void TestLabImport::importsIntoAFolderOfItsName()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("Falling 1.0.cradle"));
    QVERIFY(!exportLab(small(), path));
    const QString labs = folder.filePath(text("data/labs"));
    QString lab;
    TAKE(lab, importLab(path, labs));
    QCOMPARE(lab, labs + text("/Falling 1.0"));
    LabFiles files;
    TAKE(files, readLabFiles(lab));
    QCOMPARE(differences(files, small()), QStringList());
    QCOMPARE(everythingIn(labs), QStringList{text("Falling 1.0")});
}

void TestLabImport::importsTheSameLabOnce()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("small.cradle"));
    QVERIFY(!exportLab(small(), path));
    const QString labs = folder.filePath(text("labs"));
    const QString first = *importLab(path, labs);
    QCOMPARE(*importLab(path, labs), first);
    QCOMPARE(everythingIn(labs).size(), 1);
}

void TestLabImport::nameThatIsTakenGetsANumber()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("small.cradle"));
    const QString labs = folder.filePath(text("labs"));
    QVERIFY(!exportLab(small(), path));
    QCOMPARE(*importLab(path, labs), labs + text("/small"));
    QVERIFY(!exportLab(withText(small(), text("S1/more.md"), text("More\n")), path));
    QCOMPARE(*importLab(path, labs), labs + text("/small-2"));
    QCOMPARE(*importLab(path, labs), labs + text("/small-2"));
    LabFiles old;
    TAKE(old, readLabFiles(labs + text("/small")));
    QCOMPARE(differences(old, small()), QStringList());
    // Where the archive's name is none for a folder, the lab's id is.
    const QString odd = folder.filePath(text(".hidden.cradle"));
    QVERIFY(!exportLab(newLab(text("other"), text("Other"), text("en")), odd));
    QCOMPARE(*importLab(odd, labs), labs + text("/other"));
}

void TestLabImport::updateIsToldAndReplaces()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("small.cradle"));
    const QString labs = folder.filePath(text("labs"));
    QVERIFY(!exportLab(small(), path));
    QVERIFY(!olderThan(path, labs));
    const QString first = *importLab(path, labs);
    QVERIFY(!olderThan(path, labs)); // the same is no update
    LabFiles newer = withText(small(), text("S1/more.md"), text("More\n"));
    QVERIFY(!exportLab(newer, path));
    const auto older = olderThan(path, labs);
    QVERIFY(older);
    QCOMPARE(older->lab.folder, first);
    QCOMPARE(*importLab(path, labs, older->lab.folder), first);
    LabFiles there;
    TAKE(there, readLabFiles(first));
    QCOMPARE(differences(there, newer), QStringList());
    QCOMPARE(everythingIn(labs), QStringList{text("small")});
}

void TestLabImport::refusedArchiveLeavesNothing_data()
{
    QTest::addColumn<QByteArray>("archive");
    QTest::addColumn<QString>("word");
    const auto packed = [](const LabFiles &lab) { return *packLab(lab); };
    LabFiles newer = small();
    newer.contents[text("lab.json")].replace("\"format\": 1", "\"format\": 2, \"shaders\": true");
    QTest::newRow("newer format") << packed(newer)
                                  << text("needs a newer Cradle: format 2, this one reads 1");
    LabFiles broken = small();
    broken.contents[text("lab.json")] = "{";
    QTest::newRow("broken lab.json") << packed(broken) << text("this is not JSON");
    QTest::newRow("path out of the lab")
        << zipOf(small()).add({.name = "../evil.lua", .content = "x"}).toBytes()
        << text("../evil.lua");
}

void TestLabImport::refusedArchiveLeavesNothing()
{
    QFETCH(QByteArray, archive);
    QFETCH(QString, word);
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("evil.cradle"));
    writeTo(path, archive);
    const Result<QString> lab = importLab(path, folder.filePath(text("labs")));
    QVERIFY(!lab);
    QVERIFY2(lab.error().toString().contains(word), qPrintable(lab.error().toString()));
    QCOMPARE(everythingIn(folder.filePath(text("labs"))), QStringList());
    QCOMPARE(everythingIn(folder.path()), QStringList{text("evil.cradle")});
}

QTEST_GUILESS_MAIN(TestLabImport)
#include "test_lab_import.moc"
