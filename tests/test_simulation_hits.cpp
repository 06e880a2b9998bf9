// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"

#include "tests/patience.h"
#include "tests/scenes.h"
#include "tests/simulation_scenes.h"

#include <QSignalSpy>

using namespace cradle;
using namespace cradle::scenes;

/// The way from hit to hit of a run.
class TestSimulationHits : public QObject
{
    Q_OBJECT
private slots:
    void findsTheNextHit();
    void findsTheNextHitInTheRecording();
    void goesBackFromHitToHit();
    void pausesAtEveryHitIfAsked();
    void searchForAHitEndsAfterAMinuteWhereItBegan();
    void hitsAreRecordedWithTheirSteps();
};

void TestSimulationHits::findsTheNextHit()
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

void TestSimulationHits::findsTheNextHitInTheRecording()
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

void TestSimulationHits::goesBackFromHitToHit()
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

void TestSimulationHits::pausesAtEveryHitIfAsked()
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

void TestSimulationHits::searchForAHitEndsAfterAMinuteWhereItBegan()
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

void TestSimulationHits::hitsAreRecordedWithTheirSteps()
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

QTEST_GUILESS_MAIN(TestSimulationHits)
#include "test_simulation_hits.moc"
