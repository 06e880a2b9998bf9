// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/run_ahead.h"
#include "model/run/runner.h"
#include "model/run/simulation.h"

#include "tests/patience.h"
#include "tests/simulation_scenes.h"

#include <QSemaphore>
#include <QSignalSpy>

#include <atomic>

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// Lets circles fly until a wall at x = 1 m turns them; plots x. From step \p waits on it only goes
/// on if it is let; what it claims to work makes a search leave the GUI thread after a step.
class Slow final : public Program
{
public:
    std::optional<ProgramError> begin(Preset &) override
    {
        steps = 0;
        return std::nullopt;
    }
    bool moves() const override { return true; }
    std::optional<ProgramError> advance(World &world, double dt) override
    {
        ++steps;
        if (world.step + 1 >= waits) {
            arrived.release();
            wasLet = may.tryAcquire(1, patience) && wasLet;
        }
        Circle &circle = world.circles[0];
        circle.position += dt * circle.velocity;
        if (circle.position.x > 1.0)
            circle.velocity.x = -std::abs(circle.velocity.x);
        output.points = {{QStringLiteral("x"), circle.position.x}};
        if (world.step + 1 == failsIn)
            return ProgramError{.message = QStringLiteral("stop"), .step = failsIn};
        return std::nullopt;
    }
    qint64 instructions() const override { return steps * 2'000'000; }
    ProgramOutput takeOutput() override { return std::exchange(output, {}); }

    qint64 waits = std::numeric_limits<qint64>::max();
    qint64 failsIn = -1;
    std::atomic<qint64> steps = 0;
    QSemaphore arrived; ///< at a step that waits
    QSemaphore may;
    bool wasLet = true;
    ProgramOutput output;
};

/// The wall is met after 0.5 s.
Preset turned()
{
    Preset preset = scene({circle({0, 0}, {2, 0}, 0.2)}, {WallLaw::Reflect, CircleLaw::None, {}});
    preset.halfWidth = 1.2;
    return preset;
}

} // namespace

/// What takes long of a search for the next hit is not done on the thread of the window.
class TestSearchThread : public QObject
{
    Q_OBJECT
private slots:
    void whatIsTakenMakesRoom();
    void eventsAreHandledWhileAStepTakesLong();
    void findsWhatStepsFind();
    void goesOnFromWhereItWasEnded();
    void programThatStopsEndsIt();
    void whoIsDestroyedEndsIt();
    void crowdIsSearchedAsItIsStepped();
};

void TestSearchThread::eventsAreHandledWhileAStepTakesLong()
{
    Slow slow;
    slow.waits = 10;
    Simulation simulation(turned());
    simulation.setProgram(&slow);
    simulation.seekNextHit();
    QVERIFY(simulation.isSearching());
    QVERIFY(slow.arrived.tryAcquire(1, patience));
    // The program stands in its tenth step; the nine before come to be seen.
    QTRY_COMPARE(simulation.current(), qint64{9});
    int turns = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&turns] { ++turns; });
    timer.start(0);
    QTRY_VERIFY(turns >= 3);
    QVERIFY(simulation.isSearching());
    QVERIFY(simulation.isProgrammed());
    QVERIFY(!simulation.programError());
    slow.may.release(1000);
    QTRY_VERIFY(!simulation.isSearching());
    QVERIFY(slow.wasLet);
    QVERIFY(simulation.current() > 9);
}

void TestSearchThread::findsWhatStepsFind()
{
    Slow stepped;
    Simulation expected(turned());
    expected.setProgram(&stepped);
    while (expected.recording().hits().empty())
        expected.stepForward();
    Slow slow;
    Simulation simulation(turned());
    simulation.setProgram(&slow);
    QSignalSpy searching(&simulation, &Simulation::searchingChanged);
    simulation.seekNextHit();
    QVERIFY(simulation.isSearching());
    QTRY_VERIFY(!simulation.isSearching());
    QCOMPARE(searching.size(), 2);
    QCOMPARE(simulation.recording().last(), expected.recording().last());
    QCOMPARE(simulation.current(), simulation.recording().last());
    for (qint64 k = 0; k <= simulation.current(); ++k)
        QVERIFY(simulation.recording().world(k) == expected.recording().world(k));
    QVERIFY(simulation.recording().hits() == expected.recording().hits());
    QCOMPARE(simulation.notes().curves()[0].values, expected.notes().curves()[0].values);
    // The run goes on as if it had never been away.
    expected.stepForward();
    simulation.stepForward();
    QVERIFY(simulation.recording().world(simulation.current())
            == expected.recording().world(expected.current()));
}

