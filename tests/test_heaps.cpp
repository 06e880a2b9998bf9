// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/measurements.h"
#include "model/world/random.h"
#include "tests/heaps.h"

using namespace cradle;
using namespace cradle::scenes;

/// Heaps of many circles in continuous timing: they rest, keep apart, and gain no energy.
class TestHeaps : public QObject
{
    Q_OBJECT
private slots:
    void momentumFollowsGravityAlone_data();
    void momentumFollowsGravityAlone();
    void hitsFollowNewtonsLaw();
    void whatTouchesHitsAtOnce();
    void aHeapNeitherOverlapsNorGainsEnergy_data();
    void aHeapNeitherOverlapsNorGainsEnergy();
    void aThousandThatDoNotReboundHardlyOverlap();
    void aHeavyCircleCrushesNothing_data();
    void aHeavyCircleCrushesNothing();
    void noStepOfAHeapGainsEnergy_data();
    void noStepOfAHeapGainsEnergy();
};

namespace {

double energyOf(const Run &run)
{
    return measure(run.world.circles, {0, -g}, halfWidth).total();
}

} // namespace

void TestHeaps::momentumFollowsGravityAlone_data()
{
    QTest::addColumn<int>("count");
    for (const int count : {3, 6, 8, 9, 12, 31, 150})
        QTest::addRow("%d", count) << count;
}

/// Without walls the pile's own pushes cancel: P = P₀ + M g t.
void TestHeaps::momentumFollowsGravityAlone()
{
    QFETCH(int, count);
    Preset preset = rows(count, count / 10 + 2, 0.15, 0.01);
    preset.laws.walls = WallLaw::None;
    Random random(4);
    double mass = 0.0;
    for (PresetCircle &c : preset.circles) {
        // They fly together from all sides.
        c.body.velocity = {-0.8 * c.body.position.x, -0.8 * c.body.position.y};
        c.body.radius *= random.between(0.8, 1.0);
        mass += cradle::mass(c.body);
    }
    Run run(preset);
    const Vec2 start = measure(run.world.circles, preset.gravity, halfWidth).momentum;
    for (int step = 1; step <= 120; ++step) {
        run.steps(1);
        const Vec2 momentum = measure(run.world.circles, preset.gravity, halfWidth).momentum;
        const Vec2 expected = start + (mass * step * dt) * preset.gravity;
        COMPARE_NEAR(length(momentum - expected), 0.0, 1e-11 * mass * (1.0 + step * dt * g));
    }
    QVERIFY(run.hits.size() * 3 > static_cast<std::size_t>(2 * count));
}

/// A row lies on the floor, and all of them are dropped at once: they rebound at e times the speed
/// at which they meet it.
void TestHeaps::hitsFollowNewtonsLaw()
{
    Preset preset = rows(100, 100, 0.039, 0.001);
    constexpr double fall = 2.0;
    for (PresetCircle &c : preset.circles) {
        c.body.position.y += 0.01;
        c.body.velocity = {0, -fall};
    }
    Run run(preset);
    run.steps(1);
    QCOMPARE(run.hits.size(), std::size_t{100});
    for (const Hit &hit : run.hits) {
        const double before = -hit.beforeA.y;
        const double after = hit.afterA.y;
        COMPARE_NEAR(after, 0.5 * before, 0.01);
        COMPARE_NEAR(before, fall, 2.0 * g * dt);
        COMPARE_NEAR(hit.time, 0.01 / fall, 1e-3);
        // What it and gravity give in the step is the change of the velocity.
        const double change = run[static_cast<std::size_t>(hit.a)].velocity.y + fall;
        COMPARE_NEAR(hit.impulse, mass(run[0]) * (change + g * dt), 1e-9);
    }
}

/// Each lies on the floor and has another right upon it, which comes down: only that rebounds.
void TestHeaps::whatTouchesHitsAtOnce()
{
    Preset preset = rows(50, 50, 0.078, 0.002);
    constexpr double fall = 2.0;
    for (std::size_t i = 0; i < 50; ++i) {
        PresetCircle upper = preset.circles[i];
        upper.body.position.y += 2.0 * 0.078;
        upper.body.velocity = {0, -fall};
        preset.circles.push_back(upper);
    }
    Run run(preset);
    run.steps(1);
    QCOMPARE(run.hits.size(), std::size_t{50});
    for (const Hit &hit : run.hits) {
        QCOMPARE(hit.b, hit.a + 50);
        // m (1 + e) u, and what it bears of its weight; half of it by the mean of u and u'.
        COMPARE_NEAR(hit.impulse, mass(run[0]) * (1.5 * fall + g * dt), 1e-6);
        COMPARE_NEAR(hit.loss, 0.5 * hit.impulse * (fall - 0.5 * fall), 1e-6);
    }
    for (std::size_t i = 0; i < 50; ++i) {
        COMPARE_NEAR(run[i].velocity.y, 0.0, 0.01);
        COMPARE_NEAR(run[50 + i].velocity.y, 0.5 * fall, g * dt);
    }
}

void TestHeaps::aHeapNeitherOverlapsNorGainsEnergy_data()
{
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("spread"); // of the radii
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("steps");
    QTest::addColumn<double>("most"); // overlap, in radii
    QTest::addRow("e = 0.5") << 0.5 << 0.0 << 19 << 180 << 1e-4;
    QTest::addRow("e = 0") << 0.0 << 0.0 << 19 << 180 << 1e-4;
    QTest::addRow("e = 0.9, unequal") << 0.9 << 0.5 << 19 << 180 << 1e-4;
    QTest::addRow("thousands") << 0.5 << 0.0 << 60 << 60 << 7e-4;
}

