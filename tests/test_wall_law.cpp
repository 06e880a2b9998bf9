// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/reading/lab_list.h"
#include "tests/text.h"

using namespace cradle;
using namespace cradle::programs;

/// What is said of the walls of a program is what is wrong at them.
class TestWallLaw : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void rightWallsHaveNoFault_data();
    void rightWallsHaveNoFault();
    void slowHitsAreLookedAt_data();
    void slowHitsAreLookedAt();
    void slowHitsAtTheFloorAloneAreLookedAt();
    void faultIsNamed_data();
    void faultIsNamed();
    void wordsOfAStepWithoutLosesDoNotSpeakOfThem();
    void wrongMotionIsNoFaultOfTheWalls_data();
    void wrongMotionIsNoFaultOfTheWalls();
    void wallInAWrongPlaceIsNamed();
    void lookingASecondAheadIsNamed();
    void wallsThatAreRightAreNotCalledWrong();
    void oneCircleIsNamedForItsOwnWalls();
};

void TestWallLaw::rightWallsHaveNoFault_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("program");
    for (const char *step : {"L42T2", "L42T3", "L42T7", "L42T12", "L42T17"}) {
        const int number = QString::fromLatin1(step).mid(4).toInt();
        for (const WallWay &way : wallWays) {
            for (const Structure &structure : structures)
                QTest::addRow("%s, %s, %s", step, way.name, structure.name)
                    << QString::fromLatin1(step)
                    << written(
                           withWalls(wallsOf(way, "c.radius", number == 17 ? "restitution" : "1")),
                           structure);
        }
    }
}

void TestWallLaw::rightWallsHaveNoFault()
{
    QFETCH(QString, step);
    QFETCH(QString, program);
    QCOMPARE(LawBench(task(step)).walls(program), QStringList());
}

void TestWallLaw::slowHitsAreLookedAt_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("asked");
    QTest::addColumn<QString>("back");
    QTest::addColumn<QStringList>("said");
    const QString turns = text("s * v > 0");
    const QString fast = text("s * v > 0.5 * math.abs(s)");
    for (const char *step : {"L42T9", "L42T12"}) {
        QTest::addRow("threshold, %s", step)
            << text(step) << fast << text("restitution")
            << QStringList(text("Slow hits at the walls leave both circles moving outward"));
        QTest::addRow("right, %s", step)
            << text(step) << turns << text("restitution") << QStringList();
    }
    QTest::addRow("threshold under gravity")
        << text("L42T3") << fast << text("restitution")
        << QStringList(
               text("Slow hits at the left wall and right wall leave circle 1 moving outward"));
    QTest::addRow("another factor")
        << text("L42T17") << turns << text("math.abs(v) < 1 and 0 or restitution")
        << QStringList(
               text("Slow hits at the walls give both circles another share of the speed back"));
}

void TestWallLaw::slowHitsAreLookedAt()
{
    QFETCH(QString, step);
    QFETCH(QString, asked);
    QFETCH(QString, back);
    QFETCH(QStringList, said);
    const LawBench bench(task(step));
    for (const WallWay &way : {wallWays[0], wallWays[1]}) {
        const QString walls =
            wallsOf(way, "c.radius", back.toLatin1().constData()).replace(text("s * v > 0"), asked);
        for (const int structure : {0, 3})
            QCOMPARE(bench.walls(written({.walls = walls}, structures[structure])), said);
    }
}

void TestWallLaw::slowHitsAtTheFloorAloneAreLookedAt()
{
    const LawBench step(task(QStringLiteral("L42T17")));
    const QString both = text("y, vy, vx = one(y, vy, vx, old.y)");
    const QString rests = text("local fell = vy ") + both
                          + text(" if vy > 0 and fell < 0 and fell > -0.7 then vy = 0 end");
    for (const WallWay &way : {wallWays[0], wallWays[1]}) {
        const QString walls = wallsOf(way).replace(both, rests);
        QCOMPARE(step.walls(written(withWalls(walls), structures[0])),
                 QStringList(text("Slow hits at the floor give both circles another share of the "
                                  "speed back")));
    }
}

