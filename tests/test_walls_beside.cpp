// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_words.h"

#include "tests/told_numbers.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// What is said of walls beside another fault: none is hidden by it, and none takes the blame.
class TestWallsBeside : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void gravityInHitsAloneIsNoFaultOfTheWalls();
    void wrongFallHidesNoWall();
    void hitOfTheTwoIsNotTakenForAWalls();
    void partOfAWayIsNoStandingStill();
};

/// In the other steps it is missing: that is said of the motion.
void TestWallsBeside::gravityInHitsAloneIsNoFaultOfTheWalls()
{
    for (const WallWay &each : {wallWays[0], wallWays[1]}) {
        const LawProgram program{.move = QStringLiteral("c.position = c.position + c.velocity * h"),
                                 .walls =
                                     QStringLiteral("local v = c.velocity ") + wallsOf(each)
                                     + QStringLiteral(" if (c.velocity - v):length() > 0 then "
                                                      "c.velocity = c.velocity + gravity * h end")};
        const LawBench bench(task(QStringLiteral("L42T3")));
        const QString text = written(program, structures[0]);
        const MeasuredLaws own(&text, bench.ground);
        const auto found = wallDeviations(own.walls(), bench.right.walls(), bench.ground);
        QVERIFY2(found.empty(), qPrintable(found.empty() ? QString() : found.front().message));
    }
}

/// Under gravity that acts a whole second in every step no throw comes to its wall.
void TestWallsBeside::wrongFallHidesNoWall()
{
    const LawBench bench(task(QLatin1String("L42T3")));
    const QString program =
        written({.circles = 1,
                 .move = QStringLiteral("c.velocity = c.velocity + gravity "
                                        "c.position = c.position + c.velocity * h"),
                 .walls = wallsOf(wallWays[0], "0", "1")},
                structures[0]);
    const MeasuredLaws own(&program, bench.ground);
    QVERIFY(!bodyOf(wallDeviations(own.walls(), bench.right.walls(), bench.ground),
                    QStringLiteral("At the walls the centre of circle 1 is asked for, not the rim"))
                 .isEmpty());
}

/// Who exchange their velocities when one of them is at a wall.
void TestWallsBeside::hitOfTheTwoIsNotTakenForAWalls()
{
    const QString walls =
        wallsOf(wallWays[1], "c.radius", "1")
        + QStringLiteral(" if c.index == 2 or c == circle2 then "
                         "local d = math.abs(circle1.position.x) + circle1.radius "
                         "if d >= square.half_width then circle1.velocity, circle2.velocity = "
                         "circle2.velocity, circle1.velocity end end");
    const LawBench bench(task(QLatin1String("L42T10")));
    const QString program = written({.walls = walls}, structures[0]);
    const MeasuredLaws own(&program, bench.ground);
    const auto found = wallDeviations(own.walls(), bench.right.walls(), bench.ground);
    const auto at = std::find_if(found.begin(), found.end(), [](const LawDeviation &each) {
        return each.message.startsWith(QLatin1String("Beside a wall"));
    });
    QVERIFY(at != found.end());
    QCOMPARE(at->family, QLatin1String("of two"));
}

/// A circle that loses a third of its way is not one that is put back.
void TestWallsBeside::partOfAWayIsNoStandingStill()
{
    const LawBench bench(task(QLatin1String("L42T13")));
    const auto lawOf = [&](double lost) {
        const QString program =
            written({.walls = QStringLiteral("local came = c.velocity ")
                              + wallsOf(wallWays[1], "c.radius", "1")
                              + QStringLiteral(" if c == circle1 and came ~= c.velocity then "
                                               "circle2.position = circle2.position - %1 * "
                                               "circle2.velocity * h end")
                                    .arg(lost)},
                    structures[0]);
        return MeasuredLaws(&program, bench.ground).walls();
    };
    QVERIFY(!lawOf(1.0 / 3.0).isLike(lawOf(1.0)));
    QVERIFY(lawOf(0.9).isLike(lawOf(1.0)));
    QVERIFY(lawOf(0.05).isLike(lawOf(0.0)));
}

QTEST_GUILESS_MAIN(TestWallsBeside)
#include "test_walls_beside.moc"
