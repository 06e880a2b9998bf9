// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/contact_solver.h"
#include "model/continuous/pile_contacts.h"
#include "model/world/measurements.h"
#include "model/world/random.h"
#include "tests/scenes.h"

#include <algorithm>
#include <numeric>

using namespace cradle;
using namespace cradle::scenes;

/// Large piles: their pushes, their steps, and their sleep.
class TestPiles : public QObject
{
    Q_OBJECT
private slots:
    void pushesAreThoseOfOtherSolvers();
    void aColumnWeighsOnTheFloor();
    void aGuessIsOnlyABegin();
    void unfinishedPushesGiveNoEnergy();
    void momentumFollowsGravityAlone();
    void hitsFollowNewtonsLaw();
    void aHeapNeitherOverlapsNorGainsEnergy_data();
    void aHeapNeitherOverlapsNorGainsEnergy();
    void aHeapFallsAsleep();
    void aSleepingHeapWakesWhenItIsHit();
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

double deepestOverlap(const std::vector<Circle> &circles)
{
    double deepest = 0.0;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        const Circle &a = circles[i];
        const double out = std::max(std::abs(a.position.x), std::abs(a.position.y)) + a.radius;
        deepest = std::max(deepest, (out - halfWidth) / a.radius);
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

/// Contacts of random bodies that close at random speeds.
std::vector<PileContact> randomContacts(Random &random, std::size_t count, PileBodies &bodies)
{
    const std::size_t bodyCount = count + 2;
    bodies.velocities.assign(bodyCount, Vec2{});
    bodies.inverseMasses.assign(bodyCount, 0.0);
    for (std::size_t i = 1; i < bodyCount; ++i) {
        bodies.velocities[i] = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
        bodies.inverseMasses[i] = random.between(0.5, 2.0);
    }
    std::vector<PileContact> contacts;
    for (std::size_t i = 0; i < count; ++i) {
        const auto a = static_cast<std::uint32_t>(1 + i % (bodyCount - 1));
        auto b = static_cast<std::uint32_t>(random.below(bodyCount));
        if (a == b)
            b = 0;
        const double angle = random.between(-pi, pi);
        contacts.push_back({a, b, {std::cos(angle), std::sin(angle)}});
    }
    return contacts;
}

double kineticEnergyOf(const PileBodies &bodies)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < bodies.velocities.size(); ++i) {
        if (bodies.inverseMasses[i] > 0.0)
            sum += 0.5 * lengthSquared(bodies.velocities[i]) / bodies.inverseMasses[i];
    }
    return sum;
}

} // namespace

