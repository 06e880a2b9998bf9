// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_step.h"

#include "model/world/measurements.h"

#include "tests/continuous_scenes.h"
#include "tests/falls.h"
#include "tests/scenes.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

/// What lies, slides and sticks together with continuous timing.
class TestContinuousRest : public QObject
{
    Q_OBJECT
private slots:
    void restingOnTheFloorNeverSinks_data();
    void restingOnTheFloorNeverSinks();
    void aRestingCircleSlidesOnTheFloor();
    void gravityAsideHoldsAtTheWall();
    void whoFallsOnWhatLiesHitsInThatStep_data();
    void whoFallsOnWhatLiesHitsInThatStep();
    void aPlasticHitIsOneHit();
    void elasticHopsAreNoRest();
    void aPlasticHitAgainstTheWallEndsAtOnce();
    void pilingUpAtAWallWithoutGravityDoesNotOverlap();
    void aDeepOverlapShrinksSlowly();
    void whatLiesInTheFloorIsNotLifted();
    void threeThatStickTogetherDoNotOverlap_data();
    void threeThatStickTogetherDoNotOverlap();
};

void TestContinuousRest::restingOnTheFloorNeverSinks_data()
{
    addFalls();
}

void TestContinuousRest::restingOnTheFloorNeverSinks()
{
    QFETCH(Integrator, integrator);
    QFETCH(double, restitution);
    QFETCH(double, height);
    Preset preset =
        scene({circle({0.5, -3.8 + height}, {}, 0.2, integrator)}, lawsOf(CircleLaw::Impulse));
    preset.gravity = {0, -g};
    preset.restitution = restitution;
    Run run(preset);
    for (int i = 0; i < minute; ++i) {
        run.steps(1);
        QVERIFY(run[0].position.y - 0.2 >= -halfWidth - 1e-9);
        if (integrator != Integrator::Euler) {
            const double energy =
                0.5 * lengthSquared(run[0].velocity) + g * (run[0].position.y + 3.8);
            QVERIFY(energy <= g * height + 1e-9);
        }
    }
    // About one hit a step at the very most; and at rest none.
    QVERIFY2(run.hits.size() <= minute, QByteArray::number(qint64(run.hits.size())).constData());
    if (integrator != Integrator::Euler) {
        QVERIFY(run[0].velocity == Vec2{});
        COMPARE_NEAR(run[0].position.y, -3.8, 1e-9);
    }
}

void TestContinuousRest::aRestingCircleSlidesOnTheFloor()
{
    for (const Integrator integrator : allIntegrators) {
        Preset preset =
            scene({circle({-3, -3.8}, {0.5, 0}, 0.2, integrator)}, lawsOf(CircleLaw::None));
        preset.gravity = {0, -g};
        preset.restitution = 0.5;
        Run run(preset);
        run.steps(600); // 10 s: no friction
        COMPARE_NEAR(run[0].position.x, 2.0, 1e-11);
        COMPARE_NEAR(run[0].position.y, -3.8, 1e-12);
        QCOMPARE(run[0].velocity.x, 0.5);
    }
}

void TestContinuousRest::gravityAsideHoldsAtTheWall()
{
    // Gravity into the corner on the right above.
    Preset preset = scene({circle({3, 3}, {}, 0.2)}, lawsOf(CircleLaw::None));
    preset.gravity = {3, 4};
    preset.restitution = 0.5;
    Run run(preset);
    run.steps(1200);
    COMPARE_NEAR(run[0].position.x, 3.8, 1e-9);
    COMPARE_NEAR(run[0].position.y, 3.8, 1e-9);
    QVERIFY(run[0].velocity == Vec2{});
}

void TestContinuousRest::whoFallsOnWhatLiesHitsInThatStep_data()
{
    QTest::addColumn<Vec2>("down");
    QTest::newRow("down") << Vec2{0, -1};
    QTest::newRow("up") << Vec2{0, 1};
    QTest::newRow("to the left") << Vec2{-1, 0};
    QTest::newRow("to the right") << Vec2{1, 0};
}

