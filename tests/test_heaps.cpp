// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/sleeping_islands.h"
#include "model/world/measurements.h"
#include "model/world/random.h"
#include "tests/scenes.h"

#include <algorithm>
#include <numeric>

using namespace cradle;
using namespace cradle::scenes;

/// Heaps of many circles in continuous timing: they rest, sleep, wake, and gain no energy.
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
    void aHeapFallsAsleep();
    void whatShakesInItsPlaceIsStill();
    void aHeapSleepsAfterHalfASecond();
    void aSleepingHeapWakesWhenItIsHit_data();
    void aSleepingHeapWakesWhenItIsHit();
    void aRowOfSlidersNeverSleeps();
};

namespace {

/// \p count circles of radius \p radius in rows on the floor, \p apart (m) from each other.
Preset rows(int count, int columns, double radius, double apart)
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {0, -g};
    preset.restitution = 0.5;
    const double pitch = 2.0 * radius + apart;
    for (int i = 0; i < count; ++i) {
        // Every second row half a place aside: they lie in the gaps.
        const int row = i / columns;
        const double x = -halfWidth + radius + pitch * (i % columns) + (row % 2) * 0.5 * pitch;
        const double y = -halfWidth + radius + row * (std::sqrt(0.75) * pitch + apart);
        preset.circles.push_back(circle({x, y}, {}, radius));
    }
    return preset;
}

double energyOf(const Run &run)
{
    return measure(run.world.circles, {0, -g}, halfWidth).total();
}

double deepestOverlap(const std::vector<Circle> &circles, double room = halfWidth)
{
    double deepest = 0.0;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        const Circle &a = circles[i];
        const double out = std::max(std::abs(a.position.x), std::abs(a.position.y)) + a.radius;
        deepest = std::max(deepest, (out - room) / a.radius);
        for (std::size_t j = 0; j < i; ++j) {
            const double sum = a.radius + circles[j].radius;
            if (std::abs(circles[j].position.x - a.position.x) < sum)
                deepest = std::max(deepest, (sum - length(circles[j].position - a.position))
                                                / std::min(a.radius, circles[j].radius));
        }
    }
    return deepest;
}

