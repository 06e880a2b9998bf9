// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_step.h"
#include "model/world/random.h"
#include "tests/scenes.h"

#include <tuple>

using namespace cradle;
using namespace cradle::scenes;

/// The grid, the skin and the groups of continuous timing find what all circles taken together as
/// one group would.
class TestContinuousCrowd : public QObject
{
    Q_OBJECT
private slots:
    void groupsMissNothing_data();
    void groupsMissNothing();
    void lawsAnswerAsInOneGroup_data();
    void lawsAnswerAsInOneGroup();
    void largeCirclesMissNothing();
    void exactTimingIsTheSameMotion();
    void twoThatAreKickedInAStepMeet();
    void aLargeHeapComesToRest();
    void openSpaceMissesNothing();
};

namespace {

/// \p count circles of mixed radii, densities and integrators on a lattice, at random velocities of
/// up to \p speed (m/s) along each axis, with so different integrators that only steps can move
/// them.
Preset mixed(int count, double gravity, qint64 seed, double speed = 4.0)
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {0, -gravity};
    Random random(seed);
    const int columns = 8;
    for (int i = 0; i < count; ++i) {
        const Vec2 site{-3.5 + 1.0 * (i % columns), -3.5 + 1.0 * (i / columns)};
        // One after the other: compilers may evaluate arguments in any order.
        const double vx = random.between(-speed, speed);
        const double vy = random.between(-speed, speed);
        const double radius = random.between(0.1, 0.4);
        const Integrator integrator = allIntegrators[random.below(4)];
        const double density = random.between(0.5, 8.0);
        preset.circles.push_back(circle(site, {vx, vy}, radius, integrator, density));
    }
    // One so fast that it leaves every skin in a step.
    preset.circles[0].body.velocity = {40.0, 20.0};
    return preset;
}

/// Whether two hits tell of the same.
void compareHits(const Hit &hit, const Hit &expected)
{
    QCOMPARE(hit.kind, expected.kind);
    QCOMPARE(hit.a, expected.a);
    QCOMPARE(hit.b, expected.b);
    QCOMPARE(hit.step, expected.step);
    COMPARE_NEAR(hit.time, expected.time, 1e-7);
    COMPARE_NEAR(length(hit.normal - expected.normal), 0.0, 1e-6);
    const double size = 1.0 + std::abs(expected.impulse);
    COMPARE_NEAR(hit.impulse, expected.impulse, 1e-6 * size);
    const double energy = size * (1.0 + length(expected.beforeA) + length(expected.beforeB));
    COMPARE_NEAR(hit.loss, expected.loss, 1e-6 * energy);
}

/// Compares every step of \p preset with all circles taken as one group, for \p steps. \return how
/// many hits there were
std::size_t compareWithOneGroup(const Preset &preset, int steps)
{
    const Rules rules = rulesOf(preset);
    Run run(preset);
    ContinuousStep together;
    std::size_t hits = 0;
    // Chaos parts the two by rounding, so the reference begins each step where the run is.
    for (int step = 0; step < steps; ++step) {
        World world = run.world;
        ++world.step;
        world.time = static_cast<double>(world.step) * preset.timestep;
        std::vector<Hit> expected;
        together.run(rules, world, preset.timestep, expected);
        hits += expected.size();
        run.steps(1);
        [&] { QCOMPARE(run.hits.size(), hits); }();
        if (QTest::currentTestFailed())
            break;
        const auto order = [](const Hit &x, const Hit &y) {
            return std::tie(x.kind, x.a, x.b, x.time) < std::tie(y.kind, y.a, y.b, y.time);
        };
        const auto first = run.hits.end() - static_cast<std::ptrdiff_t>(expected.size());
        std::vector<Hit> found(first, run.hits.end());
        std::sort(found.begin(), found.end(), order);
        std::sort(expected.begin(), expected.end(), order);
        for (std::size_t i = 0; i < found.size(); ++i)
            compareHits(found[i], expected[i]);
        for (std::size_t i = 0; i < world.circles.size(); ++i) {
            const double size = 1.0 + length(world.circles[i].velocity);
            [&] {
                COMPARE_NEAR(length(run[i].position - world.circles[i].position), 0.0, 1e-7);
                COMPARE_NEAR(length(run[i].velocity - world.circles[i].velocity), 0.0, 1e-6 * size);
            }();
        }
        if (QTest::currentTestFailed())
            break;
    }
    return hits;
}

} // namespace

void TestContinuousCrowd::groupsMissNothing_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("gravity");
    QTest::addColumn<double>("speed");
    for (const int count : {9, 24, 56}) {
        QTest::addRow("%d circles", count) << count << 0.0 << 4.0;
        QTest::addRow("%d circles, falling", count) << count << g << 4.0;
    }
    // Slow ones are planned for many steps ahead.
    QTest::newRow("slow") << 56 << 0.0 << 0.4;
    QTest::newRow("slow, falling gently") << 56 << 0.3 << 0.4;
}

void TestContinuousCrowd::groupsMissNothing()
{
    QFETCH(int, count);
    QFETCH(double, gravity);
    QFETCH(double, speed);
    const int steps = speed < 4.0 ? 240 : 60;
    for (qint64 seed = 1; seed <= 8; ++seed)
        QVERIFY(compareWithOneGroup(mixed(count, gravity, seed, speed), steps) > 10);
}

