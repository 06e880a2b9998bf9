// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/reading/lab_list.h"
#include "tests/flight_moves.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::integration;

/// What is said of the free motion of a program is what is wrong with it.
class TestFlightLaw : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void rightMotionHasNoFault_data();
    void rightMotionHasNoFault();
    void faultIsNamed_data();
    void faultIsNamed();
    void ownSceneShowsACopyThatIsTooOld();
    void hitInTheFirstStepIsNoFall();
    void aProgramMayStopInItsOwnScene();
    void weightIsNamedThoughItEndsAtAWall_data();
    void weightIsNamedThoughItEndsAtAWall();
    void fallByTheMassOfAnotherIsNoCopy();
    void stopOfThoseThatComeNearerIsShown();

private:
    [[nodiscard]] LawBench bench(const char *step) const
    {
        return LawBench(task(QLatin1String(step)));
    }
};

void TestFlightLaw::rightMotionHasNoFault_data()
{
    QTest::addColumn<QString>("move");
    QTest::newRow("Euler") << euler;
    QTest::newRow("symplectic Euler") << symplectic;
    QTest::newRow("Verlet") << verlet;
    QTest::newRow("by components")
        << QStringLiteral("local x, y, vx, vy = c.position.x, c.position.y, c.velocity.x, "
                          "c.velocity.y + gravity.y * h "
                          "c.position, c.velocity = vec(x + vx * h, y + vy * h), vec(vx, vy)");
    QTest::newRow("two halves of a step")
        << QStringLiteral("for k = 1, 2 do c.velocity = c.velocity + gravity * (h / 2) "
                          "c.position = c.position + c.velocity * (h / 2) end");
}

void TestFlightLaw::rightMotionHasNoFault()
{
    QFETCH(QString, move);
    const LawBench step = bench("L42T7");
    const LawBench any = bench("L42T17"); // whichever method, in smaller steps, too
    const bool isMethod = !move.contains(QLatin1String("for k"));
    for (const Structure &structure : structures) {
        QCOMPARE(
            any.flight(written({.start = QStringLiteral("gravity = vec(0, -9.81)"), .move = move},
                               structure)),
            QStringList());
        const QStringList said = step.flight(written({.move = move}, structure));
        // Two halves of symplectic Euler fall by ¾ a h²: no method that the step knows.
        QVERIFY2(isMethod == said.isEmpty(), qPrintable(said.join(QLatin1String("; "))));
    }
}

