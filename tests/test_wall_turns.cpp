// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/wall_turn.h"

#include "tests/check_faults.h"

using namespace cradle;
using namespace cradle::kinds;
using namespace cradle::programs;
using namespace cradle::programs::faults;

/// What a look at one turn says of it, at each of its bounds and just beyond. Gravity of 10 m/s²
/// changes a velocity by 1 m/s in a step, to the bit.
class TestWallTurns : public QObject
{
    Q_OBJECT
private slots:
    void turnsAtAWallAreJudged_data();
    void turnsAtAWallAreJudged();
    void turnsInTheOpenAreJudged_data();
    void turnsInTheOpenAreJudged();
    void placesAtAWallAreJudged_data();
    void placesAtAWallAreJudged();
    void placesOfSteadyStraysAreNot();
    void turnsBeforeAWallAreSeen_data();
    void turnsBeforeAWallAreSeen();
};

namespace {

constexpr Vec2 down{0, -10};

/// Circle 2 before and after the first of six steps; the others it drifts.
Observation turning(const Circle &before, const Circle &after, Vec2 gravity, Vec2 first = {},
                    Vec2 firstAfter = {})
{
    return drift({{.position = {-2, -2}, .velocity = first}, before},
                 {{1,
                   [=](Circles &c) {
                       c[0].velocity = firstAfter;
                       c[1].position = after.position;
                       c[1].velocity = after.velocity;
                   }}},
                 6 * h, gravity);
}

/// What is said to the letter is in test_wall_faults; here, which of the sentences it is.
QString kindOf(const std::optional<Fault> &fault)
{
    if (!fault)
        return {};
    for (const char *part :
         {"3.8 m from the right wall", "3.8 m from the floor", "began away", "touches nothing",
          "turned round again", "was leaving", "only the part into", "along the wall before",
          "−e times", "and gravity,", "is right", "further in", "further out", "beside the ways"}) {
        if (fault->message.contains(QString::fromUtf8(part)))
            return QString::fromUtf8(part);
    }
    return fault->message;
}

void addFaultColumns()
{
    QTest::addColumn<QString>("said");
    QTest::addColumn<double>("expected");
    QTest::addColumn<double>("seen");
}

#define COMPARE_SAID(FAULT)                                                                        \
    do {                                                                                           \
        QFETCH(QString, said);                                                                     \
        QFETCH(double, expected);                                                                  \
        QFETCH(double, seen);                                                                      \
        const std::optional<Fault> found = FAULT;                                                  \
        QCOMPARE(kindOf(found), said);                                                             \
        QVERIFY(!found || std::abs(*found->expected - expected) < 1e-9);                           \
        QVERIFY(!found || std::abs(*found->observed - seen) < 1e-9);                               \
        QVERIFY(!found || (found->step == 1 && found->circle == 1));                               \
    } while (false)

} // namespace

