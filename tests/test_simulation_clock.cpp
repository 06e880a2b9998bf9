// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation_clock.h"

#include "tests/scenes.h"

#include <QElapsedTimer>

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// Counts what a clock says.
struct Listener {
    explicit Listener(SimulationClock &clock)
    {
        QObject::connect(&clock, &SimulationClock::stepDue, &context,
                         [this](double step) { steps.push_back(step); });
        QObject::connect(&clock, &SimulationClock::frameReady, &context, [this] {
            ++frames;
            stepsAtLastFrame = steps.size();
        });
    }
    [[nodiscard]] double sum() const
    {
        double total = 0.0;
        for (const double step : steps)
            total += step;
        return total;
    }

    std::vector<double> steps{};
    int frames = 0;
    std::size_t stepsAtLastFrame = 0;
    QObject context{};
};

} // namespace

class TestSimulationClock : public QObject
{
    Q_OBJECT
private slots:
    void stepsAreEqual();
    void wallTimeAddsUpToSteps();
    void lessThanAStepWaits();
    void aFrameIsReadyOnceAfterAllItsSteps();
    void noStepNoFrame();
    void speedScalesTheSteps_data();
    void speedScalesTheSteps();
    void ofWhatIsLateHalfAStepIsMadeUpForMoreSlowly();
    void aStallIsCapped_data();
    void aStallIsCapped();
    void afterAStallItGoesOnAsBefore();
    void slowStepsDoNotRunAway();
    void frameTimeGivesOneStepAFrame();
    void frameTimeIsCappedToo();
    void anotherStepLengthBeginsAnew();
    void aStepThatPausesIsTheLastOfItsFrame();
    void startsAndPauses();
    void startingForgetsWhatWasLeft();
};

void TestSimulationClock::stepsAreEqual()
{
    SimulationClock clock(0.01);
    Listener listener(clock);
    for (const double wall : {0.016, 0.017, 0.013, 0.033, 0.0, 0.009})
        clock.tick(wall);
    QVERIFY(!listener.steps.empty());
    for (const double step : listener.steps)
        QCOMPARE(step, 0.01);
}

void TestSimulationClock::wallTimeAddsUpToSteps()
{
    SimulationClock clock(0.01);
    Listener listener(clock);
    for (int i = 1; i <= 1000; ++i) {
        clock.tick(0.016);
        // Never ahead of the wall, and behind by less than a step (1e-9 for the summing up).
        QVERIFY(listener.sum() <= 0.016 * i + 1e-9);
        QVERIFY(listener.sum() > 0.016 * i - 0.01 - 1e-9);
    }
}

void TestSimulationClock::lessThanAStepWaits()
{
    SimulationClock clock(0.0625);
    Listener listener(clock);
    clock.tick(0.03125);
    QCOMPARE(listener.steps.size(), std::size_t{0});
    clock.tick(0.03125);
    QCOMPARE(listener.steps.size(), std::size_t{1});
    clock.tick(0.03125);
    QCOMPARE(listener.steps.size(), std::size_t{1});
}

void TestSimulationClock::aFrameIsReadyOnceAfterAllItsSteps()
{
    SimulationClock clock(0.015625);
    Listener listener(clock);
    clock.tick(0.0625);
    QCOMPARE(listener.steps.size(), std::size_t{4});
    QCOMPARE(listener.frames, 1);
    QCOMPARE(listener.stepsAtLastFrame, std::size_t{4});
}

void TestSimulationClock::noStepNoFrame()
{
    SimulationClock clock(0.0625);
    Listener listener(clock);
    clock.tick(0.0);
    clock.tick(0.03125);
    QCOMPARE(listener.frames, 0);
}

void TestSimulationClock::speedScalesTheSteps_data()
{
    QTest::addColumn<double>("speed");
    QTest::addColumn<int>("steps"); // of 1/64 s in 64 frames of 1/64 s
    QTest::newRow("sixteenth") << 0.0625 << 4;
    QTest::newRow("half") << 0.5 << 32;
    QTest::newRow("real time") << 1.0 << 64;
    QTest::newRow("twice") << 2.0 << 128;
    QTest::newRow("eight times") << 8.0 << 512;
}

void TestSimulationClock::speedScalesTheSteps()
{
    QFETCH(double, speed);
    QFETCH(int, steps);
    SimulationClock clock(0.015625);
    clock.setSpeed(speed);
    QCOMPARE(clock.speed(), speed);
    Listener listener(clock);
    for (int i = 0; i < 64; ++i)
        clock.tick(0.015625);
    QCOMPARE(static_cast<int>(listener.steps.size()), steps);
    for (const double step : listener.steps)
        QCOMPARE(step, 0.015625);
}

