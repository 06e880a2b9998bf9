// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"

#include "tests/patience.h"
#include "tests/scenes.h"
#include "tests/simulation_scenes.h"

#include <QSignalSpy>

using namespace cradle;
using namespace cradle::scenes;

using Action = void (*)(Simulation &);

/// How fast a run goes, and when it stands.
class TestSimulationPace : public QObject
{
    Q_OBJECT
private slots:
    void speedIsBounded_data();
    void speedIsBounded();
    void slowsAroundHits();
    void slowsBeforeHitsThatAreRecorded();
    void startsAndPauses();
    void steppingPauses_data();
    void steppingPauses();
    void runsByItself();
    void frameTimeStepsAsLongAsTheFrames();
    void timeGoesOnAfterFrameTime();
};

void TestSimulationPace::speedIsBounded_data()
{
    QTest::addColumn<double>("asked");
    QTest::addColumn<double>("given");
    QTest::newRow("half") << 0.5 << 0.5;
    QTest::newRow("slowest") << 0.0625 << 0.0625;
    QTest::newRow("fastest") << 8.0 << 8.0;
    QTest::newRow("too slow") << 0.01 << 0.0625;
    QTest::newRow("zero") << 0.0 << 0.0625;
    QTest::newRow("backwards") << -1.0 << 0.0625;
    QTest::newRow("too fast") << 9.0 << 8.0;
    QTest::newRow("infinite") << infinity << 8.0;
}

void TestSimulationPace::speedIsBounded()
{
    QFETCH(double, asked);
    QFETCH(double, given);
    Simulation simulation(lively());
    simulation.setSpeed(asked);
    QCOMPARE(simulation.speed(), given);
}

void TestSimulationPace::slowsAroundHits()
{
    Preset preset = metronome();
    preset.laws.timing = Timing::Continuous;
    preset.circles[0].body.velocity.x = 4.0; // at the wall after 0.95 s
    Simulation simulation(preset);
    simulation.setSlowsAtHits(true);
    simulation.setSpeed(4.0);
    QSignalSpy changes(&simulation, &Simulation::paceChanged);
    stepForward(simulation, 57);
    QCOMPARE(simulation.recording().hits().size(), std::size_t{1});
    QCOMPARE(simulation.pace(), 4.0); // it stands
    simulation.start();
    QCOMPARE(simulation.pace(), 0.125);
    QCOMPARE(simulation.speed(), 4.0); // as chosen
    simulation.setSpeed(0.0625);       // slower than that already
    QCOMPARE(simulation.pace(), 0.0625);
    simulation.setSpeed(2.0);
    QCOMPARE(simulation.pace(), 0.125);
    simulation.setSlowsAtHits(false);
    QCOMPARE(simulation.pace(), 2.0);
    simulation.setSlowsAtHits(true);
    simulation.pause();
    QCOMPARE(simulation.pace(), 2.0);
    // 0.12 s after the hit it goes on as before.
    while (simulation.time() < 0.95 + 0.12)
        simulation.stepForward();
    simulation.start();
    QCOMPARE(simulation.pace(), 2.0);
    QVERIFY(!changes.isEmpty());
}

void TestSimulationPace::slowsBeforeHitsThatAreRecorded()
{
    Preset preset = metronome();
    preset.laws.timing = Timing::Continuous;
    preset.circles[0].body.velocity.x = 4.0;
    Simulation simulation(preset);
    simulation.setSlowsAtHits(true);
    stepForward(simulation, 100);
    const auto paceAt = [&](double time) {
        simulation.seek(simulation.recording().indexAt(time));
        simulation.start();
        const double pace = simulation.pace();
        simulation.pause();
        return pace;
    };
    QCOMPARE(paceAt(0.80), 1.0);
    QCOMPARE(paceAt(0.86), 0.125);
    QCOMPARE(paceAt(1.05), 0.125);
    QCOMPARE(paceAt(1.10), 1.0);
}

