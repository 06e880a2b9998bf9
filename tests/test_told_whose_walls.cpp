// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_words.h"

#include "tests/told_numbers.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// What is told of walls is told of those circles, walls and hits alone of which it was seen.
class TestToldWhoseWalls : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void circlesAreToldWithTheirOwnWalls_data();
    void circlesAreToldWithTheirOwnWalls();
    void slowHitsAreToldWithTheirOwnWalls();
    void hitsBesideRightOnesAreSome();
    void outwardIsToldOfThoseThatMoveOutward();
    void mostOfManyKindsAreTold();
    void hitsThatHangOnEAreToldWithIt();
    void heldHitsAreNotTurnedRound();
    void slowHitsThatComeTooEarlyAreSlow();
    void lengthsAreToldWallByWall();
    void aStepTooLateIsTold();
    void oneSpeedOfTheWholeVelocityIsTold();
    void densityInTheSpeedIsTold();
    void whoIsHeldBesideAWallIsNotTurned();
    void whoStopsInACornerIsTold();
    void wallThatAsksForAnotherIsNoneThatAsksForNothing();

private:
    [[nodiscard]] std::vector<LawDeviation> found(const QString &walls, const char *step) const
    {
        const LawBench bench(task(QLatin1String(step)));
        const QString program = written({.walls = walls}, structures[3]);
        const MeasuredLaws own(&program, bench.ground);
        return wallDeviations(own.walls(), bench.right.walls(), bench.ground);
    }
    [[nodiscard]] QString body(const QString &walls, const char *step, const char *headline) const
    {
        return bodyOf(found(walls, step), QString::fromUtf8(headline));
    }
};

namespace {

/// Circle 1 at the right wall and circle 2 at the floor do \p odd, with the coordinate s and the
/// speed v into the wall, w along it; all else is right.
QString atTwoWalls(const char *odd)
{
    QString text = wallsOf(wallWays[0], "c.radius", "restitution");
    return text.replace(
        QLatin1String("s = was\n"),
        QStringLiteral("s = was "
                       "local isRight, isFloor = was == old.x and v > 0, was == old.y and v < 0 "
                       "if c.index == 1 and isRight or c.index == 2 and isFloor then %1 end\n")
            .arg(QLatin1String(odd)));
}

} // namespace

void TestToldWhoseWalls::circlesAreToldWithTheirOwnWalls_data()
{
    QTest::addColumn<QString>("odd");
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    const auto row = [](const char *odd, const char *headline) {
        const auto of = [&](const char *wall, int circle) {
            return QString::fromLatin1(headline)
                .replace(QLatin1String("WALL"), QLatin1String(wall))
                .replace(QLatin1String("WHO"), QStringLiteral("circle %1").arg(circle));
        };
        QTest::addRow("%s", odd) << QString::fromLatin1(odd) << of("right wall", 1)
                                 << of("floor", 2);
    };
    row("w = -w", "Hits at the WALL turn the whole velocity of WHO round");
    row("v = v / 2", "Hits at the WALL give WHO 0.5 times the speed back");
    row("s = edge + 0.1 * v / math.abs(v)", "Hits at the WALL put WHO further out");
    row("s = 0", "Hits at the WALL put WHO somewhere else");
    row("s = edge - 0.2 * v / math.abs(v)", "Hits at the WALL put WHO too far in");
}

void TestToldWhoseWalls::circlesAreToldWithTheirOwnWalls()
{
    QFETCH(QString, odd);
    QFETCH(QString, first);
    QFETCH(QString, second);
    const auto all = found(atTwoWalls(odd.toLatin1().constData()), "L42T12");
    QCOMPARE(LawBench::headlines(all), QStringList({first, second}));
    QVERIFY(all[0].message.contains(QLatin1String("circle 1")));
    QVERIFY(all[1].message.contains(QLatin1String("circle 2")));
    QCOMPARE(all[0].moment.circles, std::vector<int>{0});
    QCOMPARE(all[1].moment.circles, std::vector<int>{1});
}

void TestToldWhoseWalls::slowHitsAreToldWithTheirOwnWalls()
{
    QCOMPARE(
        LawBench::headlines(found(atTwoWalls("if math.abs(v) < 0.7 then v = v / 2 end"), "L42T17")),
        QStringList({QStringLiteral("Slow hits at the right wall give circle 1 another share "
                                    "of the speed back"),
                     QStringLiteral("Slow hits at the floor give circle 2 another share of "
                                    "the speed back")}));
}

