// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workbench.h"
#include "keeping_fixture.h"
#include "tests/patience.h"

#include "views/code/versions_pane.h"
#include "views/notes_pane.h"

#include <QPlainTextEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <Qsci/qsciscintilla.h>

using namespace cradle;
using namespace cradle::windows;

/// Versions of programs and notes, and the ways back to them.
class TestGoingBack final : public QObject, private KeepingFixture
{
    Q_OBJECT
private slots:
    void init();
    void versionsComeAndGoBack();
    void passedStepOutlivesATrial();
    void passOutlivesManyTrials();
    void passedSceneOutlivesATrial();
    void undoOutlivesAStep();
    void notesAreKeptForEachStep();
    void notesHaveVersions();
};

void TestGoingBack::init()
{
    begin();
}

void TestGoingBack::versionsComeAndGoBack()
{
    OpenWindow open(folder());
    inCode(open);
    const QString solution = open.bench.task()->solution;
    type(open, solution);
    check(open);
    QVERIFY(open.bench.check().report()->passed);
    type(open, solution + QStringLiteral("\nerror('broken')\n"));
    check(open);
    QVERIFY(!open.bench.check().report()->passed);
    auto *list = open.window.versions().findChild<QTreeWidget *>();
    QCOMPARE(list->topLevelItemCount(), 2);
    QVERIFY(list->topLevelItem(0)->text(1).contains(QStringLiteral("not passed")));
    QVERIFY(list->topLevelItem(0)->text(2).contains(QStringLiteral("error('broken')")));
    open.window.versions().parentWidget()->raise();
    auto *back = open.window.versions().findChildren<QPushButton *>().last();
    QCOMPARE(back->text(), QStringLiteral("Back to what &passed"));
    QVERIFY(back->isEnabled());
    back->click();
    QCOMPARE(open.bench.code().text(), solution);
    QCOMPARE(open.window.codePane().editor().text(), solution);
    QVERIFY(!back->isEnabled());
    // Going back can be undone.
    open.window.codePane().editor().undo();
    QTRY_VERIFY(open.bench.code().text().contains(QStringLiteral("broken")));
}

/// Step 17 was passed; e = 0.9 is tried, and the application is started anew.
void TestGoingBack::passedStepOutlivesATrial()
{
    QString solution;
    const QString id = QStringLiteral("L42T17");
    {
        OpenWindow open(folder());
        inCode(open);
        QVERIFY(open.bench.openTask(id));
        solution = open.bench.task()->solution;
        type(open, solution);
        check(open);
        QVERIFY(open.bench.check().report()->passed);
        QString trial = solution;
        trial.replace(QStringLiteral("restitution = 0.75"), QStringLiteral("restitution = 0.9"));
        QVERIFY(trial != solution);
        type(open, trial);
        QVERIFY(open.window.close());
    }
    OpenWindow open(folder());
    inCode(open);
    QVERIFY(open.bench.openTask(id));
    QVERIFY(open.bench.code().text().contains(QStringLiteral("= 0.9")));
    QVERIFY(open.isTicked(open.bench.current())); // once earned, it stays
    open.window.versions().parentWidget()->raise();
    // The version that passed and the program now, with the line marked in which they differ.
    auto *list = open.window.versions().findChild<QTreeWidget *>();
    list->setCurrentItem(list->topLevelItem(1));
    const auto programs = open.window.versions().findChildren<QsciScintilla *>();
    QCOMPARE(programs.size(), 2);
    for (const QsciScintilla *program : programs) {
        for (int line = 0; line < program->lines(); ++line)
            QCOMPARE(program->markersAtLine(line) != 0,
                     program->text(line).contains(QStringLiteral("restitution = 0.")));
    }
    // Who reads on in it stays there, whatever is told of the program meanwhile.
    QsciScintilla *then = programs.front();
    then->setFirstVisibleLine(then->lines());
    const int top = then->firstVisibleLine();
    QVERIFY(top > 0);
    open.bench.code().apply();
    QCOMPARE(then->firstVisibleLine(), top);
    auto *back = open.window.versions().findChildren<QPushButton *>().last();
    QCOMPARE(back->text(), QStringLiteral("Back to what &passed"));
    QVERIFY(back->isEnabled());
    back->click();
    QCOMPARE(open.bench.code().text(), solution);
    check(open);
    QVERIFY(open.bench.check().report()->passed);
}

