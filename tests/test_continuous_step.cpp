// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous_step.h"

#include "model/measurements.h"
#include "tests/scenes.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

Q_DECLARE_METATYPE(cradle::Vec2)
Q_DECLARE_METATYPE(cradle::CircleLaw)
Q_DECLARE_METATYPE(cradle::Integrator)
Q_DECLARE_METATYPE(cradle::Preset)

namespace {

constexpr int minute = 3600; // steps of 1/60 s
constexpr double room = halfWidth - 0.2;

Laws lawsOf(CircleLaw law)
{
    return {WallLaw::Reflect, law, Timing::Continuous};
}

/// Where a point that flies straight between two elastic walls at ±room is: the straight line,
/// folded up.
double folded(double x)
{
    const double period = 4.0 * room;
    const double phase = x + room - period * std::floor((x + room) / period);
    return (phase <= 2.0 * room ? phase : period - phase) - room;
}

/// The circle glances off the other at T11 of the lab: 0.3 m beside its centre.
Preset glancing(CircleLaw law)
{
    return scene({circle({-2, 2.3}, {2, 0}), circle({2, 2}, {0, 0})}, lawsOf(law));
}

Vec2 mirrored(Vec2 v, bool acrossX)
{
    return acrossX ? Vec2{v.x, -v.y} : Vec2{-v.x, v.y};
}

/// How far the circles are from mirroring each other as they did at the start, m and m/s.
double asymmetry(const World &world, const World &start, bool acrossX)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < start.circles.size(); ++i) {
        const Vec2 image = mirrored(start.circles[i].position, acrossX);
        const auto partner = static_cast<std::size_t>(
            std::find_if(start.circles.begin(), start.circles.end(),
                         [&](const Circle &c) { return c.position == image; })
            - start.circles.begin());
        const Vec2 x =
            world.circles[i].position - mirrored(world.circles[partner].position, acrossX);
        const Vec2 v =
            world.circles[i].velocity - mirrored(world.circles[partner].velocity, acrossX);
        worst = std::max({worst, std::abs(x.x), std::abs(x.y), std::abs(v.x), std::abs(v.y)});
    }
    return worst;
}

/// A cue circle and a triangle of rows of r = ¼ m in touch, all on exactly representable
/// heights, pointing left.
Preset breakOf(int rows)
{
    Preset preset = scene({circle({-2.5, 0}, {3, 0}, 0.25)}, lawsOf(CircleLaw::Impulse));
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k <= row; ++k) {
            const double x = 0.5 * std::sqrt(0.75) * row;
            preset.circles.push_back(circle({x, 0.5 * k - 0.25 * row}, {}, 0.25));
        }
    }
    preset.timestep = 1.0 / 64.0;
    return preset;
}

/// The same scene turned by a quarter: what mirrored across x now mirrors across y.
Preset turned(Preset preset)
{
    for (PresetCircle &c : preset.circles) {
        c.body.position = {-c.body.position.y, c.body.position.x};
        c.body.velocity = {-c.body.velocity.y, c.body.velocity.x};
    }
    return preset;
}

} // namespace

class TestContinuousStep : public QObject
{
    Q_OBJECT
private slots:
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
    void wallsFoldTheStraightLine_data();
    void wallsFoldTheStraightLine();
    void wallTakesItsShareOfTheNormalPart_data();
    void wallTakesItsShareOfTheNormalPart();
    void intoTheCornerAndStraightBack();
    void aFastCircleHitsManyWallsInOneStep();
    void nothingIsJumpedOver();
    void theTimestepDoesNotMatterWithoutGravity();
    void stepsOfAnyLengthGiveTheSame();
    void newtonsCradleOneInOneOut_data();
    void newtonsCradleOneInOneOut();
    void mirroredScenesStayMirrored_data();
    void mirroredScenesStayMirrored();
    void restingOnTheFloorNeverSinks_data();
    void restingOnTheFloorNeverSinks();
    void aRestingCircleSlidesOnTheFloor();
    void gravityAsideHoldsAtTheWall();
    void twoIntegratorsMeetWhereTheirPathsMeet();
    void aPlasticHitIsOneHit();
    void aPlasticHitAgainstTheWallEndsAtOnce();
    void pilingUpAtAWallWithoutGravityDoesNotOverlap();
    void threeThatStickTogetherDoNotOverlap_data();
    void threeThatStickTogetherDoNotOverlap();
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

void TestContinuousStep::wallsFoldTheStraightLine_data()
{
    QTest::addColumn<double>("degrees");
    for (int direction = 0; direction < 24; ++direction)
        QTest::addRow("%d degrees", 15 * direction) << 15.0 * direction;
}

void TestContinuousStep::wallsFoldTheStraightLine()
{
    QFETCH(double, degrees);
    const Vec2 start{0.5, -0.25};
    const Vec2 velocity{3.0 * std::cos(degrees * pi / 180.0), 3.0 * std::sin(degrees * pi / 180.0)};
    Run run(scene({circle(start, velocity)}, lawsOf(CircleLaw::None)));
    for (int i = 1; i <= 1200; ++i) {
        run.steps(1);
        COMPARE_NEAR(run[0].position.x, folded(start.x + velocity.x * i * dt), 1e-11);
        COMPARE_NEAR(run[0].position.y, folded(start.y + velocity.y * i * dt), 1e-11);
        QVERIFY(std::max(std::abs(run[0].position.x), std::abs(run[0].position.y)) <= room + 1e-12);
        QCOMPARE(std::abs(run[0].velocity.x), std::abs(velocity.x));
        QCOMPARE(std::abs(run[0].velocity.y), std::abs(velocity.y));
    }
}

void TestContinuousStep::wallTakesItsShareOfTheNormalPart_data()
{
    QTest::addColumn<double>("restitution");
    QTest::addColumn<Vec2>("velocity");
    QTest::addColumn<int>("wall");
    for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        QTest::addRow("right, e = %g", e) << e << Vec2{3.8, 0.5} << int(Wall::Right);
        QTest::addRow("left, e = %g", e) << e << Vec2{-3.8, 0.5} << int(Wall::Left);
        QTest::addRow("top, e = %g", e) << e << Vec2{0.5, 3.8} << int(Wall::Top);
        QTest::addRow("bottom, e = %g", e) << e << Vec2{0.5, -3.8} << int(Wall::Bottom);
    }
}

