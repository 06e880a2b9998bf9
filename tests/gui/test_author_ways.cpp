// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"

#include "app/author_window.h"
#include "tests/gui/open_window.h"

#include "tasks/authoring/lab_archive.h"
#include "tasks/authoring/lab_edits.h"
#include "views/code/code_editor.h"

#include <Qsci/qsciscintilla.h>

#include <QDrag>
#include <QDropEvent>
#include <QMimeData>
#include <QScrollArea>
#include <QStandardPaths>

using namespace cradle;
using namespace cradle::windows;

/// Ways through the author's window by mouse: a file that is dropped, a step that is dragged, a
/// finding that shows its run, mistakes that are suggested, a check that is written in Lua.
class TestAuthorWays : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void cleanup() { QDir(userLabsFolder()).removeRecursively(); }
    void droppedLabOpens();
    void droppedLabOpensForItsAuthor();
    void draggedStepMoves();
    void findingShowsItsRun();
    void suggestedMistakeIsTakenOver();
    void checkInLuaIsWritten();
};

namespace {

/// Verifies the open step by its button, and waits.
void verify(OpenAuthor &author)
{
    author.window.showTab(AuthorWindow::Proof);
    author.click(QStringLiteral("Verify this step"));
    QTRY_VERIFY_WITH_TIMEOUT(!author.window.proofTab().isRunning(), 120'000);
    QVERIFY(author.window.proofTab().result());
}

/// Types a program into an editor in place of what is there.
void retype(CodeEditor &editor, const QString &program)
{
    QVERIFY(editor.isVisible());
    auto *area = editor.findChild<QsciScintilla *>();
    editor.selectAll();
    QTest::keyClick(area, Qt::Key_Delete);
    area->insert(program);
    QTest::qWait(50); // the editor tells of an edit when it is through with it
}

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

QString suggestedOf(const QPushButton *button)
{
    return button->parentWidget()->findChild<QLabel *>()->text();
}

} // namespace

void TestAuthorWays::droppedLabOpens()
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
    QVERIFY(drop(QStringLiteral(CRADLE_SOURCE_DIR "/tasks/bouncing-ball")));
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

void TestAuthorWays::droppedLabOpensForItsAuthor()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("falling.cradle"));
    QVERIFY(!exportLab(
        newLab(QStringLiteral("falling"), QStringLiteral("Falling"), QStringLiteral("en")), file));
    OpenAuthor author(folder);
    openBall(author, folder);
    author.window.showTab(AuthorWindow::Text);
    // Over an editor, too, which would write down the path.
    auto *text = author.find<MarkdownEditor>("markdown")->viewport();
    const LabFiles before = author.files();
    QVERIFY(dropOn(*text, file));
    QTRY_COMPARE(author.document().title(), QStringLiteral("Falling"));
    QCOMPARE(author.document().folder(), userLabsFolder() + QStringLiteral("/falling"));

    // What is not saved is asked about first.
    author.window.steps().addStep();
    OpenAuthor::answerQuestion(QStringLiteral("Cancel"));
    QVERIFY(dropOn(author.window, folder.filePath(QStringLiteral("ball"))));
    QTest::qWait(300);
    QVERIFY(author.document().isModified());
    QCOMPARE(author.document().title(), QStringLiteral("Falling"));
    OpenAuthor::answerQuestion(QStringLiteral("Discard"));
    QVERIFY(dropOn(author.window, folder.filePath(QStringLiteral("ball"))));
    QTRY_COMPARE(author.files(), before);
}

void TestAuthorWays::draggedStepMoves()
{
    if (QGuiApplication::platformName() == QLatin1String("offscreen"))
        QSKIP("the offscreen platform has no drag and drop");
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const QStringList before = author.document().steps();
    auto *list = author.find<QListWidget>("authorSteps");
    QWidget *area = list->viewport();
    const QPoint from = list->visualItemRect(list->item(2)).center();
    const QPoint to = list->visualItemRect(list->item(0)).topLeft() + QPoint(20, 1);
    // A drag has an event loop of its own: the drop comes from there, as it does from the desktop.
    bool dragged = false;
    QTimer::singleShot(200, list, [&] {
        const std::unique_ptr<QMimeData> row(list->model()->mimeData({list->model()->index(2, 0)}));
        QDragEnterEvent enter(from, Qt::MoveAction, row.get(), Qt::LeftButton, {});
        QApplication::sendEvent(area, &enter);
        QDragMoveEvent move(to, Qt::MoveAction, row.get(), Qt::LeftButton, {});
        QApplication::sendEvent(area, &move);
        QDropEvent drop(to, Qt::MoveAction, row.get(), Qt::LeftButton, {});
        QApplication::sendEvent(area, &drop);
        dragged = enter.isAccepted() && move.isAccepted();
        QDrag::cancel();
    });
    QTest::mousePress(area, Qt::LeftButton, {}, from);
    for (int way = 4; way <= 40; way += 4)
        QTest::mouseMove(area, from - QPoint(0, way));
    QTest::mouseRelease(area, Qt::LeftButton, {}, from);
    QTRY_VERIFY(dragged);
    QTRY_COMPARE(author.document().steps(), (QStringList{before[2], before[0], before[1]}));
    QCOMPARE(list->item(0)->data(Qt::UserRole).toString(), before[2]);
    author.undo();
    QCOMPARE(author.document().steps(), before);
}

