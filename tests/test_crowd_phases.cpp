// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/crowd_sleep.h"
#include "model/continuous/meeting_groups.h"
#include "model/continuous/meeting_schedule.h"
#include "model/continuous/pair_step.h"

#include <QTest>

using namespace cradle;

/// The phases of a crowd's step, each by itself, by hand: radii of 0.2 m, steps of 0.1 s.
class TestCrowdPhases : public QObject
{
    Q_OBJECT
private slots:
    void pairsArePutDownForTheirFirstStep_data();
    void pairsArePutDownForTheirFirstStep();
    void wallsArePutDownForTheirFirstStep();
    void whoMeetsIsGroupedAndWhoDoesNotIsToldOf();
    void whoSleepsTogetherWakesTogether();
    void aPairIsSolvedByHand();
    void whatIsNotSimpleIsLeftToOthers_data();
    void whatIsNotSimpleIsLeftToOthers();
};

namespace {

constexpr double dt = 0.1; // s

Crowd crowdOf(std::vector<Circle> circles, double restitution = 1.0, double gravity = 0.0)
{
    Rules rules{.gravity = {0.0, -gravity},
                .restitution = restitution,
                .laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous}};
    rules.integrators.assign(circles.size(), Integrator::Verlet);
    Crowd crowd;
    crowd.start(rules, circles);
    return crowd;
}

/// Who was due and does not meet.
std::vector<Crowd::Pair> grouped(Crowd &crowd, std::span<const Crowd::Pair> resting,
                                 std::span<const Crowd::Pair> due, StepGroups &groups)
{
    std::vector<Crowd::Pair> inVain;
    findGroups(crowd, dt, resting, due, groups, inVain);
    return inVain;
}

/// Two that come towards each other along x at \p speed (m/s) each, their centres 2 m apart.
std::vector<Circle> headOn(double speed)
{
    return {{.position = {-1.0, 0.0}, .velocity = {speed, 0.0}},
            {.position = {1.0, 0.0}, .velocity = {-speed, 0.0}}};
}

struct Sorted {
    explicit Sorted(Crowd &crowd)
    {
        near.start(crowd);
        near.sort(dt, crowd, {});
        schedule.fill(crowd, near);
    }
    /// The only step in which a pair is due; −1 if there is none, −2 if there are more.
    [[nodiscard]] int onlyStep() const
    {
        int step = -1;
        for (std::size_t i = 0; i < SortSkin::mostSteps; ++i) {
            if (!schedule.due(i).empty())
                step = step < 0 && schedule.due(i).size() == 1 ? static_cast<int>(i) : -2;
        }
        return step;
    }

    BroadPhase near;
    MeetingSchedule schedule;
};

} // namespace

void TestCrowdPhases::pairsArePutDownForTheirFirstStep_data()
{
    QTest::addColumn<double>("speed"); // m/s, of each
    QTest::addColumn<int>("step");     // counted from 0
    // 1.6 m between them close at twice the speed.
    QTest::newRow("after 3.2 s") << 0.25 << 31;
    QTest::newRow("after 2 s") << 0.4 << 19;
    QTest::newRow("after 1.9 s") << 0.8 / 1.9 << 18;
    QTest::newRow("after 1.95 s") << 0.8 / 1.95 << 19;
    QTest::newRow("at rest") << 0.0 << -1;
    QTest::newRow("apart") << -0.1 << -1;
}

void TestCrowdPhases::pairsArePutDownForTheirFirstStep()
{
    QFETCH(double, speed);
    Crowd crowd = crowdOf(headOn(speed));
    QTEST(Sorted(crowd).onlyStep(), "step");
}

void TestCrowdPhases::wallsArePutDownForTheirFirstStep()
{
    // 2.8 m from its edge to the wall at 1 m/s; nobody else is near.
    Crowd crowd = crowdOf({{.position = {1.0, 0.0}, .velocity = {1.0, 0.0}}});
    const Sorted sorted(crowd);
    QCOMPARE(sorted.onlyStep(), 27);
    QCOMPARE(sorted.schedule.due(27)[0].b, Crowd::wall);
}

