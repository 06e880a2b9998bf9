// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include <QContextMenuEvent>
#include <QDrag>
#include <QDropEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QScrollArea>

using namespace cradle;
using namespace cradle::windows;

/// Ways through the author's window by mouse: a step that is dragged, its menu, a finding that
/// shows its run, mistakes that are suggested, a check that is written in Lua.
class TestAuthorWays : public QObject
{
    Q_OBJECT
private slots:
    void stepsHaveTheirMenu();
    void draggedStepMoves();
    void findingShowsItsRun();
    void suggestedMistakeIsTakenOver();
    void checkInLuaIsWritten();
};

namespace {

/// Verifies the open step by its button, and waits.
void verify(OpenAuthor &author)
{
    author.window.panes().showTab(AuthorWindow::Proof);
    author.click(QStringLiteral("Verify this step"));
    QTRY_VERIFY(!author.window.proofTab().isRunning());
    QVERIFY(author.window.proofTab().result());
}

QString titleOf(OpenAuthor &author, int step)
{
    return taskForm(author.files(), author.document().steps().value(step))->title;
}

QString suggestedOf(const QPushButton *button)
{
    return button->parentWidget()->findChild<QLabel *>()->text();
}

} // namespace

void TestAuthorWays::stepsHaveTheirMenu()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    auto *list = author.find<QListWidget>("authorSteps");
    const QPoint second = list->visualItemRect(list->item(1)).center();
    QTest::mouseClick(list->viewport(), Qt::RightButton, {}, second);
    QContextMenuEvent event(QContextMenuEvent::Mouse, second,
                            list->viewport()->mapToGlobal(second));
    QApplication::sendEvent(list->viewport(), &event);
    auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
    QVERIFY(menu);
    for (QAction *action : menu->actions()) {
        if (action->text() == QStringLiteral("&Duplicate"))
            action->trigger();
    }
    menu->close();
    QCOMPARE(list->count(), 4);
    QCOMPARE(titleOf(author, 1), titleOf(author, 2));
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
    author.window.panes().showTab(AuthorWindow::Programs);
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
    author.window.panes().showTab(AuthorWindow::Proof);
    QVERIFY(!author.window.notice().isVisible());
    author.window.panes().showTab(AuthorWindow::Scene);
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
    author.window.panes().showTab(AuthorWindow::Proof);
    author.click(QStringLiteral("Suggest mistakes"));
    QTRY_VERIFY(!author.window.proofTab().isRunning());
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
    author.window.panes().showTab(AuthorWindow::Checks);
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
