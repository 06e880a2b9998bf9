// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/wall_programs.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::walls;

/// The checks of walls against programs that are not the engine.
class TestChecksWalls : public QObject
{
    Q_OBJECT
private slots:
    void rightProgramIsAccepted_data();
    void rightProgramIsAccepted();
    void wrongProgramIsRefused_data();
    void wrongProgramIsRefused();
    void wallIsReachedAlongItsNormalOnly();
    void leapToTheOtherSideIsRefused();
    void wallsThatNothingCameToAreNotJudged();
    void asManyHitsAreSeenAsAreAskedFor();
    void slowHitsAreAnsweredOnce_data();
    void slowHitsAreAnsweredOnce();
    void restitutionOfTheCheckCounts();
    void whoStandsStillBehindAHitIsSeen_data();
    void whoStandsStillBehindAHitIsSeen();
    void whoAnswerEachOtherEarlyMetNoWall();
    void leavingTheSquareIsSeenByStaysInside();
    void oneStepBeyondTheWallIsAllowed();
    void comingToRestIsAccepted_data();
    void comingToRestIsAccepted();
    void hoppingForEverIsRefused();
    void hopsOfWhoLooksAheadAreRest();
};

namespace {

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
                // Looking first without setting the circle back sinks under gravity when e < 1.
                if (rightWays[way].step == lookFirst && gravity == down && e < 1.0)
                    continue;
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
    VERIFY_ACCEPTED(judge(check("bounces"), flight(thrown(degrees), gravity, e, rightWays[way])));
}

void TestChecksWalls::wrongProgramIsRefused_data()
{
    QTest::addColumn<int>("index");
    QTest::addColumn<double>("e");
    QTest::addColumn<QString>("word");
    const std::pair<double, const char *> rows[] = {
        {1.0, "along the"},       {1.0, "beyond the ceiling"},
        {1.0, "beyond the"},      {1.0, "touch first"},
        {0.5, "At step"},         {0.5, "with e = 0.5"},
        {0.5, "along the"},       {0.5, "with e = 0.5"},
        {1.0, "already leaving"}, {1.0, "further in from the"},
        {1.0, "along the"}};
    for (std::size_t i = 0; i < std::size(mistakes); ++i)
        QTest::newRow(mistakes[i].name)
            << static_cast<int>(i) << rows[i].first << QString::fromLatin1(rows[i].second);
}

void TestChecksWalls::wrongProgramIsRefused()
{
    QFETCH(int, index);
    QFETCH(double, e);
    QFETCH(QString, word);
    // The hit that nine tenths of a step overshoot, more than a slower step back can make good.
    const Circle late = thrown(0.0, 3.8 / (75.1 * scenes::dt));
    const Circle start = mistakes[index].step == stuck ? late : thrown(61.0);
    VERIFY_REFUSED(judge(check("bounces"), flight(start, {}, e, mistakes[index])), word);
}

/// What comes obliquely goes farther in a step than it comes nearer to the wall in it.
void TestChecksWalls::wallIsReachedAlongItsNormalOnly()
{
    const double room = scenes::halfWidth - 0.2;
    const auto turned = [&](double gap) {
        Circle c{.position = {room - gap, 0.0}, .velocity = {1.0, 3.0}};
        Circle after = c;
        after.velocity.x = -1.0;
        after.position += scenes::dt * after.velocity;
        return after;
    };
    const auto judgeTurn = [&](double gap) {
        const Circle start{.position = {room - gap, 0.0}, .velocity = {1.0, 3.0}};
        return judge(check("bounces"), observed(scene({start}), scenes::dt,
                                                [&](Circles &c, double) { c[0] = turned(gap); }));
    };
    VERIFY_ACCEPTED(judgeTurn(0.9 * scenes::dt));
    VERIFY_REFUSED(judgeTurn(1.1 * scenes::dt), QStringLiteral("touch first"));
}

void TestChecksWalls::leapToTheOtherSideIsRefused()
{
    // Out at one wall and in at the opposite: no velocity changes, and nothing is beyond a wall.
    const Observation o = observed(scene({thrown(20.0)}), 6.0, [](Circles &c, double h) {
        fall(c[0], {}, h);
        atWalls(c[0], [](double &x, double &, double) { x = -x; });
    });
    VERIFY_REFUSED(judge(check("bounces"), o), QStringLiteral("m at once"));
}

