// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/check_faults.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::faults;

/// What the checks of circle against circle say, where it can be worked out by hand.
class TestContactFaults : public QObject
{
    Q_OBJECT
private slots:
    void faultIsSaidToTheLetter_data();
    void faultIsSaidToTheLetter();
};

namespace {

/// 1 kg at 1 m/s, which overlaps the resting 1 kg by 0.05 m after the first step.
std::vector<Circle> headOn()
{
    return {{.position = {-0.45, 0}, .velocity = {1, 0}, .density = kilogram},
            {.position = {0, 0}, .density = kilogram}};
}

/// Rims 1.6 m from each other.
std::vector<Circle> apart()
{
    return {{.position = {-1, 0}, .velocity = {1, 0}}, {.position = {1, 0}}};
}

/// Both have these velocities from that step on.
std::vector<Change> leave(Vec2 a, Vec2 b, int step = 2)
{
    return {{step, [a, b](Circles &c) {
                 c[0].velocity = a;
                 c[1].velocity = b;
             }}};
}

CheckSpec pair(const char *kind, const QJsonObject &parameters = {})
{
    return check(kind, {0, 1}, parameters);
}

/// Both are accelerated by −2 m/s² in so many steps.
std::vector<Change> falling(int steps)
{
    std::vector<Change> changes;
    for (int step = 1; step <= steps; ++step) {
        changes.push_back({step, [](Circles &c) {
                               c[0].velocity.y -= 0.2;
                               c[1].velocity.y -= 0.2;
                           }});
    }
    return changes;
}

/// One array of two velocities.
QJsonObject velocities(Vec2 a, Vec2 b)
{
    QJsonArray list;
    list.append(json(a));
    list.append(json(b));
    return {{QStringLiteral("velocities"), list}};
}

void addCollisions()
{
    addRow("one turns too early", pair("collides"), drift(apart(), leave({1, 0}, {0, 1}, 3)),
           "At step 3 the velocity of circle 2 changed from (0, 0) to (0, 1) m/s although it "
           "touched neither a wall nor the other circle, from whose rim it was still 1.3 m away",
           3, 0.0, 1.3, "m");
    addRow("one turns when they have moved apart", pair("collides"),
           drift({{.position = {-1, 0}, .velocity = {-1, 0}}, {.position = {1, 0}}},
                 leave({-1, 0}, {1, 0}, 3)),
           "At step 3 the velocity of circle 2 changed from (0, 0) to (1, 0) m/s although the "
           "circles were moving apart, with 1.8 m between their rims",
           3, 0.0, 1.8, "m");
    addRow("one does not fall", pair("collides"),
           drift(apart(), {{2, [](Circles &c) { c[1].velocity.y += 0.1; }}}, 1.0, {0, -1}),
           "At step 2 the velocity of circle 2 went from (0, -0.1) to (0, -0.1) m/s although it "
           "touched neither a wall nor the other circle, from whose rim it was still 1.4 m away; "
           "(0, -0.2) m/s is right",
           2, 0.0, 1.4, "m");
    // The second is at its wall, and turned rightly.
    addRow("one turns too early while a wall turns the other", pair("collides"),
           drift({{.position = {0, 0}, .velocity = {1, 0}},
                  {.position = {3.75, 0}, .velocity = {1, 0}}},
                 leave({0, 1}, {-1, 0}, 1)),
           "At step 1 the velocity of circle 1 changed from (1, 0) to (0, 1) m/s although it "
           "touched neither a wall nor the other circle, from whose rim it was still 3.25 m away",
           1, 0.0, 3.25, "m");
    addRow("both turn too early", pair("collides"), drift(apart(), leave({-1, 0}, {1, 0}, 3)),
           "At step 3 the velocity of circle 1 changed from (1, 0) to (-1, 0) m/s although it "
           "touched neither a wall nor the other circle, from whose rim it was still 1.3 m away",
           3, 0.0, 1.3, "m");
    addRow("both fall otherwise", pair("collides"), drift(apart(), falling(10)),
           "At step 1, where it touches nothing, the velocity of circle 1 went from (1, 0) to (1, "
           "-0.2) m/s; (1, 0) m/s is right. Hits are judged once this is mended",
           1, 0.0, -0.2, "m/s");
    // Twice as far in a step as its velocity takes it, it crosses the wall and is mirrored there.
    std::vector<Change> twice;
    for (int step = 1; step <= 10; ++step)
        twice.push_back({step, [](Circles &c) { c[0].position.x += h * c[0].velocity.x; }});
    twice.push_back({8, [](Circles &c) { c[0].velocity = {-1, 0}; }});
    addRow("one moves twice", pair("collides"),
           drift({{.position = {2.25, 0}, .velocity = {1, 0}}, {.position = {2.25, 2}}}, twice),
           "At step 1, where it touches nothing, circle 1 moved by (0.2, 0) m; its velocity times "
           "the timestep is (0.1, 0) m. Hits are judged once this is mended",
           1, 0.1, 0.2, "m");
    // Two steps of ten are no law of its motion.
    addRow("both fall twice", pair("collides"), drift(apart(), falling(2)),
           "At step 1 the velocity of circle 1 changed from (1, 0) to (1, -0.2) m/s although it "
           "touched neither a wall nor the other circle, from whose rim it was still 1.5 m away",
           1, 0.0, 1.5, "m");
    addRow("both fall while they part", pair("collides"),
           drift({{.position = {-0.15, 0}, .velocity = {-1, 0}},
                  {.position = {0.15, 0}, .velocity = {1, 0}}},
                 falling(10)),
           "At step 3, where it touches nothing, the velocity of circle 1 went from (-1, -0.4) to "
           "(-1, -0.6) m/s; (-1, -0.4) m/s is right. Hits are judged once this is mended",
           3, -0.4, -0.6, "m/s");
    addRow("turned by a wall beside the other", pair("conserves"),
           drift({{.position = {3.4, 0}}, {.position = {3.75, 0}, .velocity = {1, 0}}},
                 leave({0, 0}, {-1, 0}, 1)),
           "In this scene no hit changed the velocities of the circles; one should", 0);
    addRow("turned by one wall both", pair("collides"),
           drift({{.position = {3.75, 0.2}, .velocity = {1, 0}},
                  {.position = {3.75, -0.2}, .velocity = {1, 0}}},
                 leave({-1, 0}, {-1, 0}, 1)),
           "In this scene no velocity changed in a hit of the circles, so there is none to judge",
           0, 1.0, 0.0);
    addRow("hit again while they part", pair("collides"),
           drift({{.position = {-0.05, 0}, .velocity = {-1, 0}},
                  {.position = {0.05, 0}, .velocity = {1, 0}}},
                 leave({1, 0}, {-1, 0})),
           "At step 2 the circles were already moving apart with 2 m/s, and their velocities "
           "changed from (-1, 0) and (1, 0) to (1, 0) and (-1, 0) m/s; circles that move apart "
           "should be left alone",
           2);
    addRow("one turns while they part", pair("collides"),
           drift({{.position = {-0.05, 0}, .velocity = {-1, 0}},
                  {.position = {0.05, 0}, .velocity = {1, 0}}},
                 leave({-1, 0}, {0.5, 1})),
           "At step 2 the velocity of circle 2 changed from (1, 0) to (0.5, 1) m/s, while the "
           "circles moved apart and the other one kept its own; it should stay as it was",
           2);
    // Who neither comes nearer nor parts is not hit, but nor was he moving apart.
    addRow("pushed apart side by side", pair("collides"),
           drift({{.position = {0, -0.19}, .velocity = {2, 0}},
                  {.position = {0, 0.19}, .velocity = {2, 0}}},
                 leave({2, -1}, {2, 1})),
           "At step 2 circle 1 left the hit with (2, -1) m/s and circle 2 with (2, 1) m/s; where "
           "their line of centres points along (0, 1), (2, 0) and (2, 0) m/s are right",
           2, 0.0, -1.0, "m/s");
    addRow("both go on with half", pair("collides"), drift(headOn(), leave({0.5, 0}, {0.5, 0})),
           "At step 2 circle 1 left the hit with (0.5, 0) m/s and circle 2 with (0.5, 0) m/s; "
           "where their line of centres points along (1, 0), (0, 0) and (1, 0) m/s are right",
           2, 0.0, 0.5, "m/s");
    addRow("one goes aside", pair("collides"), drift(headOn(), leave({0, 0.3}, {1, 0})),
           "At step 2 circle 1 left the hit with (0, 0.3) m/s and circle 2 with (1, 0) m/s; where "
           "their line of centres points along (1, 0), (0, 0) and (1, 0) m/s are right",
           2, 0.0, 0.3, "m/s");
    addRow("the second goes too slowly", pair("collides"), drift(headOn(), leave({0, 0}, {0.4, 0})),
           "At step 2 circle 1 left the hit with (0, 0) m/s and circle 2 with (0.4, 0) m/s; where "
           "their line of centres points along (1, 0), (0, 0) and (1, 0) m/s are right",
           2, 1.0, 0.4, "m/s");
    // The floor may have a part in it.
    addRow("aside at the floor", pair("collides"),
           drift({{.position = {0, -3.79}, .velocity = {1, 0}}, {.position = {0.55, -3.79}}},
                 leave({0, 0.3}, {1, 0})),
           "At step 2 circle 1 left the hit with (0, 0.3) m/s and circle 2 with (1, 0) m/s; where "
           "their line of centres points along (1, 0), (0, 0) and (1, 0) m/s are right. A wall is "
           "reached in this step, too: judge it when the walls are right",
           2, 0.0, 0.3, "m/s");
    addRow("no answer", pair("collides"), drift(headOn(), {}),
           "At step 1 the circles have run into each other and go on as if nothing had happened; "
           "they should answer as soon as their distance is r₁ + r₂",
           1);
    // 0.45 m − 4 · 0.1 m.
    addRow("answered late", pair("collides"), drift(headOn(), leave({0, 0}, {1, 0}, 5)),
           "By step 1 the circles have run into each other, and they are answered only in step 5, "
           "which begins with their centres 0.05 m apart; they should answer as soon as their "
           "distance is r₁ + r₂",
           1);
    addRow("no answer with e", pair("collides"), drift(headOn(), {}, 1.0, {}, 0.0),
           "At step 1, with e = 0, the circles have run into each other and go on as if nothing "
           "had happened; they should answer as soon as their distance is r₁ + r₂",
           1);
    addRow("too few", pair("collides", {{QStringLiteral("contacts"), 2}}),
           drift(headOn(), leave({0, 0}, {1, 0})),
           "Hits that the circles answered: 1; at least 2 is right", 0, 2.0, 1.0);
    addRow("none", pair("collides"), drift(apart(), {}),
           "In this scene no velocity changed in a hit of the circles, so there is none to judge",
           0, 1.0, 0.0);
    addRow("leaps away", pair("collides"),
           drift(headOn(), {{2,
                             [](Circles &c) {
                                 c[0].velocity = {};
                                 c[1] = {.position = {2, 0}, .velocity = {1, 0}};
                             }}}),
           "At step 2 circle 2 moved by 2 m at once; with its velocity it comes 0.1 m far", 2, 0.1,
           2.0, "m");
    // Of two laws that are allowed, that which one circle follows is told.
    addRow("one follows the second law",
           pair("collides", {{QStringLiteral("laws"), QJsonArray{QStringLiteral("swap_velocities"),
                                                                 QStringLiteral("stop")}}}),
           drift(headOn(), leave({0.3, 0}, {0, 0})),
           "At step 2 circle 1 left the hit with (0.3, 0) m/s and circle 2 with (0, 0) m/s; where "
           "their line of centres points along (1, 0), (0, 0) and (0, 0) m/s are right",
           2, 0.0, 0.3, "m/s");
    addRow("parts too fast", pair("rebounds"), drift(headOn(), leave({0, 0}, {1, 0}), 1.0, {}, 0.5),
           "At step 2 the circles met with 1 m/s along the line of centres and parted with 1 m/s; "
           "e times as much, with e = 0.5, is 0.5 m/s",
           2, 0.5, 1.0, "m/s");
    addRow("still comes nearer", pair("rebounds"),
           drift(headOn(), leave({0.8, 0}, {0.2, 0}), 1.0, {}, 0.5),
           "At step 2 the circles met with 1 m/s along the line of centres, and after the hit they "
           "still come nearer, with 0.6 m/s; they should part with e times as much as they met "
           "with: with e = 0.5, 0.5 m/s",
           2, 0.5, -0.6, "m/s");
}

} // namespace