void TestFlightLaw::faultIsNamed_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("move");
    QTest::addColumn<QStringList>("said");
    const auto row = [](const char *step, const char *name, const char *place, const char *velocity,
                        const QStringList &said) {
        QTest::addRow("%s, %s", step, name)
            << QString::fromLatin1(step)
            << QStringLiteral("c.position = c.position + %1 c.velocity = c.velocity + %2")
                   .arg(QLatin1String(place), QLatin1String(velocity))
            << said;
    };
    const char *way = "c.velocity * h";
    const char *fall = "gravity * h";
    const auto text = [](const char *utf8) { return QStringList{QString::fromUtf8(utf8)}; };
    row("L42T4", "way without time", "c.velocity", fall,
        text("The way of both circles is not multiplied by the timestep"));
    row("L42T4", "way with time twice", "c.velocity * h * h", fall,
        text("The way of both circles is multiplied by the timestep twice"));
    row("L42T4", "way of a sixtieth", "c.velocity / 60", fall,
        text("A fixed number stands for the timestep in the way of both circles"));
    row("L42T4", "way back", "-c.velocity * h", fall,
        text("The way of both circles is subtracted instead of added"));
    row("L42T4", "way twice", "2 * c.velocity * h", fall,
        text("Every step moves both circles twice as far"));
    row("L42T4", "x only", "vec(c.velocity.x * h, 0)", fall,
        text("The y of both circles does not change"));
    row("L42T4", "y by the time alone", "vec(c.velocity.x * h, h)", fall,
        text("The y of both circles changes without its velocity"));
    row("L42T4", "fall without time", way, "gravity",
        text("Gravity acts on both circles for a whole second in every step"));
    row("L42T4", "fall with time twice", way, "gravity * h * h",
        text("Gravity on both circles is multiplied by the timestep twice"));
    row("L42T4", "half of the fall", way, "gravity * h / 2",
        text("The velocity of both circles gets only half of gravity"));
    row("L42T4", "fall upward", way, "-1 * gravity * h",
        text("The acceleration of both circles is opposite to gravity"));
    row("L42T4", "no fall", way, "vec(0, 0)",
        text("In free flight gravity leaves both circles alone"));
    row("L42T4", "fall sideways", way, "vec(gravity.y, 0) * h",
        text("Gravity pulls both circles in a wrong direction"));
    row("L42T4", "gravity on the place", "c.velocity * h + gravity * h", "vec(0, 0)",
        text("Gravity moves both circles at once and changes no velocity"));
    row("L42T4", "other air", way, "gravity * h - 0.2 * c.velocity * h",
        text("Something slows both circles down on the way"));
    row("L42T4", "one does not fall", way, "(c.index == 2 and vec(0, 0) or gravity * h)",
        text("In free flight gravity leaves circle 2 alone"));
    row("L42T4", "half a step of one", "(c.index == 2 and 0.5 or 1) * c.velocity * h",
        "(c.index == 2 and 0.5 or 1) * gravity * h",
        text("The whole step of circle 2 is made as with 0.5 Δt"));
    row("L42T7", "two steps at once", "2 * c.velocity * h + 3 * gravity * h * h", "2 * gravity * h",
        text("The whole step of both circles is made as with 2 Δt"));
    row("L42T7", "two methods at once", "2 * c.velocity * h + 1.5 * gravity * h * h",
        "2 * gravity * h", text("A step of both circles does 2 times what it should"));
    row("L42T7", "no step of one", "(c.index == 2 and 0 or 1) * c.velocity * h",
        "(c.index == 2 and 0 or 1) * gravity * h",
        text("In free flight a step leaves circle 2 as it was"));
    row("L42T4", "a number for the timestep", "c.velocity / 60", "gravity / 60",
        text("A fixed number stands for the timestep of both circles"));
    row("L42T4", "parabola", "c.velocity * h + gravity * (h * h / 2)", fall,
        text("The motion of both circles is the exact parabola, not Euler"));
    row("L42T4", "place times time, too", "c.position * (h - 1) + c.velocity * h", fall,
        text("The old place of both circles is multiplied, too"));
    row("L42T4", "y anew", way, "gravity * h - vec(0, c.velocity.y)",
        text("The y of the velocity of both circles is set anew in every step"));
    row("L42T17", "a number for gravity", way, "vec(0, -9.81) * h",
        text("A number stands for gravity in the motion of both circles"));
    row("L42T4", "another one at three sixtieths", way, "3 * 60 * gravity * h * h",
        text("How gravity acts on both circles depends on the timestep"));
    row("L42T4", "wind", way, "(gravity + vec(1, 0)) * h",
        text("Something besides gravity accelerates both circles"));
    row("L42T8", "wind where nothing falls", way, "vec(0.3, 0) * h + gravity * h",
        text("Something besides gravity accelerates both circles"));
    row("L42T8", "a number where nothing falls", way, "vec(0, -9.81) * h",
        text("The velocity of both circles changes although no force acts"));
    row("L42T4", "gravity to the power of two", way, "gravity * gravity.y * h",
        text("The acceleration of both circles is not that of gravity"));
    row("L42T4", "spring", way, "(gravity - 2 * c.position) * h",
        text("The acceleration of both circles depends on the place"));
    row("L42T4", "heavy ones fall faster", way, "gravity * h * c.density / 7.8",
        text("The fall of both circles depends on radius or density"));
    row("L42T4", "a way beside its own", "c.velocity * h + vec(0.001, 0)", fall,
        text("Every step moves both circles by a fixed way besides v Δt"));
    row("L42T4", "carried by the wind", "(c.velocity + vec(1, 0)) * h", fall,
        text("Something besides its own velocity moves both circles"));
    row("L42T4", "g in the place", "c.velocity * h + gravity * h", fall,
        text("What gravity adds to the way of both circles goes with Δt, not with Δt²"));
    row("L42T4", "half a g of a sixtieth in the place", "c.velocity * h + gravity / 7200", fall,
        text("What gravity adds to the way of both circles does not depend on Δt"));
    row("L42T4", "sideways with gravity", "c.velocity * h + vec(gravity.y, 0) * h * h", fall,
        text("What a step adds to the way of both circles besides v Δt is no method's"));
    row("L42T4", "half in x, twice in y", "vec(c.velocity.x / 2, 2 * c.velocity.y) * h", fall,
        text("The way of both circles in a step is not v Δt"));
    row("L42T4", "at most 5 cm",
        "c.velocity * math.min(h, 0.05 / math.max(c.velocity:length(), 0.01))", fall,
        text("The way of both circles in a step is not v Δt"));
    row("L42T8", "no slow ones", way,
        "gravity * h - (c.velocity:length() < 0.3 and c.velocity or vec(0, 0))",
        text("The velocity of both circles changes far from everything"));
    row("L42T4", "no fall faster than 8 m/s", way,
        "(c.velocity.y > -8 and gravity * h or vec(0, 0))",
        text("The acceleration of both circles depends wrongly on the velocity"));
    row("L42T4", "towards each other", way,
        "gravity * h + (circles[3 - c.index].position - c.position) * h",
        text("The flight of both circles depends on another circle"));
    row("L42T4", "symplectic in falling",
        "(c.velocity.y > 0 and c.velocity or c.velocity + gravity * h) * h", fall,
        text("The method that moves both circles depends on the velocity"));
    row("L42T5", "symplectic in rising",
        "(c.index == 2 and c.velocity.y > 0 and c.velocity + gravity * h or c.velocity) * h", fall,
        text("The method that moves circle 2 depends on the velocity"));
    // One that rests has no direction, and stops the program.
    row("L42T5", "of one speed", "(c.index == 1 and c.velocity or c.velocity + gravity * h) * h",
        "(c.index == 1 and gravity * h or c.velocity:normalized() * 2 - c.velocity + gravity * h)",
        text("The velocity of circle 2 changes far from everything"));
    row("L42T4", "on from the first", "circles[1].position - c.position + c.velocity * h", fall,
        text("Every step moves circle 2 on from where circle 1 is"));
    // What a step does must not hang on when it is made, nor on whether it is the first.
    const QString late =
        QStringLiteral("The step of both circles depends on how long the run has lasted");
    row("L42T4", "time for the timestep", "c.velocity * time", fall, {late});
    row("L42T4", "gravity times time", way, "gravity * time", {late});
    row("L42T4", "the number of the step", "c.velocity * step / 60", fall, {late});
    row("L42T4", "the place by the clock", "vec(-2, 2) - c.position + vec(2, 0) * time", fall,
        {late});
    row("L42T4", "y twice", "vec(c.velocity.x, 2 * c.velocity.y) * h", fall,
        text("Every step moves both circles twice as far (only in y)"));
    row("L42T4", "no fall faster than 4 m/s", way,
        "(c.velocity.y > -4 and gravity * h or vec(0, 0))",
        text("The acceleration of both circles depends wrongly on the velocity"));
    const QString leaps =
        QStringLiteral("The velocity of both circles changes far from everything");
    row("L42T4", "at most 1 m/s", way,
        "gravity * h - c.velocity * (1 - math.min(1, 1 / c.velocity:length()))", {leaps});
    row("L42T4", "at most 4 m/s", way,
        "gravity * h - c.velocity * (1 - math.min(1, 4 / c.velocity:length()))", {leaps});
    row("L42T4", "only gravity moves it", "gravity * h", fall,
        text("The velocity has no part in the way of both circles"));
    // Two of them: both are named, and none besides.
    row("L42T4", "way twice, fall half", "2 * c.velocity * h", "gravity * h / 2",
        {QStringLiteral("Every step moves both circles twice as far"),
         QStringLiteral("The velocity of both circles gets only half of gravity")});
    row("L42T4", "fall twice, other order", "(c.velocity + 2 * gravity * h) * h", "2 * gravity * h",
        {QStringLiteral("Gravity acts on both circles twice as strongly"),
         QStringLiteral("The motion of both circles is symplectic Euler, not Euler")});
}

