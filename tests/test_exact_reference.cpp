// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/random.h"
#include "tests/reference_solver.h"
#include "tests/scenes.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr int circleCount = 20;
constexpr int hitCount = 60; // that are followed, 6 a circle

/// A difference grows at a pair's hit by about 1 + 2 l/(R cos φ): l the flight between hits, R the
/// sum of the radii, φ the angle of the velocity with the normal. Here l ≈ 1.2 m and R ≈ 0.9 m,
/// so 5 for a usual and 14 for a glancing hit. A hit concerns 2 of 20 circles, so a hit anywhere
/// lets the largest difference grow by up to 14^(2/20) = 1.3; 60 of them by 7e6.
constexpr double growth = 1.3;
/// m, s and m/s: some hundred roundings of numbers up to 8.
constexpr double rounding = 1e-13;

double tolerance(int hits)
{
    return rounding * std::pow(growth, hits);
}

/// Circles of mixed radii and densities at random places, none in touch; a fifth of the square.
Preset mixture(qint64 seed)
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact});
    Random random(seed);
    while (preset.circles.size() < circleCount) {
        const double radius = random.between(0.3, 0.6);
        const double room = halfWidth - radius;
        const double x = random.between(-room, room);
        const PresetCircle next = circle({x, random.between(-room, room)}, {}, radius,
                                         Integrator::Verlet, random.between(0.5, 8.0));
        const bool free =
            std::none_of(preset.circles.begin(), preset.circles.end(), [&](const PresetCircle &c) {
                return length(c.body.position - next.body.position) < c.body.radius + radius;
            });
        if (!free)
            continue;
        preset.circles.push_back(next);
        preset.circles.back().body.velocity = 2.0 * random.gaussian();
    }
    return preset;
}

} // namespace

/// Timing::Exact beside a slow and independent solver in long double, hit by hit.
class TestExactReference : public QObject
{
    Q_OBJECT
private slots:
    void referenceKnowsItsOwnFormulas();
    void everyHitIsTheReferences_data();
    void everyHitIsTheReferences();
    void everyStepIsTheReferences_data();
    void everyStepIsTheReferences();
};

void TestExactReference::referenceKnowsItsOwnFormulas()
{
    // 3.8 m of fall: √(2 · 3.8/9.81) s; up and down again: 2 · 5/9.81 s.
    COMPARE_NEAR(*reference::timeToWall(3.8L, 0.0L, 9.81L), std::sqrt(7.6 / 9.81), 1e-15);
    COMPARE_NEAR(*reference::timeToWall(0.0L, -5.0L, 9.81L), 10.0 / 9.81, 1e-15);
    COMPARE_NEAR(*reference::timeToWall(1.0L, 2.0L, 0.0L), 0.5, 1e-18);
    // Thrown up at 4 m/s under 9.81 m/s² it rises 0.816 m.
    QVERIFY(reference::timeToWall(0.815L, 4.0L, -9.81L).has_value());
    QVERIFY(!reference::timeToWall(0.816L, 4.0L, -9.81L).has_value());
    QVERIFY(!reference::timeToWall(1.0L, -1.0L, 0.0L).has_value());
    // Head on, 3 m between the rims at 2 m/s; and beside each other by more than R.
    const reference::Body a{.vx = 2, .radius = 0.5L, .mass = 1};
    QCOMPARE(static_cast<double>(*reference::timeToMeet(a, {.x = 4, .radius = 0.5L})), 1.5);
    QVERIFY(reference::timeToMeet(a, {.x = 4, .y = 0.999L, .radius = 0.5L}).has_value());
    QVERIFY(!reference::timeToMeet(a, {.x = 4, .y = 1.001L, .radius = 0.5L}).has_value());
    QVERIFY(!reference::timeToMeet(a, {.x = -4, .radius = 0.5L}).has_value());
}

