// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/check_faults.h"
#include "tests/wall_programs.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::faults;

/// What the checks of starts, motion, walls and rest say, where it can be worked out by hand.
class TestMotionFaults : public QObject
{
    Q_OBJECT
private slots:
    void faultIsSaidToTheLetter_data();
    void faultIsSaidToTheLetter();
    void smallHopsAreRest();
    void onlyTheLastFiveSecondsAreRest();
    void aBallThatLosesNothingNeedNotRest();
    void whoHardlyFallsHasNotFallen();
};

namespace {

const Vec2 unitGravity{0, -1};
const QString tolerance = QStringLiteral("tolerance");

/// One at rest in the middle, and \p second.
std::vector<Circle> beside(const Circle &second)
{
    return {{}, second};
}

/// A change of circle \p i at \p step.
std::vector<Change> change(int step, std::size_t i, const std::function<void(Circle &)> &make)
{
    return {{step, [i, make](Circles &c) { make(c[i]); }}};
}

/// The second is held where it is, and has these velocities one after the other.
std::vector<Change> held(const std::vector<Vec2> &velocities, Vec2 place)
{
    std::vector<Change> changes;
    for (std::size_t k = 0; k < velocities.size(); ++k)
        changes.push_back({static_cast<int>(k) + 1, [v = velocities[k], place](Circles &c) {
                               c[1].position = place;
                               c[1].velocity = v;
                           }});
    return changes;
}

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

void addStarts()
{
    const std::vector<Circle> two = beside({.position = {0, 1}});
    addRow("another place", check("start", {0, 1}, {{QStringLiteral("position"), json({0, 0})}}),
           drift(two, {}),
           "The position of circle 2 is (0, 1) m at the start; (0, 0) m is asked for", 0, 0.0, 1.0,
           "m");
    addRow("another density", check("start", {1}, {{QStringLiteral("density"), 1.0}}),
           drift(two, {}),
           "The density of circle 2 is 7.8 · 1000 kg/m³ at the start; 1 · 1000 kg/m³ is asked for",
           0, 1.0, 7.8, "· 1000 kg/m³");
    addRow("another count", check("start", {0}, {{QStringLiteral("count"), 3}}), drift(two, {}),
           "There are 2 circles; 3 are asked for", 0, 3.0, 2.0);
    const Circle moving{.velocity = {1, 0}};
    addRow("not together", check("together", {0, 1}),
           drift({moving, moving}, change(2, 1, [](Circle &c) { c.position.x += 0.1; })),
           "At step 2 circle 1 is at (0.2, 0) m with (1, 0) m/s and circle 2 at (0.3, 0) m with "
           "(1, 0) m/s; they should be in the same place with the same velocity",
           2, 0.0, 0.1, "m");
    const Circle slow{.velocity = {0.1, 0}};
    addRow("together, but still", check("together", {0, 1}), drift({slow, slow}, {}),
           "Circle 1 came 0.1 m far in 1 s; at least its diameter of 0.4 m must be seen to judge "
           "whether they stay together",
           10, 0.4, 0.1, "m");
    // 0.30000005 s is the third step, but for a rounding.
    QJsonArray place;
    place.append(json({1, 1}));
    addRow("ends elsewhere",
           check("ends_at", {1},
                 {{QStringLiteral("positions"), place}, {QStringLiteral("time"), 0.30000005}}),
           drift(two, {}), "At 0.3 s circle 2 is at (0, 1) m; (1, 1) m is right", 3, 1.0, 0.0, "m");
}

void addFreeMotion()
{
    const auto integrators = [](const char *name) {
        return QJsonObject{{QStringLiteral("integrators"), QJsonArray{QLatin1String(name)}}};
    };
    const std::vector<Circle> two = beside({.position = {1, 0}});
    addRow(
        "another acceleration", check("integrates", {0, 1}),
        drift(two, change(2, 1, [](Circle &c) { c.velocity.y -= 0.1; }), 1.0, unitGravity),
        "At step 2 the velocity of circle 2 changed by (0, -0.2) m/s, an acceleration of (0, -2) "
        "m/s²; (0, -1) m/s² is right here",
        2, -1.0, -2.0, "m/s²");
    // Its radius is 0.2 m, and a right one would turn at 3.8 m.
    addRow("turned before the wall", check("integrates", {1}),
           drift(beside({.position = {3.5, 0}, .velocity = {1, 0}}),
                 change(2, 1, [](Circle &c) { c.velocity.x = -1.0; })),
           "At step 2 circle 2 turned round although its rim was still 0.2 m from the right wall; "
           "it should touch first",
           2, 1.0, -1.0, "m/s");
    addRow("turned before the wall, with losses", check("integrates", {1}),
           drift(beside({.position = {3.5, 0}, .velocity = {1, 0.5}}),
                 change(2, 1, [](Circle &c) { c.velocity.x = -0.4; })),
           "At step 2 circle 2 turned round although its rim was still 0.2 m from the right wall; "
           "it should touch first",
           2, 1.0, -0.4, "m/s");
    // The faster it is, the more of its way along the wall may be rounding.
    addRow("turned before the wall, fast", check("integrates", {1}),
           drift(beside({.position = {3.2, 0}, .velocity = {2.5, 0}}),
                 change(2, 1,
                        [](Circle &c) {
                            c.velocity = {-2.5, 1e-6};
                        })),
           "At step 2 circle 2 turned round although its rim was still 0.35 m from the right wall; "
           "it should touch first",
           2, 2.5, -2.5, "m/s");
    addRow("turned far from walls", check("integrates", {1}),
           drift(beside({.position = {2.5, 0}, .velocity = {1, 0}}),
                 change(2, 1, [](Circle &c) { c.velocity.x = -1.0; })),
           "At step 2 the velocity of circle 2 changed by (-2, 0) m/s, an acceleration of (-20, 0) "
           "m/s²; (0, 0) m/s² is right here",
           2, 0.0, -20.0, "m/s²");
    addRow("another integrator", check("integrates", {1}, integrators("euler")),
           drift(two, {}, 1.0, unitGravity),
           "At step 1 circle 2 moved by (0, -0.01) m; by Euler it moves by (0, 0) m. In this step "
           "symplectic Euler does so",
           1, 0.0, -0.01, "m");
    addRow(
        "too far, without gravity", check("integrates", {1}),
        drift(beside({.velocity = {1, 0}}), change(1, 1, [](Circle &c) { c.position.x += 0.01; })),
        "At step 1 circle 2 moved by (0.11, 0) m; its velocity times the timestep is (0.1, 0) m", 1,
        0.1, 0.11, "m");
    addRow("never free", check("integrates", {1}), drift(beside({.position = {3.85, 0}}), {}),
           "Circle 2 was free of walls and other circles for 0 s only; at least 0.1 s must be seen "
           "to judge its motion. For 1 s it could reach a wall within a step, and for 0 s another "
           "circle: look at what it does there",
           0, 0.1, 0.0, "s");
    addRow("no integrator", check("same_integrator", {0, 1}),
           drift(two, change(2, 1, [](Circle &c) { c.position.x += 0.01; }), 1.0, unitGravity),
           "None of the four integrators makes all steps of circle 2 under gravity (0, -1) m/s²",
           1);
    const QJsonObject either{
        {QStringLiteral("integrators"),
         QJsonArray{QStringLiteral("euler"), QStringLiteral("symplectic_euler")}}};
    const auto back = [](Circles &c) { c[1].position.y += h * h; }; // Euler falls by g h² less
    addRow("two methods one after the other", check("integrates", {1}, either),
           drift(two, {{1, back}, {2, back}, {3, back}}, 1.0, unitGravity),
           "At step 4 circle 2 moves by symplectic Euler, and in steps before by another method; "
           "one for all steps is right",
           4);
    std::vector<Change> euler; // after a step of symplectic Euler, g h² back
    for (int step = 1; step <= 10; ++step)
        euler.push_back({step, [](Circles &c) { c[1].position.y += h * h; }});
    addRow("two integrators", check("same_integrator", {0, 1}), drift(two, euler, 1.0, unitGravity),
           "Circle 1 moves by symplectic Euler and circle 2 by Euler; the same for both is right",
           1);
    addRow("not the parabola", check("closed_form", {1}), drift(two, {}, 1.0, unitGravity),
           "At step 1 circle 2 is at (1, -0.01) m; x₀ + v₀t + ½gt² is (1, -0.005) m", 1, -0.005,
           -0.01, "m");
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
           "Turns at walls in 1 s: 0; at least 1 must be seen to judge them", 10, 1.0, 0.0);
    addRow(
        "no hits away from the other",
        check("bounces", {1}, {{QStringLiteral("collisions"), true}}), drift(beside({}), {}),
        "Turns at walls, away from the other circle, in 1 s: 0; at least 1 must be seen to judge "
        "them",
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
           "At step 2, where it touches nothing, the velocity of circle 2 went from (0.1, 0) to "
           "(-0.3, 0) m/s; (0.1, 0) m/s is right. Hits are judged once this is mended",
           2, 0.1, -0.3, "m/s");
    // The other one may push it back to the wall in every step.
    addRow(
        "stuck beside the other one", check("bounces", {1}, {{QStringLiteral("collisions"), true}}),
        drift({{.position = {3.35, 0}}, {.position = {3.75, 0}, .velocity = {1, 0}}},
              held(std::vector<Vec2>(10, {1, 0}), {3.75, 0})),
        "Turns at walls, away from the other circle, in 1 s: 0; at least 1 must be seen to judge "
        "them",
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

void TestMotionFaults::faultIsSaidToTheLetter_data()
{
    addColumns();
    addStarts();
    addFreeMotion();
    addWalls();
    addRest();
}

void TestMotionFaults::faultIsSaidToTheLetter()
{
    COMPARE_FAULT();
}

void TestMotionFaults::smallHopsAreRest()
{
    // 6 cm are always allowed.
    VERIFY_ACCEPTED(judge(check("settles", {1}), hopping(5, 0.05, 0)));
    QVERIFY(judge(check("settles", {1}), hopping(5, 0.07, 0)));
}

void TestMotionFaults::onlyTheLastFiveSecondsAreRest()
{
    VERIFY_ACCEPTED(judge(check("settles", {1}), hopping(20, 1.0, 52)));
    QVERIFY(judge(check("settles", {1}), hopping(20, 1.0, 48)));
}

void TestMotionFaults::aBallThatLosesNothingNeedNotRest()
{
    // Nor does the reference, which hops as high for ever.
    const Observation o = observed(scene({Circle{}}, walls::down), 10.0, [](Circles &c, double dt) {
        walls::goBack(c[0], walls::down, 1.0, dt);
    });
    VERIFY_ACCEPTED(judge(check("settles"), o));
}

/// Under 10 m/s², 1 m/s: what falls for a tenth of a second.
void TestMotionFaults::whoHardlyFallsHasNotFallen()
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

QTEST_APPLESS_MAIN(TestMotionFaults)
#include "test_motion_faults.moc"