void TestWallLaw::faultIsNamed_data()
{
    QTest::addColumn<QString>("walls");
    QTest::addColumn<QStringList>("said");
    const auto rows = [](const char *name, const char *reach, const char *back, const char *along,
                         const QStringList &said) {
        for (const WallWay &way : wallWays)
            QTest::addRow("%s, %s", name, way.name) << wallsOf(way, reach, back, along) << said;
    };
    const QString centre =
        text("At the walls the centre of both circles is asked for, not the rim");
    const QString twice = text("At the walls e acts on both circles twice");
    rows("centre", "0", "restitution", "1", {centre});
    rows("diameter", "2 * c.radius", "restitution", "1",
         {text("Hits at the walls turn both circles round too early")});
    rows("far side", "-c.radius", "restitution", "1",
         {text("Hits at the walls turn both circles round at the far side of the rim")});
    rows("a little late", "c.radius - 0.03", "restitution", "1",
         {text("Hits at the walls turn both circles round too late")});
    // Less than the fast ones go in a step: only a slow one shows it.
    rows("3 mm early", "c.radius + 0.003", "restitution", "1",
         {text("Slow hits at the right wall turn both circles round too early")});
    rows("e squared", "c.radius", "restitution ^ 2", "1", {twice});
    rows("root of e", "c.radius", "math.sqrt(restitution)", "1",
         {text("At the walls the root of e acts on both circles")});
    rows("1 - e", "c.radius", "1 - restitution", "1",
         {text("At the walls 1 − e stands where e belongs, for both circles")});
    rows("2 e - 1", "c.radius", "2 * restitution - 1", "1",
         {text("Hits at the walls give both circles another share of the speed than e")});
    rows("elastic", "c.radius", "1", "1",
         {text("Hits at the walls give both circles all of the speed back")});
    rows("a number", "c.radius", "0.75", "1",
         {text("At the walls a number stands for e, for both circles")});
    rows("e along, too", "c.radius", "restitution", "restitution",
         {text("At the walls e also shortens the part of both circles along the wall")});
    rows("whole velocity", "c.radius", "restitution", "-restitution",
         {text("Hits at the walls turn the whole velocity of both circles round")});
    rows("nothing along", "c.radius", "restitution", "0",
         {text("Hits at the walls take the part of both circles along the wall away")});
    rows("centre and e squared", "0", "restitution ^ 2", "1", {centre, twice});
}

void TestWallLaw::faultIsNamed()
{
    QFETCH(QString, walls);
    QFETCH(QStringList, said);
    const LawBench step(task(QStringLiteral("L42T17")));
    for (const std::size_t structure : {std::size_t{0}, std::size_t{2}})
        QCOMPARE(step.walls(written(withWalls(walls), structures[structure])), said);
}

void TestWallLaw::wordsOfAStepWithoutLosesDoNotSpeakOfThem()
{
    const LawBench step(task(QStringLiteral("L42T7")));
    const auto said = [&](const char *back) {
        const QString walls = wallsOf(wallWays[1], "c.radius", back);
        return step.walls(written(withWalls(walls), structures[3]));
    };
    QCOMPARE(
        said("0"),
        QStringList(text("Hits at the walls take the part of both circles along the normal away")));
    QCOMPARE(said("0.9"),
             QStringList(text("Hits at the walls give both circles 0.9 times the speed back")));
    QCOMPARE(said("2 / math.abs(v)"),
             QStringList(text("Hits at the walls give both circles a speed of their own")));
}

void TestWallLaw::wallInAWrongPlaceIsNamed()
{
    const LawBench step(task(QStringLiteral("L42T7")));
    const QString program = QStringLiteral(
        "function on_update(h) for _, c in ipairs(circles) do "
        "c.velocity = c.velocity + gravity * h c.position = c.position + c.velocity * h "
        "local p, v, r = c.position, c.velocity, c.radius "
        "if v.x > 0 and p.x > 4 - r or v.x < 0 and p.x < r - 4 then v = vec(-v.x, v.y) end "
        "if v.y > 0 and p.y > 4 - r or v.y < 0 and p.y < r - 2.5 then v = vec(v.x, -v.y) end "
        "c.velocity = v end end");
    const QStringList said = step.walls(program);
    QVERIFY(!said.isEmpty());
    QCOMPARE(said.front(), text("Hits at the floor turn both circles round too early"));
}

void TestWallLaw::lookingASecondAheadIsNamed()
{
    const LawBench step(task(QStringLiteral("L42T2")));
    const auto said = [&](const char *ahead) {
        return step.walls(
            QStringLiteral("function on_update(h) local c = circle1 "
                           "local p, v, w = c.position + c.velocity%1, c.velocity, 4 - c.radius "
                           "if p.x > w or p.x < -w then v = vec(-v.x, v.y) end "
                           "if p.y > w or p.y < -w then v = vec(v.x, -v.y) end "
                           "c.velocity = v c.position = c.position + v * h end")
                .arg(QLatin1String(ahead)));
    };
    QCOMPARE(said(" * h"), QStringList());
    QCOMPARE(said(""),
             QStringList(text("Hits at the walls turn circle 1 round a whole second too early")));
    QVERIFY(!said(" * 0.5").contains(
        text("Hits at the walls turn circle 1 round a whole second too early")));
}

