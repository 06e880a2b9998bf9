// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_words.h"

#include "tests/told_numbers.h"

#include <functional>

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on the walls of a program tell are those that its law makes.
class TestToldWalls : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void answerOfAWallIsTold_data();
    void answerOfAWallIsTold();
    void shareOfAWallIsTold();
    void openWallsAreTold();
    void placeOfAnotherIsTold();
    void hitsWithoutGravityAreTold();
    void whoIsPutOutKeepsNothing();
    void whoIsPutPastTheOtherWallIsToldOfIt();
    void startOfTheRunIsTold();
    void otherLawsAtOtherWallsAreToldApart();
    void oneSpeedIsNoneOfTheirOwn();
    void whoMovesWithAHitAloneIsTold();
    void slowHitsAreTold();
    void slowAnswerIsTold();
    void slowestAtTheFloorIsTold();

private:
    using Law = std::function<double(double)>; ///< of e

    [[nodiscard]] QString bodyOfWalls(const QString &walls, const QString &headline = {},
                                      const char *step = "L42T17") const
    {
        const LawBench bench(task(QLatin1String(step)));
        const QString program = written({.walls = walls}, structures[0]);
        const MeasuredLaws own(&program, bench.ground);
        return bodyOf(wallDeviations(own.walls(), bench.right.walls(), bench.ground), headline);
    }
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

} // namespace

void TestToldWalls::answerOfAWallIsTold_data()
{
    QTest::addColumn<QString>("back");
    QTest::addColumn<QString>("along");
    QTest::addColumn<Law>("backLaw");
    QTest::addColumn<Law>("alongLaw");
    const auto row = [](
                         const char *back, const Law &backLaw, const char *along = "1",
                         const Law &alongLaw = [](double) { return 1.0; }) {
        QTest::addRow("%s, %s", back, along) << text(back) << text(along) << backLaw << alongLaw;
    };
    const Law same = [](double r) { return r; };
    row("restitution ^ 2", [](double r) { return r * r; });
    row("math.sqrt(restitution)", [](double r) { return std::sqrt(r); });
    row("1 - restitution", [](double r) { return 1.0 - r; });
    row("1 + restitution", [](double r) { return 1.0 + r; });
    row("0.9 * restitution", [](double r) { return 0.9 * r; });
    row("0.3 + 0.5 * restitution", [](double r) { return 0.3 + 0.5 * r; });
    row("0.75", [](double) { return 0.75; });
    row("0", [](double) { return 0.0; });
    row("1", [](double) { return 1.0; });
    row("-restitution", [](double r) { return -r; });
    row("restitution", same, "restitution", same);
    row("restitution", same, "-restitution", [](double r) { return -r; });
    row("restitution", same, "0", [](double) { return 0.0; });
    row("restitution", same, "-1", [](double) { return -1.0; });
    row("restitution", same, "0.8", [](double) { return 0.8; });
}

/// At the e nearest to ½ of those with which it is wrong, so that laws of e are told apart.
void TestToldWalls::answerOfAWallIsTold()
{
    QFETCH(QString, back);
    QFETCH(QString, along);
    QFETCH(Law, backLaw);
    QFETCH(Law, alongLaw);
    const QString body = bodyOfWalls(
        wallsOf(wallWays[1], "c.radius", back.toUtf8().constData(), along.toUtf8().constData()));
    const bool isOutward = back == QLatin1String("-restitution");
    const auto n = numbersIn(
        body, isOutward ? "Here e is #. Circle # came to the * with (#, #) m/s and has (#, #) m/s "
                          "after the hit, still into it; (#, #) m/s is right."
                        : "Here e is #. Circle # came to the * with (#, #) m/s and left it "
                          "with (#, #) m/s; (#, #) m/s is right.");
    QVERIFY2(n.size() == 8, qPrintable(body));
    const bool isSide = body.contains(QLatin1String("t wall with"));
    const auto parts = [&](std::size_t at) { // along the normal and the wall
        return isSide ? Vec2{n[at], n[at + 1]} : Vec2{n[at + 1], n[at]};
    };
    const Vec2 came = parts(2);
    QVERIFY(came.x != 0.0 && came.y != 0.0);
    QVERIFY(isNear(parts(4).x, -backLaw(n[0]) * came.x));
    QVERIFY(isNear(parts(4).y, alongLaw(n[0]) * came.y));
    QVERIFY(isNear(parts(6).x, -n[0] * came.x));
    QVERIFY(isNear(parts(6).y, came.y));
    QCOMPARE(n[1], 1.0);
    double best = 1.0; // of 0, ¼, ½, ¾ and 1
    for (const double r : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        if (!isNear(backLaw(r), r) || !isNear(alongLaw(r), 1.0))
            best = std::min(best, std::abs(r - 0.5));
    }
    QCOMPARE(std::abs(n[0] - 0.5), best);
}

