// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/measurements.h"
#include "model/world/rules.h"
#include "tests/scenes.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr double height = 3.8; // m, of the drop
constexpr Laws exact{WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact};

Preset drop(double restitution, double timestep = dt)
{
    Preset preset = scene({circle({0, 0}, {})}, exact);
    preset.gravity = {0, -g};
    preset.restitution = restitution;
    preset.timestep = timestep;
    return preset;
}

/// Height above the floor and whether it is still bouncing, t s after it was let go.
struct Bounce {
    double height = 0.0;
    int count = 0; // bounces so far
};

Bounce bouncing(double restitution, double t)
{
    double speed = std::sqrt(2.0 * g * height); // at the next contact
    double contact = speed / g;
    if (t < contact)
        return {height - 0.5 * g * t * t, 0};
    for (int n = 1;; ++n) {
        speed *= restitution;
        const double since = t - contact;
        if (since < 2.0 * speed / g)
            return {since * (speed - 0.5 * g * since), n};
        contact += 2.0 * speed / g;
    }
}

} // namespace

class TestExactTiming : public QObject
{
    Q_OBJECT
private slots:
    void theIntegratorDoesNotMatter_data();
    void theIntegratorDoesNotMatter();
    void bouncesFollowTheirParabolas_data();
    void bouncesFollowTheirParabolas();
    void bounceHeightsFallAsTheSquareOfRestitution_data();
    void bounceHeightsFallAsTheSquareOfRestitution();
    void elasticBouncesKeepTheirEnergy();
    void theTimestepDoesNotMatter_data();
    void theTimestepDoesNotMatter();
    void bouncingEndsAtRest();
    void twoCirclesMeetInFlight();
    void everyLawTellsImpulseAndLoss_data();
    void everyLawTellsImpulseAndLoss();
    void everyTimestepIsRecorded();
    void aWideThrowFoldsAtTheWalls();
};

void TestExactTiming::theIntegratorDoesNotMatter_data()
{
    QTest::addColumn<Integrator>("integrator");
    for (const Integrator integrator : allIntegrators)
        QTest::newRow(shortName(integrator)) << integrator;
}

void TestExactTiming::theIntegratorDoesNotMatter()
{
    QFETCH(Integrator, integrator);
    Preset preset = drop(1.0);
    preset.circles[0].integrator = integrator;
    Run run(preset);
    for (int i = 1; i <= 240; ++i) {
        run.steps(1);
        COMPARE_NEAR(run[0].position.y + 3.8, bouncing(1.0, i * dt).height, 1e-9);
    }
}

void TestExactTiming::bouncesFollowTheirParabolas_data()
{
    QTest::addColumn<double>("restitution");
    for (const double e : {0.5, 0.75, 0.9, 1.0})
        QTest::addRow("e = %g", e) << e;
}

void TestExactTiming::bouncesFollowTheirParabolas()
{
    QFETCH(double, restitution);
    Run run(drop(restitution));
    for (int i = 1; i <= 150; ++i) { // 2.5 s: e = 0.5 has 0.14 s to go
        run.steps(1);
        const Bounce expected = bouncing(restitution, i * dt);
        COMPARE_NEAR(run[0].position.y + 3.8, expected.height, 1e-9);
        QCOMPARE(run.hits.size(), static_cast<std::size_t>(expected.count));
    }
}

void TestExactTiming::bounceHeightsFallAsTheSquareOfRestitution_data()
{
    bouncesFollowTheirParabolas_data();
}

void TestExactTiming::bounceHeightsFallAsTheSquareOfRestitution()
{
    QFETCH(double, restitution);
    Run run(drop(restitution));
    run.steps(180);
    QVERIFY(run.hits.size() >= 2);
    double expected = height;
    double contact = std::sqrt(2.0 * height / g);
    for (const Hit &hit : run.hits) {
        if (expected < 0.01)
            break; // near the end of the bouncing the circle is laid to rest
        COMPARE_NEAR(hit.time, contact, 1e-9);
        expected *= restitution * restitution;
        COMPARE_NEAR(lengthSquared(hit.afterA) / (2.0 * g), expected, 1e-9);
        contact += 2.0 * std::sqrt(2.0 * expected / g);
    }
}

void TestExactTiming::elasticBouncesKeepTheirEnergy()
{
    Run run(drop(1.0));
    for (int i = 0; i < 3600; ++i) { // a minute
        run.steps(1);
        const double energy = 0.5 * lengthSquared(run[0].velocity) + g * (run[0].position.y + 3.8);
        COMPARE_NEAR(energy, g * height, 1e-9);
    }
}

void TestExactTiming::theTimestepDoesNotMatter_data()
{
    bouncesFollowTheirParabolas_data();
}

