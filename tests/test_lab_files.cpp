// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/authoring_labs.h"

#include "tasks/lab_files/step_alone.h"
#include "tasks/reading/lab_reader.h"

#include <QTemporaryDir>

#include <unistd.h>

using namespace cradle;
using namespace cradle::authoring;

/// A lab as a value: read from a folder, saved into one.
class TestLabFiles : public QObject
{
    Q_OBJECT
private slots:
    void shippedLabSavedElsewhereIsTheSame();
    void shippedLabIsTheSameAsItsFolder();
    void savesWhatDiffersAlone();
    void removesWhatWasRemovedWithEmptyFolders();
    void keepsFilesThatAreNotTheLabs();
    void refusesFilesThatAnotherProgramChanged_data();
    void refusesFilesThatAnotherProgramChanged();
    void overwritesWhenTold();
    void sameChangeTwiceIsNoConflict();
    void indexIsWrittenAfterWhatItNames();
    void refusesPathsThatLeaveTheLab_data();
    void refusesPathsThatLeaveTheLab();
    void refusesToWriteThroughALink();
    void unwritableFolderIsSaid();
    void copiesShareTheirFiles();
    void stepAloneLeavesTheOthersOut();
};

namespace {

qint64 modified(const QString &path)
{
    return QFileInfo(path).lastModified().toMSecsSinceEpoch();
}

} // namespace

void TestLabFiles::shippedLabSavedElsewhereIsTheSame()
{
    LabFiles lab;
    std::vector<Error> findings;
    TAKE(lab, readLabFiles(shippedFolder, &findings));
    QVERIFY(findings.empty());
    const QTemporaryDir folder;
    const QString copy = folder.filePath(text("new/copy"));
    QVERIFY(!saveLabFiles(lab, {}, copy));
    LabFiles again;
    TAKE(again, readLabFiles(copy));
    QCOMPARE(differences(lab, again), QStringList());
    for (auto it = lab.contents.begin(); it != lab.contents.end(); ++it)
        QVERIFY2(authoring::contentOf(copy + QLatin1Char('/') + it.key())
                     == authoring::contentOf(shippedFolder + QLatin1Char('/') + it.key()),
                 qPrintable(it.key()));
    QCOMPARE(readLab(copy)->hash, readLab(shippedFolder)->hash);
}

void TestLabFiles::shippedLabIsTheSameAsItsFolder()
{
    LabFiles resource;
    TAKE(resource, readLabFiles(QLatin1String(shippedLab)));
    LabFiles folder;
    TAKE(folder, readLabFiles(shippedFolder));
    QCOMPARE(differences(resource, folder), QStringList());
    const Lab lab = *readLab(folder, shippedFolder);
    QVERIFY(lab.findings.empty());
    QCOMPARE(lab.tasks.size(), std::size_t{17});
    QCOMPARE(lab.hash, readLab(QLatin1String(shippedLab))->hash);
    QCOMPARE(lab.tasks[3].folder, shippedFolder + text("/L42T4"));
}

void TestLabFiles::savesWhatDiffersAlone()
{
    const QTemporaryDir folder;
    const LabFiles lab = small();
    QVERIFY(!saveLabFiles(lab, {}, folder.path()));
    const QString untouched = folder.filePath(text("S1/task.json"));
    const QString changed = folder.filePath(text("S1/instructions.md"));
    for (const QString &path : {untouched, changed}) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-3600),
                                 QFileDevice::FileModificationTime));
    }
    const qint64 time = modified(untouched);
    const LabFiles edited = withText(lab, text("S1/instructions.md"), text("# Other\n"));
    QVERIFY(!saveLabFiles(edited, lab, folder.path()));
    QCOMPARE(modified(untouched), time);
    QVERIFY(modified(changed) > time);
    QCOMPARE(authoring::contentOf(changed), QByteArray("# Other\n"));
    QCOMPARE(QDir(folder.filePath(text("S1"))).entryList(QDir::Files | QDir::Hidden).size(), 6);
}

