// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile_ends.h"
#include "model/continuous/pile_rebound.h"
#include "model/continuous/pile_step.h"
#include "model/world/random.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

/// The phases of a step of a pile, each by itself and worked by hand; circles of 0.2 m in steps of
/// 1/60 s, in which gravity gives 0.16 m/s.
class TestPilePhases : public QObject
{
    Q_OBJECT
private slots:
    void gapsBoundTheSpeeds_data();
    void gapsBoundTheSpeeds();
    void whoTouchesHasMetAtOnce();
    void whoIsPushedOntoAnotherMeetsIt();
    void onlyWhoPushesIsAPair();
    void partingEndsWhereThereIsNoRoom();
    void reboundsTakeTheEnergyThereIs();
};

namespace {

constexpr double radius = 0.2;                   ///< m
constexpr double apart = 1e-3 * radius;          ///< m, left between two that touch
constexpr double borne = 5e-5 * radius;          ///< m, an overlap as good as none
constexpr double tolerance = 5e-5 * radius / dt; ///< m/s

Rules rulesFor(std::size_t count, double restitution = 0.5)
{
    return {.halfWidth = halfWidth,
            .gravity = {0, -g},
            .restitution = restitution,
            .laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous},
            .integrators = std::vector(count, Integrator::Verlet)};
}

std::vector<std::uint32_t> names(std::size_t count)
{
    std::vector<std::uint32_t> ids(count);
    for (std::uint32_t i = 0; i < count; ++i)
        ids[i] = i;
    return ids;
}

Circle at(Vec2 position, Vec2 velocity = {}, double density = 7.8)
{
    return {position, velocity, radius, density};
}

} // namespace

void TestPilePhases::gapsBoundTheSpeeds_data()
{
    QTest::addColumn<double>("gap");   // m
    QTest::addColumn<double>("limit"); // m/s
    QTest::newRow("near") << 1e-3 << (1e-3 - apart) / dt;
    QTest::newRow("touching") << 0.0 << 0.0;
    QTest::newRow("hardly overlapping") << -borne << 0.0;
    // A tenth of what is too much goes in a step.
    QTest::newRow("overlapping") << -1e-3 << -0.1 * (1e-3 - borne) / dt;
}

/// A circle at rest above the floor falls as fast as its gap lets it, or is lifted out of the
/// floor.
void TestPilePhases::gapsBoundTheSpeeds()
{
    QFETCH(double, gap);
    QFETCH(double, limit);
    const Rules rules = rulesFor(1);
    const std::vector<Circle> circles{at({0, -halfWidth + radius + gap})};
    const Pile pile(rules, circles, names(1), dt);
    PilePushes pushes;
    PileMotion motion;
    findMotion(pile, pushes, motion);
    QCOMPARE(motion.contacts.size(), 1U);
    COMPARE_NEAR(motion.contacts[0].limit, limit, 1e-12);
    COMPARE_NEAR(motion.velocities[0].y, -limit, tolerance);
    COMPARE_NEAR(motion.contacts[0].push, mass(circles[0]) * (g * dt - limit),
                 mass(circles[0]) * tolerance);
}

void TestPilePhases::whoTouchesHasMetAtOnce()
{
    const Rules rules = rulesFor(2);
    std::vector<NearPair> pairs;
    const auto met = [&](double gap, double closing) {
        const std::vector<Circle> circles{at({0, 0}), at({0, 2.0 * radius + gap}, {0, -closing})};
        const Pile pile(rules, circles, names(2), dt);
        findNearPairs(pile, foreseenWays(pile), pairs);
        return pairs.size() == 1 ? pairs[0].met : notANumber;
    };
    QCOMPARE(met(0.5 * apart, 0.0), 0.0);
    QCOMPARE(met(0.5 * apart, 0.1), 0.0);
    QCOMPARE(met(0.5 * apart, -0.1), 0.0);
    QCOMPARE(met(2.0 * apart, 0.0), -1.0);
    QCOMPARE(met(2.0 * apart, -0.1), -1.0);
    COMPARE_NEAR(met(2.0 * apart, 0.1), 2.0 * apart / 0.1, 1e-12);
}