void TestContinuousCrowd::lawsAnswerAsInOneGroup_data()
{
    QTest::addColumn<CircleLaw>("law");
    QTest::addColumn<double>("restitution");
    QTest::newRow("stop") << CircleLaw::Stop << 1.0;
    QTest::newRow("swap velocities") << CircleLaw::SwapVelocities << 1.0;
    QTest::newRow("swap normal parts") << CircleLaw::SwapNormal << 1.0;
    QTest::newRow("half is lost") << CircleLaw::Impulse << 0.5;
    QTest::newRow("none") << CircleLaw::None << 1.0;
}

void TestContinuousCrowd::lawsAnswerAsInOneGroup()
{
    QFETCH(CircleLaw, law);
    QFETCH(double, restitution);
    for (qint64 seed = 1; seed <= 4; ++seed) {
        Preset preset = mixed(56, 0.0, seed);
        preset.laws.circles = law;
        preset.restitution = restitution;
        QVERIFY(compareWithOneGroup(preset, 30) > 10);
    }
}

/// Wider than a metre, in a square of 40 m.
void TestContinuousCrowd::largeCirclesMissNothing()
{
    for (qint64 seed = 1; seed <= 4; ++seed) {
        Preset preset = mixed(56, g, seed, 10.0);
        preset.halfWidth *= 5.0;
        for (PresetCircle &c : preset.circles) {
            c.body.position = 5.0 * c.body.position;
            c.body.radius *= 5.0;
        }
        QVERIFY(compareWithOneGroup(preset, 60) > 10);
    }
}

/// Without error in flight and without loss a crowd is moved by exact timing.
void TestContinuousCrowd::exactTimingIsTheSameMotion()
{
    for (qint64 seed = 1; seed <= 8; ++seed) {
        Preset preset = mixed(40, g, seed);
        for (PresetCircle &c : preset.circles)
            c.integrator = Integrator::Verlet;
        QVERIFY(compareWithOneGroup(preset, 60) > 10);
    }
}

/// Two at rest, farther apart than one of them could come in the step, are pushed towards each
/// other in the same step.
void TestContinuousCrowd::twoThatAreKickedInAStepMeet()
{
    constexpr double speed = 4.0;
    constexpr double radius = 0.1;
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {};
    const double way = speed * preset.timestep; // m in a step
    for (const double side : {-1.0, 1.0}) {
        const double x = side * (radius + 0.75 * way);
        const double behind = x + side * (2.0 * radius + 0.05 * way);
        preset.circles.push_back(circle({x, 0}, {}, radius, Integrator::SymplecticEuler));
        preset.circles.push_back(
            circle({behind, 0}, {-side * speed, 0}, radius, Integrator::SymplecticEuler));
    }
    for (int i = 0; i < 12; ++i)
        preset.circles.push_back(
            circle({-3.0 + 0.5 * i, 3.0}, {}, radius, Integrator::SymplecticEuler));
    QCOMPARE(compareWithOneGroup(preset, 1), 3U);
}

/// Hundreds fall into a heap: far more contacts than can be taken moment by moment. They hardly
/// overlap, gain no energy and come to rest.
void TestContinuousCrowd::aLargeHeapComesToRest()
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {0, -g};
    preset.restitution = 0.5;
    preset.fill = CircleFill{.count = 150, .radius = 0.16, .rmsSpeed = 1.0, .density = 1.0};
    preset.circles = *makeCircles(*preset.fill, halfWidth);
    for (PresetCircle &c : preset.circles) // others change the energy in flight
        c.integrator = Integrator::Verlet;
    Run run(preset);
    const auto energy = [&] {
        double sum = 0.0;
        for (const Circle &c : run.world.circles)
            sum += mass(c) * (0.5 * lengthSquared(c.velocity) + g * (c.position.y + halfWidth));
        return sum;
    };
    const double start = energy();
    double least = start;
    for (int step = 0; step < 240; ++step) {
        run.steps(1);
        QVERIFY2(energy() <= least + 1e-9 * start,
                 QByteArray::number((energy() - least) / start).constData());
        least = std::min(least, energy());
    }
    double fastest = 0.0;
    for (std::size_t i = 0; i < run.world.circles.size(); ++i) {
        const Circle &a = run[i];
        fastest = std::max(fastest, length(a.velocity));
        QVERIFY(std::max(std::abs(a.position.x), std::abs(a.position.y)) + a.radius
                <= halfWidth + 1e-4 * a.radius);
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(length(run[j].position - a.position) >= (2.0 - 1e-4) * a.radius);
    }
    QVERIFY2(fastest < 0.2, QByteArray::number(fastest).constData());
}

/// A wide row without walls: its size is that of its longer side.
void TestContinuousCrowd::openSpaceMissesNothing()
{
    std::size_t hits = 0;
    for (qint64 seed = 1; seed <= 8; ++seed) {
        Preset preset = mixed(16, 0.0, seed, 2.0);
        preset.laws.walls = WallLaw::None;
        preset.gravity = {0, -g};
        hits += compareWithOneGroup(preset, 40);
    }
    QVERIFY(hits > 10);
}

QTEST_APPLESS_MAIN(TestContinuousCrowd)
#include "test_continuous_crowd.moc"