void TestSimulationPace::startsAndPauses()
{
    Simulation simulation(lively());
    QSignalSpy running(&simulation, &Simulation::runningChanged);
    simulation.start();
    simulation.start();
    QVERIFY(simulation.isRunning());
    QCOMPARE(running.count(), 1);
    QCOMPARE(running.takeFirst().at(0).toBool(), true);
    simulation.pause();
    simulation.pause();
    QVERIFY(!simulation.isRunning());
    QCOMPARE(running.count(), 1);
    QCOMPARE(running.takeFirst().at(0).toBool(), false);
    simulation.setRunning(true);
    QVERIFY(simulation.isRunning());
    simulation.setRunning(false);
    QVERIFY(!simulation.isRunning());
}

void TestSimulationPace::steppingPauses_data()
{
    QTest::addColumn<Action>("act");
    QTest::newRow("forward") << Action([](Simulation &s) { s.stepForward(); });
    QTest::newRow("back") << Action([](Simulation &s) { s.stepBack(); });
    QTest::newRow("seek") << Action([](Simulation &s) { s.seek(0); });
    QTest::newRow("next hit") << Action([](Simulation &s) { s.seekNextHit(); });
    QTest::newRow("restart") << Action([](Simulation &s) { s.restart(); });
}

void TestSimulationPace::steppingPauses()
{
    QFETCH(Action, act);
    Simulation simulation(lively());
    simulation.start();
    act(simulation);
    QVERIFY(!simulation.isRunning());
}

void TestSimulationPace::runsByItself()
{
    const std::vector<World> expected = worldsOf(lively(), 1000);
    Simulation simulation(lively());
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    simulation.start();
    QVERIFY(frames.wait(patience));
    simulation.pause();
    const qint64 last = simulation.recording().last();
    QVERIFY(last >= 1);
    QCOMPARE(simulation.current(), last);
    for (qint64 i = 0; i <= std::min<qint64>(last, 1000); ++i)
        QVERIFY(simulation.recording().world(i) == expected[static_cast<std::size_t>(i)]);
}

void TestSimulationPace::frameTimeStepsAsLongAsTheFrames()
{
    Simulation simulation(metronome());
    simulation.setFrameTime(true);
    QVERIFY(simulation.usesFrameTime());
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    simulation.start();
    while (simulation.recording().last() < 3)
        QVERIFY(frames.wait(patience));
    simulation.pause();
    const Recording &recording = simulation.recording();
    for (qint64 i = 1; i <= 3; ++i) {
        QCOMPARE(recording.step(i), i);
        const double step = recording.time(i) - recording.time(i - 1);
        QVERIFY(step > 0.0 && step <= 0.1 + 1e-12);
        // The circle went as far as that step lasted.
        const double way =
            recording.circles(i)[0].position.x - recording.circles(i - 1)[0].position.x;
        COMPARE_NEAR(way, 3.8 * step, 1e-12);
    }
    // By hand a step is that of the preset, whatever the mode.
    const double before = simulation.time();
    simulation.stepForward();
    COMPARE_NEAR(simulation.time() - before, dt, 1e-12);
}

void TestSimulationPace::timeGoesOnAfterFrameTime()
{
    // At eight times the speed a frame lasts some 0.13 s: three of them are many timesteps.
    Simulation simulation(metronome());
    simulation.setFrameTime(true);
    simulation.setSpeed(Simulation::fastest);
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    simulation.start();
    while (simulation.recording().last() < 3)
        QVERIFY(frames.wait(patience));
    simulation.pause();
    simulation.setFrameTime(false);
    const double before = simulation.time();
    stepForward(simulation, 2);
    COMPARE_NEAR(simulation.time() - before, 2.0 * dt, 1e-12);
}

QTEST_GUILESS_MAIN(TestSimulationPace)
#include "test_simulation_pace.moc"