/// What comes back, where no law of e is named.
void TestToldWalls::shareOfAWallIsTold()
{
    const auto body = [&](const char *back, const char *headline) {
        return bodyOfWalls(wallsOf(wallWays[1], "c.radius", back), text(headline));
    };
    auto n =
        numbersIn(body("0.3 + 0.5 * restitution",
                       "Hits at the walls give both circles another share of the speed than e"),
                  "With e = # it is # times the speed, with e = # # times.");
    QCOMPARE(n.size(), std::size_t{4});
    QVERIFY(n[0] != n[2]);
    QVERIFY(isNear(n[1], 0.3 + 0.5 * n[0]) && isNear(n[3], 0.3 + 0.5 * n[2]));
    // What hangs on the speed is not told of e.
    for (const char *back :
         {"math.max(0, 1 - 0.5 / c.velocity:length())", "c.velocity:length() ^ (restitution - 1)",
          "restitution * c.velocity:length()"}) {
        n = numbersIn(
            body(back, "Hits at the walls give both circles another share of the speed than e"),
            "With e = # a hit with # m/s into the wall gives # times the speed back, one with # "
            "m/s # times");
        QCOMPARE(n.size(), std::size_t{5});
        QVERIFY(n[1] != n[3] && std::abs(n[2] - n[4]) > 0.1);
    }
    QVERIFY(!body("0.9 * restitution",
                  "Hits at the walls give both circles 0.9 e of the speed back, not e")
                 .isEmpty());
    n = numbersIn(body("0.75", "At the walls a number stands for e, for both circles"),
                  "With every e tried # of the speed comes back.");
    QCOMPARE(n, std::vector<double>{0.75});
    n = numbersIn(
        body("1.7 / math.abs(v)", "Hits at the walls give both circles a speed of their own"),
        "From every speed tried it has # m/s along the normal afterwards");
    QCOMPARE(n, std::vector<double>{1.7});
}

void TestToldWalls::openWallsAreTold()
{
    const auto n =
        numbersIn(bodyOfWalls({}, text("At every wall both circles went out")),
                  "Thrown at each of them without gravity, both circles went on through it; at the "
                  "* with (#, #) "
                  "m/s.");
    QCOMPARE(n.size(), std::size_t{2});
    QVERIFY(isNear(std::hypot(n[0], n[1]), 2.9 * std::hypot(1.0, 0.37))); // beside the wall, too
    const QString left = QStringLiteral("if c.position.x > -3 then ") + wallsOf(wallWays[1])
                         + QStringLiteral(" end");
    QVERIFY(!bodyOfWalls(left, text("At the left wall both circles went out")).isEmpty());
}

/// Whoever comes fast is slowed down, and all that come fast come equally fast.
/// The floor asks where the other circle is.
void TestToldWalls::placeOfAnotherIsTold()
{
    const char *walls = "local a = c.index == 2 and circle1 or circle2 "
                        "if a.position.y - c.radius < square.bottom and c.velocity.y < 0 then "
                        "c.position, c.velocity = old, vec(c.velocity.x, -c.velocity.y) end "
                        "if c.position.y + c.radius > square.top and c.velocity.y > 0 or "
                        "false then c.velocity = vec(c.velocity.x, -c.velocity.y) end "
                        "if math.abs(c.position.x) + c.radius > square.right "
                        "and c.position.x * c.velocity.x > 0 then "
                        "c.velocity = vec(-c.velocity.x, c.velocity.y) end";
    for (const auto &[circle, other] : {std::pair(1, 2), std::pair(2, 1)}) {
        const QString body =
            bodyOfWalls(text(walls),
                        QStringLiteral("At the floor the place of circle %1 is asked for, not that "
                                       "of circle %2")
                            .arg(other)
                            .arg(circle),
                        "L42T12");
        const auto n =
            numbersIn(body, "Thrown at the floor with (#, #) m/s, circle # went on past it. In the "
                            "middle its velocity changed from (#, #) to (#, #) m/s, with circle # "
                            "beyond that wall.");
        QVERIFY2(n.size() == 8, qPrintable(body));
        QCOMPARE(n[2], double(circle));
        QVERIFY(n[4] < 0.0);
        QVERIFY(isNear(n[6], -n[4]));
        QCOMPARE(n[7], double(other));
    }
}

