// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/check_faults.h"
#include "tests/wall_programs.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::faults;

/// What the checks of walls and rest say, where it can be worked out by hand.
class TestWallFaults : public QObject
{
    Q_OBJECT
private slots:
    void faultIsSaidToTheLetter_data();
    void faultIsSaidToTheLetter();
    void smallHopsAreRest();
    void onlyTheLastFiveSecondsAreRest();
    void aBallThatLosesNothingNeedNotRest();
    void hopsMayBeTwiceThoseOfTheReference();
    void whoHardlyFallsHasNotFallen();
};

namespace {

/// Circle 2 is held 0.05 m from a wall, with \p before and in all later states with \p after.
Observation atWall(Vec2 place, Vec2 before, Vec2 after, Vec2 gravity = {}, double e = 1.0)
{
    return drift(beside({.position = place, .velocity = before}),
                 held(std::vector<Vec2>(10, after), place), 1.0, gravity, e);
}

/// The heights (m) of the rim of circle 2 above the floor and its velocities upwards, from the
/// start on.
Observation hops(const std::vector<std::pair<double, double>> &states, double e,
                 Vec2 gravity = unitGravity)
{
    const auto set = [](Circle &c, std::pair<double, double> state) {
        c.position = {2, -3.8 + state.first};
        c.velocity = {0, state.second};
    };
    Circle start;
    set(start, states.front());
    std::vector<Change> changes;
    for (std::size_t k = 1; k < states.size(); ++k)
        changes.push_back(
            {static_cast<int>(k), [set, state = states[k]](Circles &c) { set(c[1], state); }});
    return drift(beside(start), changes, h * static_cast<double>(states.size() - 1), gravity, e);
}

/// So many hops of that height, two steps each, then rest on the floor.
Observation hopping(int count, double height, int rests)
{
    std::vector<std::pair<double, double>> states{{height, 0.0}};
    for (int i = 0; i < count; ++i) {
        states.emplace_back(0.0, -2.0);
        states.emplace_back(height, 2.0);
    }
    states.resize(states.size() + static_cast<std::size_t>(rests), {0.0, 0.0});
    return hops(states, 0.5);
}

void addWalls()
{
    const CheckSpec bounces = check("bounces", {1});
    addRow("stuck", bounces, atWall({3.75, 0}, {1, 0}, {1, 0}),
           "At step 3 circle 2 still has 1 m/s into the right wall, as it has since step 1; the "
           "wall should turn it round at once",
           1, -1.0, 1.0, "m/s");
    addRow("too slow", bounces, atWall({3.75, 0}, {1, 0}, {-0.5, 0}),
           "At step 1 circle 2 came to the right wall with 1 m/s and left it with -0.5 m/s; -1 m/s "
           "is right",
           1, -1.0, -0.5, "m/s");
    addRow("too slow for e", bounces, atWall({0, 3.75}, {0, 1}, {0, -0.5}, {}, 0.8),
           "At step 1 circle 2 came to the ceiling with 1 m/s and left it with -0.5 m/s; −e times "
           "1 m/s with e = 0.8 is -0.8 m/s",
           1, -0.8, -0.5, "m/s");
    // Gravity of 0.1 m/s in the step acts after the hit or before it.
    addRow("too slow under gravity", bounces, atWall({0, -3.75}, {0, -1}, {0, 0.5}, unitGravity),
           "At step 1 the velocity of circle 2 into the floor was 1 m/s before the step and -0.5 "
           "m/s after it; with e = 1 and gravity, -1.1 to -0.9 m/s is right",
           1, -1.1, -0.5, "m/s");
    addRow("turned as it leaves", bounces,
           drift(beside({.position = {-3.75, 0}, .velocity = {1, 0}}),
                 held({{-1, 0}, {1, 0}}, {-3.75, 0})),
           "At step 1 circle 2 was already leaving the left wall with 1 m/s and was turned round "
           "again; it should be left alone",
           1, -1.0, 1.0, "m/s");
    addRow("turned in the open", bounces,
           drift(beside({.position = {1, 0}, .velocity = {1, 0}}),
                 change(2, 1, [](Circle &c) { c.velocity.x = -1.0; })),
           "At step 2 circle 2 turned round although its rim was still 2.7 m from the right wall; "
           "it should touch first",
           2, 1.0, -1.0, "m/s");
    addRow("braked along the wall", bounces, atWall({0, -3.75}, {1, -1}, {0.5, 1}),
           "At step 1 circle 2 hit a wall and its velocity along the wall changed from 1 to 0.5 "
           "m/s; only the part into the wall should change",
           1, 1.0, 0.5, "m/s");
    addRow("leaps", bounces,
           drift(beside({.velocity = {1, 0}}), change(2, 1, [](Circle &c) { c.position.x = 2.1; })),
           "At step 2 circle 2 moved by 2 m at once; with its velocity it comes 0.1 m far", 2, 0.1,
           2.0, "m");
    addRow("no hits", bounces, drift(beside({}), {}),
           "Turns at walls in 1 s: 0; at least 1 must be seen to judge them. Nothing moved", 10,
           1.0, 0.0);
    addRow(
        "no hits away from the other",
        check("bounces", {1}, {{QStringLiteral("collisions"), true}}), drift(beside({}), {}),
        "Turns at walls, away from the other circle, in 1 s: 0; at least 1 must be seen to judge "
        "them. Nothing moved",
        10, 1.0, 0.0);
    addRow("faster as it leaves", bounces,
           drift(beside({.position = {0, -3.75}, .velocity = {1, 1}}),
                 held({{1, 1.2}, {1, 1.4}}, {0, -3.75})),
           "At step 1 circle 2 was leaving the floor, with 1 m/s before the step and 1.2 m/s after "
           "it; with gravity alone it is 1 m/s",
           1, -1.0, -1.2, "m/s");
    std::vector<Change> driven;
    for (int step = 1; step <= 10; ++step)
        driven.push_back({step, [](Circles &c) { c[1].velocity.y += 0.2; }});
    driven.push_back({4, [](Circles &c) { c[1].velocity.x = -1; }});
    addRow("driven in every step", bounces,
           drift(beside({.position = {3.5, 0}, .velocity = {1, 1}}), driven),
           "At step 1, where it touches nothing, the velocity of circle 2 went from (1, 1) to (1, "
           "1.2) m/s; (1, 1) m/s is right. Hits are judged once this is mended",
           1, 1.0, 1.2, "m/s");
    // A push that is more than a wall gives back.
    addRow("pushed in the open", bounces,
           drift(beside({.position = {1, 0}, .velocity = {0.1, 0}}),
                 change(2, 1, [](Circle &c) { c.velocity.x = -0.3; })),
           "At step 2, which began away from the walls, the velocity of circle 2 went from "
           "(0.1, 0) to (-0.3, 0) m/s; (0.1, 0) m/s is right. Hits are judged once this "
           "is mended",
           2, 0.1, -0.3, "m/s");
    // A wall that keeps all would turn it round whole.
    addRow("slower, the other way, in the open", bounces,
           drift(beside({.position = {1, 0}, .velocity = {1, 0}}),
                 change(2, 1, [](Circle &c) { c.velocity.x = -0.3; })),
           "At step 2, which began away from the walls, the velocity of circle 2 went from "
           "(1, 0) to (-0.3, 0) m/s; (1, 0) m/s is right. Hits are judged once this "
           "is mended",
           2, 1.0, -0.3, "m/s");
    addRow("stops on the way", check("bounces", {1}),
           drift(beside({.velocity = {1, 0}}), {{3, [](Circles &c) { c[1].velocity = {}; }}}),
           "Turns at walls in 1 s: 0; at least 1 must be seen to judge them. From 0.3 s on nothing "
           "moved",
           10, 1.0, 0.0);
    // A wall may put it back in the last step alone.
    addRow("in place in the last step", check("bounces", {1}),
           drift(beside({.velocity = {1, 0}}), {{9, [](Circles &c) { c[1].velocity = {}; }}}),
           "Turns at walls in 1 s: 0; at least 1 must be seen to judge them", 10, 1.0, 0.0);
    // The other one may push it back to the wall in every step.
    addRow(
        "stuck beside the other one", check("bounces", {1}, {{QStringLiteral("collisions"), true}}),
        drift({{.position = {3.35, 0}}, {.position = {3.75, 0}, .velocity = {1, 0}}},
              held(std::vector<Vec2>(10, {1, 0}), {3.75, 0})),
        "Turns at walls, away from the other circle, in 1 s: 0; at least 1 must be seen to judge "
        "them. Nothing moved",
        10, 1.0, 0.0);
    // It goes to the left, away from the wall that is nearer.
    addRow("turned in the open, far from where it goes", bounces,
           drift(beside({.position = {1, 0}, .velocity = {-1, 0}}),
                 change(2, 1, [](Circle &c) { c.velocity.x = 1.0; })),
           "At step 2 circle 2 turned round although its rim was still 4.7 m from the left wall; "
           "it should touch first",
           2, -1.0, 1.0, "m/s");
    // At rest it is thrown: that way is its velocity's.
    addRow("thrown from rest", bounces,
           drift(beside({.position = {0, 1}}), change(2, 1,
                                                      [](Circle &c) {
                                                          c.velocity.x = 2.0;
                                                          c.position.x = 0.2;
                                                      })),
           "Turns at walls in 1 s: 0; at least 1 must be seen to judge them", 10, 1.0, 0.0);
    addRow("braked along the wall under gravity", bounces,
           drift(beside({.position = {3.75, 0}, .velocity = {0, -1}}),
                 held({{0, -0.6}, {0, -0.7}, {0, -0.8}}, {3.75, 0}), 1.0, unitGravity),
           "At step 1, at a wall, circle 2 had -1 m/s along the wall before the step and -0.6 m/s "
           "after it; with gravity alone it is -1.1 m/s",
           1, -1.1, -0.6, "m/s");
    const CheckSpec inside = check("stays_inside", {1});
    addRow("beyond the wall", inside,
           drift(beside({.position = {3.75, 0}, .velocity = {1, 0}}), {}),
           "At step 2 the rim of circle 2 is 0.15 m beyond the right wall; at most the way of one "
           "step, 0.1 m, is right",
           2, 0.1, 0.15, "m");
    addRow("beyond the wall at rest", inside,
           drift(beside({.position = {3.75, 0}, .velocity = {1, 0}}),
                 change(1, 1, [](Circle &c) { c.velocity = {}; })),
           "At step 2 the rim of circle 2 is 0.05 m beyond the right wall, where it was without "
           "any speed; it should not be beyond it",
           2, 0.0, 0.05, "m");
    addRow("no visits", inside, drift(beside({}), {}),
           "In 1 s circle 2 came to a wall 0 times; at least 1 must be seen to judge whether it "
           "stays inside",
           10, 1.0, 0.0);
}

void addRest()
{
    addRow("never falls", check("settles", {1}), drift(beside({}), {}, 1.0, unitGravity, 0.5),
           "In 1 s circle 2 never came to the floor; that must be seen to judge how it comes to "
           "rest",
           10);
    addRow("creeps to the floor", check("settles", {1}),
           drift(beside({.position = {0, -3.75}}), held(std::vector<Vec2>(10, {0, 0}), {0, -3.8}),
                 1.0, unitGravity, 0.5),
           "In 1 s circle 2 never came to the floor as fast as a fall makes it; that must be seen "
           "to judge how it comes to rest",
           10);
    addRow("still hops", check("settles", {1}), hopping(5, 1.0, 0),
           "After 1 s circle 2 still comes 1 m above the floor with e = 0.5; at most 0.06 m is "
           "right for its integrator",
           10, 0.06, 1.0, "m");
    // It falls from 1 m, rises to 0.5 m, and falls again as the run ends.
    addRow("bounces too high", check("bounce_heights", {1}, {{QStringLiteral("bounces"), 1}}),
           hops({{1.0, 0.0}, {0.5, -1.0}, {0.0, 1.0}, {0.5, 1.0}, {0.25, -1.0}}, 0.5),
           "After bounce 1 circle 2 rises to 0.5 m above the floor; e to the power of 2 times the "
           "first height, with e = 0.5, is 0.25 m",
           3, 0.25, 0.5, "m");
    addRow("does not bounce", check("bounce_heights", {1}), hops({{1.0, 0.0}, {1.0, 0.0}}, 0.5),
           "Circle 2 comes off the floor and down again 0 times; at least 3 is right", 1, 3.0, 0.0);
}

} // namespace

