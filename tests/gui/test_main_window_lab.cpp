// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "tests/gui/open_window.h"

#include <QThreadPool>

#include <cmath>

using namespace cradle;
using namespace cradle::windows;

/// A student's way through the lab, by the real window.
class TestMainWindowLab final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { m_open.reset(); }
    void firstStartShowsStepOnePaused();
    void firstStepIsSolvedByTyping();
    void passCountsWhenItsRunIsShown();
    void passOfWorkThatWasSeenCountsAtOnce();
    void seenRunOfOtherWorkDoesNotCount();
    void allStepsAreSolved();
    void failedCheckShowsTheMomentAndTheWayBack();
    void momentOfTheOwnSceneIsNoVisit();
    void editAfterTheCheckMakesItStale();
    void editDuringTheCheckMakesItStale();
    void checkIsStopped();
    void stepLeftDuringTheCheckKeepsItsVerdict();
    void sceneOpenedDuringTheCheckEndsIt();
    void progressSurvivesClosingAndReopening();
    void progressSurvivesOpeningALab();
    void brokenProgressGivesANoticeAndIsKept();
    void stepsAreChosenFromTheListAndByKeys();

private:
    void reopen();

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestMainWindowLab::initTestCase()
{
    setLanguage(QStringLiteral("en"));
    applyTheme(ThemeChoice::Light);
}

void TestMainWindowLab::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    reopen();
}

void TestMainWindowLab::reopen()
{
    if (m_open)
        m_open->window.close();
    m_open.reset();
    m_open = std::make_unique<OpenWindow>(*m_folder);
    QVERIFY(QTest::qWaitForWindowActive(&m_open->window));
}

void TestMainWindowLab::firstStartShowsStepOnePaused()
{
    QCOMPARE(m_open->bench.current(), 0);
    QCOMPARE(m_open->bench.task()->id, QStringLiteral("L42T1"));
    QVERIFY(!m_open->simulation().isRunning());
    QVERIFY(m_open->simulation().atStart());
    QCOMPARE(m_open->steps()->count(), 17);
    QVERIFY(m_open->window.notice().isVisible());
    QVERIFY(m_open->says(QStringLiteral("Read the step on the left")));
    m_open->click(QStringLiteral("Got it"));
    QVERIFY(m_open->window.notice().isHidden());
    QVERIFY(m_open->says(QStringLiteral("Press Check")));
    for (int step = 0; step < 17; ++step)
        QVERIFY(!m_open->isTicked(step));
}

void TestMainWindowLab::firstStepIsSolvedByTyping()
{
    m_open->check();
    QVERIFY(!m_open->bench.report()->passed);
    QVERIFY(!m_open->isTicked(0));
    m_open->typeCell(0, CircleTableModel::VelocityX, QStringLiteral("2"));
    QVERIFY(m_open->says(QStringLiteral("Changed since this check")));
    m_open->check();
    QVERIFY(m_open->bench.report()->passed);
    QVERIFY(m_open->says(QStringLiteral("Passed: all 3 checks")));
    QVERIFY(m_open->says(QStringLiteral("L42T1 Set my circle moving off to the right")));
    QVERIFY(m_open->isTicked(0));
    m_open->click(QStringLiteral("Next step"));
    QCOMPARE(m_open->bench.current(), 1);
    QCOMPARE(m_open->steps()->currentRow(), 1);
    QVERIFY(m_open->says(QStringLiteral("Press Check")));
    QVERIFY(m_open->window.notice().isHidden());
    QVERIFY(m_open->isTicked(0) && !m_open->isTicked(1));
}