/// Who turns in place of falling misses what gravity gives in that step.
void TestToldWalls::hitsWithoutGravityAreTold()
{
    QString walls = wallsOf(wallWays[0], "c.radius", "1");
    walls += QStringLiteral(" if c.velocity.x * vx0 < 0 then c.velocity = c.velocity - gravity * h "
                            "end");
    const QString body =
        bodyOfWalls(QStringLiteral("local vx0 = c.velocity.x ") + walls,
                    text("In the step of a hit at the left wall and right wall gravity does not "
                         "act on circle 1"),
                    "L42T3");
    const auto n = numbersIn(body, "In a step of #/# s gravity changes the velocity by (#, #) m/s, "
                                   "in the step of a hit, too. When circle # was turned at the *, "
                                   "the part along the wall stayed as it was before the step.");
    QVERIFY2(n.size() == 5, qPrintable(body));
    QVERIFY(isNear(n[3], -9.81 * n[0] / n[1]));
    QCOMPARE(n[4], 1.0);
}

/// A wrong sign puts the circle out by what it should be put back; nothing of it is kept.
void TestToldWalls::whoIsPutOutKeepsNothing()
{
    const LawBench bench(task(text("L42T17")));
    const QString program = written(
        {.walls = text("for _, n in ipairs({vec(1, 0), vec(-1, 0), vec(0, 1), vec(0, -1)}) do "
                       "local deep = dot(c.position, n) + c.radius - square.half_width "
                       "local speed = dot(c.velocity, n) "
                       "if deep > 0 then c.position = c.position + deep * n if speed > 0 then "
                       "c.velocity = c.velocity - (1 + restitution) * speed * n end end end")},
        structures[0]);
    const MeasuredLaws own(&program, bench.ground);
    const QStringList said =
        LawBench::headlines(wallDeviations(own.walls(), bench.right.walls(), bench.ground));
    QVERIFY2(said.contains(text("Hits at the walls put both circles further out")),
             qPrintable(said.join(u'\n')));
    QVERIFY(said.filter(text("is not v Δt")).isEmpty());
}

/// From the left of the left wall it moves into that, and is rightly put back in the next step.
void TestToldWalls::whoIsPutPastTheOtherWallIsToldOfIt()
{
    const LawBench bench(task(text("L42T2")));
    const QString program =
        written({.circles = 1,
                 .walls = text("local x, y, r = c.position.x, c.position.y, c.radius "
                               "local vx, vy = c.velocity.x, c.velocity.y "
                               "if x - r < square.left then x, vx = square.left + r, math.abs(vx) "
                               "elseif x + r > square.right then "
                               "x, vx = square.left - r, -math.abs(vx) end "
                               "if y - r < square.bottom then y, vy = square.bottom + r, "
                               "math.abs(vy) elseif y + r > square.top then "
                               "y, vy = square.top - r, -math.abs(vy) end "
                               "c.position, c.velocity = vec(x, y), vec(vx, vy)")},
                structures[0]);
    const MeasuredLaws own(&program, bench.ground);
    const auto found = wallDeviations(own.walls(), bench.right.walls(), bench.ground);
    QCOMPARE(LawBench::headlines(found),
             QStringList(text("Hits at the right wall put circle 1 somewhere else")));
    const auto n = numbersIn(found.front().message,
                             "At the right wall circle 1 was put # m away from its own path");
    QVERIFY2(n.size() == 1 && n[0] > 7.5 && n[0] < 8.5, qPrintable(found.front().message));
}

/// The old place is kept once and never again.
void TestToldWalls::startOfTheRunIsTold()
{
    const LawBench bench(task(text("L42T2")));
    const QString program =
        written({.start = QStringLiteral("first = {}"),
                 .walls = QStringLiteral("first[c.index] = first[c.index] or old "
                                         "local old = first[c.index] ")
                          + wallsOf(wallWays[0])},
                structures[0]);
    const MeasuredLaws own(&program, bench.ground);
    const auto found = wallDeviations(own.walls(), bench.right.walls(), bench.ground);
    QCOMPARE(LawBench::headlines(found),
             QStringList(text("Hits at the walls put circle 1 back to the start of the run")));
}

