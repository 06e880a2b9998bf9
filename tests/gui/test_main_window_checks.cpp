// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "tests/gui/window_test.h"
#include "tests/patience.h"

#include <QThreadPool>

using namespace cradle;
using namespace cradle::windows;

/// A check in the real window: what a verdict shows, and what it is worth after an edit.
class TestMainWindowChecks final : public WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { m_open.reset(); }
    void failedCheckShowsTheMomentAndTheWayBack();
    void momentOfTheOwnSceneIsNoVisit();
    void editAfterTheCheckMakesItStale();
    void editDuringTheCheckMakesItStale();
    void checkIsStopped();
    void stepLeftDuringTheCheckKeepsItsVerdict();
    void sceneOpenedDuringTheCheckEndsIt();
};

void TestMainWindowChecks::initTestCase()
{
    setLanguage(QStringLiteral("en"));
    applyTheme(ThemeChoice::Light);
}

void TestMainWindowChecks::init()
{
    takeNewFolder();
}

void TestMainWindowChecks::failedCheckShowsTheMomentAndTheWayBack()
{
    QVERIFY(m_open->bench.openTask(QStringLiteral("L42T12")));
    Preset wrong = m_open->solution();
    wrong.laws.circles = CircleLaw::SwapVelocities;
    QVERIFY(m_open->bench.document().edit(QStringLiteral("wrong"), wrong));
    m_open->check();
    const CheckReport report = *m_open->bench.check().report();
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

void TestMainWindowChecks::momentOfTheOwnSceneIsNoVisit()
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

void TestMainWindowChecks::editAfterTheCheckMakesItStale()
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
void TestMainWindowChecks::editDuringTheCheckMakesItStale()
{
    Preset solved = m_open->solution();
    m_open->bench.document().edit(QStringLiteral("solve"), solved);
    m_open->click(QStringLiteral("Check"));
    solved.circles[0].body.velocity = {-2.0, 0.0};
    m_open->bench.document().edit(QStringLiteral("spoil"), solved);
    QTRY_VERIFY(!m_open->window.transportBar().isChecking());
    QVERIFY(!m_open->bench.check().report()
            || m_open->says(QStringLiteral("Changed since this check")));
}

void TestMainWindowChecks::checkIsStopped()
{
    QVERIFY(m_open->bench.openTask(QStringLiteral("L42T17")));
    m_open->click(QStringLiteral("Check"));
    QVERIFY(m_open->window.transportBar().isChecking());
    m_open->click(QStringLiteral("Stop"));
    QVERIFY(!m_open->window.transportBar().isChecking());
    QTRY_VERIFY(!m_open->bench.check().isRunning());
    QCoreApplication::processEvents();
    QVERIFY(!m_open->bench.check().report());
    QVERIFY(m_open->says(QStringLiteral("Press Check")));
}

void TestMainWindowChecks::stepLeftDuringTheCheckKeepsItsVerdict()
{
    m_open->click(QStringLiteral("Check"));
    m_open->bench.openNextTask();
    QVERIFY(!m_open->window.transportBar().isChecking());
    QTRY_VERIFY(!m_open->bench.check().isRunning());
    QCoreApplication::processEvents();
    QVERIFY(!m_open->bench.check().report());
    QVERIFY(!m_open->window.transportBar().isChecking());
}

void TestMainWindowChecks::sceneOpenedDuringTheCheckEndsIt()
{
    m_open->click(QStringLiteral("Check"));
    // The work is done, but no event has told so yet.
    QVERIFY(QThreadPool::globalInstance()->waitForDone(patience));
    QVERIFY(!m_open->bench.openPreset(QStringLiteral(":/labs/lab-4.2/L42T14/preset.json")));
    QTRY_VERIFY(!m_open->window.transportBar().isChecking());
}

QTEST_MAIN(TestMainWindowChecks)
#include "test_main_window_checks.moc"
