// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/collision_response.h"

#include "tests/scenes.h"

#include <optional>

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// A density that makes a circle of 1 m weigh \p kilograms.
double densityFor(double kilograms)
{
    return kilograms / (1000.0 * 4.0 / 3.0 * pi);
}

Circle ball(double kilograms, Vec2 position, Vec2 velocity)
{
    return {.position = position,
            .velocity = velocity,
            .radius = 1.0,
            .density = densityFor(kilograms)};
}

/// What \p b, which weighs \p kilograms, receives when it meets \p a along the line of centres, N
/// s; nothing if they do not respond.
std::optional<Vec2> impulseOn(Circle b, double kilograms, Circle a, double restitution)
{
    const Vec2 before = b.velocity;
    const Vec2 n = normalized(b.position - a.position);
    if (!respond(CircleLaw::Impulse, a, b, n, restitution))
        return std::nullopt;
    return kilograms * (b.velocity - before);
}

} // namespace

class TestCollisionResponse : public QObject
{
    Q_OBJECT
private slots:
    void impulseMatchesHandWorkedCase_data();
    void impulseMatchesHandWorkedCase();
    void impulseActsAlongTheLineOfCentres();
    void coincidingCentresHaveNoImpulse();
    void eachLawGivesItsVelocities_data();
    void eachLawGivesItsVelocities();
    void slowCirclesRespondToo_data();
    void slowCirclesRespondToo();
    void onlyApproachingCirclesRespond_data();
    void onlyApproachingCirclesRespond();
    void circlesOfTheLabWithMasses();
    void doubledDensityActsLikeDoubledVolume();
    void restitutionScalesTheRelativeNormalSpeed_data();
    void restitutionScalesTheRelativeNormalSpeed();
    void wallReflectsOnlyTheNormalPart_data();
    void wallReflectsOnlyTheNormalPart();
    void wallLeavesALeavingCircleAlone();
};

void TestCollisionResponse::impulseMatchesHandWorkedCase_data()
{
    QTest::addColumn<double>("massA");
    QTest::addColumn<double>("massB");
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("closingSpeed"); // m/s
    QTest::addColumn<double>("impulse");      // N s
    QTest::newRow("elastic") << 1.0 << 1.0 << 1.0 << 2.0 << 2.0;
    QTest::newRow("no rebound") << 1.0 << 1.0 << 0.0 << 2.0 << 1.0;
    QTest::newRow("half") << 1.0 << 1.0 << 0.5 << 2.0 << 1.5;
    QTest::newRow("separating") << 1.0 << 1.0 << 1.0 << -2.0 << 0.0;
    QTest::newRow("at rest") << 1.0 << 1.0 << 1.0 << 0.0 << 0.0;
    QTest::newRow("one to three") << 1.0 << 3.0 << 1.0 << 2.0 << 3.0; // 2 · ¾ · 2
    QTest::newRow("three to one") << 3.0 << 1.0 << 0.0 << 2.0 << 1.5;
    QTest::newRow("slow") << 1.0 << 1.0 << 1.0 << 0.25 << 0.25;
    QTest::newRow("hardly moving") << 1.0 << 1.0 << 0.0 << 1e-9 << 0.5e-9;
    QTest::newRow("a thousand to one") << 1000.0 << 1.0 << 1.0 << 1001.0 << 2000.0;
}

void TestCollisionResponse::impulseMatchesHandWorkedCase()
{
    QFETCH(double, massA);
    QFETCH(double, massB);
    QFETCH(double, restitution);
    QFETCH(double, closingSpeed);
    QFETCH(double, impulse);
    const Circle a = ball(massA, {-1, 0}, {0.5 * closingSpeed, 7});
    const Circle b = ball(massB, {1, 0}, {-0.5 * closingSpeed, -5});
    const std::optional<Vec2> found = impulseOn(b, massB, a, restitution);
    QCOMPARE(found.has_value(), impulse > 0.0);
    const Vec2 given = found.value_or(Vec2{});
    COMPARE_NEAR(given.x, impulse, 1e-12 * std::abs(impulse));
    COMPARE_NEAR(given.y, 0.0, 0.0);
}