void TestExactReference::everyHitIsTheReferences_data()
{
    QTest::addColumn<Vec2>("gravity");
    QTest::addColumn<double>("restitution");
    QTest::addColumn<qint64>("seed");
    for (const qint64 seed : {1, 2, 3, 4, 5}) {
        const auto row = [](const char *name, qint64 number) -> QTestData & {
            return QTest::addRow("%s, seed %lld", name, number);
        };
        row("elastic", seed) << Vec2{} << 1.0 << seed;
        row("elastic, gravity", seed) << Vec2{0, -g} << 1.0 << seed;
        row("elastic, slanting gravity", seed) << Vec2{3, -5} << 1.0 << seed;
        row("e = 0.8", seed) << Vec2{} << 0.8 << seed;
        row("e = 0.95, gravity", seed) << Vec2{0, -g} << 0.95 << seed;
    }
}

void TestExactReference::everyHitIsTheReferences()
{
    QFETCH(Vec2, gravity);
    QFETCH(double, restitution);
    QFETCH(qint64, seed);
    Preset preset = mixture(seed);
    preset.gravity = gravity;
    preset.restitution = restitution;
    QVERIFY(!findFault(preset).has_value());

    Run run(preset);
    for (int step = 0; step < 1200 && run.hits.size() < hitCount; ++step)
        run.steps(1);
    QVERIFY(run.hits.size() >= hitCount);

    reference::Solver solver(preset);
    for (int i = 0; i < hitCount; ++i) {
        std::optional<reference::Impact> expected = solver.next(20);
        QVERIFY(expected.has_value());
        solver.take(*expected);
        const Hit &hit = run.hits[static_cast<std::size_t>(i)];
        const QByteArray place = "hit " + QByteArray::number(i);
        QVERIFY2((hit.kind == Hit::Kind::Wall) == expected->wall, place.constData());
        // Who is called a is the solver's choice.
        const bool turned = !expected->wall && hit.a > hit.b;
        QVERIFY2((turned ? hit.b : hit.a) == expected->a, place.constData());
        QVERIFY2((turned ? hit.a : hit.b) == expected->b, place.constData());

        const double allowed = tolerance(i);
        COMPARE_NEAR(hit.time, expected->time, allowed);
        const double sign = turned ? -1.0 : 1.0;
        COMPARE_NEAR(sign * hit.normal.x, expected->nx, allowed);
        COMPARE_NEAR(sign * hit.normal.y, expected->ny, allowed);
        const reference::Body &a = solver[hit.a];
        COMPARE_NEAR(hit.afterA.x, a.vx, allowed);
        COMPARE_NEAR(hit.afterA.y, a.vy, allowed);
        if (!expected->wall) {
            const reference::Body &b = solver[hit.b];
            COMPARE_NEAR(hit.afterB.x, b.vx, allowed);
            COMPARE_NEAR(hit.afterB.y, b.vy, allowed);
        }
    }
}

void TestExactReference::everyStepIsTheReferences_data()
{
    everyHitIsTheReferences_data();
}

void TestExactReference::everyStepIsTheReferences()
{
    QFETCH(Vec2, gravity);
    QFETCH(double, restitution);
    QFETCH(qint64, seed);
    Preset preset = mixture(seed);
    preset.gravity = gravity;
    preset.restitution = restitution;
    Run run(preset);
    reference::Solver solver(preset);
    int hits = 0;
    while (hits < hitCount) {
        run.steps(1);
        while (std::optional<reference::Impact> hit = solver.next(run.world.time)) {
            solver.take(*hit);
            ++hits;
        }
        solver.moveTo(run.world.time);
        // Each hit is told in the step that it lies in.
        QCOMPARE(run.hits.size(), static_cast<std::size_t>(hits));
        for (int i = 0; i < circleCount; ++i) {
            const Circle &c = run[static_cast<std::size_t>(i)];
            COMPARE_NEAR(c.position.x, solver[i].x, tolerance(hits));
            COMPARE_NEAR(c.position.y, solver[i].y, tolerance(hits));
            COMPARE_NEAR(c.velocity.x, solver[i].vx, tolerance(hits));
            COMPARE_NEAR(c.velocity.y, solver[i].vy, tolerance(hits));
        }
    }
}

QTEST_APPLESS_MAIN(TestExactReference)
#include "test_exact_reference.moc"