void TestWallTurns::turnsAtAWallAreJudged_data()
{
    QTest::addColumn<Wall>("wall");
    QTest::addColumn<double>("into");  // velocity into it before the step, m/s
    QTest::addColumn<double>("after"); // and after it
    QTest::addColumn<double>("e");
    QTest::addColumn<double>("tolerance");
    QTest::addColumn<bool>("falls");
    addFaultColumns();
    const auto row = [](const char *name, double into, double after, const char *said = "",
                        double expected = 0.0, double e = 1.0, double tolerance = 0.0,
                        Wall wall = Wall::Bottom, bool falls = true) {
        QTest::newRow(name) << wall << into << after << e << tolerance << falls
                            << QString::fromUtf8(said) << expected << after;
    };
    const auto still = [&](const char *name, double into, double after, const char *said = "",
                           double expected = 0.0, double e = 1.0, double tolerance = 0.0) {
        row(name, into, after, said, expected, e, tolerance, Wall::Right, false);
    };
    still("within the tolerance", 3, 2, "", 0, 1, 0.25);
    still("beyond it", 3, 1.875, "is right", -3, 1, 0.25);
    still("elastic", 1, -0.5, "is right", -1);
    still("with e", 1, -0.25, "−e times", -0.5, 0.5);
    // What gravity makes in three steps is rest.
    row("rests", 2, -0.5);
    row("rests no more", 2.125, -1, "and gravity,", -3.125);
    row("rests no more, half a step later", 2.5, -1, "and gravity,", -3.5);
    row("does not rest", 3.5, -0.5, "and gravity,", -4.5);
    row("rests at the ceiling", 2.5, -1, "", 0, 1, 0, Wall::Top);
    row("as fast as it came", 2, -3);
    row("faster than it came", 2, -3.125, "and gravity,", -3);
    row("leaves slowly", -3, -3.5);
    row("leaves faster", -3.125, -3.5, "was leaving", -2.125);
    row("rests within the tolerance", 3, -0.5, "", 0, 1, 0.25);
    row("rests beyond it", 3.0625, -0.5, "is right", -4.0625, 1, 0.25);
    row("as fast within the tolerance", 2, -3.75, "", 0, 0.5, 0.25);
    // Gravity acts before the hit or after it.
    row("after it", 4, -3);
    row("too slow after it", 4, -2.875, "and gravity,", -5);
    row("before it", 4, -5);
    row("too fast before it", 4, -5.125, "and gravity,", -5);
    row("leaves as gravity ends it", -1, -2.5, "was leaving", 0);
    row("comes back by gravity", -0.5, -2, "and gravity,", -0.5);
    row("turned as it leaves", -4, 1, "turned round again", -4);
    row("stopped as it leaves", -4, 0, "was leaving", -3);
    row("gravity within the tolerance", 3, -5.5, "is right", -4, 1, 0.25);
    row("gravity beyond it", 2.75, -5.5, "and gravity,", -3.75, 1, 0.25);
}

void TestWallTurns::turnsAtAWallAreJudged()
{
    QFETCH(Wall, wall);
    QFETCH(double, into);
    QFETCH(double, after);
    QFETCH(double, e);
    QFETCH(double, tolerance);
    QFETCH(bool, falls);
    const Vec2 n = outwardNormal(wall);
    const Vec2 gravity = falls ? down : Vec2{};
    const Observation o = turning({.position = 3.75 * n, .velocity = into * n},
                                  {.position = 3.75 * n, .velocity = after * n}, gravity);
    const Turn turn{o, 1, 0, gravity, e, tolerance};
    COMPARE_SAID((falls ? turn.faultAlong(Wall::Bottom, Wall::Top)
                        : turn.faultAlong(Wall::Left, Wall::Right)));
}

void TestWallTurns::turnsInTheOpenAreJudged_data()
{
    QTest::addColumn<Vec2>("place");
    QTest::addColumn<Vec2>("before");
    QTest::addColumn<Vec2>("after");
    QTest::addColumn<Vec2>("gravity");
    QTest::addColumn<double>("other"); // speed after the step of circle 1, which had 3 m/s
    addFaultColumns();
    const auto row = [](const char *name, Vec2 place, Vec2 before, Vec2 after, Vec2 gravity,
                        const char *said = "", double expected = 0.0, double seen = 0.0,
                        double other = 3.0) {
        QTest::newRow(name) << place << before << after << gravity << other
                            << QString::fromUtf8(said) << expected << seen;
    };
    // Three steps of gravity are no turn.
    row("small", {}, {1.5, 0}, {-1.5, -1}, down);
    row("a turn", {}, {1.625, 0}, {-1.625, -1}, down, "3.8 m from the right wall", 1.625, -1.625);
    row("the same way", {}, {1.5, 0}, {5.5, -1}, down);
    // Turned round or a quarter as fast, with gravity before it or after it: as a wall does.
    const auto falls = [&](double after, const char *said) {
        row(qPrintable(QStringLiteral("falling, %1").arg(after)), {}, {0, -3}, {0, after}, down,
            said, -4, after);
    };
    for (const double turned : {0.125, 1.0, 2.0, 4.0})
        falls(turned, "3.8 m from the floor");
    for (const double other : {1.125, 1.875, 4.125})
        falls(other, "began away");
    const auto goes = [&](double after, const char *said) {
        row(qPrintable(QStringLiteral("going, %1").arg(after, 0, 'g', 9)), {}, {0.5, 0}, {after, 0},
            {}, said, 0.5, after);
    };
    for (const double turned : {-0.125, -0.125 - 1.4e-6, -0.5 - 1.4e-6, -0.5 + 1.4e-6})
        goes(turned, "3.8 m from the right wall");
    for (const double other : {-0.125 - 1.6e-6, -0.5 - 1.6e-6, -0.5 + 1.6e-6, -1.0})
        goes(other, "began away");
    row("with another", {}, {1, 0}, {-1, 0}, {}, "3.8 m from the right wall", 1, -1, 4);
    row("with another that is turned", {}, {1, 0}, {-1, 0}, {}, "began away", 1, -1, 4.25);
    row("along the wall", {3.75, 0}, {1, -2}, {-1, -5}, down, "along the wall before", -3, -5);
    row("along the floor", {0, -3.75}, {3, -1}, {1, 1}, {}, "only the part into", 3, 1);
}

