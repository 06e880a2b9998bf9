// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr Laws exact{WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact};

} // namespace

/// Who only touches, and who meets two at once, in exact timing.
class TestExactMeetings : public QObject
{
    Q_OBJECT
private slots:
    void aHitOnTwoThatLieLeavesThemOnTheFloor();
    void aGrazeIsNoHit_data();
    void aGrazeIsNoHit();
    void lawsWithoutMassesAnswerInTurn_data();
    void lawsWithoutMassesAnswerInTurn();
    void wallsOfACornerAnswerInTurn();
    void swappedVelocitiesLiftWhatLies();
    void aBreakIsSolvedAsOne_data();
    void aBreakIsSolvedAsOne();
    void whatFallsSlowlyMeetsWhatLies();
    void whatIsPressedStaysOnTheFloor();
    void whatRestsLiesStillByEveryLaw_data();
    void whatRestsLiesStillByEveryLaw();
};

void TestExactMeetings::aGrazeIsNoHit_data()
{
    QTest::addColumn<bool>("first");
    QTest::newRow("the first passes") << true;
    QTest::newRow("the second passes") << false;
}

/// Rims that only touch do not push, and who has passed meets what comes after.
void TestExactMeetings::aGrazeIsNoHit()
{
    QFETCH(bool, first);
    const PresetCircle passing = circle({-1, 0}, {1, 0}, 0.25);
    const PresetCircle other = circle({0, 0.5}, {0, 0}, 0.25);
    Run run(first ? scene({passing, other}, exact) : scene({other, passing}, exact));
    const Circle &c = run[first ? 0 : 1];
    run.steps(120);
    QCOMPARE(c.velocity.x, 1.0);
    QCOMPARE(run.hits.size(), std::size_t{0});
    // 4.75 m to the right wall, then back: 10 s in all.
    run.steps(480);
    QCOMPARE(run.hits.size(), std::size_t{1});
    COMPARE_NEAR(run.hits[0].time, 4.75, 1e-12);
    COMPARE_NEAR(c.position.x, 3.75 - 5.25, 1e-12);
}

void TestExactMeetings::lawsWithoutMassesAnswerInTurn_data()
{
    QTest::addColumn<int>("law");
    QTest::addColumn<std::vector<double>>("velocities"); // m/s, from the left
    QTest::addColumn<std::vector<double>>("losses");     // J, of circles of 2 kg
    QTest::addColumn<std::vector<double>>("impulses");   // N s, of what the first loses
    // 1 and 0 change, then 1 and −2, then 0 and −2.
    QTest::newRow("whole velocities")
        << int(CircleLaw::SwapVelocities) << std::vector<double>{-2.0, 0.0, 1.0}
        << std::vector<double>{0.0, 0.0, 0.0} << std::vector<double>{2.0, 6.0, 4.0};
    QTest::newRow("stop") << int(CircleLaw::Stop) << std::vector<double>{0.0, 0.0, 0.0}
                          << std::vector<double>{1.0, 4.0} << std::vector<double>{2.0, 0.0};
}

/// Two come to one between them at the same moment.
void TestExactMeetings::lawsWithoutMassesAnswerInTurn()
{
    QFETCH(int, law);
    QFETCH(std::vector<double>, velocities);
    QFETCH(std::vector<double>, losses);
    QFETCH(std::vector<double>, impulses);
    Laws laws = exact;
    laws.circles = CircleLaw(law);
    const double rho = 2.0 / mass(Circle{.radius = 0.2, .density = 1.0});
    const auto ball = [rho](double x, double v) {
        return circle({x, 0.5}, {v, 0}, 0.2, Integrator::Verlet, rho);
    };
    Run run(scene({ball(-0.9, 1), ball(0, 0), ball(1.4, -2)}, laws));
    run.steps(40); // they meet after 0.5 s
    for (std::size_t i = 0; i < 3; ++i) {
        COMPARE_NEAR(run[i].velocity.x, velocities[i], 1e-12);
        QCOMPARE(run[i].velocity.y, 0.0);
    }
    QCOMPARE(run.hits.size(), losses.size());
    for (std::size_t i = 0; i < losses.size(); ++i) {
        const Hit &hit = run.hits[i];
        COMPARE_NEAR(hit.time, 0.5, 1e-12);
        COMPARE_NEAR(hit.loss, losses[i], 1e-12);
        COMPARE_NEAR(hit.impulse, impulses[i], 1e-12);
    }
}