/// The velocities that fulfil the conditions are unique, so another solver must find the same.
void TestPiles::pushesAreThoseOfOtherSolvers()
{
    Random random(1);
    for (int run = 0; run < 20; ++run) {
        PileBodies bodies;
        std::vector<PileContact> contacts = randomContacts(random, 30, bodies);
        std::vector<Vec2> expected = bodies.velocities;
        std::vector<Contact> others;
        for (const PileContact &c : contacts) {
            // Body 0 is a wall.
            const bool wall = c.b == 0;
            const double closing = dot(expected[c.a] - expected[c.b], c.normal);
            others.push_back({.a = static_cast<int>(c.a),
                              .b = wall ? -1 : static_cast<int>(c.b),
                              .normal = c.normal,
                              .change = closing});
        }
        solveContacts(others, bodies.inverseMasses);
        for (const Contact &c : others) {
            const auto a = static_cast<std::size_t>(c.a);
            expected[a] -= (c.impulse * bodies.inverseMasses[a]) * c.normal;
            if (c.b >= 0) {
                const auto b = static_cast<std::size_t>(c.b);
                expected[b] += (c.impulse * bodies.inverseMasses[b]) * c.normal;
            }
        }
        solvePile(contacts, bodies, 1e-13, 100'000);
        for (std::size_t i = 0; i < expected.size(); ++i)
            COMPARE_NEAR(length(bodies.velocities[i] - expected[i]), 0.0, 1e-9);
        for (const PileContact &c : contacts) {
            const double closing = dot(bodies.velocities[c.a] - bodies.velocities[c.b], c.normal);
            QVERIFY(c.push >= 0.0);
            QVERIFY(closing <= 1e-9);
            COMPARE_NEAR(c.push * closing, 0.0, 1e-9);
        }
    }
}

void TestPiles::aColumnWeighsOnTheFloor()
{
    // Twenty of 1 kg, 2 kg, … upon each other: the k-th contact carries all above it.
    constexpr std::uint32_t count = 20;
    PileBodies bodies;
    std::vector<PileContact> contacts;
    for (std::uint32_t i = 0; i < count; ++i) {
        bodies.velocities.push_back({0, -g * dt});
        bodies.inverseMasses.push_back(1.0 / (i + 1.0));
        contacts.push_back({i, i == 0 ? count : i - 1, {0, -1}});
    }
    bodies.velocities.push_back({});
    bodies.inverseMasses.push_back(0.0);
    const int sweeps = solvePile(contacts, bodies, 1e-12, 10'000);
    for (std::uint32_t i = 0; i < count; ++i) {
        double above = 0.0;
        for (std::uint32_t k = i; k < count; ++k)
            above += (k + 1.0) * g * dt;
        COMPARE_NEAR(contacts[i].push, above, 1e-9 * above);
    }
    // Sweeps by height, and conjugate: far fewer than 20² it would take one by one.
    QVERIFY2(sweeps <= 80, QByteArray::number(sweeps).constData());
}

void TestPiles::aGuessIsOnlyABegin()
{
    Random random(2);
    PileBodies bodies;
    std::vector<PileContact> contacts = randomContacts(random, 200, bodies);
    PileBodies again = bodies;
    solvePile(contacts, bodies, 1e-12, 100'000);
    std::vector<PileContact> guessed = contacts;
    const int sweeps = solvePile(guessed, again, 1e-9, 100'000);
    QVERIFY2(sweeps <= 4, QByteArray::number(sweeps).constData());
    for (PileContact &c : guessed)
        c.push = 10.0 * random.between(0.0, 1.0);
    Random same(2);
    PileBodies third;
    (void)randomContacts(same, 200, third);
    solvePile(guessed, third, 1e-12, 100'000);
    for (std::size_t i = 0; i < bodies.velocities.size(); ++i)
        COMPARE_NEAR(length(third.velocities[i] - bodies.velocities[i]), 0.0, 1e-8);
}

/// Where nothing may close, contacts take energy, whenever they are left off.
void TestPiles::unfinishedPushesGiveNoEnergy()
{
    Random random(3);
    for (int sweeps = 2; sweeps <= 12; sweeps += 2) {
        PileBodies bodies;
        std::vector<PileContact> contacts = randomContacts(random, 300, bodies);
        const std::vector<Vec2> before = bodies.velocities;
        const double energy = kineticEnergyOf(bodies);
        solvePile(contacts, bodies, 0.0, sweeps);
        // Exactly what the change of the velocities takes.
        double change = 0.0;
        for (std::size_t i = 1; i < before.size(); ++i)
            change +=
                0.5 * lengthSquared(bodies.velocities[i] - before[i]) / bodies.inverseMasses[i];
        COMPARE_NEAR(kineticEnergyOf(bodies) - energy, -change, 1e-12 * energy);
    }
}

/// Without walls the pile's own pushes cancel: P = P₀ + M g t.
void TestPiles::momentumFollowsGravityAlone()
{
    Preset preset = rows(150, 15, 0.15, 0.01);
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
    QVERIFY(run.hits.size() > 100);
}

/// A row lies on the floor, and all of them are dropped at once: they rebound at e times the speed
/// at which they meet it.
void TestPiles::hitsFollowNewtonsLaw()
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
    }
}

void TestPiles::aHeapNeitherOverlapsNorGainsEnergy_data()
{
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("spread"); // of the radii
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("steps");
    QTest::addColumn<double>("most"); // overlap, in radii
    QTest::addRow("e = 0.5") << 0.5 << 0.0 << 19 << 180 << 1e-4;
    QTest::addRow("e = 0") << 0.0 << 0.0 << 19 << 180 << 1e-4;
    QTest::addRow("e = 0.9, unequal") << 0.9 << 0.5 << 19 << 180 << 1e-4;
    QTest::addRow("thousands") << 0.5 << 0.0 << 60 << 60 << 2e-3;
}

void TestPiles::aHeapNeitherOverlapsNorGainsEnergy()
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

void TestPiles::aHeapFallsAsleep()
{
    Run run(rows(150, 15, 0.15, 0.02));
    run.steps(360);
    QCOMPARE(fastestOf(run), 0.0);
    const std::vector<Circle> asleep = run.world.circles;
    run.steps(60);
    QVERIFY(run.world.circles == asleep);
}

/// A circle thrown up keeps to its parabola while a heap below falls asleep; it wakes the heap when
/// it comes down on it, and not before.
void TestPiles::aSleepingHeapWakesWhenItIsHit()
{
    Preset preset = rows(100, 100, 0.039, 0.001);
    constexpr double up = 7.0;
    preset.circles.push_back(circle({0.1, 0.5}, {0.3, up}, 0.2));
    Run run(preset);
    bool slept = false;
    bool woke = false;
    for (int step = 1; step <= 130 && !woke; ++step) {
        const std::vector<Circle> before = run.world.circles;
        run.steps(1);
        const Circle &ball = run.world.circles.back();
        const double t = step * dt;
        const bool flies = std::abs(ball.velocity.x - 0.3) < 1e-12;
        if (flies) {
            COMPARE_NEAR(ball.position.x, 0.1 + 0.3 * t, 1e-9);
            COMPARE_NEAR(ball.position.y, 0.5 + up * t - 0.5 * g * t * t, 1e-9);
        }
        const bool stays = std::equal(before.begin(), before.end() - 1, run.world.circles.begin());
        if (slept)
            QCOMPARE(stays, flies);
        woke = slept && !stays;
        slept = slept || stays;
    }
    QVERIFY(slept);
    QVERIFY(woke);
}

QTEST_APPLESS_MAIN(TestPiles)
#include "test_piles.moc"
