// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_window.h"

#include "app/code_desk.h"
#include "tests/patience.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"

#include <QSignalSpy>

using namespace cradle;
using cradle::windows::OpenWindow;

namespace {

const QString drift = QStringLiteral("function on_load()\n"
                                     "  circle1.velocity = vec(2, 0)\n"
                                     "end\n"
                                     "function on_update(timestep)\n"
                                     "  local way = circle1.velocity * timestep\n"
                                     "  circle1.position = circle1.position + way\n"
                                     "end\n");

} // namespace

/// The student's program in the window: what is typed runs, is kept, and is explained.
class TestCodeDesk final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void whatIsTypedRuns();
    void brokenTextNeverReplacesWhatRuns();
    void onlyOnDemandWhenAskedSo();
    void textSurvivesWithoutAGoodbye();
    void nextStepStartsFromThisOne();
    void afreshIsWhatTheStepBeforeEndedWith();
    void errorIsMarkedWithItsLocals();
    void linesAreSteppedThrough();
    void keysStepThroughLinesFromTheScene();
    void failureMarksItsLineAndShowsTheReference();
    void solutionIsShownAfterPassing();
    void solutionIsShownAfterAllHints();
    void modesHaveTheirTexts();
    void sceneWithoutStepHasNoCode();

private:
    CodeEditor &editor() { return m_open->window.codePane().editor(); }
    Simulation &simulation() { return m_open->bench.simulation(); }
    void write(const QString &program)
    {
        m_open->bench.code().replace(program);
        m_open->bench.code().apply();
    }
    void check()
    {
        QSignalSpy ended(&m_open->bench.check(), &WorkCheck::reported);
        m_open->bench.check().start();
        QVERIFY(!ended.isEmpty() || ended.wait(patience));
        QTRY_VERIFY(!m_open->bench.check().awaitsRun());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestCodeDesk::init()
{
    m_open.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    m_open = std::make_unique<OpenWindow>(*m_folder);
    m_open->bench.setMode(Mode::Code);
}

void TestCodeDesk::whatIsTypedRuns()
{
    editor().setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_A, Qt::ControlModifier);
    for (const QChar letter : QStringLiteral("circle1.velocity = vec(0, 3) "))
        QTest::keyClick(QApplication::focusWidget(), letter.toLatin1());
    QTRY_COMPARE(simulation().preset().circles[0].body.velocity, (Vec2{0.0, 3.0}));
    QTRY_VERIFY(m_open->bench.code().isSaved());
}

void TestCodeDesk::brokenTextNeverReplacesWhatRuns()
{
    write(drift);
    simulation().goTo(5);
    write(drift + QStringLiteral("oops("));
    QVERIFY(m_open->bench.code().run().fault());
    QCOMPARE(simulation().current(), 5); // not even started again
    QVERIFY(editor().errorLine() > 0);
    simulation().restart();
    simulation().goTo(60);
    QVERIFY(std::abs(simulation().recording().circles(60)[0].position.x - 0.0) < 1e-9);
    write(drift);
    QCOMPARE(editor().errorLine(), 0);
}

void TestCodeDesk::onlyOnDemandWhenAskedSo()
{
    write(drift);
    m_open->bench.code().setAppliesAtOnce(false);
    m_open->bench.code().edit(QStringLiteral("circle1.velocity = vec(0, 1)"));
    QTest::qWait(600);
    QCOMPARE(simulation().preset().circles[0].body.velocity, (Vec2{2.0, 0.0}));
    emit m_open->window.codePane().applyRequested();
    QCOMPARE(simulation().preset().circles[0].body.velocity, (Vec2{0.0, 1.0}));
}