/// Both walls of a corner give e times the part at each of them back.
void TestExactMeetings::wallsOfACornerAnswerInTurn()
{
    Laws laws = exact;
    laws.circles = CircleLaw::Stop;
    Preset preset = scene({circle({3, -3}, {1.6, -1.6})}, laws);
    preset.restitution = 0.5;
    Run run(preset);
    run.steps(40); // 0.8 m take 0.5 s
    QCOMPARE(run.hits.size(), std::size_t{2});
    const double m = mass(run[0]);
    for (const Hit &hit : run.hits) {
        COMPARE_NEAR(hit.loss, 0.5 * m * (1.6 * 1.6 - 0.8 * 0.8), 1e-12);
        COMPARE_NEAR(hit.impulse, 2.4 * m, 1e-12);
    }
    COMPARE_NEAR(run[0].velocity.x, -0.8, 1e-12);
    COMPARE_NEAR(run[0].velocity.y, 0.8, 1e-12);
}

/// One that slides on the floor meets one that rises, and takes its velocity; that one slides then.
/// One that falls onto what lies gives it a velocity into the floor, which does not let it.
void TestExactMeetings::swappedVelocitiesLiftWhatLies()
{
    Laws laws = exact;
    laws.circles = CircleLaw::SwapVelocities;
    Preset preset = scene({circle({-0.6, -3.8}, {2, 0}), circle({0, -3.79}, {0, 1})}, laws);
    preset.gravity = {0, -0.1};
    Run run(preset);
    run.steps(30);
    QCOMPARE(run.hits.size(), std::size_t{1});
    COMPARE_NEAR(run[0].velocity.y, 1.0 - 0.1 * 0.5, 1e-12);
    COMPARE_NEAR(run[0].velocity.x, 0.0, 1e-12);
    COMPARE_NEAR(run[1].velocity.x, 2.0, 1e-12);

    preset.circles = {circle({0, -3.8}), circle({0, -3.3}, {0.0, -1.0})};
    Run onto(preset);
    onto.steps(12); // 0.1 m take 0.1 s
    QCOMPARE(onto[0].velocity, Vec2{});
    COMPARE_NEAR(onto[0].position.y, -3.8, 1e-15);
    QVERIFY(onto[1].velocity.y <= 0.0);
}

void TestExactMeetings::aBreakIsSolvedAsOne_data()
{
    QTest::addColumn<double>("degrees");
    for (const double degrees : {0.0, 30.0, 77.0, 180.0, 245.0})
        QTest::addRow("%g degrees", degrees) << degrees;
}

/// One of 1 m/s meets two of its mass at once, ±30° from its way: along either normal, as in
/// test_contact_solver, J/m = (2/5) √3 m/s. To the side they go with 0.4 √3/2 m/s.
void TestExactMeetings::aBreakIsSolvedAsOne()
{
    QFETCH(double, degrees);
    const double angle = degrees * pi / 180.0;
    const Vec2 way{std::cos(angle), std::sin(angle)};
    const Vec2 side = perpendicular(way);
    const double share = std::sqrt(0.75);
    Run run(scene({circle(-0.5 * way, way), circle((0.4 * share) * way + 0.2 * side),
                   circle((0.4 * share) * way - 0.2 * side)},
                  exact));
    run.steps(60);
    const auto verify = [&](Vec2 velocity, double along, double aside) {
        COMPARE_NEAR(dot(velocity, way), along, 1e-9);
        COMPARE_NEAR(dot(velocity, side), aside, 1e-9);
    };
    verify(run[0].velocity, -0.2, 0.0);
    verify(run[1].velocity, 0.6, 0.4 * share);
    verify(run[2].velocity, 0.6, -0.4 * share);
    QCOMPARE(run.hits.size(), std::size_t{2});
    QCOMPARE(run.hits[0].time, run.hits[1].time);
}

