// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_step.h"

#include "model/world/measurements.h"
#include "tests/continuous_scenes.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

/// The hits of circles inside a step.
class TestContinuousStep : public QObject
{
    Q_OBJECT
private slots:
    void unlikeIntegratorsMeetWithinAStep();
    void glancingContactOfTheLab_data();
    void glancingContactOfTheLab();
    void restOfTheStepIsSpentAfterTheHit();
    void circlesOfTheLabWithMasses();
    void restitutionScalesTheRelativeNormalSpeed_data();
    void restitutionScalesTheRelativeNormalSpeed();
    void eachLawGivesItsVelocities_data();
    void eachLawGivesItsVelocities();
    void circlesWithoutLawPassThroughEachOther();
    void touchingCirclesThatLeaveAreLeftAlone();
    void nothingIsJumpedOver();
    void newtonsCradleOneInOneOut_data();
    void newtonsCradleOneInOneOut();
    void twoIntegratorsMeetWhereTheirPathsMeet();
    void noCirclesIsAWorldToo();
};

void TestContinuousStep::glancingContactOfTheLab_data()
{
    QTest::addColumn<CircleLaw>("law");
    QTest::newRow("swap normal") << CircleLaw::SwapNormal;
    QTest::newRow("impulse") << CircleLaw::Impulse;
}

void TestContinuousStep::glancingContactOfTheLab()
{
    QFETCH(CircleLaw, law);
    Run run(glancing(law));
    run.steps(120);
    // Contact where dx² + 0.3² = 0.4²; n = (√7/4, −3/4); the part 2·√7/4 along n changes hands:
    //     v₂ = 2·(√7/4) n = (7/8, −3√7/8),  v₁ = (2, 0) − v₂ = (9/8, 3√7/8)
    const double root7 = std::sqrt(7.0);
    QCOMPARE(run.hits.size(), std::size_t{1});
    const Hit &hit = run.hits[0];
    COMPARE_NEAR(hit.time, (4.0 - std::sqrt(0.07)) / 2.0, 1e-12);
    COMPARE_NEAR(hit.time, 1.8677124344, 1e-10);
    QCOMPARE(hit.step, qint64{113}); // 112/60 = 1.8667, 113/60 = 1.8833
    QCOMPARE(hit.a, 0);
    QCOMPARE(hit.b, 1);
    COMPARE_NEAR(hit.normal.x, root7 / 4.0, 1e-12);
    COMPARE_NEAR(hit.normal.y, -0.75, 1e-12);
    COMPARE_NEAR(run[0].velocity.x, 1.125, 1e-12);
    COMPARE_NEAR(run[0].velocity.y, 3.0 * root7 / 8.0, 1e-12);
    COMPARE_NEAR(run[0].velocity.y, 0.99215674164922, 1e-12);
    COMPARE_NEAR(run[1].velocity.x, 0.875, 1e-12);
    COMPARE_NEAR(run[1].velocity.y, -3.0 * root7 / 8.0, 1e-12);
    // Equal masses, one at rest: they part at a right angle.
    const Vec2 v1 = run[0].velocity;
    const Vec2 v2 = run[1].velocity;
    const double degrees = std::atan2(cross(v2, v1), dot(v2, v1)) * 180.0 / pi;
    COMPARE_NEAR(degrees, 90.0, 1e-9);
    // J = m √7/2 with m = 261.3805… kg
    COMPARE_NEAR(hit.impulse, 261.380508778670797 * root7 / 2.0, 1e-9);
}

void TestContinuousStep::restOfTheStepIsSpentAfterTheHit()
{
    Run run(glancing(CircleLaw::SwapNormal));
    run.steps(120); // 2 s
    const double root7 = std::sqrt(7.0);
    const double contact = (4.0 - std::sqrt(0.07)) / 2.0;
    const double after = 2.0 - contact;
    COMPARE_NEAR(run[0].position.x, -2.0 + 2.0 * contact + 1.125 * after, 1e-12);
    COMPARE_NEAR(run[0].position.y, 2.3 + 3.0 * root7 / 8.0 * after, 1e-12);
    COMPARE_NEAR(run[1].position.x, 2.0 + 0.875 * after, 1e-12);
    COMPARE_NEAR(run[1].position.y, 2.0 - 3.0 * root7 / 8.0 * after, 1e-12);
}

