// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/check_faults.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::faults;

/// What the check of hits accepts, and what just no more: equal circles of 0.2 m, steps of 0.1 s.
class TestCollisionBounds : public QObject
{
    Q_OBJECT
private slots:
    void boundsAreKept_data();
    void boundsAreKept();
};

namespace {

std::vector<Circle> two(const Circle &a, const Circle &b)
{
    return {a, b};
}

Change leave(int step, Vec2 a, Vec2 b)
{
    return {step, [=](Circles &c) {
                c[0].velocity = a;
                c[1].velocity = b;
            }};
}

/// As equal circles do that meet head on.
Change swap(int step)
{
    return {step, [](Circles &c) { std::swap(c[0].velocity, c[1].velocity); }};
}

Change put(int step, std::size_t circle, Vec2 by)
{
    return {step, [=](Circles &c) { c[circle].position = c[circle].position + by; }};
}

} // namespace

void TestCollisionBounds::boundsAreKept_data()
{
    QTest::addColumn<CheckSpec>("spec");
    QTest::addColumn<Observation>("run");
    QTest::addColumn<QString>("said"); // a part of what is told; nothing: it is right
    CheckSpec spec = check("collides", {0, 1});
    const auto row = [&spec](const char *name, const std::vector<Circle> &circles,
                             const std::vector<Change> &changes, const char *said = "",
                             Vec2 gravity = {}) {
        QTest::newRow(name) << spec << drift(circles, changes, 1.2, gravity)
                            << QString::fromUtf8(said);
    };
    const auto comes = [](double from) {
        return two({.position = {from, 0}, .velocity = {1, 0}}, {.position = {0, 0}});
    };
    // Gravity may move them apart by 0.01 m in a step: so early a hit may be.
    row("nearly early", comes(-0.5099), {swap(1)}, "", unitGravity);
    row("early", comes(-0.5101), {swap(1)}, "touched neither", unitGravity);
    row("twice that in", comes(-0.45), {swap(1), put(1, 1, {-0.0199, 0})}, "", unitGravity);
    row("further in", comes(-0.45), {swap(1), put(1, 1, {-0.0201, 0})}, "0.0201 m", unitGravity);
    // 0.35 m between the centres, and 0.15 m after the step: 0.7 m and a little are explained.
    const auto late = two({.position = {-0.35, 0}, .velocity = {2, 0}}, {.position = {0, 0}});
    row("late", late, {swap(1), put(1, 0, {-0.2 - 0.5, 0})});
    row("late, as far as may be", late, {swap(1), put(1, 0, {-0.2 - 0.705, 0})});
    row("late, further", late, {swap(1), put(1, 0, {-0.2 - 0.715, 0})}, "0.015 m");
    // At the floor the first may be put elsewhere.
    const Vec2 aslant{0.6, 0.8};
    for (const double floor : {-3.75, 0.0})
        row(floor < 0 ? "aside at the floor" : "aside in the open",
            two({.position = {0, floor}, .velocity = aslant},
                {.position = Vec2{0, floor} + 0.45 * aslant}),
            {swap(1), put(1, 0, {-0.1, 0.1})}, floor < 0 ? "" : "to the side");
    // Missed: in which state, and where they are answered after it.
    const auto closing = two({.position = {1, 0}, .velocity = {0.5, 0}}, {.position = {1.38, 0}});
    row("missed from the start", closing, {}, "At step 0 the circles have run into each other");
    row("answered late", closing, {leave(5, {}, {2, 0})},
        "By step 0 the circles have run into each other, and they are answered only in step 5, "
        "which begins with their centres 0.18 m apart");
    row("answered when they are through",
        two({.position = {1, 0}, .velocity = {1, 0}}, {.position = {1.38, 0}}),
        {leave(10, {0, 1}, {})}, "At step 0 the circles have run into each other and go on");
    // What a scene of parting circles begins with.
    spec = check("collides", {0, 1}, {{QStringLiteral("contacts"), 0}});
    const auto parting = [](double density) {
        return two({.position = {-0.05, 0}, .velocity = {-1, 0}, .density = density},
                   {.position = {0.05, 0}, .velocity = {1, 0}, .density = 3 * density});
    };
    // As 1 kg and 3 kg that approach with 1 m/s each leave: 2 m/s back, and rest.
    row("the start alone", parting(kilogram), {leave(1, {2, 0}, {})});
    row("the start alone, wrongly", parting(kilogram), {leave(1, {1, 0}, {-1, 0})}, "moving apart");
    row("a step after the start", parting(kilogram), {leave(2, {2, 0}, {})}, "moving apart");
    row("again as they part again", parting(kilogram), {leave(1, {2, 0}, {}), leave(6, {0, 1}, {})},
        "moving apart");
    // From rest nothing has to be kept but rest.
    spec = check("conserves", {0, 1}, {{QStringLiteral("energy"), true}});
    const auto resting = two({.position = {-0.15, 0}}, {.position = {0.15, 0}});
    row("apart from rest, with energy", resting, {leave(1, {-1, 0}, {1, 0})}, "energy");
    spec = check("conserves", {0, 1});
    row("apart from rest", resting, {leave(1, {-1, 0}, {1, 0})});
    row("the same way from rest", resting, {leave(1, {1, 0}, {1, 0})}, "momentum");
    // A quarter of 1 + 1 m/s.
    spec = check("rebounds", {0, 1}, {{tolerance, 0.25}});
    row("half as fast", comes(-0.45), {leave(1, {0.25, 0}, {0.75, 0})});
    row("less than half", comes(-0.45), {leave(1, {0.25, 0}, {0.6875, 0})}, "0.4375");
    row("faster", comes(-0.45), {leave(1, {-0.25, 0}, {1.25, 0})});
    row("too fast", comes(-0.45), {leave(1, {-0.25, 0}, {1.3125, 0})}, "1.563");
}

void TestCollisionBounds::boundsAreKept()
{
    QFETCH(CheckSpec, spec);
    QFETCH(Observation, run);
    QFETCH(QString, said);
    const auto fault = judge(spec, run);
    const QString message = fault ? fault->message : QString();
    QVERIFY2(message.isEmpty() == said.isEmpty() && message.contains(said), qPrintable(message));
}

QTEST_GUILESS_MAIN(TestCollisionBounds)
#include "test_collision_bounds.moc"