/// More versions came after the pass than are shown.
void TestGoingBack::passOutlivesManyTrials()
{
    constexpr int trials = 310;
    OpenWindow open(folder());
    inCode(open);
    const QString solution = open.bench.task()->solution;
    type(open, solution);
    check(open);
    for (int i = 0; i < trials; ++i)
        QVERIFY(!open.bench.code().workspace().keep(open.bench.task()->id,
                                                    QStringLiteral("-- trial %1\n").arg(i), {}));
    type(open, QStringLiteral("-- mine\n"));
    open.bench.openTaskAt(1);
    open.bench.openTaskAt(0);
    auto *list = open.window.versions().findChild<QTreeWidget *>();
    QVERIFY(list->topLevelItemCount() < trials);
    open.window.versions().parentWidget()->raise();
    open.click(QStringLiteral("Back to what &passed"));
    QCOMPARE(open.bench.code().text(), solution);
}

/// The same by the laws of the scene, where e is one of its values.
void TestGoingBack::passedSceneOutlivesATrial()
{
    const QString name = QStringLiteral("Back to the scene that passed");
    const QString id = QStringLiteral("L42T17");
    Preset passed;
    {
        OpenWindow open(folder());
        QVERIFY(open.bench.openTask(id));
        open.bench.setMode(Mode::Explore);
        passed = open.solution();
        open.bench.document().edit(QStringLiteral("Scene"), passed);
        check(open);
        QVERIFY(open.bench.check().report()->passed);
        QVERIFY(!open.button(name));
        Preset trial = passed;
        trial.restitution = 0.9;
        open.bench.document().edit(QStringLiteral("e"), trial);
        QVERIFY(open.button(name));
        QVERIFY(open.window.close());
    }
    OpenWindow open(folder());
    open.bench.setMode(Mode::Explore);
    QVERIFY(open.bench.openTask(id));
    QCOMPARE(open.preset().restitution, 0.9);
    open.click(name);
    QVERIFY(open.preset() == passed);
    QVERIFY(!open.button(name));
    check(open);
    QVERIFY(open.bench.check().report()->passed);
    open.bench.document().undoStack().undo();
    QCOMPARE(open.preset().restitution, 0.9);
    QVERIFY(open.button(name));
    open.bench.setMode(Mode::Code); // there programs are gone back to
    QVERIFY(!open.button(name));
}

void TestGoingBack::undoOutlivesAStep()
{
    OpenWindow open(folder());
    inCode(open);
    CodeEditor &editor = open.window.codePane().editor();
    const QString before = editor.text();
    type(open, QStringLiteral("-- mine\n"));
    open.bench.openTaskAt(1);
    QVERIFY(!editor.canUndo());
    open.bench.openTaskAt(0);
    QCOMPARE(editor.text(), QStringLiteral("-- mine\n"));
    QVERIFY(editor.canUndo());
    editor.undo();
    QCOMPARE(editor.text(), before);
}

void TestGoingBack::notesAreKeptForEachStep()
{
    OpenWindow open(folder());
    inCode(open);
    auto *field = open.window.notes().findChild<QPlainTextEdit *>();
    field->setPlainText(QStringLiteral("It *moves*."));
    open.bench.openTaskAt(1);
    QCOMPARE(field->toPlainText(), QString());
    QCOMPARE(content(work() + QStringLiteral("/notes/L42T1.md")), QByteArray("It *moves*."));
    open.bench.openTaskAt(0);
    QCOMPARE(field->toPlainText(), QStringLiteral("It *moves*."));
}

void TestGoingBack::notesHaveVersions()
{
    {
        OpenWindow open(folder());
        inCode(open);
        auto *field = open.window.notes().findChild<QPlainTextEdit *>();
        field->setPlainText(QStringLiteral("It moves."));
        open.bench.openTaskAt(1);
        open.bench.openTaskAt(0);
        field->setPlainText(QStringLiteral("It *moves*."));
        QVERIFY(open.window.close());
    }
    QCOMPARE(GitHome::git(work(), {QStringLiteral("log"), QStringLiteral("--format=%s"),
                                   QStringLiteral("refs/cradle/notes/L42T1")}),
             QStringLiteral("L42T1: notes\nL42T1: notes"));
}

QTEST_MAIN(TestGoingBack)
#include "test_going_back.moc"