void TestContinuousStep::circlesOfTheLabWithMasses()
{
    Run run(scene({circle({-2.5, 2}, {1, 0}, 0.2), circle({0, 2}, {-1, 0}, 0.252)},
                  lawsOf(CircleLaw::Impulse)));
    run.steps(66); // 1.1 s; they meet at (2.5 − 0.452)/2 = 1.024 s
    const double ratio = 1.26 * 1.26 * 1.26;
    QCOMPARE(run.hits.size(), std::size_t{1});
    COMPARE_NEAR(run.hits[0].time, 1.024, 1e-12);
    COMPARE_NEAR(run[0].velocity.x, (1.0 - 3.0 * ratio) / (1.0 + ratio), 1e-12);
    COMPARE_NEAR(run[1].velocity.x, (3.0 - ratio) / (1.0 + ratio), 1e-12);
    COMPARE_NEAR(run[0].velocity.x, -1.66683, 5e-6);
    COMPARE_NEAR(run[1].velocity.x, 0.333166, 5e-6);
    COMPARE_NEAR(run[0].velocity.y, 0.0, 1e-12);
}

void TestContinuousStep::restitutionScalesTheRelativeNormalSpeed_data()
{
    QTest::addColumn<double>("restitution");
    for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0})
        QTest::addRow("e = %g", e) << e;
}

void TestContinuousStep::restitutionScalesTheRelativeNormalSpeed()
{
    QFETCH(double, restitution);
    Preset preset = scene({circle({-1, 0.125}, {2, 0.5}, 0.2), circle({1, 0}, {-1, 0.25}, 0.3)},
                          lawsOf(CircleLaw::Impulse));
    preset.restitution = restitution;
    Run run(preset);
    run.steps(60);
    QVERIFY(!run.hits.empty());
    const Hit &hit = run.hits[0];
    const double before = dot(hit.beforeA - hit.beforeB, hit.normal);
    const double after = dot(hit.afterB - hit.afterA, hit.normal);
    COMPARE_NEAR(after, restitution * before, 1e-12 * before);
    COMPARE_NEAR(cross(hit.normal, hit.afterA), cross(hit.normal, hit.beforeA), 1e-12);
    COMPARE_NEAR(cross(hit.normal, hit.afterB), cross(hit.normal, hit.beforeB), 1e-12);

    // Masses as 8 : 27
    const Vec2 p0 = 8.0 * hit.beforeA + 27.0 * hit.beforeB;
    const Vec2 p1 = 8.0 * hit.afterA + 27.0 * hit.afterB;
    COMPARE_NEAR(p1.x, p0.x, 1e-12 * 43.0);
    COMPARE_NEAR(p1.y, p0.y, 1e-12 * 43.0);
    const double k0 = 0.5 * (8.0 * lengthSquared(hit.beforeA) + 27.0 * lengthSquared(hit.beforeB));
    const double k1 = 0.5 * (8.0 * lengthSquared(hit.afterA) + 27.0 * lengthSquared(hit.afterB));
    const double reduced = 8.0 * 27.0 / 35.0;
    const double loss = (1.0 - restitution * restitution) * 0.5 * reduced * before * before;
    COMPARE_NEAR(k0 - k1, loss, 1e-12 * k0);
}