void TestContinuousStep::wallTakesItsShareOfTheNormalPart()
{
    QFETCH(double, restitution);
    QFETCH(Vec2, velocity);
    QFETCH(int, wall);
    Preset preset = scene({circle({0, 0}, velocity)}, lawsOf(CircleLaw::None));
    preset.restitution = restitution;
    Run run(preset);
    run.steps(90); // 1.5 s; the wall is met at 1 s
    const Vec2 n = outwardNormal(static_cast<Wall>(wall));
    QCOMPARE(run.hits.size(), std::size_t{1});
    COMPARE_NEAR(run.hits[0].time, 1.0, 1e-12);
    QCOMPARE(run.hits[0].b, wall);
    QVERIFY(run.hits[0].normal == n);
    COMPARE_NEAR(dot(run[0].velocity, n), -3.8 * restitution, 1e-13);
    COMPARE_NEAR(dot(run[0].position, n), 3.8 - 0.5 * 3.8 * restitution, 1e-12);
    // The part along the wall stays: 0.5 m/s for 1.5 s.
    COMPARE_NEAR(std::abs(cross(run[0].velocity, n)), 0.5, 0.0);
    COMPARE_NEAR(std::abs(cross(run[0].position, n)), 0.75, 1e-13);
}

void TestContinuousStep::intoTheCornerAndStraightBack()
{
    Run run(scene({circle({0, 0}, {2, -2})}, lawsOf(CircleLaw::None)));
    run.steps(228); // to the corner in 1.9 s and back
    COMPARE_NEAR(run[0].position.x, 0.0, 1e-12);
    COMPARE_NEAR(run[0].position.y, 0.0, 1e-12);
    QVERIFY(run[0].velocity == (Vec2{-2, 2}));
    QCOMPARE(run.hits.size(), std::size_t{2});
}