void TestMainWindowLab::passCountsWhenItsRunIsShown()
{
    QVERIFY(m_open->bench.document().edit(QStringLiteral("solve"), m_open->solution()));
    std::vector<bool> atVerdict;
    connect(&m_open->bench, &Workbench::reportChanged, this, [&] {
        atVerdict = m_open->bench.passed();
        QVERIFY(m_open->simulation().atStart());
    });
    m_open->check();
    QVERIFY(m_open->bench.report()->passed);
    QVERIFY(!atVerdict.empty() && !atVerdict.front());
    // Check itself plays what it passed; with that the step counts.
    QVERIFY(m_open->simulation().isRunning());
    QVERIFY(!m_open->simulation().atStart());
    QVERIFY(m_open->isTicked(0));
    QVERIFY(!m_open->says(QStringLiteral("as soon as the run")));
}

void TestMainWindowLab::passOfWorkThatWasSeenCountsAtOnce()
{
    QVERIFY(m_open->bench.document().edit(QStringLiteral("solve"), m_open->solution()));
    m_open->simulation().stepForward();
    m_open->simulation().restart();
    bool atVerdict = false;
    connect(&m_open->bench, &Workbench::reportChanged, this,
            [&] { atVerdict = m_open->bench.passed().front(); });
    m_open->check();
    QVERIFY(atVerdict);
    QVERIFY(!m_open->simulation().isRunning());
    QVERIFY(m_open->simulation().atStart());
}