void TestChecksWalls::wallsThatNothingCameToAreNotJudged()
{
    VERIFY_REFUSED(judge(check("bounces"), flight({}, {}, 1.0, rightWays[0])),
                   QStringLiteral(": 0; at least 1 must be seen"));
    VERIFY_REFUSED(judge(check("stays_inside"), flight({}, {}, 1.0, rightWays[0])),
                   QStringLiteral("0 times; at least 1 must be seen"));
    // Nor does it help to stand still before a wall, or to creep to the floor.
    const Way frozen{"", [](Circle &, Vec2, double, double) {}};
    VERIFY_REFUSED(judge(check("bounces"), flight(thrown(20.0), {}, 1.0, frozen)),
                   QStringLiteral("must be seen"));
    const Way creeping{"", [](Circle &c, Vec2, double, double) {
                           c.position.y = std::max(c.radius - wall, c.position.y - 0.01);
                           c.velocity = {};
                       }};
    for (const char *kind : {"bounces", "settles"})
        VERIFY_REFUSED(judge(check(kind), flight({}, down, 0.5, creeping)),
                       QStringLiteral("must be seen"));
}

void TestChecksWalls::asManyHitsAreSeenAsAreAskedFor()
{
    // 3.8 m and then 7.6 m at 3 m/s: hits after 1.27 and 3.8 s.
    const Observation o = flight(thrown(0.0), {}, 1.0, rightWays[0]);
    VERIFY_ACCEPTED(judge(check("bounces", {0}, {{QStringLiteral("hits"), 2}}), o));
    VERIFY_REFUSED(judge(check("bounces", {0}, {{QStringLiteral("hits"), 3}}), o),
                   QStringLiteral(": 2; at least 3 must be seen"));
    VERIFY_ACCEPTED(judge(check("stays_inside", {0}, {{QStringLiteral("visits"), 2}}), o));
    VERIFY_REFUSED(judge(check("stays_inside", {0}, {{QStringLiteral("visits"), 3}}), o),
                   QStringLiteral("2 times; at least 3 must be seen"));
}

void TestChecksWalls::slowHitsAreAnsweredOnce_data()
{
    QTest::addColumn<int>("way");
    for (int way = 0; way < static_cast<int>(std::size(rightWays)); ++way)
        QTest::newRow(rightWays[way].name) << way;
    QTest::newRow("neither back nor test, symplectic Euler") << -1;
    QTest::newRow("neither back nor test, Euler") << -2;
}

/// Turned without a way back and without asking where it goes to, which fast hits hardly show.
void TestChecksWalls::slowHitsAreAnsweredOnce()
{
    QFETCH(int, way);
    const Way blind{"", stuck};
    const Way blindEuler{"", [](Circle &c, Vec2 gravity, double e, double h) {
                             c.position += h * c.velocity;
                             c.velocity += h * gravity;
                             atWalls(c, [&](double &, double &v, double) { v *= -e; });
                         }};
    CheckSpec slow = check("bounces");
    slow.scene = {{QStringLiteral("kind"), QStringLiteral("slow")},
                  {QStringLiteral("count"), 12},
                  {QStringLiteral("duration"), 0.5},
                  {QStringLiteral("timesteps"), QJsonArray{1.0 / 30.0}},
                  {QStringLiteral("gravity"), json(down)}};
    for (qint64 seed = 1; seed <= 40; ++seed) {
        bool refused = false;
        for (const Variant &variant : makeVariants(scene({Circle{}}), slow, seed)) {
            const Way &program = way >= 0 ? rightWays[way] : way == -1 ? blind : blindEuler;
            const Observation o =
                observed(variant.preset, variant.duration,
                         [&](Circles &c, double h) { program.step(c[0], down, 1.0, h); });
            const auto fault = judge(slow, o);
            QVERIFY2(!fault || way < 0, say(fault).constData());
            refused = refused || fault;
        }
        QVERIFY2(refused == (way < 0), qPrintable(QStringLiteral("seed %1").arg(seed)));
    }
}

void TestChecksWalls::restitutionOfTheCheckCounts()
{
    const Observation o = flight(thrown(10.0), {}, 0.5, rightWays[0]);
    VERIFY_ACCEPTED(judge(check("bounces"), o));
    const QJsonObject elastic{{QStringLiteral("restitution"), 1.0}};
    VERIFY_REFUSED(judge(check("bounces", {0}, elastic), o), QStringLiteral("is right"));
}