void TestFlightLaw::faultIsNamed()
{
    QFETCH(QString, step);
    QFETCH(QString, move);
    QFETCH(QStringList, said);
    const LawBench judged(task(step));
    for (const Structure &structure : structures)
        QCOMPARE(judged.flight(written({.move = move}, structure)), said);
}

void TestFlightLaw::ownSceneShowsACopyThatIsTooOld()
{
    const LawBench step = bench("L42T17");
    const LawProgram program{.start = QStringLiteral("pull = gravity gravity = vec(0, -9.81)"),
                             .move = QStringLiteral("c.velocity = c.velocity + pull * h "
                                                    "c.position = c.position + c.velocity * h")};
    QCOMPARE(
        step.flight(written(program, structures[3])),
        QStringList(QStringLiteral("The fall of both circles is not that of the gravity in the "
                                   "scene")));
}

void TestFlightLaw::hitInTheFirstStepIsNoFall()
{
    const LawBench step = bench("L42T17");
    const LawProgram program{
        .start = QStringLiteral("gravity = vec(0, -9.81) circle1.position = vec(0, 0) "
                                "circle1.velocity = vec(2, 0) circle2.position = vec(0.35, 0)"),
        .hit = QStringLiteral("if (q.position - p.position):length() < 0.4 then "
                              "p.velocity, q.velocity = vec(0, 0), vec(0, 0) end")};
    QCOMPARE(step.flight(written(program, structures[3])), QStringList());
}