/// What a third presses onto the floor and aside slides on it, exactly.
void TestExactMeetings::whatIsPressedStaysOnTheFloor()
{
    for (const double apart : {0.21, 0.25, 0.3, 0.33}) {
        Preset preset =
            scene({circle({-apart, -3.8}), circle({apart, -3.8}), circle({0, -3.0})}, exact);
        preset.gravity = {0, -g};
        preset.restitution = 0.5;
        Run run(preset);
        while (run.world.step < 120 && run[1].velocity.x == 0.0)
            run.steps(1);
        QVERIFY(run[1].velocity.x > 0.1);
        for (const std::size_t lower : {std::size_t{0}, std::size_t{1}}) {
            QCOMPARE(run[lower].velocity.y, 0.0);
            COMPARE_NEAR(run[lower].position.y, -3.8, 1e-15);
        }
    }
}

/// One falls between two that lie on the floor and drives them apart: they slide, and no rounding
/// of the blow lifts them or presses them down.
void TestExactMeetings::aHitOnTwoThatLieLeavesThemOnTheFloor()
{
    for (const double density : {0.7, 2.3, 7.8, 11.9}) {
        for (const double place : {0.21, 0.25, 0.33}) {
            const auto lying = [&](double x, double rho) {
                return circle({x, -halfWidth + 0.2}, {}, 0.2, Integrator::Verlet, rho);
            };
            Preset preset = scene(
                {lying(-place, 7.8), lying(place, density), circle({0, -halfWidth + 1.3}, {}, 0.2)},
                exact);
            preset.gravity = {0, -g};
            preset.restitution = 0.5;
            Run run(preset);
            run.steps(40);
            QVERIFY(run[0].velocity.x < -0.1);
            QVERIFY(run[1].velocity.x > 0.1);
            QCOMPARE(run[0].velocity.y, 0.0);
            QCOMPARE(run[1].velocity.y, 0.0);
        }
    }
}

/// Where gravity is weak the one falls 0.4 m onto the other in √(2 · 0.4 / 0.3) s.
void TestExactMeetings::whatFallsSlowlyMeetsWhatLies()
{
    Preset preset = scene({circle({0, -3.8}), circle({0, -3.0})}, exact);
    preset.gravity = {0, -0.3};
    preset.restitution = 0.5;
    Run run(preset);
    run.steps(105);
    QVERIFY(!run.hits.empty());
    const Hit *first = nullptr;
    for (const Hit &hit : run.hits) {
        if (hit.b == 1 && !first)
            first = &hit;
    }
    QVERIFY(first);
    COMPARE_NEAR(first->time, std::sqrt(0.8 / 0.3), 1e-9);
}

void TestExactMeetings::whatRestsLiesStillByEveryLaw_data()
{
    QTest::addColumn<int>("law");
    QTest::newRow("none") << int(CircleLaw::None);
    QTest::newRow("stop") << int(CircleLaw::Stop);
    QTest::newRow("whole velocities") << int(CircleLaw::SwapVelocities);
    QTest::newRow("parts along the normal") << int(CircleLaw::SwapNormal);
    QTest::newRow("impulse") << int(CircleLaw::Impulse);
}

/// Two fall onto the floor, slide and bounce ever lower; the time of all hops is a geometric
/// series.
void TestExactMeetings::whatRestsLiesStillByEveryLaw()
{
    QFETCH(int, law);
    Laws laws = exact;
    laws.circles = CircleLaw(law);
    Preset preset = scene({circle({-2, -3}, {0.25, 0}), circle({2, -3.5}, {-0.1, 0})}, laws);
    preset.gravity = {0, -g};
    preset.restitution = 0.5;
    Run run(preset);
    // From 0.8 m up: √(2 h / g) (1 + 2 Σ eⁿ) = 3 √(2 h / g), 1.2 s.
    run.steps(120);
    const std::size_t hits = run.hits.size();
    QVERIFY(hits > 4);
    run.steps(300);
    QCOMPARE(run.hits.size(), hits);
    for (const std::size_t i : {0U, 1U}) {
        COMPARE_NEAR(run[i].position.y, 0.2 - halfWidth, 1e-12);
        QCOMPARE(run[i].velocity.y, 0.0);
        QCOMPARE(run[i].velocity.x, i == 0 ? 0.25 : -0.1);
        COMPARE_NEAR(run[i].position.x, (i == 0 ? -2.0 + 0.25 * 7.0 : 2.0 - 0.1 * 7.0), 1e-9);
    }
}

QTEST_APPLESS_MAIN(TestExactMeetings)
#include "test_exact_meetings.moc"