void TestWallLaw::wallsThatAreRightAreNotCalledWrong()
{
    const LawBench step(task(QStringLiteral("L42T7")));
    const auto said = [&](const char *shorter) {
        const LawProgram program = withWalls(
            QStringLiteral("local v, p = c.velocity, c.position "
                           "local r, w = c.radius, square.half_width "
                           "if p.x > w - %1 and v.x > 0 then c.position = vec(w - %1, p.y) "
                           "c.velocity = vec(-v.x, v.y) v, p = c.velocity, c.position end "
                           "if p.x < r - w and v.x < 0 then c.position = vec(r - w, p.y) "
                           "c.velocity = vec(-v.x, v.y) v, p = c.velocity, c.position end "
                           "if p.y > w - r and v.y > 0 then c.position = vec(p.x, w - r) "
                           "c.velocity = vec(v.x, -v.y) v, p = c.velocity, c.position end "
                           "if p.y < r - w and v.y < 0 then c.position = vec(p.x, r - w) "
                           "c.velocity = vec(v.x, -v.y) end")
                .arg(QLatin1String(shorter)));
        return step.walls(written(program, structures[3]));
    };
    QCOMPARE(said("r"), QStringList());
    QCOMPARE(said("0").value(0),
             text("At the right wall the centre of both circles is asked for, not the rim"));
    QCOMPARE(said("(r - 0.08)").value(0),
             text("Hits at the right wall turn both circles round too late"));
}

void TestWallLaw::wrongMotionIsNoFaultOfTheWalls_data()
{
    QTest::addColumn<QString>("move");
    for (const char *way :
         {"c.velocity", "c.velocity / 60", "c.velocity * h * h", "2 * c.velocity * h",
          "-c.velocity * h", "c.velocity * h + gravity * h", "vec(c.velocity.x, 0) * h"})
        QTest::newRow(way) << QStringLiteral("c.position = c.position + %1 "
                                             "c.velocity = c.velocity + gravity * h")
                                  .arg(QLatin1String(way));
    for (const char *fall : {"gravity", "2 * gravity * h", "-1 * gravity * h", "vec(0, -9.81) * h",
                             "gravity * h - 0.3 * c.velocity * h"})
        QTest::newRow(fall) << QStringLiteral("c.velocity = c.velocity + %1 "
                                              "c.position = c.position + c.velocity * h")
                                   .arg(QLatin1String(fall));
}

void TestWallLaw::wrongMotionIsNoFaultOfTheWalls()
{
    QFETCH(QString, move);
    for (const char *step : {"L42T7", "L42T12"}) {
        const LawBench judged(task(QLatin1String(step)));
        for (const WallWay &way : wallWays) {
            const LawProgram program{.move = move, .walls = wallsOf(way, "c.radius", "1")};
            QCOMPARE(judged.walls(written(program, structures[1])), QStringList());
        }
    }
}

void TestWallLaw::oneCircleIsNamedForItsOwnWalls()
{
    const LawBench step(task(QStringLiteral("L42T14")));
    const QString good = wallsOf(wallWays[0], "c.radius", "1");
    const QString late = wallsOf(wallWays[0], "(c.index == 2 and 0 or c.radius)", "1");
    const QString first = wallsOf(wallWays[0], "circle1.radius", "1");
    QCOMPARE(step.walls(written(withWalls(good), structures[1])), QStringList());
    QCOMPARE(step.walls(written(withWalls(late), structures[1])),
             QStringList(text("At the walls the centre of circle 2 is asked for, not the rim")));
    QCOMPARE(
        step.walls(written(withWalls(first), structures[3])),
        QStringList(text("At the walls the radius of another circle stands for that of circle 2")));
    const QString larger = wallsOf(wallWays[0], "math.max(circle1.radius, circle2.radius)", "1");
    QCOMPARE(step.walls(written(withWalls(larger), structures[3])),
             QStringList(text("At the walls the larger radius stands for that of both circles")));
    const QString open = QStringLiteral("if c.index == 1 then ") + good + QStringLiteral(" end");
    QCOMPARE(step.walls(written(withWalls(open), structures[3])),
             QStringList(text("At every wall circle 2 went out")));
}

QTEST_GUILESS_MAIN(TestWallLaw)
#include "test_wall_law.moc"
