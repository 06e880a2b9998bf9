// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/programs.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::programs;
using scenes::dt;

/// The checks of walls against programs that are not the engine.
class TestChecksWalls : public QObject
{
    Q_OBJECT
private slots:
    void rightProgramIsAccepted_data();
    void rightProgramIsAccepted();
    void wrongProgramIsRefused_data();
    void wrongProgramIsRefused();
    void circleInAFreeSquareIsAccepted();
    void restitutionOfTheCheckCounts();
    void leavingTheSquareIsSeenByStaysInside();
    void oneStepBeyondTheWallIsAllowed();
    void comingToRestIsAccepted_data();
    void comingToRestIsAccepted();
    void hoppingForEverIsRefused();
};

namespace {

constexpr double wall = scenes::halfWidth;
constexpr Vec2 down{0.0, -scenes::g};

/// Calls \p hit with a component of position and velocity for each wall that the rim is beyond.
void atWalls(Circle &c, const std::function<void(double &x, double &v, double side)> &hit)
{
    for (const double side : {-1.0, 1.0}) {
        if (side * c.position.x + c.radius > wall)
            hit(c.position.x, c.velocity.x, side);
        if (side * c.position.y + c.radius > wall)
            hit(c.position.y, c.velocity.y, side);
    }
}

struct Way {
    const char *name;
    void (*step)(Circle &c, Vec2 gravity, double e, double h);
};

void goBack(Circle &c, Vec2 gravity, double e, double h)
{
    const Vec2 old = c.position;
    fall(c, gravity, h);
    bool back = false;
    atWalls(c, [&](double &, double &v, double side) {
        back = true;
        if (v * side > 0.0)
            v *= -e;
    });
    if (back)
        c.position = old;
}

void clamp(Circle &c, Vec2 gravity, double e, double h)
{
    fall(c, gravity, h);
    const double reach = wall - c.radius;
    atWalls(c, [&](double &x, double &v, double side) {
        x = side * reach;
        if (v * side > 0.0)
            v *= -e;
    });
}

void mirror(Circle &c, Vec2 gravity, double e, double h)
{
    fall(c, gravity, h);
    const double reach = wall - c.radius;
    atWalls(c, [&](double &x, double &v, double side) {
        x = side * reach - e * (x - side * reach);
        if (v * side > 0.0)
            v *= -e;
    });
}

/// Looks before it moves: the hit shows one step late.
void lookFirst(Circle &c, Vec2 gravity, double e, double h)
{
    atWalls(c, [&](double &, double &v, double side) {
        if (v * side > 0.0)
            v *= -e;
    });
    fall(c, gravity, h);
}

/// Velocity turned round after the position was carried on (Euler).
void eulerGoBack(Circle &c, Vec2 gravity, double e, double h)
{
    const Vec2 old = c.position;
    c.position += h * c.velocity;
    bool back = false;
    atWalls(c, [&](double &, double &v, double side) {
        back = true;
        if (v * side > 0.0)
            v *= -e;
    });
    c.velocity += h * gravity;
    if (back)
        c.position = old;
}

constexpr Way rightWays[] = {{"goes back", goBack},
                             {"clamps", clamp},
                             {"mirrors the overshoot", mirror},
                             {"looks before it moves", lookFirst},
                             {"Euler, goes back", eulerGoBack}};

Circle thrown(double degrees, double speed = 3.0)
{
    const double a = degrees * scenes::pi / 180.0;
    return {.velocity = {speed * std::cos(a), speed * std::sin(a)}};
}

Observation flight(const Circle &start, Vec2 gravity, double e, const Way &way)
{
    return observed(scene({start}, gravity, e), 6.0,
                    [&](Circles &c, double h) { way.step(c[0], gravity, e, h); });
}

// The known mistakes, each a change of the right program.

void wholeVelocity(Circle &c, Vec2 gravity, double e, double h)
{
    const Vec2 old = c.position;
    fall(c, gravity, h);
    bool hit = false;
    atWalls(c, [&](double &, double &, double) { hit = true; });
    if (hit) {
        c.position = old;
        c.velocity = -e * c.velocity;
    }
}

void twoWalls(Circle &c, Vec2 gravity, double e, double h)
{
    fall(c, gravity, h);
    if (std::abs(c.position.x) + c.radius > wall && c.position.x * c.velocity.x > 0.0)
        c.velocity.x *= -e;
}

void centre(Circle &c, Vec2 gravity, double e, double h)
{
    const double radius = c.radius;
    c.radius = 0.0;
    goBack(c, gravity, e, h);
    c.radius = radius;
}

void margin(Circle &c, Vec2 gravity, double e, double h)
{
    c.radius += 0.1;
    goBack(c, gravity, e, h);
    c.radius -= 0.1;
}

/// Turns round at every step beyond the wall: with e < 1 it never comes out again.
void stuck(Circle &c, Vec2 gravity, double e, double h)
{
    fall(c, gravity, h);
    atWalls(c, [&](double &, double &v, double) { v *= -e; });
}

void twiceRestitution(Circle &c, Vec2 gravity, double e, double h)
{
    goBack(c, gravity, e * e, h);
}

void restitutionOnBothParts(Circle &c, Vec2 gravity, double e, double h)
{
    const Vec2 old = c.position;
    fall(c, gravity, h);
    atWalls(c, [&](double &, double &v, double side) {
        if (v * side > 0.0) {
            v = -v;
            c.velocity = e * c.velocity;
        }
        c.position = old;
    });
}

void absorbed(Circle &c, Vec2 gravity, double, double h)
{
    goBack(c, gravity, 0.0, h);
}

} // namespace

