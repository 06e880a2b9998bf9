// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/discrete_step.h"

#include "model/world/measurements.h"
#include "tests/scenes.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr Laws walls{WallLaw::Reflect, CircleLaw::None, Timing::Discrete};

Laws lawsOf(CircleLaw law)
{
    return {WallLaw::Reflect, law, Timing::Discrete};
}

} // namespace

/// The lab's own way of a hit: back to the old place, and respond.
class TestDiscreteStep : public QObject
{
    Q_OBJECT
private slots:
    void aWallHitGoesBackAndReflects_data();
    void aWallHitGoesBackAndReflects();
    void aCornerReflectsBothParts();
    void onTheWayBackAWallDoesNothing();
    void withoutWallsCirclesLeave();
    void from24DirectionsNothingLeavesTheSquare_data();
    void from24DirectionsNothingLeavesTheSquare();
    void circlesThatMeetGoBackAndRespond_data();
    void circlesThatMeetGoBackAndRespond();
    void touchingCirclesThatLeaveAreLeftAlone_data();
    void touchingCirclesThatLeaveAreLeftAlone();
    void overlappingCirclesThatApproachAreParted();
    void circlesWithoutLawPassThroughEachOther();
    void theLastNormalIsThatOfTheOldPositions();
    void aNewtonsCradleOfTwoPassesTheVelocityOn();
    void aHitIsReportedWithAllItsParts();
};

void TestDiscreteStep::aWallHitGoesBackAndReflects_data()
{
    QTest::addColumn<Vec2>("position");
    QTest::addColumn<Vec2>("velocity");
    QTest::addColumn<Vec2>("after"); // e = ½
    QTest::addColumn<int>("wall");
    // 3 m/s is 0.05 m a step: from 3.78 the rim would reach 4.03.
    QTest::newRow("right") << Vec2{3.78, 1} << Vec2{3, 0.5} << Vec2{-1.5, 0.5} << int(Wall::Right);
    QTest::newRow("left") << Vec2{-3.78, 1} << Vec2{-3, 0.5} << Vec2{1.5, 0.5} << int(Wall::Left);
    QTest::newRow("top") << Vec2{1, 3.78} << Vec2{0.5, 3} << Vec2{0.5, -1.5} << int(Wall::Top);
    QTest::newRow("bottom") << Vec2{1, -3.78} << Vec2{0.5, -3} << Vec2{0.5, 1.5}
                            << int(Wall::Bottom);
}

void TestDiscreteStep::aWallHitGoesBackAndReflects()
{
    QFETCH(Vec2, position);
    QFETCH(Vec2, velocity);
    QFETCH(Vec2, after);
    QFETCH(int, wall);
    Preset preset = scene({circle(position, velocity)}, walls);
    preset.restitution = 0.5;
    Run run(preset);
    run.steps(1);
    QVERIFY(run[0].position == position);
    QVERIFY(run[0].velocity == after);
    QCOMPARE(run.hits.size(), std::size_t{1});
    QVERIFY(run.hits[0].kind == Hit::Kind::Wall);
    QCOMPARE(run.hits[0].b, wall);
    // And then it moves away.
    run.steps(1);
    QVERIFY(run[0].position == position + dt * after);
    QCOMPARE(run.hits.size(), std::size_t{1});
}

void TestDiscreteStep::aCornerReflectsBothParts()
{
    Run run(scene({circle({3.78, -3.78}, {3, -3})}, walls));
    run.steps(1);
    QVERIFY(run[0].velocity == (Vec2{-3, 3}));
    QVERIFY(run[0].position == (Vec2{3.78, -3.78}));
    QCOMPARE(run.hits.size(), std::size_t{2});
}

void TestDiscreteStep::onTheWayBackAWallDoesNothing()
{
    // Beyond the wall but on the way in: the lab's "jitter" does not happen.
    Run run(scene({circle({3.9, 0}, {-1, 0})}, walls));
    run.steps(3);
    QVERIFY(run[0].velocity == (Vec2{-1, 0}));
    QVERIFY(run.hits.empty());
}

void TestDiscreteStep::withoutWallsCirclesLeave()
{
    Run run(scene({circle({3.78, 0}, {3, 0})}, {WallLaw::None, CircleLaw::None, Timing::Discrete}));
    run.steps(60);
    COMPARE_NEAR(run[0].position.x, 6.78, 1e-12);
    QVERIFY(run.hits.empty());
}

