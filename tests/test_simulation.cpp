// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"

#include "tests/scenes.h"
#include "tests/simulation_scenes.h"

#include <QSignalSpy>

using namespace cradle;
using namespace cradle::scenes;

/// The run: its steps, its past, and what begins it anew.
class TestSimulation : public QObject
{
    Q_OBJECT
private slots:
    void beginsPausedAtTheStart();
    void stepsForwardAsTheStepperDoes();
    void stepsBackAlongTheRecording();
    void seekingIsExactToTheBit();
    void seekingStaysWithinTheRecording();
    void goesToAStepThatWasMadeOrIsToCome();
    void thePastIsNotWorkedOutAgain();
    void goesOnFromTheEndAsIfNeverLeft();
    void restartsFromThePreset();
    void anotherPresetStartsItsRun();
    void anotherPresetRunsOnIfItWasRunning();
    void aLongRunOfACrowdDropsItsOldestSteps();
    void theSameRunTwiceIsTheSame();
};

void TestSimulation::beginsPausedAtTheStart()
{
    const Simulation simulation(lively());
    QVERIFY(!simulation.isRunning());
    QVERIFY(simulation.atStart());
    QVERIFY(!simulation.usesFrameTime());
    QCOMPARE(simulation.current(), qint64{0});
    QCOMPARE(simulation.time(), 0.0);
    QCOMPARE(simulation.speed(), 1.0);
    QVERIFY(simulation.preset() == lively());
    QCOMPARE(simulation.recording().last(), qint64{0});
    QVERIFY(simulation.recording().circles(0)[0] == lively().circles[0].body);
}

void TestSimulation::stepsForwardAsTheStepperDoes()
{
    const std::vector<World> expected = worldsOf(lively(), 300);
    Simulation simulation(lively());
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    for (qint64 i = 1; i <= 300; ++i) {
        simulation.stepForward();
        QCOMPARE(simulation.current(), i);
        QCOMPARE(simulation.time(), static_cast<double>(i) * dt);
        QVERIFY(simulation.recording().world(i) == expected[static_cast<std::size_t>(i)]);
        QVERIFY(!simulation.atStart());
    }
    QCOMPARE(frames.count(), 300);
}

void TestSimulation::stepsBackAlongTheRecording()
{
    Simulation simulation(lively());
    stepForward(simulation, 3);
    simulation.stepBack();
    QCOMPARE(simulation.current(), qint64{2});
    QCOMPARE(simulation.recording().last(), qint64{3});
    simulation.stepBack();
    simulation.stepBack();
    QVERIFY(simulation.atStart());
    simulation.stepBack();
    QVERIFY(simulation.atStart());
}

void TestSimulation::seekingIsExactToTheBit()
{
    const std::vector<World> expected = worldsOf(lively(), 400);
    Simulation simulation(lively());
    stepForward(simulation, 400);
    for (const qint64 index : {0, 399, 17, 128, 127, 256, 400, 1}) {
        simulation.seek(index);
        QCOMPARE(simulation.current(), index);
        QCOMPARE(simulation.time(), static_cast<double>(index) * dt);
        QVERIFY(simulation.recording().world(simulation.current())
                == expected[static_cast<std::size_t>(index)]);
    }
}

void TestSimulation::seekingStaysWithinTheRecording()
{
    Simulation simulation(lively());
    stepForward(simulation, 10);
    simulation.seek(-5);
    QCOMPARE(simulation.current(), qint64{0});
    simulation.seek(1000);
    QCOMPARE(simulation.current(), qint64{10});
}

void TestSimulation::goesToAStepThatWasMadeOrIsToCome()
{
    Simulation simulation(lively());
    for (const qint64 step : {7, 3, 7, 0, 12}) {
        simulation.goTo(step);
        QCOMPARE(simulation.current(), step);
    }
    QCOMPARE(simulation.recording().last(), qint64{12});
}

void TestSimulation::thePastIsNotWorkedOutAgain()
{
    Simulation simulation(lively());
    stepForward(simulation, 200);
    const std::size_t hits = simulation.recording().hits().size();
    QVERIFY(hits > 0);
    simulation.seek(50);
    stepForward(simulation, 100);
    QCOMPARE(simulation.current(), qint64{150});
    QCOMPARE(simulation.recording().last(), qint64{200});
    QCOMPARE(simulation.recording().hits().size(), hits);
}