void TestChecksWalls::whoStandsStillBehindAHitIsSeen_data()
{
    QTest::addColumn<Vec2>("gravity");
    QTest::newRow("without gravity") << Vec2{};
    QTest::newRow("under gravity") << down;
}

void TestChecksWalls::whoStandsStillBehindAHitIsSeen()
{
    QFETCH(Vec2, gravity);
    for (int pause = 0; pause <= 4; ++pause) {
        int left = 0;
        const Observation o =
            observed(scene({thrown(61.0, 5.0)}, gravity, 1.0), 2.0, [&](Circles &c, double h) {
                const Vec2 before = c[0].velocity;
                if (left-- > 0) {
                    c[0].velocity += h * gravity;
                    return;
                }
                rightWays[0].step(c[0], gravity, 1.0, h);
                left = length(c[0].velocity - before) > 1.0 ? pause : 0;
            });
        const auto fault = judge(check("bounces"), o);
        if (pause < 3)
            VERIFY_ACCEPTED(fault);
        else
            VERIFY_REFUSED(fault, QStringLiteral("After a hit"));
    }
}

/// Two turn round half a metre from each other; one alone did so because of a wall.
void TestChecksWalls::whoAnswerEachOtherEarlyMetNoWall()
{
    const Circle one{.position = {-1.0, 0.0}, .velocity = {1.0, 0.0}};
    const Circle two{.position = {1.0, 0.0}, .velocity = {-1.0, 0.0}};
    for (const std::size_t turned : {1u, 2u}) {
        const Observation o = observed(scene({one, two}, {}, 1.0), 1.0, [&](Circles &c, double h) {
            for (std::size_t i = 0; i < 2; ++i) {
                c[i].position += h * c[i].velocity;
                if (i < turned && std::abs(c[i].position.x) < 0.45
                    && c[i].position.x * c[i].velocity.x < 0.0)
                    c[i].velocity.x *= -1.0;
            }
        });
        CheckSpec close = check(
            "bounces", {0, 1}, {{QStringLiteral("collisions"), true}, {QStringLiteral("hits"), 0}});
        VERIFY_REFUSED(judge(close, o), turned == 2 ? QStringLiteral("the velocity of circle 1")
                                                    : QStringLiteral("touch first"));
        close.scene.insert(QStringLiteral("kind"), QStringLiteral("encounters"));
        if (turned == 2)
            VERIFY_ACCEPTED(judge(close, o));
        else
            VERIFY_REFUSED(judge(close, o), QStringLiteral("touch first"));
    }
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
    const Observation o = observed(scene({Circle{}}, down, e), 60.0, [&](Circles &c, double h) {
        rightWays[way].step(c[0], down, e, h);
    });
    VERIFY_ACCEPTED(judge(check("settles"), o));
    VERIFY_ACCEPTED(judge(check("stays_inside"), o));
}

void TestChecksWalls::hoppingForEverIsRefused()
{
    const Observation o = observed(scene({Circle{}}, down, 0.75), 60.0,
                                   [](Circles &c, double h) { goBack(c[0], down, 1.0, h); });
    VERIFY_REFUSED(judge(check("settles"), o), QStringLiteral("still comes"));
}

/// Turned a step before it would be beyond the floor it goes up from there: that lifts each hop.
void TestChecksWalls::hopsOfWhoLooksAheadAreRest()
{
    const auto hopping = [](double e, double more) {
        return observed(scene({Circle{}}, down, e), 60.0, [e, more](Circles &c, double h) {
            fall(c[0], down, h);
            if (c[0].position.y < c[0].radius - wall) {
                c[0].position -= h * c[0].velocity;
                c[0].velocity.y *= -e * more;
                c[0].position += h * c[0].velocity;
            }
        });
    };
    for (const double e : {0.5, 0.75, 0.9})
        VERIFY_ACCEPTED(judge(check("settles"), hopping(e, 1.0)));
    // A hit that takes two thirds of what it should hops higher than any timestep explains.
    VERIFY_REFUSED(judge(check("settles"), hopping(0.9, 0.935 / 0.9)),
                   QStringLiteral("still comes"));
}

QTEST_APPLESS_MAIN(TestChecksWalls)
#include "test_checks_walls.moc"
