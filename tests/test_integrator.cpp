// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/integrator.h"

#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr int steps = 200;
constexpr double wideHalfWidth = 100.0; // m: no bounce within the 200 steps
constexpr Vec2 start{-2.0, 2.0};
constexpr Vec2 push{2.0, 1.0};
constexpr Vec2 gravity{0.0, -g};

struct Exact {
    long double x = 0.0L;
    long double v = 0.0L;
};

/// The recurrences summed up by hand for n steps of h, in higher precision:
///     v_n = v₀ + n h a
///     x_n = x₀ + n h v₀ + a h² (0 + 1 + … + (n−1))     Euler: the old velocity
///     x_n = x₀ + n h v₀ + a h² (1 + 2 + … + n)         symplectic Euler: the new one
///     x_n = x₀ + n h v₀ + ½ a (n h)²                   Verlet, Runge–Kutta: their mean
Exact afterSteps(Integrator integrator, double x0, double v0, double a, double h, int n)
{
    const long double count = n;
    const long double t = count * static_cast<long double>(h);
    const long double hh = static_cast<long double>(h) * static_cast<long double>(h);
    long double sum = 0.5L * count * count;
    if (integrator == Integrator::Euler)
        sum = count * (count - 1.0L) / 2.0L;
    else if (integrator == Integrator::SymplecticEuler)
        sum = count * (count + 1.0L) / 2.0L;
    return {x0 + t * v0 + a * hh * sum, v0 + t * a};
}

/// ½ v² − a·x in higher precision, J/kg
long double energyPerMass(const Motion &m, Vec2 a)
{
    const auto l = [](double value) { return static_cast<long double>(value); };
    return 0.5L * (l(m.velocity.x) * l(m.velocity.x) + l(m.velocity.y) * l(m.velocity.y))
           - (l(a.x) * l(m.position.x) + l(a.y) * l(m.position.y));
}

} // namespace

class TestIntegrator : public QObject
{
    Q_OBJECT
private slots:
    void oneStepMatchesHandWorkedCase_data();
    void oneStepMatchesHandWorkedCase();
    void followsItsRecurrenceFor200Steps_data();
    void followsItsRecurrenceFor200Steps();
    void followsItsRecurrenceThroughTheStepper_data();
    void followsItsRecurrenceThroughTheStepper();
    void verletAndRungeKuttaMatchTheParabola_data();
    void verletAndRungeKuttaMatchTheParabola();
    void eachStepChangesTheEnergyByTheKnownAmount_data();
    void eachStepChangesTheEnergyByTheKnownAmount();
    void withoutForceAllMoveStraight_data();
    void withoutForceAllMoveStraight();
    void stepOfNoLengthChangesNothing_data();
    void stepOfNoLengthChangesNothing();
    void pathCurvatureDescribesTheStepAsItGrows_data();
    void pathCurvatureDescribesTheStepAsItGrows();
    void theFirstStepTellsTheEulersApart();
};

void TestIntegrator::oneStepMatchesHandWorkedCase_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<double>("height"); // m, from y = 1 with v = 3 m/s, a = −8 m/s², h = ¼ s
    QTest::newRow("Euler") << Integrator::Euler << 1.75;                // 1 + ¾
    QTest::newRow("symplectic") << Integrator::SymplecticEuler << 1.25; // 1 + (3−2)/4
    QTest::newRow("Verlet") << Integrator::Verlet << 1.5;               // 1 + ¾ − 4/16
    QTest::newRow("RK4") << Integrator::RungeKutta4 << 1.5;
}

void TestIntegrator::oneStepMatchesHandWorkedCase()
{
    QFETCH(Integrator, integrator);
    QFETCH(double, height);
    const Motion m = advance(integrator, {{5.0, 1.0}, {2.0, 3.0}}, {0.0, -8.0}, 0.25);
    COMPARE_NEAR(m.position.y, height, 1e-15);
    QCOMPARE(m.velocity.y, 1.0);
    COMPARE_NEAR(m.position.x, 5.5, 1e-15);
    QCOMPARE(m.velocity.x, 2.0);
}

void TestIntegrator::followsItsRecurrenceFor200Steps_data()
{
    QTest::addColumn<Integrator>("integrator");
    for (const Integrator integrator : allIntegrators)
        QTest::newRow(shortName(integrator)) << integrator;
}

void TestIntegrator::followsItsRecurrenceFor200Steps()
{
    QFETCH(Integrator, integrator);
    const Vec2 a{0.75, -g};
    Motion m{start, push};
    for (int n = 1; n <= steps; ++n) {
        m = advance(integrator, m, a, dt);
        const Exact x = afterSteps(integrator, start.x, push.x, a.x, dt, n);
        const Exact y = afterSteps(integrator, start.y, push.y, a.y, dt, n);
        COMPARE_NEAR(m.position.x, x.x, 1e-12);
        COMPARE_NEAR(m.position.y, y.x, 1e-12);
        COMPARE_NEAR(m.velocity.x, x.v, 1e-12);
        COMPARE_NEAR(m.velocity.y, y.v, 1e-12);
    }
}

void TestIntegrator::followsItsRecurrenceThroughTheStepper_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<Timing>("timing");
    for (const Timing timing : {Timing::Discrete, Timing::Continuous}) {
        for (const Integrator integrator : allIntegrators) {
            QTest::addRow("%s, %s", shortName(integrator), shortName(timing))
                << integrator << timing;
        }
    }
}