double fastestOf(const Run &run)
{
    double fastest = 0.0;
    for (const Circle &c : run.world.circles)
        fastest = std::max(fastest, length(c.velocity));
    return fastest;
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

void TestHeaps::aHeapFallsAsleep()
{
    Run run(rows(150, 15, 0.15, 0.02));
    run.steps(480);
    QCOMPARE(fastestOf(run), 0.0);
    const std::vector<Circle> asleep = run.world.circles;
    run.steps(60);
    QVERIFY(run.world.circles == asleep);
}

/// The errors of a large pile's pushes shake its circles; a slow fall is no such error.
void TestHeaps::whatShakesInItsPlaceIsStill()
{
    constexpr double reach = 0.004;
    SleepingIslands islands;
    islands.start(3);
    for (int step = 1; step <= 40; ++step) {
        const double shaken = step % 2 == 0 ? 0.9 * reach : 0.0;
        QCOMPARE(islands.countStill(0, true, {0, shaken}, reach), step);
        // A fifth of the reach in a step: in the sixth step after it began it is out of reach.
        const int creeping = islands.countStill(1, true, {0.2 * reach * step, 0}, 0.99 * reach);
        QCOMPARE(creeping, 1 + (step - 1) % 5);
        // Fast in every tenth step.
        QCOMPARE(islands.countStill(2, step % 10 != 0, {}, reach), step % 10);
    }
}

/// What lies still does so for half a second, thirty steps, before it sleeps; not for a step less.
/// That is: nobody has come farther than at 0.05 g h for so long, nor been faster than ½ g h.
void TestHeaps::aHeapSleepsAfterHalfASecond()
{
    Run run(rows(40, 20, 0.15, 0.02));
    const double reach = 0.05 * g * dt * 0.5;
    std::vector<Circle> begun = run.world.circles; // of each circle, where it began to lie
    std::vector<int> steps(begun.size(), 0);       // for which it does
    int least = 0;
    do {
        run.steps(1);
        const bool sleeps = fastestOf(run) == 0.0;
        for (std::size_t i = 0; i < begun.size(); ++i) {
            const bool slow = length(run[i].velocity) <= 0.5 * g * dt;
            if (!slow || steps[i] == 0 || length(run[i].position - begun[i].position) > reach) {
                begun[i] = run[i];
                steps[i] = slow ? 1 : 0;
            } else {
                ++steps[i];
            }
        }
        least = *std::min_element(steps.begin(), steps.end());
        QCOMPARE(sleeps, least >= 30);
    } while (least < 30 && run.world.step < 480);
    QCOMPARE(least, 30);
}

/// Without friction they go on for ever, however fast.
void TestHeaps::aRowOfSlidersNeverSleeps()
{
    for (const double speed : {0.25, 1.0}) {
        Preset preset = rows(40, 40, 0.05, 0.05);
        for (PresetCircle &c : preset.circles)
            c.body.velocity = {speed, 0.0};
        Run run(preset);
        run.steps(60);
        run.stepper.advanceBy(run.world, 0.0, run.hits); // a step of no time changes nothing
        run.steps(60);
        for (std::size_t i = 0; i < 20; ++i) { // the others have come to the wall
            QCOMPARE(run[i].velocity.x, speed);
            COMPARE_NEAR(run[i].position.x, preset.circles[i].body.position.x + speed * 2.0, 1e-9);
        }
    }
}

void TestHeaps::aSleepingHeapWakesWhenItIsHit_data()
{
    QTest::addColumn<double>("radius"); // m
    QTest::addColumn<double>("from");   // m
    QTest::addColumn<double>("up");     // m/s
    QTest::addColumn<bool>("aside");
    // It sleeps after thirty steps. Let go, the circle falls onto it in the next ones.
    for (const int step : {31, 32, 33, 34, 35, 36, 38, 40}) {
        const double fall = 0.5 * g * (step + 0.5) * dt * (step + 0.5) * dt;
        QTest::addRow("step %d", step)
            << 0.2 << -halfWidth + 2.0 * 0.039 + 0.2 + fall << 0.0 << false;
    }
    // 8,600 times as heavy.
    QTest::addRow("3 m/s, very wide") << 0.8 << 0.0 << 3.0 << false;
    for (const double up : {2.0, 2.5, 3.0, 4.0, 7.0}) {
        QTest::addRow("%g m/s", up) << 0.2 << 0.5 << up << false;
        QTest::addRow("%g m/s aside", up) << 0.2 << 0.5 << up << true;
        QTest::addRow("%g m/s, wide", up) << 0.4 << 0.5 << up << false;
        QTest::addRow("%g m/s aside, wide", up) << 0.4 << 0.5 << up << true;
    }
}

/// A circle thrown up keeps to its parabola while a heap below falls asleep; it wakes the heap when
/// it comes down on it, and not before.
void TestHeaps::aSleepingHeapWakesWhenItIsHit()
{
    Preset preset = rows(100, 100, 0.039, 0.001);
    QFETCH(double, radius); // 0.2 m: 135 times as heavy as those that it hits, 0.4 m: 1,080 times
    QFETCH(double, from);
    QFETCH(double, up);
    QFETCH(bool, aside); // gravity, and all else
    preset.circles.push_back(circle({0.1, from}, {0.3, up}, radius));
    const auto turned = [aside](Vec2 v) { return aside ? Vec2{v.y, v.x} : v; };
    for (PresetCircle &c : preset.circles) {
        c.body.position = turned(c.body.position);
        c.body.velocity = turned(c.body.velocity);
    }
    preset.gravity = turned(preset.gravity);
    Run run(preset);
    bool slept = false;
    bool woke = false;
    for (int step = 1; step <= 130 && !woke; ++step) {
        const std::vector<Circle> before = run.world.circles;
        run.steps(1);
        const Circle &ball = run.world.circles.back();
        const double t = step * dt;
        const Vec2 place = turned(ball.position);
        const bool flies = std::abs(turned(ball.velocity).x - 0.3) < 1e-12;
        if (flies) {
            COMPARE_NEAR(place.x, 0.1 + 0.3 * t, 1e-9);
            COMPARE_NEAR(place.y, from + up * t - 0.5 * g * t * t, 1e-9);
        }
        const bool stays = std::equal(before.begin(), before.end() - 1, run.world.circles.begin());
        if (slept)
            QCOMPARE(stays, flies);
        woke = slept && !stays;
        slept = slept || stays;
    }
    QVERIFY(slept && woke);
    // Who woke does not fall through the floor, where in a step it would by 0.07 radii, and is not
    // pressed into it by what is a thousand times as heavy; none of them gains energy.
    const auto energy = [&] {
        return measure(run.world.circles, preset.gravity, halfWidth).total();
    };
    const double whole = mass(preset.circles.back().body) * g * 2.0 * halfWidth;
    double least = energy();
    for (int step = 0; step < 160; ++step) {
        run.steps(1);
        const double overlap = deepestOverlap(run.world.circles);
        QVERIFY2(overlap <= 1e-4, QByteArray::number(overlap).constData());
        const double gain = (energy() - least) / whole;
        QVERIFY2(gain <= 1e-9, QByteArray::number(gain).constData());
        least = std::min(least, energy());
    }
}

QTEST_APPLESS_MAIN(TestHeaps)
#include "test_heaps.moc"