void TestLabFiles::removesWhatWasRemovedWithEmptyFolders()
{
    const QTemporaryDir folder;
    LabFiles two;
    TAKE(two, withStepAdded(small(), text("S2"), text("Second")));
    QVERIFY(!saveLabFiles(two, {}, folder.path()));
    QVERIFY(QFileInfo::exists(folder.filePath(text("S2/mistakes/upward.lua"))));
    LabFiles one;
    TAKE(one, withStepRemoved(two, text("S2")));
    QVERIFY(!saveLabFiles(one, two, folder.path()));
    QVERIFY(!QFileInfo::exists(folder.filePath(text("S2"))));
    LabFiles again;
    TAKE(again, readLabFiles(folder.path()));
    QCOMPARE(differences(again, small()), QStringList());
}

void TestLabFiles::keepsFilesThatAreNotTheLabs()
{
    const QTemporaryDir folder;
    writeTo(folder.filePath(text(".git/config")), "[core]\n");
    writeTo(folder.filePath(text("S1/notes.md~")), "old\n");
    const LabFiles lab = small();
    QVERIFY(!saveLabFiles(lab, {}, folder.path()));
    LabFiles again;
    TAKE(again, readLabFiles(folder.path()));
    QCOMPARE(differences(again, lab), QStringList());
    QVERIFY(!saveLabFiles({}, lab, folder.path()));
    QVERIFY(QFileInfo::exists(folder.filePath(text(".git/config"))));
    QVERIFY(QFileInfo::exists(folder.filePath(text("S1/notes.md~"))));
    QVERIFY(!QFileInfo::exists(folder.filePath(text("lab.json"))));
}

void TestLabFiles::refusesFilesThatAnotherProgramChanged_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<bool>("removed");
    QTest::newRow("the same file") << text("S1/instructions.md") << false;
    QTest::newRow("another file") << text("S1/preset.json") << false;
    QTest::newRow("a file that is gone") << text("S1/task.json") << true;
    QTest::newRow("a file that is new to both") << text("S1/new.md") << false;
}

void TestLabFiles::refusesFilesThatAnotherProgramChanged()
{
    QFETCH(QString, path);
    QFETCH(bool, removed);
    const QTemporaryDir folder;
    const LabFiles lab = small();
    QVERIFY(!saveLabFiles(lab, {}, folder.path()));
    QCOMPARE(changedOnDisk(lab, folder.path()), QStringList());
    if (removed)
        QVERIFY(QFile::remove(folder.filePath(path)));
    else
        writeTo(folder.filePath(path), "of another program\n");
    QCOMPARE(changedOnDisk(lab, folder.path()), QStringList{path});
    LabFiles edited = withText(lab, text("S1/instructions.md"), text("# Mine\n"));
    edited = withText(edited, text("S1/new.md"), text("mine\n"));
    const QByteArray before = authoring::contentOf(folder.filePath(text("S1/instructions.md")));
    const std::optional<Error> error = saveLabFiles(edited, lab, folder.path());
    QVERIFY(error);
    QVERIFY2(error->message.contains(path), qPrintable(error->message));
    QCOMPARE(authoring::contentOf(folder.filePath(text("S1/instructions.md"))), before);
}

void TestLabFiles::overwritesWhenTold()
{
    const QTemporaryDir folder;
    const LabFiles lab = small();
    QVERIFY(!saveLabFiles(lab, {}, folder.path()));
    writeTo(folder.filePath(text("S1/preset.json")), "of another program\n");
    QVERIFY(QFile::remove(folder.filePath(text("S1/solution.lua"))));
    const LabFiles edited = withText(lab, text("S1/instructions.md"), text("# Mine\n"));
    QVERIFY(!saveLabFiles(edited, lab, folder.path(), OnConflict::Overwrite));
    QCOMPARE(changedOnDisk(edited, folder.path()), QStringList());
}

void TestLabFiles::sameChangeTwiceIsNoConflict()
{
    const QTemporaryDir folder;
    const LabFiles lab = small();
    QVERIFY(!saveLabFiles(lab, {}, folder.path()));
    const LabFiles edited = withText(lab, text("S1/instructions.md"), text("# Mine\n"));
    QVERIFY(!saveLabFiles(edited, lab, folder.path()));
    QVERIFY(!saveLabFiles(edited, lab, folder.path()));
}