/// 17.5 mm above what lies: a step takes it v Δt = 16.7 mm, and g Δt² / 2 = 1.4 mm more.
void TestContinuousRest::whoFallsOnWhatLiesHitsInThatStep()
{
    QFETCH(Vec2, down);
    constexpr double gap = 17.5e-3;
    const Vec2 lies = room * down;
    Preset preset = scene({circle(lies, {0, 0}, 0.2, Integrator::Verlet),
                           circle(lies - (0.4 + gap) * down, down, 0.2, Integrator::Verlet)},
                          lawsOf(CircleLaw::Impulse));
    preset.gravity = g * down;
    preset.restitution = 0.5;
    Run run(preset);
    run.steps(1);
    const auto hit = std::find_if(run.hits.begin(), run.hits.end(),
                                  [](const Hit &each) { return each.kind == Hit::Kind::Circle; });
    QVERIFY(hit != run.hits.end());
    COMPARE_NEAR(hit->time, (std::sqrt(1.0 + 2.0 * g * gap) - 1.0) / g, 1e-9);
}

void TestContinuousRest::aPlasticHitIsOneHit()
{
    // With e = 0 they go on with a common normal velocity: what rounding leaves is no hit.
    Preset preset = scene({circle({-1, 0.125}, {2, 0.5}, 0.2), circle({1, 0}, {-1, 0.25}, 0.3)},
                          lawsOf(CircleLaw::Impulse));
    preset.restitution = 0.0;
    Run run(preset);
    run.steps(60);
    QCOMPARE(run.hits.size(), std::size_t{1});
}

void TestContinuousRest::aPlasticHitAgainstTheWallEndsAtOnce()
{
    // One circle stands at the wall, another runs into it: both stand, after few hits.
    Preset preset =
        scene({circle({3.8, 0}, {}), circle({3, 0}, {1, 0})}, lawsOf(CircleLaw::Impulse));
    preset.restitution = 0.0;
    Run run(preset);
    run.steps(60);
    COMPARE_NEAR(run[0].velocity.x, 0.0, 1e-9);
    COMPARE_NEAR(run[1].velocity.x, 0.0, 1e-9);
    COMPARE_NEAR(run[0].position.x, 3.8, 1e-9);
    COMPARE_NEAR(run[1].position.x, 3.4, 1e-9);
    QVERIFY2(run.hits.size() <= 50, QByteArray::number(qint64(run.hits.size())).constData());
}

void TestContinuousRest::pilingUpAtAWallWithoutGravityDoesNotOverlap()
{
    // A row of four flies into the wall, e = 0; aslant, so that they can give way.
    Preset preset = scene({circle({2, 0}, {3, 0}, 0.25), circle({1.25, 0.125}, {3, 0}, 0.25),
                           circle({0.5, -0.125}, {3, 0}, 0.25), circle({-0.25, 0}, {3, 0}, 0.25)},
                          lawsOf(CircleLaw::Impulse));
    preset.restitution = 0.0;
    Run run(preset);
    for (int i = 0; i < 300; ++i) {
        run.steps(1);
        for (std::size_t a = 0; a < 4; ++a) {
            QVERIFY(run[a].position.x <= halfWidth - 0.25 + 1e-9);
            for (std::size_t b = a + 1; b < 4; ++b) {
                const double distance = length(run[b].position - run[a].position);
                QVERIFY2(distance >= 0.5 - 1e-9, QByteArray::number(distance).constData());
            }
        }
    }
    QVERIFY2(run.hits.size() <= 500, QByteArray::number(qint64(run.hits.size())).constData());
}