void TestChecksWalls::rightProgramIsAccepted_data()
{
    QTest::addColumn<int>("way");
    QTest::addColumn<Vec2>("gravity");
    QTest::addColumn<double>("e");
    QTest::addColumn<double>("degrees");
    for (int way = 0; way < static_cast<int>(std::size(rightWays)); ++way) {
        for (const Vec2 gravity : {Vec2{}, down}) {
            for (const double e : {1.0, 0.5}) {
                for (const double degrees : {0.0, 45.0, 46.3, 90.0, 133.0, 225.0, 307.0})
                    QTest::addRow("%s, e = %g, %g degrees%s", rightWays[way].name, e, degrees,
                                  gravity == down ? ", gravity" : "")
                        << way << gravity << e << degrees;
            }
        }
    }
}

void TestChecksWalls::rightProgramIsAccepted()
{
    QFETCH(int, way);
    QFETCH(Vec2, gravity);
    QFETCH(double, e);
    QFETCH(double, degrees);
    VERIFY_ACCEPTED(
        judge(check("bounces"), flight(thrown(degrees), gravity, e, rightWays[way])));
}

void TestChecksWalls::wrongProgramIsRefused_data()
{
    QTest::addColumn<int>("index");
    QTest::addColumn<double>("e");
    QTest::addColumn<QString>("word");
    int index = 0;
    QTest::newRow("whole velocity turned") << index++ << 1.0 << QStringLiteral("along the");
    QTest::newRow("only two walls") << index++ << 1.0 << QStringLiteral("beyond the ceiling");
    QTest::newRow("centre instead of rim") << index++ << 1.0 << QStringLiteral("beyond the");
    QTest::newRow("margin") << index++ << 1.0 << QStringLiteral("touch first");
    QTest::newRow("stuck in the wall") << index++ << 0.5 << QStringLiteral("At step");
    QTest::newRow("e twice") << index++ << 0.5 << QStringLiteral("with e = 0.5");
    QTest::newRow("e along the wall, too") << index++ << 0.5 << QStringLiteral("along the");
    QTest::newRow("no rebound") << index++ << 0.5 << QStringLiteral("with e = 0.5");
}

void TestChecksWalls::wrongProgramIsRefused()
{
    QFETCH(int, index);
    QFETCH(double, e);
    QFETCH(QString, word);
    constexpr Way ways[] = {{"", wholeVelocity},    {"", twoWalls}, {"", centre},
                            {"", margin},           {"", stuck},    {"", twiceRestitution},
                            {"", restitutionOnBothParts}, {"", absorbed}};
    VERIFY_REFUSED(judge(check("bounces"), flight(thrown(61.0), {}, e, ways[index])), word);
}

void TestChecksWalls::circleInAFreeSquareIsAccepted()
{
    VERIFY_ACCEPTED(judge(check("bounces"), flight({}, {}, 1.0, rightWays[0])));
    VERIFY_ACCEPTED(judge(check("stays_inside"), flight({}, {}, 1.0, rightWays[0])));
}

void TestChecksWalls::restitutionOfTheCheckCounts()
{
    const Observation o = flight(thrown(10.0), {}, 0.5, rightWays[0]);
    VERIFY_ACCEPTED(judge(check("bounces"), o));
    const QJsonObject elastic{{QStringLiteral("restitution"), 1.0}};
    VERIFY_REFUSED(judge(check("bounces", {0}, elastic), o), QStringLiteral("with e = 1"));
}

void TestChecksWalls::leavingTheSquareIsSeenByStaysInside()
{
    const Way none{"", [](Circle &c, Vec2 gravity, double, double h) { fall(c, gravity, h); }};
    const auto fault = judge(check("stays_inside"), flight(thrown(180.0), {}, 1.0, none));
    VERIFY_REFUSED(fault, QStringLiteral("left wall"));
    // 3.8 m at 3 m/s take 76 steps; one step more may show.
    QCOMPARE(fault->step, qint64{78});
    QCOMPARE(fault->unit, QStringLiteral("m"));
    COMPARE_NEAR(*fault->observed, 0.1, 1e-9);
}

void TestChecksWalls::oneStepBeyondTheWallIsAllowed()
{
    VERIFY_ACCEPTED(judge(check("stays_inside"), flight(thrown(7.0), {}, 1.0, rightWays[3])));
}

void TestChecksWalls::comingToRestIsAccepted_data()
{
    QTest::addColumn<int>("way");
    QTest::addColumn<double>("e");
    for (int way = 0; way < 3; ++way) {
        for (const double e : {0.5, 0.9})
            QTest::addRow("%s, e = %g", rightWays[way].name, e) << way << e;
    }
}

void TestChecksWalls::comingToRestIsAccepted()
{
    QFETCH(int, way);
    QFETCH(double, e);
    const Observation o =
        observed(scene({Circle{}}, down, e), 60.0,
                 [&](Circles &c, double h) { rightWays[way].step(c[0], down, e, h); });
    VERIFY_ACCEPTED(judge(check("settles"), o));
    VERIFY_ACCEPTED(judge(check("stays_inside"), o));
}

void TestChecksWalls::hoppingForEverIsRefused()
{
    const Observation o = observed(scene({Circle{}}, down, 0.75), 60.0, [](Circles &c, double h) {
        goBack(c[0], down, 1.0, h);
    });
    VERIFY_REFUSED(judge(check("settles"), o), QStringLiteral("still comes"));
}

QTEST_APPLESS_MAIN(TestChecksWalls)
#include "test_checks_walls.moc"