void TestAuthorWays::findingShowsItsRun()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Runs"));
    const QString step = author.document().step();
    // A solution that falls too slowly: it fails by a check.
    author.window.showTab(AuthorWindow::Programs);
    author.window.programsTab().openProgram(QStringLiteral("solution.lua"));
    QString program = textOf(author.files(), step + QStringLiteral("/solution.lua"));
    QVERIFY(program.contains(QStringLiteral("-9.81")));
    retype(author.window.programsTab().editor(),
           program.replace(QStringLiteral("-9.81"), QStringLiteral("-9.0")));
    verify(author);
    QVERIFY(!author.window.proofTab().result()->findings.empty());
    author.click(QStringLiteral("Show the run"));

    SceneTab &scene = author.window.sceneTab();
    QCOMPARE(author.window.tabs().currentIndex(), int{AuthorWindow::Scene});
    QVERIFY(scene.preset().isVisiting());
    QVERIFY(author.window.notice().isVisible());
    QVERIFY(author.window.notice().text().contains(QStringLiteral("solution")));
    // It is the run of that program: the circle falls with 9 m/s².
    QVERIFY(scene.simulation().current() > 0);
    const Simulation &run = scene.simulation();
    const double fallen = run.recording().circles(run.current()).front().velocity.y;
    const double began = run.preset().circles.front().body.velocity.y;
    QVERIFY2(std::abs(fallen - began + 9.0 * run.time()) < 1e-9,
             qPrintable(QString::number(fallen)));
    // The notice belongs to that scene alone.
    author.window.showTab(AuthorWindow::Proof);
    QVERIFY(!author.window.notice().isVisible());
    author.window.showTab(AuthorWindow::Scene);
    QVERIFY(author.window.notice().isVisible());
    author.click(QStringLiteral("Back to the step's scene"));
    QVERIFY(!scene.preset().isVisiting());
    QVERIFY(!author.window.notice().isVisible());
}

void TestAuthorWays::suggestedMistakeIsTakenOver()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Suggest"));
    const QString step = author.document().step();
    const QStringList before = knownNames(author.files(), step, KnownKind::Mistake);
    author.window.showTab(AuthorWindow::Proof);
    author.click(QStringLiteral("Suggest mistakes"));
    QTRY_VERIFY_WITH_TIMEOUT(!author.window.proofTab().isRunning(), 120'000);
    auto *rows = author.find<QScrollArea>("proofRows");
    QVERIFY(rows->isVisible());
    QPushButton *taken = nullptr;
    for (auto *button : rows->findChildren<QPushButton *>()) {
        if (!taken && suggestedOf(button).startsWith(QStringLiteral("Fails by")))
            taken = button;
    }
    QVERIFY(taken);
    const QString said = suggestedOf(taken);
    QTest::mouseClick(taken, Qt::LeftButton);
    const QStringList after = knownNames(author.files(), step, KnownKind::Mistake);
    QCOMPARE(after.size(), before.size() + 1);
    // It is open, and begins with what the suggestion says.
    QCOMPARE(author.window.tabs().currentIndex(), int{AuthorWindow::Programs});
    const QString program = author.window.programsTab().editor().text();
    QVERIFY(program.startsWith(QStringLiteral("-- ")));
    const QString headline =
        program.section(QLatin1Char('\n'), 0, 0).mid(3).remove(QLatin1Char('`'));
    QVERIFY2(said.contains(headline), qPrintable(said));

    // The proof recognises it.
    verify(author);
    for (const LabFinding &finding : author.window.proofTab().result()->findings)
        QVERIFY2(finding.program.isEmpty(), qPrintable(finding.program + finding.message));
    author.undo();
    QCOMPARE(knownNames(author.files(), step, KnownKind::Mistake), before);
}

void TestAuthorWays::checkInLuaIsWritten()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Lua"));
    const QString step = author.document().step();
    author.window.showTab(AuthorWindow::Checks);
    CodeEditor &script = author.window.checksTab().scriptEditor();
    QVERIFY(!script.isVisible());
    author.click(QStringLiteral("Add a check"));
    author.fill("checkId", QStringLiteral("sinks"));
    author.pick("checkKind", QStringLiteral("script"));
    author.fill("duration", QStringLiteral("1"));
    const QString path = step + QStringLiteral("/checks/sinks.lua");
    QVERIFY(author.files().contents.contains(path));
    QVERIFY(script.isVisible());
    QVERIFY(script.text().contains(QStringLiteral("function check(run)")));

    // Broken while it is typed: the line is marked.
    retype(script, QStringLiteral("function check(run)\n  return return\nend\n"));
    QCOMPARE(script.errorLine(), 2);
    retype(script, QStringLiteral("function check(run)\n"
                                  "  local ball = run:circle(1):at(1)\n"
                                  "  return ball.position.y < 0, \"it is still above the middle\"\n"
                                  "end\n"));
    QCOMPARE(script.errorLine(), 0);
    QCOMPARE(textOf(author.files(), path), script.text());
    verify(author);
    const VerifiedTask *proof = author.window.proofTab().result();
    QVERIFY(proof->checks.contains(QStringLiteral("sinks")));
    for (const LabFinding &finding : proof->findings)
        QVERIFY2(finding.program != QLatin1String("solution"), qPrintable(finding.message));
    // The template's mistake falls upward: it fails by the new check, with its words.
    bool failed = false;
    for (const VerifiedProgram &program : proof->programs) {
        for (const CheckOutcome &outcome : program.reports.front().checks) {
            if (program.role == VerifiedProgram::Role::Mistake && !outcome.passed
                && outcome.id == QLatin1String("sinks"))
                failed = outcome.message.contains(QStringLiteral("it is still above the middle"));
        }
    }
    QVERIFY(failed);
}

QTEST_MAIN(TestAuthorWays)
#include "test_author_ways.moc"
