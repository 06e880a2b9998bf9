// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/shadow_run.h"

#include "model/run/simulation.h"
#include "model/world/measurements.h"
#include "tests/patience.h"
#include "tests/scenes.h"
#include "tests/showing_program.h"

#include <QSignalSpy>

using namespace cradle;
using namespace cradle::scenes;

using Action = void (*)(Simulation &);

namespace {

/// A circle that is thrown sideways, with nothing to meet for a second.
Preset thrown(Integrator integrator)
{
    Preset preset = scene({circle({-2, 2}, {2, 1}, 0.2, integrator)},
                          {WallLaw::Reflect, CircleLaw::None, Timing::Discrete});
    preset.gravity = {0, -g};
    return preset;
}

/// Two circles that meet each other and the walls, under gravity.
Preset lively()
{
    Preset preset = scene({circle({-2, 2.3}, {2, 0}, 0.2, Integrator::Euler),
                           circle({2, 2}, {-1, 1}, 0.3, Integrator::SymplecticEuler)},
                          {WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete});
    preset.gravity = {0, -g};
    return preset;
}

Preset exact(Preset preset)
{
    preset.laws.timing = Timing::Exact;
    return preset;
}

void stepForward(Simulation &simulation, int steps)
{
    for (int i = 0; i < steps; ++i)
        simulation.stepForward();
}

Deviation deviationOf(const Simulation &simulation)
{
    const Preset &preset = simulation.preset();
    return deviation(simulation.recording().circles(simulation.current()),
                     simulation.shadow()->circles(simulation.current()), preset.gravity,
                     preset.halfWidth);
}

/// Whether every kept frame has the exact circles of its time beside it.
bool isInStep(const Simulation &simulation, const Preset &scene)
{
    Run run(exact(scene));
    const Recording &recording = simulation.recording();
    for (qint64 i = recording.first(); i <= recording.last(); ++i) {
        run.steps(static_cast<int>(recording.step(i) - run.world.step));
        const auto circles = simulation.shadow()->circles(i);
        if (circles.size() != run.world.circles.size())
            return false;
        for (std::size_t k = 0; k < circles.size(); ++k) {
            if (!near(length(circles[k].position - run[k].position), 0.0, 1e-9))
                return false;
        }
    }
    return simulation.shadow()->circles(recording.last() + 1).empty();
}

} // namespace

class TestShadowRun : public QObject
{
    Q_OBJECT
private slots:
    void isThereOnlyWhenWanted();
    void integratorsAreOffByTheirFormula_data();
    void integratorsAreOffByTheirFormula();
    void isTheExactRun();
    void canBeAskedForLate();
    void staysInStep_data();
    void staysInStep();
    void staysInStepWithFrameTime();
    void keepsWhatTheRunKeeps();
    void followsARunThatWasTruncated();
    void programsAreMeasuredByTheLawsOfTheStep();
    void forbiddenStartsAndCrowdsHaveNone();
};

void TestShadowRun::isThereOnlyWhenWanted()
{
    Simulation simulation(lively());
    QSignalSpy changed(&simulation, &Simulation::shadowChanged);
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    QVERIFY(!simulation.shadow());
    simulation.setShadowed(true);
    simulation.setShadowed(true);
    QVERIFY(simulation.shadow() && simulation.shadow()->isPossible());
    QVERIFY(deviationOf(simulation) == Deviation{});
    simulation.setShadowed(false);
    QVERIFY(!simulation.shadow());
    QCOMPARE(changed.count(), 2);
    QCOMPARE(frames.count(), 2);
}

void TestShadowRun::integratorsAreOffByTheirFormula_data()
{
    // x_n = x₀ + n h v₀ + g h² Σ k over k = 0 … n − 1 (Euler) or 1 … n (symplectic), which is
    // ∓½ g h t beside x₀ + v₀ t + ½ g t²; the velocities are exact.
    QTest::addColumn<int>("integrator");
    QTest::addColumn<double>("above"); // of ½ |g| h t
    QTest::newRow("Euler lags behind the fall") << int(Integrator::Euler) << 1.0;
    QTest::newRow("symplectic is ahead of it") << int(Integrator::SymplecticEuler) << -1.0;
    QTest::newRow("Verlet is exact") << int(Integrator::Verlet) << 0.0;
    QTest::newRow("RK4 is exact") << int(Integrator::RungeKutta4) << 0.0;
}

