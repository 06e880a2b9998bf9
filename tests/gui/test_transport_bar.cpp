// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/transport_scene.h"
#include "tests/patience.h"
#include "views/action_button.h"
#include "views/theme.h"
#include "views/transport_bar.h"

#include <QLabel>
#include <QLayout>
#include <QProgressBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

using namespace cradle;

namespace {

QString allText(const QWidget &bar)
{
    QStringList texts;
    for (const QLabel *label : bar.findChildren<QLabel *>())
        texts.append(label->text());
    return texts.join(QLatin1Char('|'));
}

} // namespace

class TestTransportBar final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void stepsForwardAndBack();
    void keysDriveTheSimulation();
    void runsAndPauses();
    void nothingMovesWhenTheRunBegins();
    void nothingMovesWhenTheCheckBegins();
    void goesToTheNextHitAndBack();
    void searchForAHitCanBeStopped();
    void speedGoesInPowersOfTwo();
};

void TestTransportBar::stepsForwardAndBack()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    QVERIFY(!bar.stepBackAction()->isEnabled());
    bar.stepAction()->trigger();
    bar.stepAction()->trigger();
    QVERIFY(allText(bar).contains(QStringLiteral("step 2")));
    QVERIFY(allText(bar).contains(QStringLiteral("t = 0.033 s")));
    bar.stepBackAction()->trigger();
    QVERIFY(allText(bar).contains(QStringLiteral("step 1")));
    bar.restartAction()->trigger();
    QVERIFY(simulation.atStart());
}

void TestTransportBar::keysDriveTheSimulation()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    bar.show();
    bar.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&bar, patience));
    bar.setFocus();
    QTest::keyClick(&bar, Qt::Key_Right);
    QTest::keyClick(&bar, Qt::Key_Right);
    QCOMPARE(simulation.current(), 2);
    QTest::keyClick(&bar, Qt::Key_Left);
    QCOMPARE(simulation.current(), 1);
    QTest::keyClick(&bar, Qt::Key_R);
    QCOMPARE(simulation.current(), 0);
    QTest::keyClick(&bar, Qt::Key_Space);
    QVERIFY(simulation.isRunning());
    QTest::keyClick(&bar, Qt::Key_Space);
    QVERIFY(!simulation.isRunning());
    QTest::keyClick(&bar, Qt::Key_BracketLeft);
    QCOMPARE(simulation.speed(), 0.5);
    QTest::keyClick(&bar, Qt::Key_BracketRight);
    QCOMPARE(simulation.speed(), 1.0);
    QSignalSpy checks(&bar, &TransportBar::checkRequested);
    QTest::keyClick(&bar, Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(checks.size(), 1);
}

void TestTransportBar::runsAndPauses()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    QCOMPARE(bar.runAction()->text(), QStringLiteral("Run"));
    QTest::mouseClick(buttonOf(bar, QStringLiteral("Run")), Qt::LeftButton);
    QVERIFY(simulation.isRunning());
    QCOMPARE(bar.runAction()->text(), QStringLiteral("Pause"));
    simulation.pause();
    QCOMPARE(bar.runAction()->text(), QStringLiteral("Run"));
}

void TestTransportBar::nothingMovesWhenTheRunBegins()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    bar.resize(1280, bar.sizeHint().height());
    bar.show();
    const QAbstractButton *nextHit = buttonOf(bar, QStringLiteral("Next hit"));
    const QRect before = nextHit->geometry();
    simulation.start();
    bar.layout()->activate();
    QVERIFY(buttonOf(bar, QStringLiteral("Pause")));
    QCOMPARE(nextHit->geometry(), before);
}

/// The row asks for the same room as long as it is there, so no other button loses its text.
void TestTransportBar::nothingMovesWhenTheCheckBegins()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    bar.resize(1280, bar.sizeHint().height());
    bar.show();
    const QAbstractButton *check = buttonOf(bar, QStringLiteral("Check"));
    const QRect before = check->geometry();
    bar.setChecking(true);
    bar.layout()->activate();
    QVERIFY(buttonOf(bar, QStringLiteral("Stop")));
    QCOMPARE(check->geometry(), before);
}

void TestTransportBar::goesToTheNextHitAndBack()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    bar.nextHitAction()->trigger();
    QVERIFY(!simulation.recording().hits().empty());
    QVERIFY(std::abs(simulation.time() - 1.0) < 0.05);
    const qint64 first = simulation.current();
    bar.nextHitAction()->trigger();
    QVERIFY(simulation.current() > first);
    bar.previousHitAction()->trigger();
    QCOMPARE(simulation.current(), first);
    bar.previousHitAction()->trigger();
    QVERIFY(simulation.atStart());
    QVERIFY(!bar.previousHitAction()->isEnabled());
}

void TestTransportBar::searchForAHitCanBeStopped()
{
    Preset many; // nothing moves, so the search looks on for a minute of the scene
    many.fill = CircleFill{.count = 1200, .radius = 0.05};
    many.circles = *makeCircles(*many.fill, many.halfWidth);
    Simulation simulation(many);
    TransportBar bar(simulation);
    bar.resize(1280, bar.sizeHint().height());
    bar.show();
    const auto *progress = bar.findChildren<QProgressBar *>().last();
    const QAbstractButton *nextHit = buttonOf(bar, QStringLiteral("Next hit"));
    const QRect place = nextHit->geometry();
    QVERIFY(!progress->isVisible());

    bar.nextHitAction()->trigger();
    QVERIFY(simulation.isSearching());
    QCOMPARE(nextHit->accessibleName(), QStringLiteral("Stop"));
    QCOMPARE(nextHit->geometry(), place);
    QVERIFY(progress->isVisible());
    QCOMPARE(progress->value(), static_cast<int>(std::lround(simulation.time() / 60.0 * 1000.0)));
    while (simulation.isSearching() && progress->value() == 0)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
    QVERIFY(simulation.isSearching());

    bar.nextHitAction()->trigger();
    QVERIFY(!simulation.isSearching());
    QVERIFY(simulation.atStart());
    QCOMPARE(nextHit->accessibleName(), QStringLiteral("Next hit"));
    QVERIFY(!progress->isVisible());
}

void TestTransportBar::speedGoesInPowersOfTwo()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    for (int i = 0; i < 10; ++i)
        bar.slowerAction()->trigger();
    QCOMPARE(simulation.speed(), 1.0 / 16.0);
    QVERIFY(!bar.slowerAction()->isEnabled());
    QVERIFY(allText(bar).contains(QStringLiteral("1/16×")));
    bar.findChild<QSlider *>()->setValue(3);
    QCOMPARE(simulation.speed(), 8.0);
    QVERIFY(!bar.fasterAction()->isEnabled());
    QVERIFY(allText(bar).contains(QStringLiteral("8×")));
}

QTEST_MAIN(TestTransportBar)
#include "test_transport_bar.moc"