void TestWallTurns::turnsInTheOpenAreJudged()
{
    QFETCH(Vec2, place);
    QFETCH(Vec2, before);
    QFETCH(Vec2, after);
    QFETCH(Vec2, gravity);
    QFETCH(double, other);
    const Observation o = turning({.position = place, .velocity = before},
                                  {.position = place + h * after, .velocity = after}, gravity,
                                  {3, 0}, Vec2{other, 0} + h * gravity);
    const bool isVertical = before.x == 0.0 || place.x > 0.0;
    const Turn turn{o, 1, 0, gravity, 0.25, 0.25};
    COMPARE_SAID((isVertical ? turn.faultAlong(Wall::Bottom, Wall::Top)
                             : turn.faultAlong(Wall::Left, Wall::Right)));
}

void TestWallTurns::placesAtAWallAreJudged_data()
{
    QTest::addColumn<Vec2>("gap");    // to the right wall and the floor, m
    QTest::addColumn<Vec2>("before"); // rightward and downward, m/s
    QTest::addColumn<Vec2>("after");
    QTest::addColumn<Vec2>("made"); // inward from both, m
    addFaultColumns();
    const auto row = [](const char *name, Vec2 gap, Vec2 before, Vec2 after, Vec2 made,
                        const char *said = "", double by = 0.0) {
        QTest::newRow(name) << gap << before << after << made << QString::fromUtf8(said) << 0.0
                            << by;
    };
    const Vec2 near{0.02, 3}; // 0.18 m beyond it after the step
    row("twice what is beyond", near, {2, 0}, {-2, 0}, {0.365, 0});
    row("further in", near, {2, 0}, {-2, 0}, {0.375, 0}, "further in", 0.015);
    row("further out", near, {2, 0}, {-2, 0}, {-0.21, 0}, "further out", 0.01);
    row("beside", near, {2, 0}, {-2, 0}, {0, 0.01}, "beside the ways", 0.01);
    row("touching", {0, 3}, {2, 0}, {-2, 0}, {0.5, 0}, "further in", 0.1);
    row("late", {-0.05, 3}, {2, 0}, {-2, 0}, {0.905, 0});
    row("late, further in", {-0.05, 3}, {2, 0}, {-2, 0}, {0.92, 0}, "further in", 0.02);
    row("half turned", near, {2, 0}, {0.9, 0}, {0, 0.5}, "beside the ways", 0.5);
    row("less than half", near, {2, 0}, {1.1, 0}, {0, 0.5});
    row("slower than is seen", near, {0.9e-6, 0}, {-0.9e-6, 0}, {0, 0.5});
    row("out of reach", {0.2001, 3}, {2, 0}, {-2, 0}, {0, 0.5});
    row("pushed off the ceiling, too", near, {2, 0}, {-2, 2}, {0.36, -0.2});
    row("corner", {0.02, 0.02}, {2, 2}, {-2, -2}, {0.36, 0.36});
    row("corner, further in from the floor", {0.02, 0.02}, {2, 2}, {-2, -2}, {0.2, 0.45},
        "further in", 0.09);
}

