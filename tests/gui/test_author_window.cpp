// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"

#include "app/author_window.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/reading/lab_archive.h"
#include "views/code/code_editor.h"
#include "views/markdown_view.h"
#include "views/menu.h"

#include <Qsci/qsciscintilla.h>

#include <QSignalSpy>

using namespace cradle;
using namespace cradle::windows;

/// A lab made from nothing through the window, proved, exported, and passed by a student.
class TestAuthorWindow : public QObject
{
    Q_OBJECT
private slots:
    void labFromNothingToAStudentWhoPasses();
    void stepsAreAddedRenamedMovedAndRemoved();
    void typingIsOneUndoOfTheLab();
    void sceneIsEditedLockedAndTakenFromTheMoment();
    void figureOfTheSceneGoesIntoTheText();
};

namespace {

QStringList titles(OpenAuthor &author)
{
    QStringList result;
    for (const QString &step : author.document().steps())
        result.append(taskForm(author.files(), step)->title);
    return result;
}

} // namespace

void TestAuthorWindow::labFromNothingToAStudentWhoPasses()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Falling"));
    const QString step = author.document().step();

    // The text, with its preview.
    author.window.panes().showTab(AuthorWindow::Text);
    auto *text = author.find<MarkdownEditor>("markdown");
    text->selectAll();
    QTest::keyClicks(text, QStringLiteral("# Let it fall"));
    QTest::keyClick(text, Qt::Key_Return);
    QTest::keyClicks(text, QStringLiteral("Set `gravity` in `on_load`."));
    QTRY_VERIFY(
        textShown(author.window.textTab().student()).contains(QStringLiteral("Let it fall")));
    QVERIFY(textOf(author.files(), instructionsPath(author.files(), step))
                .startsWith(QStringLiteral("# Let it fall")));
    author.fill("stepCommit", QStringLiteral("Let it fall"));

    // A check of its own, by the form that the catalogue makes.
    author.window.panes().showTab(AuthorWindow::Checks);
    author.click(QStringLiteral("Add a check"));
    author.fill("checkTitle", QStringLiteral("It starts to the right"));
    author.fill("checkId", QStringLiteral("start"));
    author.pick("checkKind", QStringLiteral("start"));
    author.fill("velocity", QStringLiteral("2, 0"));
    author.fill("duration", QStringLiteral("0.05"));
    const Result<TaskForm> form = taskForm(author.files(), step);
    QCOMPARE(form->checks.size(), std::size_t{2});
    QCOMPARE(form->checks[1].id, QStringLiteral("start"));
    QCOMPARE(form->checks[1].title, QStringLiteral("It starts to the right"));

    // A mistake that fails by it.
    author.window.panes().showTab(AuthorWindow::Programs);
    author.choose(QStringLiteral("A mistake that students make"));
    author.typeInPlace(author.find<QListWidget>("programs"), QStringLiteral("thrown"));
    QVERIFY(
        knownNames(author.files(), step, KnownKind::Mistake).contains(QStringLiteral("thrown")));
    CodeEditor &code = author.window.programsTab().editor();
    code.selectAll();
    QTest::keyClick(code.findChild<QsciScintilla *>(), Qt::Key_Delete);
    auto *area = code.findChild<QsciScintilla *>();
    area->insert(
        QStringLiteral("-- It is thrown\n--\n-- The circle starts with 2 m/s upward "
                       "instead of to the right. Look at on_load.\n\n"
                       "function on_load()\n  gravity = vec(0, -9.81)\n"
                       "  circle1.velocity = vec(0, 2)\nend\n\n"
                       "function on_update(timestep)\n"
                       "  circle1.velocity = circle1.velocity + gravity * timestep\n"
                       "  circle1.position = circle1.position + circle1.velocity * timestep\n"
                       "end\n"));
    QTRY_VERIFY(
        programText(author.files(), knownPath(step, KnownKind::Mistake, QStringLiteral("thrown")))
            ->contains(QStringLiteral("vec(0, 2)")));

    // The proof.
    author.choose(QStringLiteral("Verify this step"));
    QTRY_VERIFY(author.window.proofTab().result());
    const VerifiedTask *proof = author.window.proofTab().result();
    QStringList findings;
    for (const LabFinding &finding : proof->findings)
        findings.append(finding.program + finding.message);
    QVERIFY2(findings.isEmpty(), qPrintable(findings.join(QLatin1Char('\n'))));

    // Saved, exported, opened by a student who passes.
    const QString place = folder.filePath(QStringLiteral("falling"));
    OpenAuthor::answerDialog(place);
    author.choose(QStringLiteral("Save"));
    QVERIFY(!author.document().isModified());
    QCOMPARE(*readLabFiles(place), author.files());
    const QString file = folder.filePath(QStringLiteral("falling.cradle"));
    OpenAuthor::answerDialog(file);
    author.choose(QStringLiteral("Export as one file…"));
    QVERIFY(QFileInfo::exists(file));

    const Result<QString> unpacked = importLab(file, folder.filePath(QStringLiteral("labs")));
    QVERIFY(unpacked.ok());
    OpenWindow student(folder);
    QVERIFY(!student.bench.openLab(*unpacked, QStringLiteral("en")));
    QVERIFY(student.bench.task());
    student.bench.setMode(Mode::Code);
    QVERIFY(!student.bench.takeScript(*unpacked + QStringLiteral("/%1/starter.lua").arg(step)));
    student.check();
    QVERIFY(!student.bench.check().report()->passed);
    QVERIFY(!student.bench.takeScript(*unpacked + QStringLiteral("/%1/solution.lua").arg(step)));
    student.check();
    QVERIFY(student.bench.check().report()->passed);
}