void TestExactTiming::theTimestepDoesNotMatter()
{
    QFETCH(double, restitution);
    Run fine(drop(restitution, 1.0 / 128.0));
    Run coarse(drop(restitution, 1.0 / 16.0));
    for (int i = 0; i < 36; ++i) { // 2.25 s
        coarse.steps(1);
        fine.steps(8);
        COMPARE_NEAR(coarse[0].position.y, fine[0].position.y, 1e-9);
    }
}

void TestExactTiming::bouncingEndsAtRest()
{
    // The bounces of e = ½ sum up to √(2h/g)·(1 + e)/(1 − e) = 2.64 s.
    Run run(drop(0.5));
    run.steps(162); // 2.7 s
    QVERIFY(run[0].velocity == Vec2{});
    COMPARE_NEAR(run[0].position.y, -3.8, 1e-12);
    const std::size_t hits = run.hits.size();
    run.steps(3600);
    QCOMPARE(run.hits.size(), hits);
    COMPARE_NEAR(run[0].position.y, -3.8, 1e-12);
}

void TestExactTiming::twoCirclesMeetInFlight()
{
    // Both fall alike, so they meet as if there were no gravity: after (4 − 0.4)/4 s. Then the
    // velocities along x are exchanged.
    Preset preset = scene({circle({-2, 3}, {2, 1}), circle({2, 3}, {-2, 1})}, exact);
    preset.gravity = {0, -g};
    Run run(preset);
    run.steps(60);
    const double t = 0.9;
    QCOMPARE(run.hits.size(), std::size_t{1});
    COMPARE_NEAR(run.hits[0].time, t, 1e-12);
    QCOMPARE(run.hits[0].normal.x, 1.0);
    COMPARE_NEAR(run[0].position.x, -0.2 - 2.0 * 0.1, 1e-12);
    COMPARE_NEAR(run[0].position.y, 3.0 + 1.0 - 0.5 * g, 1e-12);
    COMPARE_NEAR(run[1].velocity.x, 2.0, 1e-12);
    COMPARE_NEAR(run[1].velocity.y, 1.0 - g, 1e-12);
}

void TestExactTiming::everyLawTellsImpulseAndLoss_data()
{
    QTest::addColumn<int>("law");
    QTest::newRow("stop") << static_cast<int>(CircleLaw::Stop);
    QTest::newRow("swap velocities") << static_cast<int>(CircleLaw::SwapVelocities);
    QTest::newRow("swap normal") << static_cast<int>(CircleLaw::SwapNormal);
    QTest::newRow("impulse") << static_cast<int>(CircleLaw::Impulse);
}

void TestExactTiming::everyLawTellsImpulseAndLoss()
{
    // Unequal masses: what a hit tells must be what the circles have gained and lost.
    QFETCH(int, law);
    Preset preset = scene({circle({-1, 0.1}, {2, 0.5}, 0.2), circle({1, 0}, {-1, 0}, 0.4)},
                          {WallLaw::None, static_cast<CircleLaw>(law), Timing::Exact});
    preset.restitution = 0.5;
    const Circle &first = preset.circles[0].body;
    const Circle &second = preset.circles[1].body;
    Run run(preset);
    run.steps(60);
    QCOMPARE(run.hits.size(), std::size_t{1});
    const Hit &hit = run.hits[0];
    const double pushed = mass(first) * dot(hit.beforeA - hit.afterA, hit.normal);
    COMPARE_NEAR(hit.impulse, pushed, 1e-9 * std::abs(pushed));
    const double before = kineticEnergy(first) + kineticEnergy(second);
    const double after = kineticEnergy(run[0]) + kineticEnergy(run[1]);
    COMPARE_NEAR(hit.loss, before - after, 1e-12 * before);
}

void TestExactTiming::everyTimestepIsRecorded()
{
    Run run(drop(0.5));
    for (int i = 1; i <= 120; ++i) {
        run.steps(1);
        QCOMPARE(run.world.step, qint64{i});
        QCOMPARE(run.world.time, i * dt);
    }
}

void TestExactTiming::aWideThrowFoldsAtTheWalls()
{
    // The walls aside only turn x round: 2.5 m/s from 0, walls at ±3.8 of the centre.
    Preset preset = drop(1.0);
    preset.circles[0].body.velocity = {2.5, 0};
    Run run(preset);
    for (int i = 1; i <= 600; ++i) {
        run.steps(1);
        const double phase = std::fmod(2.5 * i * dt + 3.8, 15.2);
        COMPARE_NEAR(run[0].position.x, (phase <= 7.6 ? phase : 15.2 - phase) - 3.8, 1e-9);
        COMPARE_NEAR(run[0].position.y + 3.8, bouncing(1.0, i * dt).height, 1e-8);
    }
}

QTEST_APPLESS_MAIN(TestExactTiming)
#include "test_exact_timing.moc"