void TestCodeDesk::textSurvivesWithoutAGoodbye()
{
    m_open->bench.code().edit(drift);
    QTRY_VERIFY(m_open->bench.code().isSaved());
    // As after kill -9: another window reads what lies on the disk.
    QFile file(m_folder->filePath(QStringLiteral("programs/lab-4.2/lab.lua")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(QString::fromUtf8(file.readAll()), drift);
}

void TestCodeDesk::nextStepStartsFromThisOne()
{
    write(drift);
    m_open->bench.openNextTask();
    QCOMPARE(editor().text(), drift);
    write(drift + QStringLiteral("-- two\n"));
    m_open->bench.openPreviousTask();
    QCOMPARE(editor().text(), drift);
}

void TestCodeDesk::afreshIsWhatTheStepBeforeEndedWith()
{
    write(drift);
    m_open->bench.openNextTask();
    write(QStringLiteral("-- lost my way\n"));
    m_open->bench.waysBack().startAfresh();
    QCOMPARE(editor().text(), drift);
}

void TestCodeDesk::errorIsMarkedWithItsLocals()
{
    write(QString(drift).replace(QStringLiteral("+ way"), QStringLiteral("+ way / (2 - step)")));
    simulation().goTo(10);
    QCOMPARE(simulation().recording().last(), 2);
    QCOMPARE(editor().errorLine(), 6);
    QCOMPARE(simulation().programError()->locals.size(), 2u);
    QCOMPARE(simulation().programError()->locals[1].name, QStringLiteral("way"));
    QVERIFY(m_open->says(QStringLiteral("Local variables")));
    write(drift);
    QCOMPARE(editor().errorLine(), 0);
    QVERIFY(!m_open->says(QStringLiteral("Local variables")));
}

void TestCodeDesk::linesAreSteppedThrough()
{
    write(drift);
    CodePane &pane = m_open->window.codePane();
    emit pane.lineStepRequested();
    QCOMPARE(editor().executingLine(), 5);
    emit pane.lineStepRequested();
    QCOMPARE(editor().executingLine(), 6);
    QVERIFY(m_open->says(QStringLiteral("Local variables")));
    QCOMPARE(simulation().current(), 0);
    emit pane.lineStepRequested(); // the end of on_update
    emit pane.lineStepRequested();
    QCOMPARE(simulation().current(), 1);
    QCOMPARE(editor().executingLine(), 0);
    const double x = simulation().recording().circles(1)[0].position.x;
    QVERIFY(std::abs(x - (-2.0 + 2.0 / 60.0)) < 1e-12);
    // Half a step and then the rest: the same as a whole one.
    emit pane.lineStepRequested();
    emit pane.lineStepRequested();
    emit pane.finishStepRequested();
    QCOMPARE(simulation().current(), 2);
    QVERIFY(std::abs(simulation().recording().circles(2)[0].position.x - (x + 2.0 / 60.0)) < 1e-12);
}

/// Also while the scene is watched, not only in the editor; without a program the keys rest.
void TestCodeDesk::keysStepThroughLinesFromTheScene()
{
    write(drift);
    m_open->press(Qt::Key_F10);
    QCOMPARE(editor().executingLine(), 5);
    m_open->press(Qt::Key_F10, Qt::ControlModifier);
    QCOMPARE(editor().executingLine(), 0);
    QCOMPARE(simulation().current(), 1);
    m_open->bench.setMode(Mode::Explore);
    m_open->press(Qt::Key_F10);
    QCOMPARE(editor().executingLine(), 0);
}

void TestCodeDesk::failureMarksItsLineAndShowsTheReference()
{
    write(
        QString(drift).replace(QStringLiteral("velocity * timestep"), QStringLiteral("velocity")));
    check();
    QVERIFY(m_open->bench.check().report());
    QVERIFY(!m_open->bench.check().report()->passed);
    QCOMPARE(editor().suspectLine(), 5); // which the finding names; what shows it is line 6
    QCOMPARE(simulation().current(), 1); // where it first went wrong
    QTRY_VERIFY(m_open->bench.moment().ghost());
    QVERIFY(std::abs(m_open->bench.moment().ghost()->circles(1)[0].position.x - (-2.0 + 2.0 / 60.0))
            < 1e-12);
    m_open->bench.code().edit(drift);
    QVERIFY(!m_open->bench.moment().ghost());
}

void TestCodeDesk::solutionIsShownAfterPassing()
{
    CodePane &pane = m_open->window.codePane();
    emit pane.solutionRequested();
    QVERIFY(!pane.isSolutionShown());
    write(drift);
    check();
    QVERIFY(m_open->bench.check().report()->passed);
    m_open->click(QStringLiteral("Compare with the reference"));
    QVERIFY(pane.isSolutionShown());
    m_open->bench.openNextTask();
    QVERIFY(!pane.isSolutionShown());
}

void TestCodeDesk::solutionIsShownAfterAllHints()
{
    QVERIFY(!m_open->bench.progress().mayShowSolution());
    m_open->bench.progress().setHintsOpened(
        static_cast<int>(m_open->bench.task()->codeHints.size()));
    QVERIFY(m_open->bench.progress().mayShowSolution());
}

void TestCodeDesk::modesHaveTheirTexts()
{
    QVERIFY(m_open->window.codePane().isVisible());
    m_open->click(QStringLiteral("Explore"));
    QVERIFY(m_open->bench.mode() == Mode::Explore);
    QTRY_VERIFY(!m_open->window.codePane().isVisible());
    QVERIFY(m_open->window.inspector().isVisible());
    QVERIFY(!simulation().isProgrammed());
    m_open->click(QStringLiteral("Code"));
    QVERIFY(m_open->bench.mode() == Mode::Code);
    QTRY_VERIFY(m_open->window.codePane().isVisible());
    QVERIFY(simulation().isProgrammed());
}

void TestCodeDesk::sceneWithoutStepHasNoCode()
{
    const QString path = m_folder->filePath(QStringLiteral("scene.json"));
    QVERIFY(!savePreset(m_open->preset(), path));
    QVERIFY(!m_open->bench.openPreset(path));
    QVERIFY(m_open->bench.mode() == Mode::Explore);
    QVERIFY(!m_open->window.codePane().isVisible());
    QVERIFY(!m_open->button(QStringLiteral("Code")));
    QVERIFY(m_open->bench.openTask(QStringLiteral("L42T1")));
    QVERIFY(m_open->bench.mode() == Mode::Code);
}

QTEST_MAIN(TestCodeDesk)
#include "test_code_desk.moc"