/// Of two throws at each wall the fast one comes out wrong.
void TestToldWhoseWalls::hitsBesideRightOnesAreSome()
{
    const auto n = numbersIn(
        body(wallsOf(wallWays[1], "c.radius", "(math.abs(v) > 2 and 0.5 or 1)"), "L42T12",
             "Some hits of both circles at the walls come out wrong"),
        "Circle # came to the * with (#, #) m/s and left it with (#, #) m/s; (#, #) m/s is right. "
        "Of # hits tried there, # came out right.");
    QCOMPARE(n.size(), std::size_t{9});
    QVERIFY(isNear(std::abs(n[1]), 2.0 * std::abs(n[3])));
    QCOMPARE(n[7], 16.0);
    QCOMPARE(n[8], 8.0);
}

void TestToldWhoseWalls::outwardIsToldOfThoseThatMoveOutward()
{
    const QString walls =
        wallsOf(wallWays[1], "c.radius", "(was == old.x and (v > 0 and -0.5 or 0.5) or 1)");
    QCOMPARE(LawBench::headlines(found(walls, "L42T2")),
             QStringList({QStringLiteral("Hits at the left wall give circle 1 0.5 times the speed "
                                         "back"),
                          QStringLiteral("Hits at the right wall leave circle 1 moving outward")}));
}

/// Each of three walls does something else: nothing is said of one that is true of another.
void TestToldWhoseWalls::mostOfManyKindsAreTold()
{
    QString walls = wallsOf(wallWays[1], "c.radius", "1");
    walls.replace(
        QLatin1String("s = edge\n"),
        QLatin1String("s = edge if was == old.x and v > 0 then w = -w "
                      "elseif was == old.x then w = 0 elseif v > 0 then v = v / 2 end\n"));
    const QStringList headlines = LawBench::headlines(found(walls, "L42T2"));
    QCOMPARE(headlines.size(), 2);
    for (const QString &headline : headlines)
        QVERIFY2(headline.contains(QLatin1String("right wall turn the whole"))
                     || headline.contains(QLatin1String("left wall take the part"))
                     || headline.contains(QLatin1String("ceiling give circle 1 0.5")),
                 qPrintable(headline));
}

void TestToldWhoseWalls::hitsThatHangOnEAreToldWithIt()
{
    QString walls = wallsOf(wallWays[1], "c.radius", "restitution");
    walls.replace(QLatin1String("s * v > 0"), QLatin1String("s * v > 0 and restitution > 0.8"));
    const auto n =
        numbersIn(body(walls, "L42T17", "Some hits of both circles at the walls are not answered"),
                  "Thrown at the * with (#, #) m/s and e = #, circle # went on past it; with "
                  "(#, #) m/s and e = # it did not.");
    QCOMPARE(n.size(), std::size_t{7});
    QVERIFY(n[2] < 0.8);
    QCOMPARE(n[6], 1.0);
}

/// The fast are let through and the slow put back, with the velocity that they had.
void TestToldWhoseWalls::heldHitsAreNotTurnedRound()
{
    QString walls = wallsOf(wallWays[0], "c.radius", "1");
    walls.replace(QLatin1String("s = was\n"),
                  QLatin1String("if was == old.x then if math.abs(v) < 2 then s = was end "
                                "return s, v, w end s = was\n"));
    const auto n = numbersIn(
        body(walls, "L42T2",
             "Some hits of circle 1 at the left wall and right wall are not answered"),
        "Thrown at the * with (#, #) m/s from (#, #) m, circle # went on past it; with (#, #) m/s "
        "from (#, #) m it is held there.");
    QCOMPARE(n.size(), std::size_t{9});
    QVERIFY(std::abs(n[0]) > 2.0 && std::abs(n[5]) < 2.0);
}

/// A margin of 1 cm shows with slow ones alone: fast ones go farther in a step.
void TestToldWhoseWalls::slowHitsThatComeTooEarlyAreSlow()
{
    const auto n = numbersIn(
        body(wallsOf(wallWays[0], "c.radius + 0.004"), "L42T2",
             "Slow hits at the right wall turn circle 1 round too early"),
        "Circle # came to the * with # m/s and turned when its centre was between # and # "
        "m from the wall; its radius is # m. With # m/s it turned at its rim, as far as a "
        "step of # m shows.");
    QCOMPARE(n.size(), std::size_t{7});
    QVERIFY(n[2] - 1e-3 <= n[4] + 0.004 && n[4] + 0.004 <= n[3] + 1e-3);
    QVERIFY(isNear(n[6], n[5] / 60.0));
}

/// Two walls ask for two lengths.
void TestToldWhoseWalls::lengthsAreToldWallByWall()
{
    const char *reach = "(s == y and (y < 0 and 0.2 or circle2.radius) or c.radius)";
    const auto all = found(wallsOf(wallWays[0], reach), "L42T13");
    QCOMPARE(LawBench::headlines(all),
             QStringList({QStringLiteral("At the floor a number stands for the radius of both "
                                         "circles"),
                          QStringLiteral("At the ceiling the radius of another circle stands for "
                                         "that of circle 1")}));
}

