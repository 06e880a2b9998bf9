// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/check_faults.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::faults;

/// What the checks of starts and motion say, where it can be worked out by hand.
class TestMotionFaults : public QObject
{
    Q_OBJECT
private slots:
    void faultIsSaidToTheLetter_data();
    void faultIsSaidToTheLetter();
};

namespace {

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
           "to judge its motion. For 1 s it was within a step's way of a wall or beyond it: look "
           "at what it does there",
           0, 0.1, 0.0, "s");
    addRow("never free of the other one",
           check("integrates", {1}, {{QStringLiteral("collisions"), true}}),
           drift(beside({.position = {0.3, 0}}), {}),
           "Circle 2 was free of walls and other circles for 0 s only; at least 0.1 s must be seen "
           "to judge its motion. For 1 s it was within a step's way of another circle: look at "
           "what it does there",
           0, 0.1, 0.0, "s");
    addRow("never free of both", check("integrates", {1}),
           drift({{.position = {3.5, 0}}, {.position = {3.85, 0}}}, {}),
           "Circle 2 was free of walls and other circles for 0 s only; at least 0.1 s must be seen "
           "to judge its motion. For 1 s it was within a step's way of a wall or beyond it, for 1 "
           "s of another circle: "
           "look at what it does there",
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

} // namespace

void TestMotionFaults::faultIsSaidToTheLetter_data()
{
    addColumns();
    addStarts();
    addFreeMotion();
}

void TestMotionFaults::faultIsSaidToTheLetter()
{
    COMPARE_FAULT();
}

QTEST_APPLESS_MAIN(TestMotionFaults)
#include "test_motion_faults.moc"