/// A save that is broken off must leave a lab that opens.
void TestLabFiles::indexIsWrittenAfterWhatItNames()
{
    const QTemporaryDir folder;
    const LabFiles lab = small();
    QVERIFY(!saveLabFiles(lab, {}, folder.path()));
    LabFiles two;
    TAKE(two, withStepAdded(lab, text("A2"), text("Second")));
    // A folder stands where the step's solution should be, so that the save breaks off.
    QVERIFY(QDir(folder.path()).mkpath(text("A2/solution.lua/in-the-way")));
    QVERIFY(saveLabFiles(two, lab, folder.path(), OnConflict::Overwrite));
    const Lab left = *readLab(folder.path());
    QCOMPARE(left.tasks.size(), std::size_t{1});
    QCOMPARE(authoring::contentOf(folder.filePath(text("lab.json"))),
             lab.contents[text("lab.json")]);
}

void TestLabFiles::refusesPathsThatLeaveTheLab_data()
{
    QTest::addColumn<QString>("path");
    for (const char *path :
         {"../lab.json", "S1/../../x.md", "/etc/passwd", "S1//x.md", "", "S1/", "C:/x.md", "C:x.md",
          "S1\\x.md", "S1/a\tb.md", ".git/config", "S1/.hidden", "con", "S1/NUL.txt", "S1/x.",
          "S1/x ", "a/b/c/d/e/f/g.md"})
        QTest::newRow(path) << text(path);
    QTest::newRow("long") << QString(300, QLatin1Char('a'));
}

void TestLabFiles::refusesPathsThatLeaveTheLab()
{
    QFETCH(QString, path);
    QVERIFY(!faultOfLabPath(path).isEmpty());
    const QTemporaryDir folder;
    const QString inner = folder.filePath(text("lab"));
    const LabFiles lab = withText(small(), path, text("text\n"));
    QVERIFY(saveLabFiles(lab, {}, inner));
    QVERIFY(!QFileInfo::exists(inner));
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList());
}

void TestLabFiles::refusesToWriteThroughALink()
{
    const QTemporaryDir folder;
    const QString inner = folder.filePath(text("lab"));
    QVERIFY(QDir().mkpath(inner));
    QVERIFY(QDir().mkpath(folder.filePath(text("elsewhere"))));
    QVERIFY(QFile::link(folder.filePath(text("elsewhere")), inner + text("/S1")));
    const std::optional<Error> error = saveLabFiles(small(), {}, inner);
    QVERIFY(error && error->message.contains(text("link")));
    QVERIFY(QDir(folder.filePath(text("elsewhere"))).isEmpty());
}

void TestLabFiles::unwritableFolderIsSaid()
{
    const QTemporaryDir folder;
    writeTo(folder.filePath(text("file")), "text");
    const QString inside = folder.filePath(text("file/lab"));
    const std::optional<Error> error = saveLabFiles(small(), {}, inside);
    QVERIFY(error);
    // What stands in the way is named, or what could not be made.
    QVERIFY2(!error->file.isEmpty() && inside.startsWith(error->file), qPrintable(error->file));
}

/// An undo keeps many states of a lab: they must cost little.
void TestLabFiles::copiesShareTheirFiles()
{
    const LabFiles lab = small();
    const LabFiles edited = withText(lab, text("S1/instructions.md"), text("# Other\n"));
    const QString path = text("S1/task.json");
    QVERIFY(lab.contents.find(path)->constData() == edited.contents.find(path)->constData());
}

void TestLabFiles::stepAloneLeavesTheOthersOut()
{
    LabFiles lab;
    lab.contents = {{text("lab.json"), R"({"steps": ["a", "b", "", "ab"]})"},
                    {text("a/task.json"), "{}"},
                    {text("ab/task.json"), "{}"},
                    {text("b/task.json"), "{}"},
                    {text("walls.lua"), ""}};
    QCOMPARE(stepAlone(lab, text("b")).contents.keys(),
             QStringList({text("b/task.json"), text("lab.json"), text("walls.lua")}));
    QCOMPARE(stepAlone(lab, text("c")).contents, lab.contents);
}

QTEST_GUILESS_MAIN(TestLabFiles)
#include "test_lab_files.moc"