/// It flies alike where it runs, and is compared there alone.
void TestFlightLaw::aProgramMayStopInItsOwnScene()
{
    const LawBench step = bench("L42T17");
    const Vec2 place = step.ground.own.circles.front().body.position;
    const QString stops =
        QStringLiteral("if circle1.position.x == %1 and circle1.position.y == %2 "
                       "then error('no') end")
            .arg(QString::number(place.x, 'g', 17), QString::number(place.y, 'g', 17));
    const QString plain = written({.move = symplectic}, structures[3]);
    const QString stopping = written({.start = stops, .move = symplectic}, structures[3]);
    const MeasuredLaws first(&plain, step.ground);
    const MeasuredLaws second(&stopping, step.ground);
    QVERIFY(!first.flight().own().accelerations.empty());
    QVERIFY(second.flight().own().accelerations.empty());
    QVERIFY(first.flight().isLike(second.flight()));
    QVERIFY(second.flight().isLike(first.flight()));
}

void TestFlightLaw::weightIsNamedThoughItEndsAtAWall_data()
{
    QTest::addColumn<QString>("walls");
    QTest::newRow("no walls") << QString();
    for (const WallWay &way : wallWays)
        QTest::newRow(way.name) << wallsOf(way);
}

/// A ball of steel, drawn with its weight for its acceleration, is at the wall two steps later.
void TestFlightLaw::weightIsNamedThoughItEndsAtAWall()
{
    QFETCH(QString, walls);
    const QString move = QStringLiteral(
        "local m = 1000 * c.density * 4 / 3 * math.pi * c.radius ^ 3 "
        "c.velocity = c.velocity + m * gravity * h c.position = c.position + c.velocity * h");
    const LawBench step = bench("L42T17");
    const QString start = QStringLiteral("gravity = vec(0, -9.81)");
    for (const Structure &structure : structures)
        QCOMPARE(
            step.flight(written({.start = start, .move = move, .walls = walls}, structure)),
            QStringList(QStringLiteral("The fall of both circles depends on radius or density")));
}

void TestFlightLaw::fallByTheMassOfAnotherIsNoCopy()
{
    const LawBench step = bench("L42T17");
    const LawProgram program{
        .start = QStringLiteral("gravity = vec(0, -9.81) circle1.density, circle2.density = 1, 2"),
        .move = QStringLiteral("c.velocity = c.velocity + gravity * (c.density * c.radius ^ 3 / "
                               "(circle1.density * circle1.radius ^ 3)) * h "
                               "c.position = c.position + c.velocity * h")};
    for (const Structure &structure : structures)
        QCOMPARE(step.flight(written(program, structure)),
                 QStringList(QStringLiteral("The fall of circle 2 depends on radius or density")));
}

/// A wrong time of impact: whoever comes nearer is stopped, however far away.
void TestFlightLaw::stopOfThoseThatComeNearerIsShown()
{
    const LawBench step = bench("L42T9");
    const LawProgram program{
        .hit = QStringLiteral("if dot(q.velocity - p.velocity, q.position - p.position) < 0 "
                              "then p.velocity, q.velocity = vec(0, 0), vec(0, 0) end")};
    for (const Structure &structure : structures)
        QCOMPARE(step.flight(written(program, structure)),
                 QStringList(
                     QStringLiteral("The velocity of both circles changes far from everything")));
}

QTEST_GUILESS_MAIN(TestFlightLaw)
#include "test_flight_law.moc"