void TestDiscreteStep::from24DirectionsNothingLeavesTheSquare_data()
{
    QTest::addColumn<double>("timestep");
    QTest::addColumn<int>("direction"); // times 15°
    for (const double timestep : {1.0 / 60.0, 0.1, 0.001}) {
        for (int direction = 0; direction < 24; ++direction) {
            QTest::addRow("%g s, %d degrees", timestep, 15 * direction) << timestep << direction;
        }
    }
}

void TestDiscreteStep::from24DirectionsNothingLeavesTheSquare()
{
    QFETCH(double, timestep);
    QFETCH(int, direction);
    const double angle = direction * pi / 12.0;
    const Vec2 velocity{3.0 * std::cos(angle), 3.0 * std::sin(angle)};
    Preset preset = scene({circle({0.5, -0.25}, velocity)}, walls);
    preset.timestep = timestep;
    Run run(preset);
    const int count = static_cast<int>(20.0 / timestep);
    double furthest = 0.0;
    for (int i = 0; i < count; ++i) {
        run.steps(1);
        const Circle &c = run[0];
        furthest = std::max({furthest, std::abs(c.position.x), std::abs(c.position.y)});
        QCOMPARE(std::abs(c.velocity.x), std::abs(velocity.x));
        QCOMPARE(std::abs(c.velocity.y), std::abs(velocity.y));
    }
    // It goes back on a hit, so the rim stays inside, and it does come near.
    QVERIFY(furthest <= halfWidth - 0.2);
    QVERIFY(furthest >= halfWidth - 0.2 - 3.0 * timestep);
    QVERIFY(!run.hits.empty());
}

void TestDiscreteStep::circlesThatMeetGoBackAndRespond_data()
{
    QTest::addColumn<CircleLaw>("law");
    QTest::addColumn<Vec2>("afterA"); // of (3, 1), steel
    QTest::addColumn<Vec2>("afterB"); // of (−3, 0), twice as dense; e = ½
    QTest::newRow("stop") << CircleLaw::Stop << Vec2{} << Vec2{};
    QTest::newRow("swap velocities") << CircleLaw::SwapVelocities << Vec2{-3, 0} << Vec2{3, 1};
    QTest::newRow("swap normal") << CircleLaw::SwapNormal << Vec2{-3, 1} << Vec2{3, 0};
    // Closing 6, μ = ⅔ m: J = 1.5 · ⅔ m · 6 = 6 m
    QTest::newRow("impulse") << CircleLaw::Impulse << Vec2{-3, 1} << Vec2{0, 0};
}

void TestDiscreteStep::circlesThatMeetGoBackAndRespond()
{
    QFETCH(CircleLaw, law);
    QFETCH(Vec2, afterA);
    QFETCH(Vec2, afterB);
    // 0.42 apart, closing at 0.1 m a step.
    Preset preset = scene({circle({-0.21, 0}, {3, 1}, 0.2, Integrator::Euler, 7.8),
                           circle({0.21, 0}, {-3, 0}, 0.2, Integrator::Euler, 15.6)},
                          lawsOf(law));
    preset.restitution = 0.5;
    Run run(preset);
    run.steps(1);
    QVERIFY(run[0].position == (Vec2{-0.21, 0}));
    QVERIFY(run[1].position == (Vec2{0.21, 0}));
    for (const auto &[found, wanted] :
         {std::pair{run[0].velocity, afterA}, std::pair{run[1].velocity, afterB}}) {
        COMPARE_NEAR(found.x, wanted.x, 1e-14);
        COMPARE_NEAR(found.y, wanted.y, 1e-14);
    }
    QCOMPARE(run.hits.size(), std::size_t{1});
}

void TestDiscreteStep::touchingCirclesThatLeaveAreLeftAlone_data()
{
    QTest::addColumn<CircleLaw>("law");
    QTest::newRow("stop") << CircleLaw::Stop;
    QTest::newRow("swap velocities") << CircleLaw::SwapVelocities;
    QTest::newRow("swap normal") << CircleLaw::SwapNormal;
    QTest::newRow("impulse") << CircleLaw::Impulse;
}