void TestShadowRun::integratorsAreOffByTheirFormula()
{
    QFETCH(int, integrator);
    QFETCH(double, above);
    Simulation simulation(thrown(static_cast<Integrator>(integrator)));
    simulation.setShadowed(true);
    const double m = mass(simulation.preset().circles[0].body);
    for (int n = 1; n <= 60; ++n) {
        simulation.stepForward();
        const Deviation off = deviationOf(simulation);
        const Vec2 ghost = simulation.shadow()->circles(n)[0].position;
        const double expected = above * 0.5 * g * dt * n * dt;
        COMPARE_NEAR(simulation.recording().circles(n)[0].position.y - ghost.y, expected, 1e-12);
        COMPARE_NEAR(off.greatest, std::abs(expected), 1e-12);
        COMPARE_NEAR(off.rootMeanSquare, std::abs(expected), 1e-12);
        // ±½ m g² h² in every step: at the same velocity the one that is higher has more energy.
        COMPARE_NEAR(off.energy, above * 0.5 * m * g * g * dt * dt * n, 1e-8);
    }
}

void TestShadowRun::isTheExactRun()
{
    Simulation simulation(lively());
    simulation.setShadowed(true);
    stepForward(simulation, 300);
    QVERIFY(isInStep(simulation, lively()));
    QVERIFY(deviationOf(simulation).greatest > 0.1); // so the run is another one
}

void TestShadowRun::canBeAskedForLate()
{
    Simulation early(lively());
    Simulation late(lively());
    early.setShadowed(true);
    stepForward(early, 200);
    stepForward(late, 200);
    late.setShadowed(true);
    for (qint64 i = 0; i <= 200; ++i)
        QVERIFY(early.shadow()->circles(i)[0] == late.shadow()->circles(i)[0]);
}

void TestShadowRun::staysInStep_data()
{
    QTest::addColumn<Action>("act");
    QTest::newRow("seek") << Action([](Simulation &s) { s.seek(20); });
    QTest::newRow("go on in the past") << Action([](Simulation &s) {
        s.seek(20);
        stepForward(s, 30);
    });
    QTest::newRow("go far ahead") << Action([](Simulation &s) { s.goTo(500); });
    QTest::newRow("next hit") << Action([](Simulation &s) { s.seekNextHit(); });
    QTest::newRow("restart") << Action([](Simulation &s) { s.restart(); });
    QTest::newRow("the same preset") << Action([](Simulation &s) { s.setPreset(s.basePreset()); });
}

void TestShadowRun::staysInStep()
{
    QFETCH(Action, act);
    Simulation simulation(lively());
    simulation.setShadowed(true);
    stepForward(simulation, 100);
    act(simulation);
    QVERIFY(isInStep(simulation, lively()));
    stepForward(simulation, 100);
    QVERIFY(isInStep(simulation, lively()));
    Preset edited = lively();
    edited.circles[0].body.velocity = {3, 1};
    edited.circles.push_back(circle({0, -2}));
    simulation.setPreset(edited);
    stepForward(simulation, 50);
    QVERIFY(isInStep(simulation, edited));
}

void TestShadowRun::staysInStepWithFrameTime()
{
    Simulation simulation(thrown(Integrator::Verlet));
    simulation.setShadowed(true);
    stepForward(simulation, 3);
    simulation.setFrameTime(true);
    QSignalSpy frames(&simulation, &Simulation::frameReady);
    simulation.start();
    while (simulation.recording().last() < 8)
        QVERIFY(frames.wait(patience));
    simulation.pause();
    simulation.setFrameTime(false);
    stepForward(simulation, 3);
    for (qint64 i = 0; i <= simulation.recording().last(); ++i) {
        const double t = simulation.recording().time(i);
        COMPARE_NEAR(simulation.shadow()->circles(i)[0].position.y, 2.0 + t - 0.5 * g * t * t,
                     1e-12);
    }
}