void TestContinuousStep::eachLawGivesItsVelocities_data()
{
    QTest::addColumn<CircleLaw>("law");
    QTest::addColumn<Vec2>("afterA"); // of (3, 1), steel
    QTest::addColumn<Vec2>("afterB"); // of (−3, 1), twice as dense; e = ½
    QTest::newRow("stop") << CircleLaw::Stop << Vec2{} << Vec2{};
    QTest::newRow("swap velocities") << CircleLaw::SwapVelocities << Vec2{-3, 1} << Vec2{3, 1};
    QTest::newRow("swap normal") << CircleLaw::SwapNormal << Vec2{-3, 1} << Vec2{3, 1};
    // Closing 6, μ = ⅔ m: J = 1.5 · ⅔ m · 6 = 6 m
    QTest::newRow("impulse") << CircleLaw::Impulse << Vec2{-3, 1} << Vec2{0, 1};
}

void TestContinuousStep::eachLawGivesItsVelocities()
{
    QFETCH(CircleLaw, law);
    QFETCH(Vec2, afterA);
    QFETCH(Vec2, afterB);
    Preset preset = scene({circle({-0.5, 0}, {3, 1}, 0.2, Integrator::Euler, 7.8),
                           circle({0.5, 0}, {-3, 1}, 0.2, Integrator::Verlet, 15.6)},
                          lawsOf(law));
    preset.restitution = 0.5;
    Run run(preset);
    run.steps(12); // 0.2 s; they meet at 0.6/6 = 0.1 s at x = ∓0.2, y = 0.1
    QCOMPARE(run.hits.size(), std::size_t{1});
    COMPARE_NEAR(run.hits[0].time, 0.1, 1e-13);
    COMPARE_NEAR(run[0].velocity.x, afterA.x, 1e-13);
    COMPARE_NEAR(run[0].velocity.y, afterA.y, 1e-13);
    COMPARE_NEAR(run[1].velocity.x, afterB.x, 1e-13);
    COMPARE_NEAR(run[1].velocity.y, afterB.y, 1e-13);
    COMPARE_NEAR(run[0].position.x, -0.2 + 0.1 * afterA.x, 1e-13);
    COMPARE_NEAR(run[1].position.x, 0.2 + 0.1 * afterB.x, 1e-13);
    COMPARE_NEAR(run[0].position.y, 0.1 + 0.1 * afterA.y, 1e-13);
}

void TestContinuousStep::circlesWithoutLawPassThroughEachOther()
{
    Run run(scene({circle({-2, 2}, {2, 0}), circle({2, 2}, {0, 0})}, lawsOf(CircleLaw::None)));
    run.steps(120);
    QVERIFY(run.hits.empty());
    COMPARE_NEAR(run[0].position.x, 2.0, 1e-12);
    QVERIFY(run[1].velocity == Vec2{});
}

void TestContinuousStep::touchingCirclesThatLeaveAreLeftAlone()
{
    for (const CircleLaw law :
         {CircleLaw::Stop, CircleLaw::SwapVelocities, CircleLaw::SwapNormal, CircleLaw::Impulse}) {
        Run run(scene({circle({-0.25, 0}, {-1, 0}, 0.25), circle({0.25, 0}, {1, 0}, 0.25)},
                      lawsOf(law)));
        run.steps(60);
        QVERIFY(run.hits.empty());
        COMPARE_NEAR(run[1].position.x, 1.25, 1e-13);
    }
}

void TestContinuousStep::nothingIsJumpedOver()
{
    // 10 m/s · 0.1 s is more than both circles are wide.
    Preset preset = scene({circle({-3, 0}, {10, 0}, 0.05), circle({0, 0}, {}, 0.05)},
                          lawsOf(CircleLaw::Impulse));
    preset.timestep = 0.1;
    Run run(preset);
    run.steps(4);
    QCOMPARE(run.hits.size(), std::size_t{1});
    COMPARE_NEAR(run.hits[0].time, 0.29, 1e-13);
    COMPARE_NEAR(run[0].position.x, -0.1, 1e-13);
    COMPARE_NEAR(run[1].position.x, 1.1, 1e-13);
}

void TestContinuousStep::newtonsCradleOneInOneOut_data()
{
    QTest::addColumn<CircleLaw>("law");
    QTest::newRow("swap velocities") << CircleLaw::SwapVelocities;
    QTest::newRow("swap normal") << CircleLaw::SwapNormal;
    QTest::newRow("impulse") << CircleLaw::Impulse;
}

