// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"

#include "app/author_window.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"
#include "tests/test_paths.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/reading/lab_archive.h"

#include <QDropEvent>
#include <QMimeData>
#include <QStandardPaths>

using namespace cradle;
using namespace cradle::windows;

/// A lab that is dropped on a window, as a folder or as one file.
class TestLabDrop : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void cleanup() { QDir(userLabsFolder()).removeRecursively(); }
    void droppedLabOpens();
    void droppedLabOpensForItsAuthor();
};

namespace {

/// \return whether the window takes it
bool dropOn(QWidget &target, const QString &path)
{
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    const QPoint centre = target.rect().center();
    QDragEnterEvent enter(centre, Qt::CopyAction, &data, Qt::LeftButton, {});
    enter.ignore();
    QApplication::sendEvent(&target, &enter);
    if (!enter.isAccepted())
        return false;
    QDropEvent event(centre, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&target, &event);
    return true;
}

} // namespace

void TestLabDrop::droppedLabOpens()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("falling.cradle"));
    QVERIFY(!exportLab(
        newLab(QStringLiteral("falling"), QStringLiteral("Falling"), QStringLiteral("en")), file));
    OpenWindow student(folder);
    const auto drop = [&student](const QString &path) { return dropOn(student.window, path); };
    const QString shipped = student.bench.lab().title;
    QVERIFY(!drop(folder.filePath(QStringLiteral("notes.txt"))));
    QCOMPARE(student.bench.lab().title, shipped);
    QVERIFY(drop(file));
    QCOMPARE(student.bench.lab().title, QStringLiteral("Falling"));
    QCOMPARE(student.steps()->count(), 1);
    QVERIFY(QFileInfo::exists(userLabsFolder() + QStringLiteral("/falling/lab.json")));
    // The same again is the same lab, not a second one.
    QVERIFY(drop(file));
    QCOMPARE(QDir(userLabsFolder()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 1);
    // A folder is a lab, too; a file that only is named so is told, and the lab stays.
    QVERIFY(drop(sourcePath("tasks/labs/bouncing-ball")));
    QCOMPARE(student.steps()->count(), 3);
    const QString broken = folder.filePath(QStringLiteral("broken.cradle"));
    QFile text(broken);
    QVERIFY(text.open(QIODevice::WriteOnly));
    QCOMPARE(text.write("no archive"), 10);
    text.close();
    QVERIFY(drop(broken));
    QCOMPARE(student.steps()->count(), 3);
    QVERIFY(student.says(QStringLiteral("broken.cradle")));
}

void TestLabDrop::droppedLabOpensForItsAuthor()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("falling.cradle"));
    QVERIFY(!exportLab(
        newLab(QStringLiteral("falling"), QStringLiteral("Falling"), QStringLiteral("en")), file));
    OpenAuthor author(folder);
    openBall(author, folder);
    author.window.panes().showTab(AuthorWindow::Text);
    // Over an editor, too, which would write down the path.
    auto *text = author.find<MarkdownEditor>("markdown")->viewport();
    const LabFiles before = author.files();
    QVERIFY(dropOn(*text, file));
    QTRY_COMPARE(author.document().title(), QStringLiteral("Falling"));
    QCOMPARE(author.document().folder(), userLabsFolder() + QStringLiteral("/falling"));

    // What is not saved is asked about first.
    author.window.steps().addStep();
    const auto cancelled = OpenAuthor::answerQuestion(QStringLiteral("Cancel"));
    QVERIFY(dropOn(author.window, folder.filePath(QStringLiteral("ball"))));
    QTRY_VERIFY(*cancelled);
    QVERIFY(author.document().isModified());
    QCOMPARE(author.document().title(), QStringLiteral("Falling"));
    OpenAuthor::answerQuestion(QStringLiteral("Discard"));
    QVERIFY(dropOn(author.window, folder.filePath(QStringLiteral("ball"))));
    QTRY_COMPARE(author.files(), before);
}

QTEST_MAIN(TestLabDrop)
#include "test_lab_drop.moc"