void TestShadowRun::keepsWhatTheRunKeeps()
{
    // A recording of a few blocks only, and a shadow that comes when the first ones are gone.
    const Preset preset = thrown(Integrator::SymplecticEuler);
    Recording recording(100'000);
    ShadowRun shadow(preset, preset.laws);
    ShadowRun late(preset, preset.laws);
    Run run(preset);
    Run truth(exact(preset));
    for (; run.world.step <= 4000; run.steps(1)) {
        recording.append(run.world, run.hits);
        run.hits.clear();
        shadow.follow(recording);
    }
    late.follow(recording);
    QVERIFY(recording.hasDropped());
    truth.steps(static_cast<int>(recording.first()));
    for (qint64 i = recording.first(); i <= recording.last(); ++i, truth.steps(1)) {
        for (const ShadowRun *each : {&shadow, &late})
            COMPARE_NEAR(each->circles(i)[0].position.y, truth[0].position.y, 1e-9);
    }
    QVERIFY(late.circles(recording.first() - 1).empty());
}

void TestShadowRun::followsARunThatWasTruncated()
{
    const Preset preset = thrown(Integrator::Euler);
    ShadowRun shadow(preset, preset.laws);
    Recording recording;
    World world = initialWorld(preset);
    const auto append = [&](double time) {
        world.time = time;
        recording.append(world);
        ++world.step;
    };
    for (const double time : {0.0, 0.1, 0.2, 0.3})
        append(time);
    shadow.follow(recording);
    recording.truncateAfter(1);
    shadow.follow(recording);
    QVERIFY(shadow.circles(2).empty());
    append(0.35); // another way on
    shadow.follow(recording);
    COMPARE_NEAR(shadow.circles(2)[0].position.y, 2.0 + 0.35 - 0.5 * g * 0.35 * 0.35, 1e-12);
}

void TestShadowRun::programsAreMeasuredByTheLawsOfTheStep()
{
    // A program whose circle goes on through the wall, in a scene whose own laws know none.
    Preset preset = scene({circle({3, 0}, {1, 0})}, {});
    ShowingProgram program;
    Simulation simulation(preset);
    simulation.setShadowed(true);
    simulation.setProgramLaws(Laws{WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete});
    simulation.setProgram(&program);
    simulation.goTo(120);
    COMPARE_NEAR(simulation.recording().circles(120)[0].position.x, 5.0, 1e-9);
    COMPARE_NEAR(simulation.shadow()->circles(120)[0].position.x, 2.6, 1e-9); // 3.8 − 1.2
    // Without a program those of the scene hold.
    simulation.setProgram(nullptr);
    simulation.goTo(120);
    COMPARE_NEAR(simulation.shadow()->circles(120)[0].position.x, 5.0, 1e-9);
}

void TestShadowRun::forbiddenStartsAndCrowdsHaveNone()
{
    // Two circles at one place may stay there as long as they pass through each other.
    const Preset preset = scene({circle({0, 0}, {1, 0}), circle({0, 0}, {2, 0})}, {});
    QVERIFY(ShadowRun(preset, preset.laws).isPossible());
    ShadowRun none(preset, {WallLaw::None, CircleLaw::Impulse, Timing::Discrete});
    none.follow(Simulation(preset).recording());
    QVERIFY(!none.isPossible());
    QVERIFY(none.circles(0).empty());
    Preset crowd = scene({}, {});
    crowd.circles.assign(ShadowRun::mostCircles, circle({0, 0}));
    QVERIFY(ShadowRun(crowd, crowd.laws).isPossible());
    crowd.circles.push_back(circle({1, 0}));
    QVERIFY(!ShadowRun(crowd, crowd.laws).isPossible());
}

QTEST_GUILESS_MAIN(TestShadowRun)
#include "test_shadow_run.moc"