void TestWallTurns::placesAtAWallAreJudged()
{
    QFETCH(Vec2, gap);
    QFETCH(Vec2, before);
    QFETCH(Vec2, after);
    QFETCH(Vec2, made);
    const auto flipped = [](Vec2 v) { return Vec2{v.x, -v.y}; };
    const Vec2 place{3.8 - gap.x, gap.y - 3.8};
    const Observation o =
        turning({.position = place, .velocity = flipped(before)},
                {.position = place - flipped(made), .velocity = flipped(after)}, {});
    const Turn turn{o, 1, 0, {}, 1.0, 1e-9};
    COMPARE_SAID(turn.misplaced());
}

/// Who goes beside its velocity in the open is told that, and not where a wall puts it.
void TestWallTurns::placesOfSteadyStraysAreNot()
{
    std::vector<Change> changes = held({{-2, 0}}, {3.6, 0.1});
    for (int step = 2; step <= 6; ++step)
        changes.push_back({step, [](Circles &c) { c[1].position.y += 0.1; }});
    const Circle before{.position = {3.78, 0}, .velocity = {2, 0}};
    const Observation strays = drift(beside(before), changes, 6 * h);
    QVERIFY(!(Turn{strays, 1, 0, {}, 1.0, 1e-9}.misplaced()));
    changes.resize(1);
    const Observation once = drift(beside(before), changes, 6 * h);
    QVERIFY((Turn{once, 1, 0, {}, 1.0, 1e-9}.misplaced()));
}

void TestWallTurns::turnsBeforeAWallAreSeen_data()
{
    QTest::addColumn<double>("gap");
    QTest::addColumn<Vec2>("after"); // of 2 m/s to the right
    QTest::addColumn<bool>("isSeen");
    QTest::newRow("turned") << 0.3 << Vec2{-1, 0} << true;
    QTest::newRow("a circle away") << 0.3999 << Vec2{-1, 0} << true;
    QTest::newRow("further") << 0.4001 << Vec2{-1, 0} << false;
    QTest::newRow("along it by rounding") << 0.3 << Vec2{-1, 1.9e-6} << true;
    QTest::newRow("along it") << 0.3 << Vec2{-1, 2.1e-6} << false;
    QTest::newRow("as fast but for rounding") << 0.3 << Vec2{-2 - 1.9e-6, 0} << true;
    QTest::newRow("faster") << 0.3 << Vec2{-2 - 2.1e-6, 0} << false;
    QTest::newRow("hardly turned") << 0.3 << Vec2{-2.1e-6, 0} << true;
    QTest::newRow("stopped") << 0.3 << Vec2{-1.9e-6, 0} << false;
    QTest::newRow("goes on") << 0.3 << Vec2{2, 0} << false;
}

void TestWallTurns::turnsBeforeAWallAreSeen()
{
    QFETCH(double, gap);
    QFETCH(Vec2, after);
    QFETCH(bool, isSeen);
    for (const Vec2 gravity : {Vec2{}, down}) {
        const Circle before{.position = {3.8 - gap, 0}, .velocity = Vec2{2, 0} - h * gravity};
        const Observation o =
            turning(before, {.position = before.position, .velocity = after}, gravity);
        const auto fault = turnBeforeWall(o, 1, 0, gravity);
        QCOMPARE(fault.has_value(), isSeen);
        QVERIFY(!fault || (std::abs(*fault->expected - 2) < 1e-9 && *fault->observed == after.x));
        QVERIFY(!fault
                || (fault->step == 1 && fault->message.contains(QStringLiteral("right wall"))));
    }
}

QTEST_GUILESS_MAIN(TestWallTurns)
#include "test_wall_turns.moc"