void TestAuthorWindow::stepsAreAddedRenamedMovedAndRemoved()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Steps"));
    const QString first = titles(author).front();
    auto *list = author.find<QListWidget>("authorSteps");
    QSignalSpy read(&author.document(), &AuthorDocument::labRead);
    author.click(QStringLiteral("Add a step"));
    QTRY_VERIFY(!read.isEmpty()); // which takes nothing from who is typing
    auto *field = list->viewport()->findChild<QLineEdit *>();
    QVERIFY(field);
    QCOMPARE(field->selectedText(), QStringLiteral("New step"));
    author.typeInPlace(list, QStringLiteral("Second"));
    author.click(QStringLiteral("Add a step"));
    author.typeInPlace(list, QStringLiteral("Third"));
    QCOMPARE(titles(author),
             QStringList({first, QStringLiteral("Second"), QStringLiteral("Third")}));

    list->setFocus();
    QTest::keyClick(list, Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(titles(author),
             QStringList({first, QStringLiteral("Third"), QStringLiteral("Second")}));
    author.click(QStringLiteral("Duplicate the step"));
    QCOMPARE(author.document().steps().size(), 4);
    author.undo();
    QCOMPARE(author.document().steps().size(), 3);
    author.undo();
    QCOMPARE(titles(author),
             QStringList({first, QStringLiteral("Second"), QStringLiteral("Third")}));
    author.redo();
    QCOMPARE(titles(author),
             QStringList({first, QStringLiteral("Third"), QStringLiteral("Second")}));

    // As a drag moves the row.
    QVERIFY(list->model()->moveRow({}, 2, {}, 0));
    QTRY_COMPARE(titles(author),
                 QStringList({QStringLiteral("Second"), first, QStringLiteral("Third")}));
    author.click(QStringLiteral("Remove the step"));
    QCOMPARE(titles(author), QStringList({first, QStringLiteral("Third")}));
    QCOMPARE(author.document().steps().indexOf(author.document().step()), 0);
}