void TestIntegrator::followsItsRecurrenceThroughTheStepper()
{
    QFETCH(Integrator, integrator);
    QFETCH(Timing, timing);
    Preset preset = scene({circle(start, push, 0.2, integrator)},
                          {WallLaw::Reflect, CircleLaw::Impulse, timing});
    preset.halfWidth = wideHalfWidth;
    preset.gravity = gravity;
    Run run(preset);
    for (int n = 1; n <= steps; ++n) {
        run.steps(1);
        const Exact y = afterSteps(integrator, start.y, push.y, gravity.y, dt, n);
        COMPARE_NEAR(run[0].position.x, start.x + n * dt * push.x, 1e-12);
        COMPARE_NEAR(run[0].position.y, y.x, 1e-12);
        COMPARE_NEAR(run[0].velocity.y, y.v, 1e-12);
        QCOMPARE(run[0].velocity.x, push.x);
        QCOMPARE(run.world.step, qint64{n});
        QCOMPARE(run.world.time, n * dt);
    }
    QVERIFY(run.hits.empty());
}

void TestIntegrator::verletAndRungeKuttaMatchTheParabola_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<double>("timestep");
    for (const double timestep : {1.0 / 60.0, 0.1, 0.001}) {
        QTest::addRow("Verlet, %g s", timestep) << Integrator::Verlet << timestep;
        QTest::addRow("RK4, %g s", timestep) << Integrator::RungeKutta4 << timestep;
    }
}

void TestIntegrator::verletAndRungeKuttaMatchTheParabola()
{
    QFETCH(Integrator, integrator);
    QFETCH(double, timestep);
    Motion m{start, push};
    for (int n = 1; n <= steps; ++n) {
        m = advance(integrator, m, gravity, timestep);
        const double t = n * timestep;
        COMPARE_NEAR(m.position.x, start.x + push.x * t, 1e-9);
        COMPARE_NEAR(m.position.y, start.y + push.y * t - 0.5 * g * t * t, 1e-9);
        COMPARE_NEAR(m.velocity.y, push.y - g * t, 1e-9);
    }
}

void TestIntegrator::eachStepChangesTheEnergyByTheKnownAmount_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<double>("change"); // J/kg a step
    const double half = 0.5 * g * g * dt * dt;
    QTest::newRow("Euler gains") << Integrator::Euler << half;
    QTest::newRow("symplectic loses") << Integrator::SymplecticEuler << -half;
    QTest::newRow("Verlet keeps") << Integrator::Verlet << 0.0;
    QTest::newRow("RK4 keeps") << Integrator::RungeKutta4 << 0.0;
}

void TestIntegrator::eachStepChangesTheEnergyByTheKnownAmount()
{
    QFETCH(Integrator, integrator);
    QFETCH(double, change);
    Motion m{start, push};
    for (int n = 0; n < steps; ++n) {
        const long double before = energyPerMass(m, gravity);
        m = advance(integrator, m, gravity, dt);
        COMPARE_NEAR(energyPerMass(m, gravity) - before, change, 1e-12);
    }
}

void TestIntegrator::withoutForceAllMoveStraight_data()
{
    followsItsRecurrenceFor200Steps_data();
}

void TestIntegrator::withoutForceAllMoveStraight()
{
    QFETCH(Integrator, integrator);
    const Motion m = advance(integrator, {start, push}, {}, 0.5);
    COMPARE_NEAR(m.position.x, -1.0, 1e-15);
    COMPARE_NEAR(m.position.y, 2.5, 1e-15);
    QVERIFY(m.velocity == push);
}

void TestIntegrator::stepOfNoLengthChangesNothing_data()
{
    followsItsRecurrenceFor200Steps_data();
}

void TestIntegrator::stepOfNoLengthChangesNothing()
{
    QFETCH(Integrator, integrator);
    QVERIFY(advance(integrator, {start, push}, gravity, 0.0) == (Motion{start, push}));
}

void TestIntegrator::pathCurvatureDescribesTheStepAsItGrows_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<double>("curvature");
    QTest::newRow("Euler: a straight line") << Integrator::Euler << 0.0;
    QTest::newRow("symplectic: a twice as steep") << Integrator::SymplecticEuler << 1.0;
    QTest::newRow("Verlet: the parabola") << Integrator::Verlet << 0.5;
    QTest::newRow("RK4: the parabola") << Integrator::RungeKutta4 << 0.5;
}

void TestIntegrator::pathCurvatureDescribesTheStepAsItGrows()
{
    QFETCH(Integrator, integrator);
    QFETCH(double, curvature);
    QCOMPARE(pathCurvature(integrator), curvature);
    for (int n = 1; n <= 16; ++n) {
        const double s = n * dt / 16.0;
        const Motion m = advance(integrator, {start, push}, gravity, s);
        COMPARE_NEAR(m.position.y, start.y + push.y * s - curvature * g * s * s, 1e-14);
    }
}

void TestIntegrator::theFirstStepTellsTheEulersApart()
{
    // From rest Euler has not moved after one step, symplectic Euler by g Δt² = 2.725 mm.
    COMPARE_NEAR(advance(Integrator::Euler, {}, gravity, dt).position.y, 0.0, 0.0);
    COMPARE_NEAR(advance(Integrator::SymplecticEuler, {}, gravity, dt).position.y, -0.002725,
                 1e-15);
}

QTEST_APPLESS_MAIN(TestIntegrator)
#include "test_integrator.moc"