void TestContactFaults::faultIsSaidToTheLetter_data()
{
    addColumns();
    addCollisions();
    addRow("momentum lost", pair("conserves"), drift(headOn(), leave({0.5, 0}, {0, 0.4})),
           "At step 2 the hit changed the total momentum from (1, 0) to (0.5, 0.4) kg m/s; it "
           "should stay",
           2, 1.0, 0.5, "kg m/s");
    addRow("momentum gained aside", pair("conserves"), drift(headOn(), leave({0.9, 0}, {0, 0.4})),
           "At step 2 the hit changed the total momentum from (1, 0) to (0.9, 0.4) kg m/s; it "
           "should stay",
           2, 0.0, 0.4, "kg m/s");
    addRow("momentum lost far from each other", pair("conserves"),
           drift({{.position = {-1, 0}, .velocity = {1, 0}, .density = kilogram},
                  {.position = {1, 0}, .density = kilogram}},
                 leave({0.5, 0}, {0, 0}, 3)),
           "At step 3, where the circles do not touch, the total momentum changed from (1, 0) to "
           "(0.5, 0) kg m/s; it should stay",
           3, 1.0, 0.5, "kg m/s");
    addRow("momentum lost in every step", pair("conserves"), drift(apart(), falling(10)),
           "At step 1, where it touches nothing, the velocity of circle 1 went from (1, 0) to (1, "
           "-0.2) m/s; (1, 0) m/s is right. Hits are judged once this is mended",
           1, 0.0, -0.2, "m/s");
    // ½ 1 kg (1 m/s)², then twice ½ 1 kg (½ m/s)².
    addRow("energy lost", pair("conserves", {{QStringLiteral("energy"), true}}),
           drift(headOn(), leave({0.5, 0}, {0.5, 0})),
           "At step 2 the hit changed the kinetic energy from 0.5 to 0.25 J; it should stay", 2,
           0.5, 0.25, "J");
    // Beside each other, where they overlap and part.
    const Circles parting = {{.position = {-0.05, 0}, .velocity = {-1, 0}, .density = kilogram},
                             {.position = {0.05, 0}, .velocity = {1, 0}, .density = kilogram}};
    addRow("momentum lost while they part", pair("conserves"),
           drift(parting, leave({-1, 0}, {1, 0.5}, 2)),
           "At step 2, while the circles did not come nearer, the total momentum changed from (0, "
           "0) to (0, 0.5) kg m/s; it should stay",
           2, 0.0, 0.5, "kg m/s");
    addRow("energy lost while they part", pair("conserves", {{QStringLiteral("energy"), true}}),
           drift(parting, leave({-0.5, 0}, {0.5, 0}, 2)),
           "At step 2, while the circles did not come nearer, the kinetic energy changed from 1 "
           "to 0.25 J; it should stay",
           2, 1.0, 0.25, "J");
    addRow("no energy lost where nothing meets", pair("loses_energy"),
           drift(apart(), leave({-1, 0}, {0, 0}, 1)),
           "In this scene no hit changed the velocities of the circles; one should", 0);
    addRow("no energy lost while they part", pair("loses_energy"),
           drift(parting, leave({1, 0}, {-1, 0}, 1)),
           "In this scene no hit changed the velocities of the circles; one should", 0);
    addRow("nothing to conserve", pair("conserves"), drift(apart(), {}),
           "In this scene no hit changed the velocities of the circles; one should", 0);
    addRow("the first leaves with another velocity", pair("after_contact", velocities({}, {1, 0})),
           drift(headOn(), leave({0.5, 0}, {0.5, 0})),
           "At step 2 circle 1 left the first hit with (0.5, 0) m/s; (0, 0) m/s is right", 2, 0.0,
           0.5, "m/s");
    addRow("the second does", pair("after_contact", velocities({0.5, 0}, {0.5, 0.2})),
           drift(headOn(), leave({0.5, 0}, {0.5, 0})),
           "At step 2 circle 2 left the first hit with (0.5, 0) m/s; (0.5, 0.2) m/s is right", 2,
           0.2, 0.0, "m/s");
    addRow("no energy lost", pair("loses_energy"), drift(headOn(), leave({0, 0}, {1, 0})),
           "At step 2 the kinetic energy was 0.5 J before the hit and 0.5 J after it; with e below "
           "1 it should be less",
           2, 0.5, 0.5, "J");
    addRow("never meet as they should pass", pair("passes_through"), drift(apart(), {}, 0.2),
           "In this scene the circles never met, so nothing shows whether they pass through each "
           "other",
           0);
    // Under 1 m/s² both have fallen for two steps before, and for three after it.
    addRow("kicked as they should pass", pair("passes_through"),
           drift(apart(), {{3, [](Circles &c) { c[1].velocity.x = 1.0; }}}, 1.0, {0, -1}),
           "At step 3 the velocity of circle 2 changed from (0, -0.2) to (1, -0.3) m/s; the "
           "circles should pass through each other unchanged",
           3);
}

void TestContactFaults::faultIsSaidToTheLetter()
{
    COMPARE_FAULT();
}

QTEST_APPLESS_MAIN(TestContactFaults)
#include "test_contact_faults.moc"