/// The upper one throws the middle one 25 mm down in the step, onto the lower one that is 20 mm
/// off.
void TestPilePhases::whoIsPushedOntoAnotherMeetsIt()
{
    const Rules rules = rulesFor(3);
    const std::vector<Circle> circles{at({0, 0}), at({0, 0.42}), at({0, 0.821}, {0, -3})};
    const Pile pile(rules, circles, names(3), dt);
    PilePushes pushes;
    PileMotion motion;
    findMotion(pile, pushes, motion);
    QCOMPARE(motion.contacts.size(), 2U);
    for (const PileContact &c : motion.contacts) {
        QVERIFY(c.push > 0.0);
        const double closing = dot(motion.velocities[c.a] - motion.velocities[c.b], c.normal);
        COMPARE_NEAR(closing, c.limit, 2.0 * tolerance);
    }
    PileEnds ends = fly(pile, motion);
    QVERIFY(pile.gapBetween(0, 1, ends.places) >= -borne);
    QVERIFY(pile.gapBetween(1, 2, ends.places) >= -borne);
}

/// Light ones, whose pushes are less than 1 N s: one upon another, and two side by side that part.
void TestPilePhases::onlyWhoPushesIsAPair()
{
    const double floor = -halfWidth + radius;
    World world;
    world.circles = {at({0, floor}, {}, 0.1), at({0, floor + 0.4}, {}, 0.1),
                     at({2, floor}, {}, 0.1), at({2.401, floor}, {0.02, 0}, 0.1)};
    const Rules rules = rulesFor(4);
    PileStep step;
    std::vector<Hit> hits;
    step.run(rules, world, names(4), dt, hits);
    QCOMPARE(step.pushingPairs(), (std::vector<std::pair<int, int>>{{0, 1}}));
    QVERIFY(hits.empty());
}

/// Two upon each other between floor and ceiling, 0.3 m too high for that.
void TestPilePhases::partingEndsWhereThereIsNoRoom()
{
    Rules rules = rulesFor(2);
    rules.halfWidth = 0.25;
    const std::vector<Circle> circles{at({0, -0.05}), at({0, 0.05})};
    const Pile pile(rules, circles, names(2), dt);
    PilePushes pushes;
    PileMotion motion;
    findMotion(pile, pushes, motion);
    PileEnds ends = fly(pile, motion);
    partOverlaps(pile, motion, ends);
    QVERIFY(gained(pile, ends, motion.velocities) <= 1e-9);
}

/// Several hits at once, each with its own rebound, could make energy: then all there is is taken,
/// and no more.
void TestPilePhases::reboundsTakeTheEnergyThereIs()
{
    Random random(1);
    int bounded = 0;
    for (int run = 0; run < 200; ++run) {
        std::vector<Circle> circles;
        for (int i = 0; i < 6; ++i) {
            const double x = random.between(-0.1, 0.1);
            const double vx = random.between(-1.0, 1.0);
            const double vy = random.between(-2.0, 2.0);
            const double density = random.between(0.5, 8.0);
            circles.push_back(at({x, -halfWidth + radius + 0.4 * i}, {vx, vy}, density));
        }
        const Rules rules = rulesFor(circles.size(), 0.9);
        const Pile pile(rules, circles, names(circles.size()), dt);
        PilePushes pushes;
        PileMotion motion;
        findMotion(pile, pushes, motion);
        PileEnds ends = fly(pile, motion);
        partOverlaps(pile, motion, ends);
        const PileRebound rebound = findRebound(pile, motion, ends);
        double kinetic = 0.0;
        for (const Circle &c : circles)
            kinetic += 0.5 * mass(c) * lengthSquared(c.velocity);
        const double gain = gained(pile, ends, rebound.velocities);
        QVERIFY2(gain <= 1e-12 * kinetic, QByteArray::number(gain).constData());
        bounded += gain >= -1e-12 * kinetic ? 1 : 0;
    }
    QVERIFY(bounded > 10);
}

QTEST_APPLESS_MAIN(TestPilePhases)
#include "test_pile_phases.moc"