void TestHeaps::aHeapNeitherOverlapsNorGainsEnergy()
{
    QFETCH(double, restitution);
    QFETCH(double, spread);
    QFETCH(int, columns);
    QFETCH(int, steps);
    QFETCH(double, most);
    const double pitch = 0.4 * 19 / columns;
    Preset preset = rows(columns == 19 ? 190 : 50 * columns, columns, 0.375 * pitch, 0.25 * pitch);
    preset.restitution = restitution;
    Random random(5);
    for (PresetCircle &c : preset.circles) {
        c.body.velocity.x = random.between(-1.0, 1.0);
        c.body.velocity.y = random.between(-1.0, 1.0);
        c.body.radius *= 1.0 - spread * random.between(0.0, 1.0);
    }
    Run run(preset);
    const double start = energyOf(run);
    double least = start;
    for (int step = 0; step < steps; ++step) {
        run.steps(1);
        const double overlap = deepestOverlap(run.world.circles);
        QVERIFY2(overlap <= most, QByteArray::number(overlap).constData());
        const double gain = (energyOf(run) - least) / start;
        QVERIFY2(gain <= 1e-9, QByteArray::number(gain).constData());
        least = std::min(least, energyOf(run));
    }
}

/// With e = 0 they come down as one dense mass, whose pushes take many sweeps.
void TestHeaps::aThousandThatDoNotReboundHardlyOverlap()
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {0, -g};
    preset.restitution = 0.0;
    preset.halfWidth = 8.9;
    preset.fill = CircleFill{.count = 1000, .radius = 0.2, .rmsSpeed = 2.0, .seed = 3};
    preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    for (PresetCircle &c : preset.circles)
        c.integrator = Integrator::Verlet;
    Run run(preset);
    for (int step = 0; step < 110; ++step) {
        run.steps(1);
        const double overlap = deepestOverlap(run.world.circles, preset.halfWidth);
        QVERIFY2(overlap <= 3e-4, QByteArray::number(overlap).constData());
    }
}

void TestHeaps::aHeavyCircleCrushesNothing_data()
{
    QTest::addColumn<double>("restitution");
    QTest::addColumn<qint64>("seed");
    for (const double restitution : {0.0, 0.5}) {
        for (const qint64 seed : {1, 8, 13, 17, 24})
            QTest::addRow("e = %g, %d", restitution, static_cast<int>(seed)) << restitution << seed;
    }
}

/// One of a heap is 8,000 times as heavy as the others, and throws them much farther in a step than
/// they came before.
void TestHeaps::aHeavyCircleCrushesNothing()
{
    QFETCH(double, restitution);
    QFETCH(qint64, seed);
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {0, -g};
    preset.restitution = restitution;
    preset.halfWidth = 1.77;
    preset.fill = CircleFill{.count = 40, .radius = 0.2, .rmsSpeed = 2.0, .seed = seed};
    preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    for (PresetCircle &c : preset.circles)
        c.integrator = Integrator::Verlet;
    preset.circles[0].body.density *= 8000.0;
    Run run(preset);
    for (int step = 0; step < 250; ++step) {
        run.steps(1);
        const double overlap = deepestOverlap(run.world.circles, preset.halfWidth);
        QVERIFY2(overlap <= 1e-4, QByteArray::number(overlap).constData());
    }
}

void TestHeaps::noStepOfAHeapGainsEnergy_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("restitution");
    for (const int count : {2, 3, 5, 6, 8, 9, 10, 12, 16, 24, 31, 60}) {
        for (const double restitution : {0.0, 0.5, 0.9})
            QTest::addRow("%d, e = %g", count, restitution) << count << restitution;
    }
}

/// Circles of half to all of the largest radius, that fall into a heap in a box without much room:
/// no step gains more energy than its sum is rounded.
void TestHeaps::noStepOfAHeapGainsEnergy()
{
    QFETCH(int, count);
    QFETCH(double, restitution);
    for (qint64 seed = 1; seed <= 3; ++seed) {
        Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
        preset.gravity = {0, -g};
        preset.restitution = restitution;
        preset.halfWidth = std::max(0.75, 0.28 * std::sqrt(count));
        preset.fill = CircleFill{.count = count, .radius = 0.2, .rmsSpeed = 2.0, .seed = seed};
        preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
        Random random(seed);
        for (PresetCircle &c : preset.circles) {
            c.integrator = Integrator::Verlet;
            c.body.radius *= random.between(0.5, 1.0);
        }
        Run run(preset);
        const auto energy = [&] {
            return measure(run.world.circles, preset.gravity, preset.halfWidth).total();
        };
        const double start = energy();
        double before = start;
        for (int step = 0; step < 300; ++step) {
            run.steps(1);
            const double gain = (energy() - before) / start;
            QVERIFY2(gain <= 1e-12, QByteArray::number(gain).constData());
            before = energy();
            const double overlap = deepestOverlap(run.world.circles, preset.halfWidth);
            QVERIFY2(overlap <= 5e-5, QByteArray::number(overlap).constData());
        }
    }
}

QTEST_APPLESS_MAIN(TestHeaps)
#include "test_heaps.moc"