void TestToldWalls::otherLawsAtOtherWallsAreToldApart()
{
    const LawBench bench(task(text("L42T17")));
    const QString program = written(
        {.walls = wallsOf(wallWays[1], "c.radius",
                          "(c.index == 1 and s > 0 and was == old.y and 1 or c.index == 2 and "
                          "s < 0 and was == old.y and 0.75 or restitution)")},
        structures[0]);
    const MeasuredLaws own(&program, bench.ground);
    QCOMPARE(LawBench::headlines(wallDeviations(own.walls(), bench.right.walls(), bench.ground)),
             QStringList({text("At the floor a number stands for e, for circle 2"),
                          text("Hits at the ceiling give circle 1 all of the speed back")}));
}

void TestToldWalls::oneSpeedIsNoneOfTheirOwn()
{
    const QString walls = wallsOf(wallWays[1], "c.radius", "0.5");
    QVERIFY(!bodyOfWalls(walls,
                         text("Hits at the walls give both circles 0.5 times the speed back"),
                         "L42T12")
                 .isEmpty());
    QVERIFY(!bodyOfWalls(wallsOf(wallWays[1], "c.radius", "1.7 / math.abs(v)"),
                         text("Hits at the walls give both circles a speed of their own"), "L42T12")
                 .isEmpty());
}

/// A step ends with circle 1, but where a wall turns that.
void TestToldWalls::whoMovesWithAHitAloneIsTold()
{
    const auto n = numbersIn(
        bodyOfWalls(QStringLiteral("local came = c.velocity ") + wallsOf(wallWays[0])
                        + QStringLiteral(" if c == circle1 and c.velocity == came then return end"),
                    QStringLiteral("Circle 2 moved only in a step in which a wall was hit"),
                    "L42T7"),
        "In the step in which circle # was answered by the * the other circle went (#, #) m; in no "
        "step before did it move.");
    QCOMPARE(n.size(), std::size_t{3});
    QCOMPARE(n[0], 1.0);
    QVERIFY(n[1] != 0.0);
}

void TestToldWalls::slowHitsAreTold()
{
    QString walls = wallsOf(wallWays[1], "c.radius", "restitution");
    walls.replace(QLatin1String("s * v > 0"), QLatin1String("s * v > 0 and math.abs(v) > 0.7"));
    const QString body =
        bodyOfWalls(walls, text("Slow hits at the walls leave both circles moving outward"));
    const auto n = numbersIn(body, "Circle # came to the * with # m/s and went on past it; with # "
                                   "m/s it is turned round.");
    QVERIFY2(n.size() == 3, qPrintable(body));
    QCOMPARE(n[0], 1.0);
    QVERIFY(n[1] > 0.0 && n[1] < 0.7);
    QCOMPARE(n[2], 2.9); // the first of all throws
}

void TestToldWalls::slowAnswerIsTold()
{
    const QString body = bodyOfWalls(
        wallsOf(wallWays[1], "c.radius", "(math.abs(v) > 0.7 and restitution or 0.9)"),
        text("Slow hits at the walls give both circles another share of the speed back"));
    const auto n =
        numbersIn(body, "Here e is #. Circle # came to the * with # m/s and left it with "
                        "# times that speed; # times is right");
    QVERIFY2(n.size() == 5, qPrintable(body));
    QCOMPARE(n[1], 1.0);
    QVERIFY(n[2] > 0.0 && n[2] < 0.7);
    QVERIFY(isNear(n[3], 0.9));
    QVERIFY(isNear(n[4], n[0]));
    QVERIFY(!body.contains(text("At the floor")));
}

/// The floor is tried faster than that, for what lies there may stay.
void TestToldWalls::slowestAtTheFloorIsTold()
{
    const QString body = bodyOfWalls(
        wallsOf(wallWays[1], "c.radius",
                "(was == old.y and math.abs(v) < 0.4 and 0 or restitution)"),
        text("Slow hits at the ceiling give both circles another share of the speed back"));
    const auto n = numbersIn(body, "At the floor, none slower than # m/s was tried.");
    QVERIFY2(n.size() == 1, qPrintable(body));
    QVERIFY(n[0] > 0.4 && n[0] < 0.7);
}

QTEST_GUILESS_MAIN(TestToldWalls)
#include "test_told_walls.moc"