void TestDiscreteStep::touchingCirclesThatLeaveAreLeftAlone()
{
    QFETCH(CircleLaw, law);
    // Even where they overlap, as after a hit that was seen late.
    Run run(scene({circle({-0.15, 0}, {-1, 0}), circle({0.15, 0}, {1, 0})}, lawsOf(law)));
    run.steps(2);
    QVERIFY(run.hits.empty());
    QVERIFY(run[0].velocity == (Vec2{-1, 0}));
    COMPARE_NEAR(run[1].position.x, 0.15 + 2.0 / 60.0, 1e-14);
}

void TestDiscreteStep::overlappingCirclesThatApproachAreParted()
{
    Run run(scene({circle({-0.15, 0}, {1, 0}), circle({0.15, 0}, {-1, 0})},
                  lawsOf(CircleLaw::Impulse)));
    run.steps(60);
    QCOMPARE(run.hits.size(), std::size_t{1});
    COMPARE_NEAR(run[0].velocity.x, -1.0, 1e-14);
    COMPARE_NEAR(run[1].velocity.x, 1.0, 1e-14);
}

void TestDiscreteStep::circlesWithoutLawPassThroughEachOther()
{
    Run run(scene({circle({-2, 2}, {2, 0}), circle({2, 2}, {0, 0})}, walls));
    run.steps(120); // 2 s
    QVERIFY(run.hits.empty());
    COMPARE_NEAR(run[0].position.x, 2.0, 1e-12);
    QVERIFY(run[1].position == (Vec2{2, 2}));
}

void TestDiscreteStep::theLastNormalIsThatOfTheOldPositions()
{
    // So fast that they have passed each other after the step: the normal still points onward.
    Run run(scene({circle({-0.25, 0}, {18, 0}), circle({0.25, 0}, {-18, 0})},
                  lawsOf(CircleLaw::Impulse)));
    run.steps(1);
    QCOMPARE(run.hits.size(), std::size_t{1});
    QVERIFY(run.hits[0].normal == (Vec2{1, 0}));
    COMPARE_NEAR(run[0].velocity.x, -18.0, 1e-13);
}

void TestDiscreteStep::aNewtonsCradleOfTwoPassesTheVelocityOn()
{
    Run run(scene({circle({-2, 2}, {2, 0}), circle({2, 2}, {0, 0})},
                  lawsOf(CircleLaw::SwapVelocities)));
    // To the contact 1.8 s, to the wall 0.9 s, back 0.9 s: then the first one is off again.
    run.steps(150);
    QVERIFY(run[0].velocity == Vec2{});
    QVERIFY(run[1].velocity == (Vec2{2, 0}));
    run.steps(45);
    QVERIFY(run[1].velocity == (Vec2{-2, 0}));
    run.steps(60);
    QVERIFY(run[0].velocity == (Vec2{-2, 0}));
    QVERIFY(run[1].velocity == Vec2{});
}

void TestDiscreteStep::aHitIsReportedWithAllItsParts()
{
    Preset preset =
        scene({circle({-0.21, 0}, {3, 0}), circle({0.21, 0}, {-3, 0})}, lawsOf(CircleLaw::Impulse));
    Run run(preset);
    run.steps(1);
    QCOMPARE(run.hits.size(), std::size_t{1});
    const Hit &hit = run.hits[0];
    QVERIFY(hit.kind == Hit::Kind::Circle);
    QCOMPARE(hit.step, qint64{1});
    QCOMPARE(hit.time, dt);
    QCOMPARE(hit.a, 0);
    QCOMPARE(hit.b, 1);
    QVERIFY(hit.normal == (Vec2{1, 0}));
    QVERIFY(hit.beforeA == (Vec2{3, 0}));
    QVERIFY(hit.beforeB == (Vec2{-3, 0}));
    COMPARE_NEAR(hit.afterA.x, -3.0, 1e-14);
    COMPARE_NEAR(hit.afterB.x, 3.0, 1e-14);
    // J = m Δv with m = 261.3805… kg
    COMPARE_NEAR(hit.impulse, 261.380508778670797 * 6.0, 1e-9);
}

QTEST_APPLESS_MAIN(TestDiscreteStep)
#include "test_discrete_step.moc"