void TestAuthorWindow::typingIsOneUndoOfTheLab()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Undo"));
    const LabFiles before = author.files();
    author.window.panes().showTab(AuthorWindow::Text);
    auto *text = author.find<MarkdownEditor>("markdown");
    const QString old = text->toPlainText();
    text->setFocus();
    QTest::keyClicks(text, QStringLiteral("Abc"));
    QCOMPARE(text->toPlainText(), QStringLiteral("Abc") + old);
    QCOMPARE(author.document().undoStack().count(), 1);
    QVERIFY(author.window.isWindowModified());
    author.undo();
    QCOMPARE(text->toPlainText(), old);
    QCOMPARE(author.files(), before);
    author.redo();
    QCOMPARE(text->toPlainText(), QStringLiteral("Abc") + old);

    // A name that nothing is called is told.
    QTest::keyClicks(text, QStringLiteral("`circle7.speed` "));
    QTRY_VERIFY(author.find<QPushButton>("unknownNames")->isVisible());
    QVERIFY(author.find<QPushButton>("unknownNames")->text().contains(QStringLiteral("circle7")));
}

void TestAuthorWindow::sceneIsEditedLockedAndTakenFromTheMoment()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Scene"));
    const QString step = author.document().step();
    SceneTab &tab = author.window.sceneTab();
    author.window.panes().showTab(AuthorWindow::Scene);
    QCOMPARE(tab.templates().actions().size(), 9); // five scenes, a line, three patterns
    tab.templates().actions().front()->trigger();  // head-on
    QCOMPARE(presetOf(author.files(), step)->circles.size(), std::size_t{2});

    tab.simulation().goTo(60);
    author.click(QStringLiteral("Start from this moment"));
    const Preset moved = *presetOf(author.files(), step);
    QVERIFY(std::abs(moved.circles[0].body.position.x) < 1e-9); // −2 m + 2 m/s · 1 s
    author.undo();
    QCOMPARE(presetOf(author.files(), step)->circles[0].body.position.x, -2.0);
    QCOMPARE(tab.preset().preset().circles[0].body.position.x, -2.0);

    for (QAction *action : tab.locks().actions()) {
        if (action->data().toString() == QLatin1String("gravity"))
            action->trigger();
    }
    QCOMPARE(taskForm(author.files(), step)->locked, QStringList{QStringLiteral("gravity")});
    author.document().readNow();
    QVERIFY(author.document().task());
    QCOMPARE(author.document().task()->locked, QStringList{QStringLiteral("gravity")});
}

void TestAuthorWindow::figureOfTheSceneGoesIntoTheText()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Figure"));
    const QString step = author.document().step();
    author.window.panes().showTab(AuthorWindow::Text);
    author.click(QStringLiteral("Insert the scene as a figure"));
    const QByteArray svg = author.files().contents.value(step + QStringLiteral("/figure-1.svg"));
    QVERIFY(svg.contains("<svg"));
    QVERIFY(svg.contains("<path") || svg.contains("<circle"));
    QVERIFY(textOf(author.files(), instructionsPath(author.files(), step))
                .contains(QStringLiteral("](figure-1.svg)")));
    author.document().readNow();
    QVERIFY(author.document().lab().findings.empty());

    // A paragraph of its own, below the title, or between two others.
    auto *text = author.find<MarkdownEditor>("markdown");
    text->setPlainText(QStringLiteral("# Title\n\nOne two.\n"));
    const QString second = QStringLiteral("![](figure-2.svg)");
    text->insertParagraph(second);
    QCOMPARE(text->toPlainText(), QStringLiteral("# Title\n\n%1\n\nOne two.\n").arg(second));
    text->setPlainText(QStringLiteral("# Title\n\nOne two.\n"));
    QTextCursor cursor = text->textCursor();
    cursor.setPosition(static_cast<int>(text->toPlainText().indexOf(QStringLiteral(" two"))));
    text->setTextCursor(cursor);
    text->insertParagraph(second);
    QCOMPARE(text->toPlainText(), QStringLiteral("# Title\n\nOne\n\n%1\n\n two.\n").arg(second));
}

QTEST_MAIN(TestAuthorWindow)
#include "test_author_window.moc"
