// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/simulation.h"

#include "tests/scenes.h"

#include <QSignalSpy>

using namespace cradle;
using namespace cradle::scenes;

using Action = void (*)(Simulation &);

Q_DECLARE_METATYPE(Action)

namespace {

/// Two circles that meet each other and the walls, under gravity.
Preset lively()
{
    Preset preset = scene({circle({-2, 2.3}, {2, 0}, 0.2, Integrator::SymplecticEuler),
                           circle({2, 2}, {-1, 1}, 0.3, Integrator::Verlet)},
                          {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {0, -g};
    preset.restitution = 0.9;
    return preset;
}

/// A circle that meets a wall after 1 s and then every 2 s.
Preset metronome()
{
    return scene({circle({0, 0}, {3.8, 0})}, {WallLaw::Reflect, CircleLaw::None, Timing::Discrete});
}

std::vector<World> worldsOf(const Preset &preset, int steps)
{
    Run run(preset);
    std::vector<World> worlds{run.world};
    for (int i = 0; i < steps; ++i) {
        run.steps(1);
        worlds.push_back(run.world);
    }
    return worlds;
}

void stepForward(Simulation &simulation, int steps)
{
    for (int i = 0; i < steps; ++i)
        simulation.stepForward();
}

} // namespace

class TestSimulation : public QObject
{
    Q_OBJECT
private slots:
    void beginsPausedAtTheStart();
    void stepsForwardAsTheStepperDoes();
    void stepsBackAlongTheRecording();
    void seekingIsExactToTheBit();
    void seekingStaysWithinTheRecording();
    void thePastIsNotWorkedOutAgain();
    void goesOnFromTheEndAsIfNeverLeft();
    void restartsFromThePreset();
    void anotherPresetStartsItsRun();
    void anotherPresetRunsOnIfItWasRunning();
    void findsTheNextHit();
    void findsTheNextHitInTheRecording();
    void goesBackFromHitToHit();
    void pausesAtEveryHitIfAsked();
    void searchForAHitEndsAfterAMinuteWhereItBegan();
    void speedIsBounded_data();
    void speedIsBounded();
    void startsAndPauses();
    void steppingPauses_data();
    void steppingPauses();
    void runsByItself();
    void frameTimeStepsAsLongAsTheFrames();
    void timeGoesOnAfterFrameTime();
    void hitsAreRecordedWithTheirSteps();
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

void TestSimulation::findsTheNextHit()
{
    Preset preset = metronome();
    preset.laws.timing = Timing::Continuous;
    preset.circles[0].body.velocity.x = 4.0; // at the walls after 0.95 s, 2.85 s, 4.75 s …
    Simulation simulation(preset);
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    for (const double hit : {0.95, 2.85, 4.75}) {
        simulation.seekNextHit();
        // The first recorded state at or after the hit.
        QVERIFY(simulation.time() >= hit - 1e-9);
        QVERIFY(simulation.time() < hit + dt + 1e-9);
        QCOMPARE(simulation.current(), simulation.recording().last());
        COMPARE_NEAR(simulation.recording().hits().back().time, hit, 1e-9);
    }
    QCOMPARE(frames.count(), 3);
}

void TestSimulation::findsTheNextHitInTheRecording()
{
    Simulation simulation(metronome());
    stepForward(simulation, 400);
    const auto &hits = simulation.recording().hits();
    QCOMPARE(hits.size(), std::size_t{3}); // about 1 s, 3 s and 5 s
    simulation.seek(0);
    for (std::size_t i = 0; i < 3; ++i) {
        simulation.seekNextHit();
        QCOMPARE(simulation.recording().step(simulation.current()), hits[i].step);
    }
    QCOMPARE(simulation.recording().last(), qint64{400});
    simulation.seekNextHit(); // beyond the recording
    QVERIFY(simulation.recording().last() > 400);
}

void TestSimulation::goesBackFromHitToHit()
{
    Simulation simulation(metronome());
    stepForward(simulation, 400);
    const auto &hits = simulation.recording().hits(); // about 1 s, 3 s and 5 s
    simulation.start();
    for (std::size_t i = 3; i-- > 0;) {
        simulation.seekPreviousHit();
        QVERIFY(!simulation.isRunning());
        QCOMPARE(simulation.recording().step(simulation.current()), hits[i].step);
    }
    simulation.seekPreviousHit();
    QVERIFY(simulation.atStart());
    simulation.seekPreviousHit();
    QVERIFY(simulation.atStart());
    QCOMPARE(simulation.recording().last(), qint64{400});
}

void TestSimulation::pausesAtEveryHitIfAsked()
{
    Simulation simulation(metronome());
    simulation.setSpeed(Simulation::fastest); // 8 steps a frame: a hit is within one
    simulation.setPausesAtHits(true);
    for (std::size_t i = 0; i < 3; ++i) {
        simulation.start();
        QTRY_VERIFY(!simulation.isRunning());
        const auto &hits = simulation.recording().hits();
        QCOMPARE(hits.size(), i + 1);
        QCOMPARE(simulation.recording().step(simulation.current()), hits[i].step);
        QCOMPARE(simulation.current(), simulation.recording().last());
    }
    const qint64 third = simulation.current();
    simulation.seek(0); // the same hits happen again
    simulation.start();
    QTRY_VERIFY(!simulation.isRunning());
    QCOMPARE(simulation.recording().step(simulation.current()),
             simulation.recording().hits().front().step);
    simulation.setPausesAtHits(false);
    simulation.start();
    QTRY_VERIFY(simulation.current() > third);
}

void TestSimulation::searchForAHitEndsAfterAMinuteWhereItBegan()
{
    Simulation simulation(scene({circle({0, 0})}, {WallLaw::Reflect, CircleLaw::None, {}}));
    QSignalSpy noHit(&simulation, &Simulation::noHitFound);
    simulation.goTo(10);
    simulation.seekNextHit();
    QVERIFY(!simulation.isRunning());
    QCOMPARE(noHit.size(), 1);
    QCOMPARE(simulation.current(), qint64{10});
    COMPARE_NEAR(simulation.recording().time(simulation.recording().last()), 60.0, 12.0 * dt);
}

void TestSimulation::speedIsBounded_data()
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

void TestSimulation::speedIsBounded()
{
    QFETCH(double, asked);
    QFETCH(double, given);
    Simulation simulation(lively());
    simulation.setSpeed(asked);
    QCOMPARE(simulation.speed(), given);
}

void TestSimulation::startsAndPauses()
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

void TestSimulation::steppingPauses_data()
{
    QTest::addColumn<Action>("act");
    QTest::newRow("forward") << Action([](Simulation &s) { s.stepForward(); });
    QTest::newRow("back") << Action([](Simulation &s) { s.stepBack(); });
    QTest::newRow("seek") << Action([](Simulation &s) { s.seek(0); });
    QTest::newRow("next hit") << Action([](Simulation &s) { s.seekNextHit(); });
    QTest::newRow("restart") << Action([](Simulation &s) { s.restart(); });
}

void TestSimulation::steppingPauses()
{
    QFETCH(Action, act);
    Simulation simulation(lively());
    simulation.start();
    act(simulation);
    QVERIFY(!simulation.isRunning());
}

void TestSimulation::runsByItself()
{
    const std::vector<World> expected = worldsOf(lively(), 1000);
    Simulation simulation(lively());
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    simulation.start();
    QVERIFY(frames.wait());
    simulation.pause();
    const qint64 last = simulation.recording().last();
    QVERIFY(last >= 1);
    QCOMPARE(simulation.current(), last);
    for (qint64 i = 0; i <= std::min<qint64>(last, 1000); ++i)
        QVERIFY(simulation.recording().world(i) == expected[static_cast<std::size_t>(i)]);
}

void TestSimulation::frameTimeStepsAsLongAsTheFrames()
{
    Simulation simulation(metronome());
    simulation.setFrameTime(true);
    QVERIFY(simulation.usesFrameTime());
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    simulation.start();
    while (simulation.recording().last() < 3)
        QVERIFY(frames.wait());
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

void TestSimulation::timeGoesOnAfterFrameTime()
{
    // At eight times the speed a frame lasts some 0.13 s: three of them are many timesteps.
    Simulation simulation(metronome());
    simulation.setFrameTime(true);
    simulation.setSpeed(Simulation::fastest);
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    simulation.start();
    while (simulation.recording().last() < 3)
        QVERIFY(frames.wait());
    simulation.pause();
    simulation.setFrameTime(false);
    const double before = simulation.time();
    stepForward(simulation, 2);
    COMPARE_NEAR(simulation.time() - before, 2.0 * dt, 1e-12);
}

void TestSimulation::hitsAreRecordedWithTheirSteps()
{
    Simulation simulation(metronome());
    stepForward(simulation, 400);
    for (const Hit &hit : simulation.recording().hits()) {
        QVERIFY(hit.step >= 1 && hit.step <= 400);
        // At the end of that step the velocity is the one after the hit.
        QVERIFY(simulation.recording().circles(hit.step)[0].velocity == hit.afterA);
        QVERIFY(simulation.recording().circles(hit.step - 1)[0].velocity == hit.beforeA);
    }
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