void TestContinuousStep::newtonsCradleOneInOneOut()
{
    QFETCH(CircleLaw, law);
    // Four in touch and a fifth that comes at 2 m/s over a gap of 1 m.
    Preset preset =
        scene({circle({-2, 0}, {2, 0}, 0.25), circle({-0.5, 0}, {}, 0.25), circle({0, 0}, {}, 0.25),
               circle({0.5, 0}, {}, 0.25), circle({1, 0}, {}, 0.25)},
              lawsOf(law));
    preset.timestep = 1.0 / 64.0;
    Run run(preset);
    run.steps(64); // 1 s: ½ s to the contact, ½ s after it
    const double places[] = {-1, -0.5, 0, 0.5, 2};
    for (std::size_t i = 0; i < 5; ++i) {
        COMPARE_NEAR(run[i].velocity.x, i == 4 ? 2.0 : 0.0, 1e-12);
        COMPARE_NEAR(run[i].position.x, places[i], 1e-12);
        QCOMPARE(run[i].velocity.y, 0.0);
    }
    QCOMPARE(run.hits.size(), std::size_t{4});
    // The wall sends it back, and the first one leaves to the left.
    run.steps(208); // to 4.25 s: 1.75 m to the wall and 2.75 m … back, then away
    COMPARE_NEAR(run[4].velocity.x, 0.0, 1e-12);
    COMPARE_NEAR(std::abs(run[0].velocity.x), 2.0, 1e-12);
}

void TestContinuousStep::twoIntegratorsMeetWhereTheirPathsMeet()
{
    // Within the first step Euler stays on its straight line, Verlet falls by ½ g s²: from
    // 5 mm above touch, thrown down at 0.3 m/s, it meets the other at 0.005 = 0.3 s + ½ g s².
    Preset preset = scene({circle({0, 0}, {}, 0.2, Integrator::Euler),
                           circle({0, 0.405}, {0, -0.3}, 0.2, Integrator::Verlet)},
                          lawsOf(CircleLaw::Impulse));
    preset.gravity = {0, -g};
    Run run(preset);
    run.steps(1);
    QCOMPARE(run.hits.size(), std::size_t{1});
    const double s = (std::sqrt(0.09 + 0.01 * g) - 0.3) / g;
    COMPARE_NEAR(run.hits[0].time, s, 1e-12);
    QVERIFY(run.hits[0].normal == (Vec2{0, 1}));
    // Equal masses, elastic: the 0.3 m/s by which they close change hands.
    COMPARE_NEAR(run.hits[0].afterA.y, -g * s - 0.3, 1e-12);
    COMPARE_NEAR(run.hits[0].afterB.y, -g * s, 1e-12);
}

void TestContinuousStep::noCirclesIsAWorldToo()
{
    Run run(scene({}, lawsOf(CircleLaw::Impulse)));
    run.steps(3);
    QCOMPARE(run.world.step, qint64{3});
    QCOMPARE(run.world.time, 3.0 * dt);
}

/// Let go above each other, the upper by symplectic Euler, the lower by Euler: in the first step
/// only the upper falls, by g h², five times what is between them. It is stopped at the rim.
void TestContinuousStep::unlikeIntegratorsMeetWithinAStep()
{
    constexpr double gap = 5e-4;
    Preset preset = scene({circle({0, 0.4 + gap}, {}, 0.2, Integrator::SymplecticEuler),
                           circle({0, 0}, {}, 0.2, Integrator::Euler)},
                          lawsOf(CircleLaw::Impulse));
    preset.gravity = {0, -g};
    Run run(preset);
    run.steps(1);
    QVERIFY(length(run[0].position - run[1].position) >= 0.4 - 1e-9);
}

QTEST_APPLESS_MAIN(TestContinuousStep)
#include "test_continuous_step.moc"
