// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_step.h"

#include "tests/continuous_scenes.h"
#include "tests/scenes.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// Where a point that flies straight between two elastic walls at ±room is: the straight line,
/// folded up.
double folded(double x)
{
    const double period = 4.0 * room;
    const double phase = x + room - period * std::floor((x + room) / period);
    return (phase <= 2.0 * room ? phase : period - phase) - room;
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

/// The hits at walls inside a step, and steps of any length.
class TestContinuousWalls : public QObject
{
    Q_OBJECT
private slots:
    void aStepOfNoTimeChangesNothing();
    void wallsFoldTheStraightLine_data();
    void wallsFoldTheStraightLine();
    void wallTakesItsShareOfTheNormalPart_data();
    void wallTakesItsShareOfTheNormalPart();
    void intoTheCornerAndStraightBack();
    void aFastCircleHitsManyWallsInOneStep();
    void theTimestepDoesNotMatterWithoutGravity();
    void stepsOfAnyLengthGiveTheSame();
    void mirroredScenesStayMirrored_data();
    void mirroredScenesStayMirrored();
};

void TestContinuousWalls::wallsFoldTheStraightLine_data()
{
    QTest::addColumn<double>("degrees");
    for (int direction = 0; direction < 24; ++direction)
        QTest::addRow("%d degrees", 15 * direction) << 15.0 * direction;
}

void TestContinuousWalls::wallsFoldTheStraightLine()
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

void TestContinuousWalls::wallTakesItsShareOfTheNormalPart_data()
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

void TestContinuousWalls::wallTakesItsShareOfTheNormalPart()
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

void TestContinuousWalls::intoTheCornerAndStraightBack()
{
    Run run(scene({circle({0, 0}, {2, -2})}, lawsOf(CircleLaw::None)));
    run.steps(228); // to the corner in 1.9 s and back
    COMPARE_NEAR(run[0].position.x, 0.0, 1e-12);
    COMPARE_NEAR(run[0].position.y, 0.0, 1e-12);
    QVERIFY(run[0].velocity == (Vec2{-2, 2}));
    QCOMPARE(run.hits.size(), std::size_t{2});
}

void TestContinuousWalls::aFastCircleHitsManyWallsInOneStep()
{
    // 0.1 s at 1000 m/s is 100 m: thirteen widths of the room.
    Preset preset = scene({circle({0.5, 0}, {1000, 0})}, lawsOf(CircleLaw::None));
    preset.timestep = 0.1;
    Run run(preset);
    run.steps(1);
    COMPARE_NEAR(run[0].position.x, folded(100.5), 1e-10);
    QCOMPARE(run.hits.size(), std::size_t{13}); // at 3.8 + 7.6 k ≤ 100.5: k = 0 … 12
}

void TestContinuousWalls::theTimestepDoesNotMatterWithoutGravity()
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

void TestContinuousWalls::stepsOfAnyLengthGiveTheSame()
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

void TestContinuousWalls::mirroredScenesStayMirrored_data()
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

void TestContinuousWalls::mirroredScenesStayMirrored()
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

/// A step of 0 s leaves everything as it was, and so do all after it.
void TestContinuousWalls::aStepOfNoTimeChangesNothing()
{
    Preset preset =
        scene({circle({0, 3}, {1, 0}), circle({2, 3}, {-1, 0})}, lawsOf(CircleLaw::Impulse));
    preset.gravity = {0, -g};
    preset.restitution = 0.5;
    Run plain(preset);
    Run halted(preset);
    plain.steps(10);
    halted.steps(10);
    halted.stepper.advanceBy(halted.world, 0.0, halted.hits);
    QVERIFY(halted.world.circles == plain.world.circles);
    QCOMPARE(halted.world.time, plain.world.time);
    plain.steps(100);
    halted.steps(100);
    QVERIFY(halted.world.circles == plain.world.circles);
    QCOMPARE(halted.hits.size(), plain.hits.size());
}

QTEST_APPLESS_MAIN(TestContinuousWalls)
#include "test_continuous_walls.moc"