void TestCrowdPhases::whoMeetsIsGroupedAndWhoDoesNotIsToldOf()
{
    std::vector<Circle> circles = headOn(8.5); // 1.6 m in 0.094 s
    circles.push_back({.position = {0.0, 3.0}});
    Crowd crowd = crowdOf(circles);
    StepGroups groups;
    groups.start(3);
    const std::vector<Crowd::Pair> due{{0, 1}, {0, 2}};
    const std::vector<Crowd::Pair> inVain = grouped(crowd, {}, due, groups);
    QCOMPARE(groups.size(), 2U);
    QCOMPARE(groups.groupOf(groups.of(0)), groups.groupOf(groups.of(1)));
    QVERIFY(!groups.has(2));
    QCOMPARE(inVain.size(), std::size_t{1});
    QCOMPARE(inVain[0].b, 2U);
    // What was in touch stays a group without being due.
    QVERIFY(grouped(crowd, std::vector<Crowd::Pair>{{1, 2}}, {}, groups).empty());
    QVERIFY(!groups.has(0));
    QCOMPARE(groups.groupOf(groups.of(1)), groups.groupOf(groups.of(2)));
}

void TestCrowdPhases::whoSleepsTogetherWakesTogether()
{
    std::vector<Circle> circles{{.position = {0.0, -3.8}}, {.position = {0.4, -3.8}}};
    circles.push_back({.position = {0.0, -3.0}, .velocity = {0.0, -5.0}}); // 0.4 m in 0.075 s
    Crowd crowd = crowdOf(circles, 0.5, 9.81);
    StepGroups groups;
    groups.start(3);
    const std::vector<Crowd::Pair> resting{{0, 1}};
    constexpr int untilSleep = 5; // steps, 0.5 s
    for (int step = 1; step <= untilSleep; ++step) {
        QVERIFY(!crowd.sleeps(0) && !crowd.sleeps(1));
        QVERIFY(grouped(crowd, resting, {}, groups).empty());
        for (const std::uint32_t member : {0U, 1U})
            groups[member].after = crowd.motions[groups[member].slot];
        layToSleep(crowd, dt, groups);
    }
    QVERIFY(crowd.sleeps(0) && crowd.sleeps(1));
    QVERIFY(grouped(crowd, {}, std::vector<Crowd::Pair>{{0, 2}}, groups).empty());
    QVERIFY(!crowd.sleeps(0) && !crowd.sleeps(1));
    QCOMPARE(groups.size(), 3U);
    QCOMPARE(groups.groupOf(groups.of(1)), groups.groupOf(groups.of(2)));
}

void TestCrowdPhases::aPairIsSolvedByHand()
{
    // They meet after 0.08 s at ∓0.2 m, and with e = ½ part at half of the speed.
    Crowd crowd = crowdOf(headOn(10.0), 0.5);
    const Sorted sorted(crowd);
    const Crowd::Slot a = crowd.ids[0] == 0 ? 0 : 1;
    const auto pair = pairStep(crowd, sorted.near.skin(), {dt, 2.0, 20}, a, 1 - a);
    QVERIFY(pair);
    QCOMPARE(pair->hit.time, 1.98);
    QCOMPARE(pair->hit.step, 20);
    QCOMPARE(pair->hit.a, 0);
    QCOMPARE(pair->hit.b, 1);
    QCOMPARE(pair->hit.afterA.x, -5.0);
    QCOMPARE(pair->hit.afterB.x, 5.0);
    QCOMPARE(pair->afterA.position.x, -0.3);
    QCOMPARE(pair->afterB.position.x, 0.3);
    QCOMPARE(pair->fastest, 10.0);
    const double m = mass(Circle{});
    QCOMPARE(pair->hit.impulse, 15.0 * m);
    QCOMPARE(pair->hit.loss, 2.0 * 0.5 * m * (100.0 - 25.0));
}

void TestCrowdPhases::whatIsNotSimpleIsLeftToOthers_data()
{
    QTest::addColumn<double>("speed"); // m/s, of each
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("side"); // by so much both lie towards the wall at the top, m
    QTest::addColumn<bool>("simple");
    QTest::newRow("a hit far from walls") << 10.0 << 0.5 << 0.0 << true;
    QTest::newRow("no rebound") << 10.0 << 0.0 << 0.0 << false;
    QTest::newRow("too slow to meet") << 7.0 << 0.5 << 0.0 << false;
    QTest::newRow("a wall 1.1 m away") << 10.0 << 0.5 << 2.7 << true;
    QTest::newRow("a wall 0.9 m away") << 10.0 << 0.5 << 2.9 << false;
}

void TestCrowdPhases::whatIsNotSimpleIsLeftToOthers()
{
    QFETCH(double, speed);
    QFETCH(double, restitution);
    QFETCH(double, side);
    std::vector<Circle> circles = headOn(speed);
    for (Circle &circle : circles)
        circle.position.y += side;
    Crowd crowd = crowdOf(circles, restitution);
    const Sorted sorted(crowd);
    QTEST(pairStep(crowd, sorted.near.skin(), {dt, 2.0, 20}, 0, 1).has_value(), "simple");
}

QTEST_APPLESS_MAIN(TestCrowdPhases)
#include "test_crowd_phases.moc"