void TestContinuousRest::aDeepOverlapShrinksSlowly()
{
    // No run begins so, but another timing may leave it: a tenth goes in a step, and no more than a
    // ten-thousandth of the radius, so that what is parted is not thrown. A thousandth stays: to
    // part what lies takes energy.
    Preset preset = scene({circle({0, -3.8}), circle({0, -3.4})}, lawsOf(CircleLaw::Impulse));
    preset.gravity = {0, -g};
    preset.restitution = 0.5;
    Run run(preset);
    const double most = 1e-4 * 0.2; // m in a step
    double depth = 20.5 * most;
    run.world.circles[1].position.y -= depth;
    for (int step = 0; step < 60; ++step) {
        run.steps(1);
        depth -= depth > 10.0 * most ? std::min(0.1 * depth, most) : 0.0;
        COMPARE_NEAR(-3.4 - run[1].position.y, depth, 1e-12);
        COMPARE_NEAR(length(run[1].velocity), 0.0, 1.01 * most / dt);
    }
    COMPARE_NEAR(depth, 9.5 * most, 1e-12);
    QVERIFY(run.hits.empty());
}

/// The pushes of a pile leave a circle a little in the floor, which it then falls onto.
void TestContinuousRest::whatLiesInTheFloorIsNotLifted()
{
    for (const double speed : {0.0, 1e-6, 1e-3}) {
        Preset preset = scene({circle({0, -3.8}, {0.5, -speed})}, lawsOf(CircleLaw::Impulse));
        preset.gravity = {0, -g};
        preset.restitution = 0.5;
        Run run(preset);
        const double depth = 1e-6;
        run.world.circles[0].position.y -= depth;
        const double start = measure(run.world.circles, preset.gravity, halfWidth).total();
        run.steps(60);
        COMPARE_NEAR(run[0].position.y, -3.8 - depth, 1e-12);
        COMPARE_NEAR(run[0].position.x, 0.5, 1e-12);
        QVERIFY(measure(run.world.circles, preset.gravity, halfWidth).total() <= start);
        QVERIFY(run.hits.size() <= 1);
    }
}

void TestContinuousRest::threeThatStickTogetherDoNotOverlap_data()
{
    QTest::addColumn<Preset>("preset");
    const Laws laws = lawsOf(CircleLaw::Impulse);
    QTest::newRow("the middle one squeezed") << scene({circle({-1.91, -2.07}, {3.75, 0.09}, 0.5),
                                                       circle({-0.23, -2.32}, {2.36, 0.41}, 0.5),
                                                       circle({1.89, -2.23}, {-0.66, 0.81}, 0.5)},
                                                      laws);
    QTest::newRow("and turned out") << scene({circle({-2.14, -2.18}, {4.68, 2.21}, 0.5),
                                              circle({0.07, -1.67}, {-2.48, 2.17}, 0.5),
                                              circle({2.32, -2.21}, {-3.41, 3.93}, 0.5)},
                                             laws);
}

void TestContinuousRest::threeThatStickTogetherDoNotOverlap()
{
    // e = 0, no gravity: what meets stays together and hands on what it is pushed with.
    QFETCH(Preset, preset);
    preset.restitution = 0.0;
    Run run(preset);
    for (int i = 0; i < 60; ++i) {
        run.steps(1);
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = a + 1; b < 3; ++b) {
                const double distance = length(run[b].position - run[a].position);
                QVERIFY2(distance >= 1.0 - 1e-9, QByteArray::number(distance).constData());
            }
        }
    }
    QVERIFY2(run.hits.size() <= 500, QByteArray::number(qint64(run.hits.size())).constData());
}

/// With e = 1 even a hop that is over within a step is a hop: what falls 0.1 mm onto a circle that
/// lies on the floor keeps its energy.
void TestContinuousRest::elasticHopsAreNoRest()
{
    constexpr double height = 1e-4;
    Preset preset =
        scene({circle({0, -3.8}), circle({0, -3.4 + height})}, lawsOf(CircleLaw::Impulse));
    preset.gravity = {0, -g};
    Run run(preset);
    const double start = measure(run.world.circles, preset.gravity, halfWidth).total();
    for (int step = 0; step < 60; ++step) {
        run.steps(1);
        const double now = measure(run.world.circles, preset.gravity, halfWidth).total();
        COMPARE_NEAR(now, start, 1e-8 * mass(run[0]) * g * height);
    }
    QVERIFY(run.hits.size() > 60);
}

QTEST_APPLESS_MAIN(TestContinuousRest)
#include "test_continuous_rest.moc"