void TestCollisionResponse::impulseActsAlongTheLineOfCentres()
{
    // n = (0.6, 0.8); closing speed (10, 0)·n = 6; J = 2 · ½ · 6 n = (3.6, 4.8)
    const Circle a = ball(1.0, {0, 0}, {10, 0});
    const Circle b = ball(1.0, {1.2, 1.6}, {0, 0});
    const std::optional<Vec2> found = impulseOn(b, 1.0, a, 1.0);
    QVERIFY(found.has_value());
    COMPARE_NEAR(found->x, 3.6, 1e-14);
    COMPARE_NEAR(found->y, 4.8, 1e-14);
}

void TestCollisionResponse::coincidingCentresHaveNoImpulse()
{
    QVERIFY(!impulseOn(ball(1, {1, 2}, {-3, 0}), 1.0, ball(1, {1, 2}, {3, 0}), 1.0).has_value());
}

void TestCollisionResponse::eachLawGivesItsVelocities_data()
{
    QTest::addColumn<CircleLaw>("law");
    QTest::addColumn<Vec2>("afterA"); // of 1 kg with (10, 5)
    QTest::addColumn<Vec2>("afterB"); // of 3 kg with (0, −5), n = (0.6, 0.8)
    QTest::addColumn<bool>("changed");
    // Along n: 6 + 4 = 10 and −4; the closing speed is 14.
    QTest::newRow("none") << CircleLaw::None << Vec2{10, 5} << Vec2{0, -5} << false;
    QTest::newRow("stop") << CircleLaw::Stop << Vec2{} << Vec2{} << true;
    QTest::newRow("swap velocities")
        << CircleLaw::SwapVelocities << Vec2{0, -5} << Vec2{10, 5} << true;
    QTest::newRow("swap normal") << CircleLaw::SwapNormal << Vec2{10 - 8.4, 5 - 11.2}
                                 << Vec2{8.4, -5 + 11.2} << true;
    // J = 1.5 · ¾ · 14 = 15.75 with e = ½
    QTest::newRow("impulse") << CircleLaw::Impulse << Vec2{10 - 9.45, 5 - 12.6}
                             << Vec2{3.15, -5 + 4.2} << true;
}

void TestCollisionResponse::eachLawGivesItsVelocities()
{
    QFETCH(CircleLaw, law);
    QFETCH(Vec2, afterA);
    QFETCH(Vec2, afterB);
    QFETCH(bool, changed);
    Circle a = ball(1.0, {0, 0}, {10, 5});
    Circle b = ball(3.0, {1.2, 1.6}, {0, -5});
    QCOMPARE(respond(law, a, b, {0.6, 0.8}, 0.5), changed);
    COMPARE_NEAR(a.velocity.x, afterA.x, 1e-14);
    COMPARE_NEAR(a.velocity.y, afterA.y, 1e-14);
    COMPARE_NEAR(b.velocity.x, afterB.x, 1e-14);
    COMPARE_NEAR(b.velocity.y, afterB.y, 1e-14);
    QVERIFY(a.position == Vec2{});
    QVERIFY(b.position == (Vec2{1.2, 1.6}));
}

void TestCollisionResponse::slowCirclesRespondToo_data()
{
    QTest::addColumn<CircleLaw>("law");
    QTest::addColumn<Vec2>("afterA"); // of 1 kg with (0.25, 3), the other as heavy and at rest
    QTest::addColumn<Vec2>("afterB");
    QTest::newRow("stop") << CircleLaw::Stop << Vec2{} << Vec2{};
    QTest::newRow("swap velocities") << CircleLaw::SwapVelocities << Vec2{} << Vec2{0.25, 3};
    QTest::newRow("swap normal") << CircleLaw::SwapNormal << Vec2{0, 3} << Vec2{0.25, 0};
    QTest::newRow("impulse") << CircleLaw::Impulse << Vec2{0, 3} << Vec2{0.25, 0};
}