void TestWallFaults::faultIsSaidToTheLetter_data()
{
    addColumns();
    addWalls();
    addRest();
}

void TestWallFaults::faultIsSaidToTheLetter()
{
    COMPARE_FAULT();
}

void TestWallFaults::smallHopsAreRest()
{
    // 6 cm are always allowed.
    VERIFY_ACCEPTED(judge(check("settles", {1}), hopping(5, 0.05, 0)));
    QVERIFY(judge(check("settles", {1}), hopping(5, 0.07, 0)));
}

void TestWallFaults::onlyTheLastFiveSecondsAreRest()
{
    VERIFY_ACCEPTED(judge(check("settles", {1}), hopping(20, 1.0, 52)));
    QVERIFY(judge(check("settles", {1}), hopping(20, 1.0, 48)));
}

void TestWallFaults::aBallThatLosesNothingNeedNotRest()
{
    // Nor does the reference, which hops as high for ever.
    const Observation o = observed(scene({Circle{}}, walls::down), 10.0, [](Circles &c, double dt) {
        walls::goBack(c[0], walls::down, 1.0, dt);
    });
    VERIFY_ACCEPTED(judge(check("settles"), o));
}

/// Without losses that hops to 0.8 m for ever; here the first hit gives back more.
void TestWallFaults::hopsMayBeTwiceThoseOfTheReference()
{
    const auto hopping = [](double times) {
        const Circle start{.position = {0.0, 0.2 + 0.8 - walls::wall}};
        return observed(scene({start}, walls::down), 10.0,
                        [times, isFirst = true](Circles &c, double dt) mutable {
                            const double came = c[0].velocity.y;
                            walls::goBack(c[0], walls::down, 1.0, dt);
                            if (isFirst && came < 0.0 && c[0].velocity.y > 0.0) {
                                c[0].velocity.y *= std::sqrt(times);
                                isFirst = false;
                            }
                        });
    };
    VERIFY_ACCEPTED(judge(check("settles"), hopping(1.8)));
    VERIFY_REFUSED(judge(check("settles"), hopping(2.3)), QStringLiteral("still comes"));
}

/// Under 10 m/s², 1 m/s: what falls for a tenth of a second.
void TestWallFaults::whoHardlyFallsHasNotFallen()
{
    const auto falling = [](double speed) {
        std::vector<Change> changes;
        for (int step = 1; step <= 10; ++step)
            changes.push_back({step, [speed](Circles &c) {
                                   c[1].position = {0, -3.79};
                                   c[1].velocity = {0, -speed};
                               }});
        return drift(beside({.position = {0, -3.79}}), changes, 1.0, {0, -10}, 0.5);
    };
    VERIFY_ACCEPTED(judge(check("settles", {1}), falling(1.05)));
    VERIFY_REFUSED(judge(check("settles", {1}), falling(0.95)), QStringLiteral("never came"));
}

QTEST_APPLESS_MAIN(TestWallFaults)
#include "test_wall_faults.moc"