/// Both ask for the place before the step, and are turned where they are after it.
void TestToldWhoseWalls::aStepTooLateIsTold()
{
    QString walls = wallsOf(wallWays[0], "c.radius", "1");
    walls.replace(QLatin1String("s = was\n"), QLatin1String("\n"))
        .replace(QLatin1String("math.abs(s) > room"), QLatin1String("math.abs(was) > room"));
    const auto n = numbersIn(
        body(walls, "L42T12", "Hits at the walls turn both circles round a step too late"),
        "At the * the rim of circle # was # m past the wall before the step in which it was turned "
        "round, and # m after it.");
    QCOMPARE(n.size(), std::size_t{3});
    QCOMPARE(n[0], 1.0);
    QVERIFY(n[1] > 0.0);
    QVERIFY(isNear(n[2] - n[1], 2.9 / 60.0));
}

/// Besides e.
void TestToldWhoseWalls::densityInTheSpeedIsTold()
{
    const QString walls = QStringLiteral("local came = c.velocity ") + wallsOf(wallWays[0])
                          + QStringLiteral(" local v, k = c.velocity, 0.1 * c.density "
                                           "if v.x ~= came.x then v = vec(k * v.x, v.y) end "
                                           "if v.y ~= came.y then v = vec(v.x, k * v.y) end "
                                           "c.velocity = v");
    const auto n = numbersIn(
        body(walls, "L42T17", "At the walls the density comes into the speed of both circles"),
        "With ρ = # what comes back is # times the speed, with ρ = # it is # times");
    QCOMPARE(n.size(), std::size_t{4});
    QVERIFY(n[2] > 1.5 * n[0]);
    QVERIFY(isNear(n[3] / n[1], n[2] / n[0]));
}

void TestToldWhoseWalls::oneSpeedOfTheWholeVelocityIsTold()
{
    const QString walls = QStringLiteral("local came = c.velocity ") + wallsOf(wallWays[0])
                          + QStringLiteral(" if c.velocity ~= came then "
                                           "c.velocity = 2 * c.velocity:normalized() end");
    const auto n =
        numbersIn(body(walls, "L42T2", "Hits at the walls give circle 1 one and the same speed"),
                  "From every speed tried it leaves with # m/s");
    QCOMPARE(n, std::vector<double>{2.0});
}

/// At the ceiling circle 2 is put back, and the velocity of circle 1 is set in place of its own.
void TestToldWhoseWalls::whoIsHeldBesideAWallIsNotTurned()
{
    QString walls = wallsOf(wallWays[0], "c.radius", "1");
    walls.replace(QLatin1String("s = was\n"),
                  QLatin1String("s = was if c.index == 2 and was == old.y and v > 0 then "
                                "circle1.velocity = vec(circle1.velocity.x, -v) return s, v, w "
                                "end\n"));
    const auto n = numbersIn(
        body(walls, "L42T16", "Beside a wall the velocity of another circle changes"),
        "When circle # was # m from the ceiling its velocity stayed as it was, and that of the "
        "other changed");
    QCOMPARE(n.size(), std::size_t{2});
    QCOMPARE(n[0], 2.0);
}

void TestToldWhoseWalls::whoStopsInACornerIsTold()
{
    const QString walls = QStringLiteral("local came = c.velocity ") + wallsOf(wallWays[0])
                          + QStringLiteral(" if c.velocity.x * came.x < 0 and "
                                           "c.velocity.y * came.y < 0 then "
                                           "c.velocity = vec(0, 0) end");
    QVERIFY(!body(walls, "L42T2", "In a corner the velocity of circle 1 is lost").isEmpty());
}

/// The floor asks where the other circle is, and the right wall nothing.
void TestToldWhoseWalls::wallThatAsksForAnotherIsNoneThatAsksForNothing()
{
    QString walls = wallsOf(wallWays[0], "c.radius", "1");
    walls
        .replace(QLatin1String("math.abs(s) > room"),
                 QLatin1String("math.abs(place(s, was)) > room and not (was == old.x and v > 0)"))
        .prepend(QLatin1String(
            "local other = c.index == 2 and circle1 or circle2 local function place(s, was) "
            "return was == old.y and c.velocity.y < 0 and other.position.y or s end "));
    QCOMPARE(
        LawBench::headlines(found(walls, "L42T12")),
        QStringList({QStringLiteral("Beside a wall the velocity of both circles changes at once"),
                     QStringLiteral("At the floor the place of circle 2 is asked for, not "
                                    "that of circle 1"),
                     QStringLiteral("At the floor the place of circle 1 is asked for, not "
                                    "that of circle 2"),
                     QStringLiteral("At the right wall both circles went out")}));
}

QTEST_GUILESS_MAIN(TestToldWhoseWalls)
#include "test_told_whose_walls.moc"