void TestMainWindowLab::seenRunOfOtherWorkDoesNotCount()
{
    m_open->simulation().stepForward();
    QVERIFY(m_open->bench.document().edit(QStringLiteral("solve"), m_open->solution()));
    QVERIFY(m_open->simulation().atStart());
    m_open->bench.check();
    // The work is changed before the verdict comes: what is shown later is not what was judged.
    Preset other = m_open->solution();
    other.circles.front().body.velocity.x *= 1.5;
    QVERIFY(m_open->bench.document().edit(QStringLiteral("other"), other));
    QTRY_VERIFY_WITH_TIMEOUT(m_open->bench.report(), 60'000);
    QVERIFY(m_open->bench.report()->passed && m_open->bench.awaitsRun());
    QVERIFY(m_open->says(QStringLiteral("as soon as the run")));
    m_open->simulation().stepForward();
    QVERIFY(!m_open->bench.passed().front());
    m_open->bench.document().undoStack().undo();
    m_open->simulation().stepForward();
    QVERIFY(m_open->bench.passed().front());
    QVERIFY(!m_open->says(QStringLiteral("as soon as the run")));
}

void TestMainWindowLab::allStepsAreSolved()
{
    for (int step = 0; step < 17; ++step) {
        QCOMPARE(m_open->bench.current(), step);
        QVERIFY(m_open->bench.document().edit(QStringLiteral("solve"), m_open->solution()));
        m_open->check();
        QVERIFY2(m_open->bench.report()->passed, qPrintable(m_open->bench.task()->id));
        QVERIFY(m_open->isTicked(step));
        if (step < 16)
            m_open->click(QStringLiteral("Next step"));
    }
    QVERIFY(m_open->button(QStringLiteral("All steps, Steps · 17 of 17")));
    // After the last step there is no next one to open.
    if (QAbstractButton *next = m_open->button(QStringLiteral("Next step")))
        next->click();
    QCOMPARE(m_open->bench.current(), 16);
}

void TestMainWindowLab::failedCheckShowsTheMomentAndTheWayBack()
{
    QVERIFY(m_open->bench.openTask(QStringLiteral("L42T12")));
    Preset wrong = m_open->solution();
    wrong.laws.circles = CircleLaw::SwapVelocities;
    QVERIFY(m_open->bench.document().edit(QStringLiteral("wrong"), wrong));
    m_open->check();
    const CheckReport report = *m_open->bench.report();
    const auto failed =
        std::find_if(report.checks.begin(), report.checks.end(), [&](const CheckOutcome &check) {
            return !check.passed && check.variant != QLatin1String("preset");
        });
    QVERIFY(failed != report.checks.end());
    emit m_open->window.taskPane().showMoment(*failed);
    QVERIFY(m_open->bench.document().isVisiting());
    QVERIFY(m_open->preset() == *failed->scene);
    QCOMPARE(m_open->simulation().recording().step(m_open->simulation().current()), failed->step);
    QVERIFY(!m_open->simulation().isRunning());
    QVERIFY(m_open->says(QStringLiteral("at the moment where it went wrong")));
    m_open->simulation().stepForward();
    QVERIFY(m_open->says(QStringLiteral("This is a scene of the check.")));
    QVERIFY(!m_open->says(QStringLiteral("at the moment where it went wrong")));
    m_open->simulation().stepBack();
    QVERIFY(m_open->says(QStringLiteral("at the moment where it went wrong")));
    // It is not the student's to edit, and is not what is checked.
    QVERIFY(!m_open->bench.document().edit(QStringLiteral("no"), wrong));
    m_open->click(QStringLiteral("Back to my scene"));
    QVERIFY(!m_open->bench.document().isVisiting());
    QVERIFY(m_open->preset() == wrong);
    QVERIFY(m_open->window.notice().isHidden());
}

void TestMainWindowLab::momentOfTheOwnSceneIsNoVisit()
{
    QVERIFY(m_open->bench.openTask(QStringLiteral("L42T2")));
    Preset open = m_open->solution();
    open.laws.walls = WallLaw::None;
    m_open->bench.document().edit(QStringLiteral("no walls"), open);
    m_open->check();
    m_open->click(QStringLiteral("Show the moment"));
    QVERIFY(!m_open->bench.document().isVisiting());
    QVERIFY(m_open->preset() == open);
    QVERIFY(m_open->simulation().current() > 0);
}

void TestMainWindowLab::editAfterTheCheckMakesItStale()
{
    m_open->check();
    QVERIFY(!m_open->says(QStringLiteral("Changed since this check")));
    m_open->typeCell(0, CircleTableModel::VelocityX, QStringLiteral("1"));
    QVERIFY(m_open->says(QStringLiteral("Changed since this check")));
    m_open->bench.document().undoStack().undo(); // back to what was checked
    QVERIFY(!m_open->says(QStringLiteral("Changed since this check")));
    m_open->bench.document().undoStack().redo();
    QVERIFY(m_open->says(QStringLiteral("Changed since this check")));
    m_open->check();
    QVERIFY(!m_open->says(QStringLiteral("Changed since this check")));
}

/// The verdict is on the scene as it was; the student must not take it for the one that is there.
void TestMainWindowLab::editDuringTheCheckMakesItStale()
{
    Preset solved = m_open->solution();
    m_open->bench.document().edit(QStringLiteral("solve"), solved);
    m_open->click(QStringLiteral("Check"));
    solved.circles[0].body.velocity = {-2.0, 0.0};
    m_open->bench.document().edit(QStringLiteral("spoil"), solved);
    QTRY_VERIFY(!m_open->window.transportBar().isChecking());
    QVERIFY(!m_open->bench.report() || m_open->says(QStringLiteral("Changed since this check")));
}

void TestMainWindowLab::checkIsStopped()
{
    QVERIFY(m_open->bench.openTask(QStringLiteral("L42T17")));
    m_open->click(QStringLiteral("Check"));
    QVERIFY(m_open->window.transportBar().isChecking());
    m_open->click(QStringLiteral("Stop"));
    QVERIFY(!m_open->window.transportBar().isChecking());
    QTRY_VERIFY(!m_open->bench.isChecking());
    QCoreApplication::processEvents();
    QVERIFY(!m_open->bench.report());
    QVERIFY(m_open->says(QStringLiteral("Press Check")));
}

void TestMainWindowLab::stepLeftDuringTheCheckKeepsItsVerdict()
{
    m_open->click(QStringLiteral("Check"));
    m_open->bench.openNextTask();
    QVERIFY(!m_open->window.transportBar().isChecking());
    QTRY_VERIFY(!m_open->bench.isChecking());
    QCoreApplication::processEvents();
    QVERIFY(!m_open->bench.report());
    QVERIFY(!m_open->window.transportBar().isChecking());
}

void TestMainWindowLab::sceneOpenedDuringTheCheckEndsIt()
{
    m_open->click(QStringLiteral("Check"));
    // The work is done, but no event has told so yet.
    QVERIFY(QThreadPool::globalInstance()->waitForDone(60'000));
    QVERIFY(!m_open->bench.openPreset(QStringLiteral(":/labs/lab-4.2/L42T14/preset.json")));
    QTRY_VERIFY(!m_open->window.transportBar().isChecking());
}

void TestMainWindowLab::progressSurvivesClosingAndReopening()
{
    m_open->typeCell(0, CircleTableModel::VelocityX, QStringLiteral("2"));
    m_open->check();
    m_open->click(QStringLiteral("Next step"));
    m_open->click(QStringLiteral("Hint 1"));
    m_open->typeCell(0, CircleTableModel::VelocityY, QStringLiteral("0.5"));
    const Preset edited = m_open->preset();
    reopen();
    QCOMPARE(m_open->bench.current(), 1);
    QVERIFY(m_open->preset() == edited);
    QVERIFY(m_open->isTicked(0) && !m_open->isTicked(1));
    QCOMPARE(m_open->bench.hintsOpened(), 1);
    QVERIFY(m_open->button(QStringLiteral("Hint 2")));
    QVERIFY2(m_open->window.notice().isHidden(), "this is not the first start");
    m_open->bench.openTaskAt(0);
    QCOMPARE(m_open->preset().circles[0].body.velocity.x, 2.0);
    // The verdict is kept with its time and the commit message.
    QVERIFY(m_open->says(QStringLiteral("You have passed this step")));
    const QDateTime when = m_open->bench.pass().when;
    QVERIFY(std::abs(when.secsTo(QDateTime::currentDateTimeUtc())) < 300);
    QVERIFY(
        m_open->says(when.toLocalTime().toString(QStringLiteral("'on 'yyyy-MM-dd' at 'HH:mm"))));
    QVERIFY(m_open->says(QStringLiteral("L42T1 Set my circle moving off to the right")));
}

/// Also what was done in the moment before.
void TestMainWindowLab::progressSurvivesOpeningALab()
{
    m_open->typeCell(0, CircleTableModel::VelocityX, QStringLiteral("2"));
    QVERIFY(!m_open->bench.openLab(QLatin1String(shippedLab), QStringLiteral("en")));
    QCOMPARE(m_open->preset().circles[0].body.velocity.x, 2.0);
}

void TestMainWindowLab::brokenProgressGivesANoticeAndIsKept()
{
    m_open->window.close();
    m_open.reset();
    const QByteArray broken = "{ this was a semester's work";
    QFile file(m_folder->filePath(QStringLiteral("progress.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(broken);
    file.close();
    reopen();
    QCOMPARE(m_open->bench.current(), 0);
    QVERIFY(m_open->window.notice().isVisible());
    QVERIFY2(m_open->window.notice().text().contains(QStringLiteral("progress")),
             qPrintable(m_open->window.notice().text()));
    QVERIFY(!m_open->window.notice().text().contains(QStringLiteral("Read the step")));
    QFile kept(m_folder->filePath(QStringLiteral("progress.json.unreadable")));
    QVERIFY(kept.open(QIODevice::ReadOnly));
    QCOMPARE(kept.readAll(), broken);
}

void TestMainWindowLab::stepsAreChosenFromTheListAndByKeys()
{
    QListWidget *list = m_open->steps();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(2)).center());
    QCOMPARE(m_open->bench.current(), 2);
    m_open->press(Qt::Key_PageDown, Qt::ControlModifier);
    QCOMPARE(m_open->bench.current(), 3);
    m_open->press(Qt::Key_PageUp, Qt::ControlModifier);
    m_open->press(Qt::Key_PageUp, Qt::ControlModifier);
    QCOMPARE(m_open->bench.current(), 1);
    QVERIFY(!m_open->simulation().isRunning());
}

QTEST_MAIN(TestMainWindowLab)
#include "test_main_window_lab.moc"