void TestContinuousStep::aFastCircleHitsManyWallsInOneStep()
{
    // 0.1 s at 1000 m/s is 100 m: thirteen widths of the room.
    Preset preset = scene({circle({0.5, 0}, {1000, 0})}, lawsOf(CircleLaw::None));
    preset.timestep = 0.1;
    Run run(preset);
    run.steps(1);
    COMPARE_NEAR(run[0].position.x, folded(100.5), 1e-10);
    QCOMPARE(run.hits.size(), std::size_t{13}); // at 3.8 + 7.6 k ≤ 100.5: k = 0 … 12
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

void TestContinuousStep::theTimestepDoesNotMatterWithoutGravity()
{
    Preset preset = glancing(CircleLaw::Impulse);
    preset.timestep = 1.0 / 64.0;
    Run fine(preset);
    fine.steps(320); // 5 s
    preset.timestep = 1.0 / 16.0;
    Run coarse(preset);
    coarse.steps(80);
    QCOMPARE(coarse.hits.size(), fine.hits.size());
    for (std::size_t i = 0; i < 2; ++i) {
        COMPARE_NEAR(coarse[i].position.x, fine[i].position.x, 1e-11);
        COMPARE_NEAR(coarse[i].position.y, fine[i].position.y, 1e-11);
    }
}

void TestContinuousStep::stepsOfAnyLengthGiveTheSame()
{
    Run even(glancing(CircleLaw::Impulse));
    even.steps(300); // 5 s
    Run uneven(glancing(CircleLaw::Impulse));
    for (int i = 0; i < 100; ++i) {
        for (const double part : {0.01, 0.0, 0.035, 0.005})
            uneven.stepper.advanceBy(uneven.world, part, uneven.hits);
    }
    COMPARE_NEAR(uneven.world.time, 5.0, 1e-12);
    QCOMPARE(uneven.hits.size(), even.hits.size());
    for (std::size_t i = 0; i < 2; ++i) {
        COMPARE_NEAR(uneven[i].position.x, even[i].position.x, 1e-11);
        COMPARE_NEAR(uneven[i].position.y, even[i].position.y, 1e-11);
    }
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

void TestContinuousStep::mirroredScenesStayMirrored_data()
{
    QTest::addColumn<Preset>("preset");
    QTest::addColumn<bool>("acrossX");
    Preset pair = scene(
        {circle({-2, 0}, {2, 0}, 0.25), circle({0, 0.25}, {}, 0.25), circle({0, -0.25}, {}, 0.25)},
        lawsOf(CircleLaw::Impulse));
    pair.timestep = 1.0 / 64.0;
    Preset four = scene({circle({2, 0}, {-1, 0}, 0.25), circle({-2, 0}, {1, 0}, 0.25),
                         circle({0, 2}, {0, -1}, 0.25), circle({0, -2}, {0, 1}, 0.25)},
                        lawsOf(CircleLaw::Impulse));
    four.timestep = 1.0 / 64.0;
    const std::pair<const char *, Preset> scenes[] = {{"one hits two that touch", pair},
                                                      {"break of three", breakOf(2)},
                                                      {"break of six", breakOf(3)}};
    for (const auto &[name, preset] : scenes) {
        for (const double e : {1.0, 0.5}) {
            Preset p = preset;
            p.restitution = e;
            QTest::addRow("%s, e = %g, across x", name, e) << p << true;
            QTest::addRow("%s, e = %g, across y", name, e) << turned(p) << false;
        }
    }
    QTest::newRow("four to the centre, across x") << four << true;
    QTest::newRow("four to the centre, across y") << four << false;
}

void TestContinuousStep::mirroredScenesStayMirrored()
{
    QFETCH(Preset, preset);
    QFETCH(bool, acrossX);
    Run run(preset);
    const World start = run.world;
    for (int i = 0; i < 1280; ++i) { // 20 s
        run.steps(1);
        // Bit for bit: rounding is symmetric, too, where the sums are.
        COMPARE_NEAR(asymmetry(run.world, start, acrossX), 0.0, 0.0);
    }
    QVERIFY(run.hits.size() >= 4);
}

void TestContinuousStep::restingOnTheFloorNeverSinks_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("height"); // of the rim above the floor at the start, m
    for (const Integrator integrator : allIntegrators) {
        for (const double e : {0.0, 0.5, 0.9}) {
            for (const double height : {0.0, 3.8}) {
                QTest::addRow("%s, e = %g, from %g m", shortName(integrator), e, height)
                    << integrator << e << height;
            }
        }
    }
}

void TestContinuousStep::restingOnTheFloorNeverSinks()
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

void TestContinuousStep::aRestingCircleSlidesOnTheFloor()
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

void TestContinuousStep::gravityAsideHoldsAtTheWall()
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

void TestContinuousStep::aPlasticHitIsOneHit()
{
    // With e = 0 they go on with a common normal velocity: what rounding leaves is no hit.
    Preset preset = scene({circle({-1, 0.125}, {2, 0.5}, 0.2), circle({1, 0}, {-1, 0.25}, 0.3)},
                          lawsOf(CircleLaw::Impulse));
    preset.restitution = 0.0;
    Run run(preset);
    run.steps(60);
    QCOMPARE(run.hits.size(), std::size_t{1});
}

void TestContinuousStep::aPlasticHitAgainstTheWallEndsAtOnce()
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

void TestContinuousStep::pilingUpAtAWallWithoutGravityDoesNotOverlap()
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

void TestContinuousStep::threeThatStickTogetherDoNotOverlap_data()
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

void TestContinuousStep::threeThatStickTogetherDoNotOverlap()
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

void TestContinuousStep::noCirclesIsAWorldToo()
{
    Run run(scene({}, lawsOf(CircleLaw::Impulse)));
    run.steps(3);
    QCOMPARE(run.world.step, qint64{3});
    QCOMPARE(run.world.time, 3.0 * dt);
}

QTEST_APPLESS_MAIN(TestContinuousStep)
#include "test_continuous_step.moc"