void TestCollisionResponse::slowCirclesRespondToo()
{
    QFETCH(CircleLaw, law);
    QFETCH(Vec2, afterA);
    QFETCH(Vec2, afterB);
    Circle a = ball(1.0, {-1, 0}, {0.25, 3});
    Circle b = ball(1.0, {1, 0}, {});
    QVERIFY(respond(law, a, b, {1, 0}, 1.0));
    COMPARE_NEAR(a.velocity.x, afterA.x, 1e-15);
    COMPARE_NEAR(a.velocity.y, afterA.y, 1e-15);
    COMPARE_NEAR(b.velocity.x, afterB.x, 1e-15);
    COMPARE_NEAR(b.velocity.y, afterB.y, 1e-15);
}

void TestCollisionResponse::onlyApproachingCirclesRespond_data()
{
    QTest::addColumn<CircleLaw>("law");
    QTest::newRow("none") << CircleLaw::None;
    QTest::newRow("stop") << CircleLaw::Stop;
    QTest::newRow("swap velocities") << CircleLaw::SwapVelocities;
    QTest::newRow("swap normal") << CircleLaw::SwapNormal;
    QTest::newRow("impulse") << CircleLaw::Impulse;
}

void TestCollisionResponse::onlyApproachingCirclesRespond()
{
    QFETCH(CircleLaw, law);
    for (const Vec2 velocity : {Vec2{-2, 1}, Vec2{-1e-9, 1}, Vec2{0, 3}, Vec2{0, 0}}) {
        Circle a = ball(1.0, {-1, 0}, velocity);
        Circle b = ball(2.0, {1, 0}, {});
        QVERIFY(!respond(law, a, b, {1, 0}, 1.0));
        QVERIFY(a.velocity == velocity);
        QVERIFY(b.velocity == Vec2{});
    }
}

void TestCollisionResponse::circlesOfTheLabWithMasses()
{
    // m₁ : m₂ = 1 : 1.26³. Elastic and head-on, from ±1 m/s:
    //     v₁' = (m₁ − 3 m₂)/(m₁ + m₂), v₂' = (3 m₁ − m₂)/(m₁ + m₂)
    const double ratio = 1.26 * 1.26 * 1.26;
    Circle a{.position = {-0.226, 2}, .velocity = {1, 0}, .radius = 0.2, .density = 7.8};
    Circle b{.position = {0.226, 2}, .velocity = {-1, 0}, .radius = 0.252, .density = 7.8};
    QVERIFY(respond(CircleLaw::Impulse, a, b, {1, 0}, 1.0));
    COMPARE_NEAR(a.velocity.x, (1.0 - 3.0 * ratio) / (1.0 + ratio), 1e-14);
    COMPARE_NEAR(b.velocity.x, (3.0 - ratio) / (1.0 + ratio), 1e-14);
    COMPARE_NEAR(a.velocity.x, -1.66683, 5e-6);
    COMPARE_NEAR(b.velocity.x, 0.333166, 5e-6);
}

void TestCollisionResponse::doubledDensityActsLikeDoubledVolume()
{
    Circle a{.position = {-0.2, 2}, .velocity = {1, 0}, .radius = 0.2, .density = 1.0};
    Circle b{.position = {0.2, 2}, .velocity = {-1, 0}, .radius = 0.2, .density = 2.0};
    QVERIFY(respond(CircleLaw::Impulse, a, b, {1, 0}, 1.0));
    COMPARE_NEAR(a.velocity.x, -5.0 / 3.0, 1e-14);
    COMPARE_NEAR(b.velocity.x, 1.0 / 3.0, 1e-14);
}