/// Three quarters of a step are late: at half the speed a half, at the same or twice the speed all.
void TestSimulationClock::ofWhatIsLateHalfAStepIsMadeUpForMoreSlowly()
{
    constexpr double step = 0.0625; // s
    const auto stepsAfter = [](double speed, double parts) {
        SimulationClock clock(step);
        Listener listener(clock);
        clock.tick(0.75 * step);
        clock.setSpeed(speed);
        clock.tick(parts * step / speed);
        return listener.steps.size();
    };
    QCOMPARE(stepsAfter(0.5, 0.5), std::size_t{1});
    QCOMPARE(stepsAfter(0.5, 0.4375), std::size_t{0});
    for (const double speed : {1.0, 2.0}) {
        QCOMPARE(stepsAfter(speed, 0.25), std::size_t{1});
        QCOMPARE(stepsAfter(speed, 0.1875), std::size_t{0});
    }
}

void TestSimulationClock::aStallIsCapped_data()
{
    QTest::addColumn<double>("stall");
    QTest::newRow("a second") << 1.0;
    QTest::newRow("an hour") << 3600.0;
    QTest::newRow("for ever") << infinity;
}

void TestSimulationClock::aStallIsCapped()
{
    QFETCH(double, stall);
    SimulationClock clock(0.01);
    Listener listener(clock);
    clock.tick(stall);
    QVERIFY(listener.steps.size() >= 1);
    QVERIFY(listener.sum() <= 0.1 + 1e-9); // a tenth of a second is made up for, no more
}

void TestSimulationClock::afterAStallItGoesOnAsBefore()
{
    SimulationClock clock(0.015625);
    Listener listener(clock);
    clock.tick(60.0);
    const std::size_t before = listener.steps.size();
    for (int i = 0; i < 64; ++i)
        clock.tick(0.015625);
    const std::size_t after = listener.steps.size() - before;
    QVERIFY(after >= 63 && after <= 65);
}

void TestSimulationClock::slowStepsDoNotRunAway()
{
    // Each step takes longer than the step itself and than a frame may: had the clock to make
    // up for it all, every frame would take longer than the one before.
    SimulationClock clock(0.001);
    Listener listener(clock);
    QObject context;
    connect(&clock, &SimulationClock::stepDue, &context, [] {
        QElapsedTimer work;
        work.start();
        while (work.elapsed() < 55) {
        }
    });
    clock.tick(0.1);
    QCOMPARE(listener.steps.size(), std::size_t{1});
    QCOMPARE(listener.frames, 1);
    // What was late is dropped, not kept for later.
    clock.tick(0.0005);
    QVERIFY(listener.steps.size() <= 2);
}

void TestSimulationClock::frameTimeGivesOneStepAFrame()
{
    SimulationClock clock(0.01);
    clock.setFrameTime(true);
    Listener listener(clock);
    const std::vector<double> walls{0.016, 0.02, 0.033, 0.001};
    for (const double wall : walls)
        clock.tick(wall);
    QVERIFY(listener.steps == walls);
    QCOMPARE(listener.frames, 4);
    clock.setSpeed(0.5);
    clock.tick(0.016);
    QCOMPARE(listener.steps.back(), 0.008);
    clock.setSpeed(1.0);
    clock.setFrameTime(false);
    clock.tick(0.016);
    QCOMPARE(listener.steps.back(), 0.01);
}

void TestSimulationClock::frameTimeIsCappedToo()
{
    SimulationClock clock(0.01);
    clock.setFrameTime(true);
    Listener listener(clock);
    clock.tick(5.0);
    QCOMPARE(listener.steps.size(), std::size_t{1});
    QVERIFY(listener.steps[0] <= 0.1);
}

void TestSimulationClock::anotherStepLengthBeginsAnew()
{
    SimulationClock clock(0.0625);
    Listener listener(clock);
    clock.tick(0.03125);
    clock.setStep(0.03125);
    clock.tick(0.0);
    QCOMPARE(listener.steps.size(), std::size_t{0});
    clock.tick(0.03125);
    QVERIFY(listener.steps == std::vector{0.03125});
}

/// Half a step is left of the other three, whatever made it pause.
void TestSimulationClock::aStepThatPausesIsTheLastOfItsFrame()
{
    constexpr double step = 0.0625; // s
    SimulationClock clock(step);
    Listener listener(clock);
    connect(&clock, &SimulationClock::stepDue, &listener.context, [&clock] { clock.pause(); });
    clock.tick(4.0 * step);
    QCOMPARE(listener.steps.size(), std::size_t{1});
    clock.tick(0.4375 * step);
    QCOMPARE(listener.steps.size(), std::size_t{1});
    clock.tick(0.0625 * step);
    QCOMPARE(listener.steps.size(), std::size_t{2});
}

void TestSimulationClock::startsAndPauses()
{
    SimulationClock clock(0.01);
    QVERIFY(!clock.isRunning());
    clock.start();
    QVERIFY(clock.isRunning());
    clock.pause();
    QVERIFY(!clock.isRunning());
    clock.pause();
    QVERIFY(!clock.isRunning());
}

void TestSimulationClock::startingForgetsWhatWasLeft()
{
    SimulationClock clock(0.0625);
    Listener listener(clock);
    clock.tick(0.046875);
    clock.start();
    clock.pause();
    clock.tick(0.046875);
    QCOMPARE(listener.steps.size(), std::size_t{0});
}

QTEST_GUILESS_MAIN(TestSimulationClock)
#include "test_simulation_clock.moc"