void TestSearchThread::goesOnFromWhereItWasEnded()
{
    Slow slow;
    slow.waits = 10;
    Simulation simulation(turned());
    simulation.setProgram(&slow);
    simulation.seekNextHit();
    QVERIFY(slow.arrived.tryAcquire(1, patience));
    slow.may.release(1000);
    simulation.pause();
    QVERIFY(!simulation.isSearching());
    QCOMPARE(simulation.current(), qint64{0});
    const qint64 last = simulation.recording().last();
    QVERIFY(last >= 10);
    QCOMPARE(slow.steps.load(), last);
    simulation.goTo(last + 3);
    QCOMPARE(simulation.recording().step(simulation.current()), last + 3);
    QCOMPARE(simulation.notes().curves()[0].values.size(), static_cast<std::size_t>(last + 3));
}

void TestSearchThread::programThatStopsEndsIt()
{
    Slow slow;
    slow.failsIn = 12;
    Simulation simulation(turned());
    simulation.setProgram(&slow);
    QSignalSpy failed(&simulation, &Simulation::programFailed);
    QSignalSpy noHit(&simulation, &Simulation::noHitFound);
    simulation.seekNextHit();
    QTRY_VERIFY(!simulation.isSearching());
    QCOMPARE(failed.size(), 1);
    QCOMPARE(noHit.size(), 1);
    QCOMPARE(simulation.programError()->step, qint64{12});
    QCOMPARE(simulation.current(), qint64{0});
    QCOMPARE(simulation.recording().last(), qint64{11});
    // What it has shown in the step that failed is shown.
    QCOMPARE(simulation.notes().curves()[0].values.size(), std::size_t{12});
}

void TestSearchThread::whoIsDestroyedEndsIt()
{
    Slow slow;
    slow.waits = 10;
    {
        Simulation simulation(turned());
        simulation.setProgram(&slow);
        simulation.seekNextHit();
        QVERIFY(slow.arrived.tryAcquire(1, patience));
        slow.may.release(1000);
    }
    const qint64 steps = slow.steps;
    QCoreApplication::processEvents();
    QCOMPARE(slow.steps.load(), steps);
    QVERIFY(slow.wasLet);
}

/// More circles than are searched at once, which rest on the floor but for one that flies.
void TestSearchThread::crowdIsSearchedAsItIsStepped()
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {0, -g};
    preset.restitution = 0.5;
    preset.halfWidth = 40.0;
    for (int i = 0; i < 150; ++i)
        preset.circles.push_back(circle({0.5 * i - 38.0, -39.8}));
    preset.circles.push_back(circle({0.0, 10.0}, {0.0, 20.0}));
    Simulation expected(preset);
    Simulation simulation(preset);
    expected.goTo(60);
    simulation.goTo(60); // all lie still
    const std::size_t contacts = expected.recording().encounters().size();
    while (expected.recording().encounters().size() == contacts)
        expected.stepForward();
    simulation.seekNextHit();
    QVERIFY(simulation.isSearching());
    QTRY_VERIFY(!simulation.isSearching());
    QCOMPARE(simulation.current(), expected.current());
    QVERIFY(simulation.recording().world(simulation.current())
            == expected.recording().world(expected.current()));
    QVERIFY(simulation.recording().encounters() == expected.recording().encounters());
}

/// More steps than are kept: the thread waits until some are taken, and then goes on.
void TestSearchThread::whatIsTakenMakesRoom()
{
    constexpr int steps = 10'000;
    Preset preset =
        scene({circle({0, 0}, {1e-3, 0})}, {WallLaw::Reflect, CircleLaw::None, Timing::Discrete});
    Runner run(preset);
    RunAhead ahead;
    ahead.start(run, nullptr, {}, (steps - 0.5) * preset.timestep);
    int taken = 0;
    const auto takeAll = [&] {
        while (ahead.take())
            ++taken;
        return taken == steps;
    };
    QTRY_VERIFY(takeAll());
    QTRY_VERIFY(ahead.isDone());
}

QTEST_GUILESS_MAIN(TestSearchThread)
#include "test_search_thread.moc"