void TestSimulation::goesOnFromTheEndAsIfNeverLeft()
{
    const std::vector<World> expected = worldsOf(lively(), 300);
    Simulation simulation(lively());
    stepForward(simulation, 200);
    simulation.seek(20);
    stepForward(simulation, 280);
    QCOMPARE(simulation.current(), qint64{300});
    for (qint64 i = 0; i <= 300; ++i)
        QVERIFY(simulation.recording().world(i) == expected[static_cast<std::size_t>(i)]);
}

void TestSimulation::restartsFromThePreset()
{
    Simulation simulation(lively());
    stepForward(simulation, 200);
    simulation.start();
    QSignalSpy restarted(&simulation, &Simulation::restarted);
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    simulation.restart();
    QVERIFY(!simulation.isRunning());
    QVERIFY(simulation.atStart());
    QCOMPARE(simulation.recording().last(), qint64{0});
    QVERIFY(simulation.recording().hits().empty());
    QCOMPARE(restarted.count(), 1);
    QCOMPARE(frames.count(), 1);
    // And runs the same again.
    const std::vector<World> expected = worldsOf(lively(), 100);
    stepForward(simulation, 100);
    QVERIFY(simulation.recording().world(100) == expected[100]);
}

void TestSimulation::anotherPresetStartsItsRun()
{
    Simulation simulation(lively());
    stepForward(simulation, 20);
    QSignalSpy changed(&simulation, &Simulation::presetChanged);
    QSignalSpy restarted(&simulation, &Simulation::restarted);
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    Preset other = metronome();
    other.timestep = 0.01;
    simulation.setPreset(other);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(restarted.count(), 1);
    QCOMPARE(frames.count(), 1);
    QVERIFY(simulation.preset() == other);
    QVERIFY(simulation.atStart());
    QVERIFY(!simulation.isRunning());
    QCOMPARE(simulation.recording().circleCount(), std::size_t{1});
    simulation.stepForward();
    QCOMPARE(simulation.time(), 0.01);
    COMPARE_NEAR(simulation.recording().circles(1)[0].position.x, 0.038, 1e-15);
}

void TestSimulation::anotherPresetRunsOnIfItWasRunning()
{
    Simulation simulation(lively());
    simulation.start();
    simulation.setPreset(metronome());
    QVERIFY(simulation.isRunning());
    QVERIFY(simulation.atStart());
}

void TestSimulation::aLongRunOfACrowdDropsItsOldestSteps()
{
    // So many circles that two blocks of steps take all the memory allowed.
    Preset preset = scene({}, {});
    for (int i = 0; i < 5000; ++i)
        preset.circles.push_back(circle({0.001 * i, 0}, {1, 0}));
    Simulation simulation(preset);
    stepForward(simulation, 400);
    const Recording &recording = simulation.recording();
    QVERIFY(recording.hasDropped());
    QVERIFY(recording.bytes() <= Recording::defaultBytes);
    QCOMPARE(simulation.current(), qint64{400});
    COMPARE_NEAR(recording.circles(400)[0].position.x, 400.0 * dt, 1e-9);
    simulation.seek(0);
    QCOMPARE(simulation.current(), recording.first());
    QVERIFY(!simulation.atStart());
    COMPARE_NEAR(recording.circles(simulation.current())[0].position.x, simulation.time(), 1e-9);
    simulation.stepForward();
    QCOMPARE(simulation.current(), recording.first() + 1);
}

void TestSimulation::theSameRunTwiceIsTheSame()
{
    Simulation first(lively());
    Simulation second(lively());
    stepForward(first, 600);
    stepForward(second, 600);
    for (qint64 i = 0; i <= 600; ++i)
        QVERIFY(first.recording().world(i) == second.recording().world(i));
    QVERIFY(first.recording().hits() == second.recording().hits());
}

QTEST_GUILESS_MAIN(TestSimulation)
#include "test_simulation.moc"
