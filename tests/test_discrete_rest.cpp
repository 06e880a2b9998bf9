// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/discrete_step.h"

#include "tests/falls.h"
#include "tests/scenes.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr Laws walls{WallLaw::Reflect, CircleLaw::None, Timing::Discrete};
constexpr int minute = 3600; // steps of 1/60 s

} // namespace

/// How circles come to rest on the floor in discrete steps.
class TestDiscreteRest : public QObject
{
    Q_OBJECT
private slots:
    void restingOnTheFloorNeverSinks_data();
    void restingOnTheFloorNeverSinks();
    void restingOnTheFloorGainsNoEnergy_data();
    void restingOnTheFloorGainsNoEnergy();
    void droppedCircleEndsWithinItsMeasuredHeight_data();
    void droppedCircleEndsWithinItsMeasuredHeight();
    void elasticEulerClimbs();
};

void TestDiscreteRest::restingOnTheFloorNeverSinks_data()
{
    addFalls();
}

void TestDiscreteRest::restingOnTheFloorNeverSinks()
{
    QFETCH(Integrator, integrator);
    QFETCH(double, restitution);
    QFETCH(double, height);
    Preset preset = scene({circle({0.5, -3.8 + height}, {}, 0.2, integrator)}, walls);
    preset.gravity = {0, -g};
    preset.restitution = restitution;
    Run run(preset);
    for (int i = 0; i < minute; ++i) {
        const double travel = std::abs(run[0].velocity.y) * dt + g * dt * dt;
        run.steps(1);
        QVERIFY(run[0].position.y - 0.2 >= -halfWidth - travel);
    }
    QVERIFY(run.hits.size() <= minute);
}

void TestDiscreteRest::restingOnTheFloorGainsNoEnergy_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<double>("restitution");
    for (const Integrator integrator :
         {Integrator::SymplecticEuler, Integrator::Verlet, Integrator::RungeKutta4}) {
        for (const double e : {0.0, 0.25, 0.5, 0.75, 0.9})
            QTest::addRow("%s, e = %g", shortName(integrator), e) << integrator << e;
    }
}

void TestDiscreteRest::restingOnTheFloorGainsNoEnergy()
{
    QFETCH(Integrator, integrator);
    QFETCH(double, restitution);
    Preset preset = scene({circle({0, 0}, {}, 0.2, integrator)}, walls);
    preset.gravity = {0, -g};
    preset.restitution = restitution;
    Run run(preset);
    // E/m above the floor, J/kg. Going back to the old position after a hit gives one step's
    // fall back: that much is the way's own error, no more.
    const double start = g * 3.8;
    for (int i = 0; i < minute; ++i) {
        run.steps(1);
        const double energy = 0.5 * lengthSquared(run[0].velocity) + g * (run[0].position.y + 3.8);
        QVERIFY(energy <= start * (1.0 + 1e-12));
    }
}

void TestDiscreteRest::droppedCircleEndsWithinItsMeasuredHeight_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("bound"); // m above the floor in the seconds after a minute
    for (const double e : {0.0, 0.5, 0.75, 0.9}) {
        QTest::addRow("symplectic, e = %g: rests", e) << Integrator::SymplecticEuler << e << 0.0016;
    }
    QTest::newRow("Euler, e = 0.5: hops") << Integrator::Euler << 0.5 << 0.013;
    QTest::newRow("Euler, e = 0.75: hops") << Integrator::Euler << 0.75 << 0.070;
    QTest::newRow("Euler, e = 0.9: hops") << Integrator::Euler << 0.9 << 0.52;
}

void TestDiscreteRest::droppedCircleEndsWithinItsMeasuredHeight()
{
    QFETCH(Integrator, integrator);
    QFETCH(double, restitution);
    QFETCH(double, bound);
    Preset preset = scene({circle({0, 0}, {}, 0.2, integrator)}, walls);
    preset.gravity = {0, -g};
    preset.restitution = restitution;
    Run run(preset);
    run.steps(minute);
    double highest = 0.0;
    for (int i = 0; i < 300; ++i) {
        run.steps(1);
        highest = std::max(highest, run[0].position.y + 3.8);
    }
    QVERIFY2(highest <= bound, QByteArray::number(highest).constData());
    // Euler never comes to rest: that is what the student is to see.
    if (integrator == Integrator::Euler)
        QVERIFY2(highest >= 0.5 * bound, QByteArray::number(highest).constData());
}

void TestDiscreteRest::elasticEulerClimbs()
{
    // Dropped 3.8 m, without a ceiling in reach: about 13 m after a minute.
    Preset preset = scene({circle({0, -30.0 + 0.2 + 3.8}, {}, 0.2, Integrator::Euler)}, walls);
    preset.halfWidth = 30.0;
    preset.gravity = {0, -g};
    Run run(preset);
    double highest = 0.0;
    for (int i = 0; i < minute; ++i) {
        run.steps(1);
        highest = std::max(highest, run[0].position.y + 29.8);
    }
    QVERIFY2(highest > 12.0 && highest < 14.0, QByteArray::number(highest).constData());
}

QTEST_APPLESS_MAIN(TestDiscreteRest)
#include "test_discrete_rest.moc"