void TestCollisionResponse::restitutionScalesTheRelativeNormalSpeed_data()
{
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("massRatio");
    for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        for (const double ratio : {1e-3, 0.5, 1.0, 2.0, 1e3})
            QTest::addRow("e = %g, masses 1 : %g", e, ratio) << e << ratio;
    }
}

void TestCollisionResponse::restitutionScalesTheRelativeNormalSpeed()
{
    QFETCH(double, restitution);
    QFETCH(double, massRatio);
    const Vec2 n{0.6, 0.8};
    const Vec2 along{-0.8, 0.6};
    Circle a = ball(2.0, {0, 0}, {3, 1});
    Circle b = ball(2.0 * massRatio, {1.2, 1.6}, {-1, -2});
    const Circle a0 = a;
    const Circle b0 = b;
    QVERIFY(respond(CircleLaw::Impulse, a, b, n, restitution));

    // Closing speed (4, 3)·n = 4.8
    const double parting = dot(b.velocity - a.velocity, n);
    COMPARE_NEAR(parting, restitution * 4.8, 4.8e-12);
    // The parts across n stay.
    COMPARE_NEAR(dot(a.velocity, along), dot(a0.velocity, along), 1e-12);
    COMPARE_NEAR(dot(b.velocity, along), dot(b0.velocity, along), 1e-12);
    // Momentum, with masses 2 and 2 r kg.
    const Vec2 before = 2.0 * a0.velocity + 2.0 * massRatio * b0.velocity;
    const Vec2 after = 2.0 * a.velocity + 2.0 * massRatio * b.velocity;
    const double size = 2.0 * length(a0.velocity) + 2.0 * massRatio * length(b0.velocity);
    COMPARE_NEAR(after.x, before.x, 1e-12 * size);
    COMPARE_NEAR(after.y, before.y, 1e-12 * size);
    // Only the relative motion along n loses energy: ½ μ u² (1 − e²)
    const auto kinetic = [&](const Circle &x, const Circle &y) {
        return lengthSquared(x.velocity) + massRatio * lengthSquared(y.velocity);
    };
    const double reduced = 2.0 * massRatio / (1.0 + massRatio);
    const double loss = 0.5 * reduced * 4.8 * 4.8 * (1.0 - restitution * restitution);
    COMPARE_NEAR(kinetic(a0, b0) - kinetic(a, b), loss, 1e-12 * kinetic(a0, b0));
}

void TestCollisionResponse::wallReflectsOnlyTheNormalPart_data()
{
    QTest::addColumn<Vec2>("normal");
    QTest::addColumn<double>("restitution");
    QTest::addColumn<Vec2>("before");
    QTest::addColumn<Vec2>("after");
    QTest::newRow("right, elastic") << Vec2{1, 0} << 1.0 << Vec2{2, 3} << Vec2{-2, 3};
    QTest::newRow("left, half") << Vec2{-1, 0} << 0.5 << Vec2{-2, 3} << Vec2{1, 3};
    QTest::newRow("floor, no rebound") << Vec2{0, -1} << 0.0 << Vec2{2, -3} << Vec2{2, 0};
    QTest::newRow("ceiling, quarter") << Vec2{0, 1} << 0.25 << Vec2{2, 4} << Vec2{2, -1};
}

void TestCollisionResponse::wallReflectsOnlyTheNormalPart()
{
    QFETCH(Vec2, normal);
    QFETCH(double, restitution);
    QFETCH(Vec2, before);
    QFETCH(Vec2, after);
    Vec2 velocity = before;
    QVERIFY(reflect(velocity, normal, restitution));
    QVERIFY(velocity == after);
}

void TestCollisionResponse::wallLeavesALeavingCircleAlone()
{
    for (const Vec2 leaving : {Vec2{-2, 3}, Vec2{0, 3}, Vec2{}}) {
        Vec2 velocity = leaving;
        QVERIFY(!reflect(velocity, {1, 0}, 0.5));
        QVERIFY(velocity == leaving);
    }
}

QTEST_APPLESS_MAIN(TestCollisionResponse)
#include "test_collision_response.moc"
