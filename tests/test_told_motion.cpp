// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"

#include "tests/told_flight.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on the way of a step tell are those that its law makes.
class TestToldMotion : public ToldFlight
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void wayOfAStepIsTold_data();
    void wayOfAStepIsTold();
    void whoMovesInTheOwnSceneAloneIsTold();
    void aStartThatIsCopiedTooEarlyIsTold_data();
    void aStartThatIsCopiedTooEarlyIsTold();
    void aLeapOfTheFirstStepIsTold_data();
    void aLeapOfTheFirstStepIsTold();
    void aPartThatIsBrakedBlursNoOther();
    void ofWallsNoFirstStepIsTold();
    void velocityThatIsWrittenCrossedIsTold();
    void crossedWayIsTold_data();
    void crossedWayIsTold();
    void aTimestepThatIsRightIsTold();
    void aVelocityThatIsOddIsNoWay();
    void stepsFromTheStartAreTold();
    void aRightFirstStepIsNotBlamed();
    void aFirstStepOfItsOwnIsTold();
    void stepsThatAlternateAreTold();
    void aWallIsNoOddStep();
    void stepsThatAreUnlikeAreTold_data();
    void stepsThatAreUnlikeAreTold();
    void timeThatIsSavedUpIsTold();
    void stepsThatGrowWithTheirNumberAreTold();
};

void TestToldMotion::wayOfAStepIsTold_data()
{
    QTest::addColumn<QString>("place");
    QTest::addColumn<Vec2>("factors"); // the way is these times v h^power
    QTest::addColumn<double>("power");
    QTest::newRow("without time") << "c.velocity" << Vec2{1, 1} << 0.0;
    QTest::newRow("time twice") << "c.velocity * h * h" << Vec2{1, 1} << 2.0;
    QTest::newRow("divided by time") << "c.velocity / h" << Vec2{1, 1} << -1.0;
    QTest::newRow("a sixtieth") << "c.velocity / 60" << Vec2{1.0 / 60, 1.0 / 60} << 0.0;
    QTest::newRow("back") << "-c.velocity * h" << Vec2{-1, -1} << 1.0;
    QTest::newRow("twice") << "2 * c.velocity * h" << Vec2{2, 2} << 1.0;
    QTest::newRow("0.7 times") << "0.7 * c.velocity * h" << Vec2{0.7, 0.7} << 1.0;
    QTest::newRow("x only") << "vec(c.velocity.x, 0) * h" << Vec2{1, 0} << 1.0;
    QTest::newRow("y only") << "vec(0, c.velocity.y) * h" << Vec2{0, 1} << 1.0;
    QTest::newRow("y twice") << "vec(c.velocity.x, 2 * c.velocity.y) * h" << Vec2{1, 2} << 1.0;
    QTest::newRow("none") << "vec(0, 0)" << Vec2{0, 0} << 1.0;
}

/// With a timestep with which it is not the right one by chance.
void TestToldMotion::wayOfAStepIsTold()
{
    QFETCH(QString, place);
    QFETCH(Vec2, factors);
    QFETCH(double, power);
    const auto n = numbersIn(body("L42T4", place, fall),
                             "With the velocity (#, #) m/s and Δt = 1/# s the way of a step is "
                             "(#, #) m; v Δt is (#, #) m.");
    QCOMPARE(n.size(), std::size_t{7});
    const double h = 1.0 / n[2];
    const double times = std::pow(h, power);
    QVERIFY(n[0] != 0.0 && n[1] != 0.0);
    QVERIFY(isNear(Vec2{n[3], n[4]}, times * Vec2{factors.x * n[0], factors.y * n[1]}));
    QVERIFY(isNear(Vec2{n[5], n[6]}, h * Vec2{n[0], n[1]}));
    QVERIFY(!isNear(Vec2{n[3], n[4]}, Vec2{n[5], n[6]}));
}

void TestToldMotion::whoMovesInTheOwnSceneAloneIsTold()
{
    const LawProgram program{
        .start = QStringLiteral("circle1.velocity = vec(2, 0)"),
        .move = QStringLiteral("if step == 0 then mine = c.velocity == vec(2, 0) end if mine "
                               "then c.position = c.position + c.velocity * h end")};
    const auto n = numbersIn(bodyOfProgram("L42T2", written(program, structures[0]),
                                           "Only in your own scene a step moves circle 1"),
                             "In the first step of your own scene it goes (#, #) m");
    QCOMPARE(n.size(), std::size_t{2});
    QVERIFY(isNear(n[0], 2.0 / 60.0));
}

void TestToldMotion::aStartThatIsCopiedTooEarlyIsTold_data()
{
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after");
    QTest::addColumn<QString>("seen");
    QTest::newRow("both") << "p, v = c.position, c.velocity"
                          << ""
                          << "Your program sets it at (#, #) m with (#, #) m/s, and one step later "
                             "it is at (#, #) m with (#, #) m/s: that step goes on from (#, #) m "
                             "and (#, #) m/s, which the scene gives it.";
    QTest::newRow("place") << "p = c.position"
                           << "v = c.velocity"
                           << "Your program sets it at (#, #) m, and one step later it is at (#, "
                              "#) m: that step goes on from (#, #) m, where the scene has it.";
    QTest::newRow("velocity") << "v = c.velocity"
                              << "p = c.position"
                              << "Your program starts it with (#, #) m/s, and one step later it "
                                 "has (#, #) m/s: that step goes on from (#, #) m/s, which the "
                                 "scene gives it.";
}

/// Only the own scene shows it, in which the program sets what the scene has otherwise.
void TestToldMotion::aStartThatIsCopiedTooEarlyIsTold()
{
    QFETCH(QString, before);
    QFETCH(QString, after);
    QFETCH(QString, seen);
    const QString program = QStringLiteral("local c, p, v = circle1 "
                                           "function on_load() gravity = vec(0, -9.81) %1 "
                                           "c.position, c.velocity = vec(-1.5, 2.5), vec(3, 0.5) "
                                           "%2 end "
                                           "function on_update(h) "
                                           "p, v = p + v * h, v + gravity * h "
                                           "c.position, c.velocity = p, v end")
                                .arg(before, after);
    const auto n =
        numbersIn(bodyOfProgram("L42T3", program,
                                "The start of circle 1 in your own scene is not taken over"),
                  qPrintable(seen));
    QVERIFY(!n.empty());
    const double h = 1.0 / 60.0;
    if (before.startsWith(u'v')) {
        QVERIFY(isNear(Vec2{n[0], n[1]}, Vec2{3.0, 0.5}));
        QVERIFY(isNear(Vec2{n[2], n[3]}, Vec2{n[4], n[5] - 9.81 * h}));
        return;
    }
    QVERIFY(isNear(Vec2{n[0], n[1]}, Vec2{-1.5, 2.5}));
    if (n.size() == 6) {
        QVERIFY(isNear(Vec2{n[2], n[3]}, Vec2{n[4], n[5]} + h * Vec2{3.0, 0.5}));
        return;
    }
    QVERIFY(isNear(Vec2{n[4], n[5]}, Vec2{n[8], n[9]} + h * Vec2{n[10], n[11]}));
    QVERIFY(isNear(Vec2{n[6], n[7]}, Vec2{n[10], n[11] - 9.81 * h}));
}

void TestToldMotion::aLeapOfTheFirstStepIsTold_data()
{
    QTest::addColumn<QString>("walls");
    QTest::newRow("into a corner") << "reflect(c, vec(1, 0)) reflect(c, vec(-1, 0)) "
                                      "reflect(c, vec(0, 1)) reflect(c, vec(0, -1))";
    QTest::newRow("to one wall") << "reflect(c, vec(0, 1)) reflect(c, vec(0, -1))";
}

/// Who sticks where the first step has put it is moved by that step, and far.
void TestToldMotion::aLeapOfTheFirstStepIsTold()
{
    QFETCH(QString, walls);
    const QString program = QStringLiteral("local function reflect(c, n) "
                                           "local out = dot(c.position, n) + c.radius - 4 "
                                           "local speed = dot(c.velocity, n) "
                                           "if out > 0 or speed > 0 then "
                                           "c.position = c.position - out * n "
                                           "c.velocity = c.velocity - 2 * speed * n end end "
                                           "function on_update(h) "
                                           "local c = circle1 "
                                           "c.position = c.position + c.velocity * h "
                                           "c.velocity = c.velocity + gravity * h %1 end")
                                .arg(walls);
    const auto n = numbersIn(
        bodyOfProgram("L42T3", program, "A step takes circle 1 much farther than its velocity"),
        "Started with (#, #) m/s, away from every wall and every other circle, it goes (#, #) m in "
        "the first step of 1/# s; v Δt is (#, #) m.");
    QCOMPARE(n.size(), std::size_t{7});
    QVERIFY(length({n[2], n[3]}) > 1.0);
    QVERIFY(isNear(Vec2{n[5], n[6]}, 1.0 / n[4] * Vec2{n[0], n[1]}));
}

/// What brakes the velocity may be seen in the way of the same step, but does not make it twice as
/// long.
void TestToldMotion::aPartThatIsBrakedBlursNoOther()
{
    const QString program =
        programs::written({.move = QStringLiteral("c.velocity = c.velocity * (1 - 0.5 * h) "
                                                  "c.position = c.position "
                                                  "+ vec(c.velocity.x, 2 * c.velocity.y) * h")},
                          programs::structures[0]);
    const auto n = numbersIn(bodyOfProgram("L42T2", program, "The way of circle 1 in a step"),
                             "With the velocity (#, #) m/s and Δt = 1/# s the way of a step is "
                             "(#, #) m; v Δt is (#, #) m.");
    QCOMPARE(n.size(), std::size_t{7});
    QVERIFY(std::abs(n[4] / n[6] - 2.0 * (1.0 - 0.5 / n[2])) < 0.01);
}

namespace {

/// With a place and a velocity of its own, to which every step adds \p fall, written as \p written.
QString ownState(const char *fall, const char *written)
{
    return QStringLiteral("local s = {} "
                          "function on_load() "
                          "s.p, s.v = circle1.position, circle1.velocity end "
                          "function on_update(h) "
                          "local was, limit = s.p, square.half_width - circle1.radius "
                          "s.p = s.p + s.v * h s.v = s.v + %1 "
                          "if math.abs(s.p.y) > limit and s.p.y * s.v.y > 0 then "
                          "s.p, s.v = was, vec(s.v.x, -s.v.y) end "
                          "circle1.position, circle1.velocity = s.p, %2 end")
        .arg(QLatin1String(fall), QLatin1String(written));
}

} // namespace

/// It falls so fast that a wall turns it in its second step, which every step could be.
void TestToldMotion::ofWallsNoFirstStepIsTold()
{
    const QString said = bodyOfProgram("L42T3", ownState("vec(0, gravity.y / h)", "s.v"),
                                       "Gravity on circle 1 is divided by the timestep");
    QVERIFY(!said.isEmpty());
    QVERIFY2(!said.contains(QLatin1String("first step")), qPrintable(said));
}

/// The way is right, and what is written down of the velocity is not.
void TestToldMotion::velocityThatIsWrittenCrossedIsTold()
{
    const auto n = numbersIn(bodyOfProgram("L42T2", ownState("vec(0, 0)", "vec(s.v.y, s.v.x)"),
                                           "x and y of the velocity of circle 1 are exchanged"),
                             "Started with (#, #) m/s, it goes (#, #) m in the first step of 1/# "
                             "s and has (#, #) m/s after it.");
    QCOMPARE(n.size(), std::size_t{7});
    QVERIFY(isNear(Vec2{n[2], n[3]}, Vec2{n[0], n[1]} / n[4]));
    QVERIFY(isNear(Vec2{n[5], n[6]}, Vec2{n[1], n[0]}));
}

void TestToldMotion::crossedWayIsTold_data()
{
    QTest::addColumn<QString>("velocity");
    QTest::addColumn<QString>("headline");
    QTest::newRow("x for both") << "vec(c.velocity.x, c.velocity.x)"
                                << "The x part of the velocity moves both circles in y";
    QTest::newRow("y for both") << "vec(c.velocity.y, c.velocity.y)"
                                << "The y part of the velocity moves both circles in x";
    QTest::newRow("exchanged")
        << "vec(c.velocity.y, c.velocity.x)"
        << "x and y of the velocity are exchanged in the way of both circles";
    QTest::newRow("its size") << "vec(c.velocity:length(), 0)"
                              << "The way of both circles in a step is not v Δt";
}

void TestToldMotion::crossedWayIsTold()
{
    QFETCH(QString, velocity);
    QFETCH(QString, headline);
    const auto n = numbersIn(
        body("L42T4", velocity + QStringLiteral(" * h"), fall, headline.toUtf8().constData()),
        "With the velocity (#, #) m/s and Δt = 1/# s the way of a step is (#, #) m, with (#, #) "
        "m/s "
        "(#, #) m; v Δt is (#, #) and (#, #) m.");
    QCOMPARE(n.size(), std::size_t{13});
    const double h = 1.0 / n[2];
    const auto moved = [&](double x, double y) {
        const Vec2 crossed =
            velocity.contains(QLatin1String("length")) ? Vec2{std::hypot(x, y), 0}
            : velocity == QLatin1String("vec(c.velocity.x, c.velocity.x)") ? Vec2{x, x}
            : velocity == QLatin1String("vec(c.velocity.y, c.velocity.y)") ? Vec2{y, y}
                                                                           : Vec2{y, x};
        return h * crossed;
    };
    QVERIFY(isNear(Vec2{n[3], n[4]}, moved(n[0], n[1])));
    QVERIFY(isNear(Vec2{n[7], n[8]}, moved(n[5], n[6])));
    QVERIFY(isNear(Vec2{n[9], n[10]}, h * Vec2{n[0], n[1]}));
    QVERIFY(isNear(Vec2{n[11], n[12]}, h * Vec2{n[5], n[6]}));
    QVERIFY(!isNear(Vec2{n[0], n[1]}, Vec2{n[5], n[6]}));
}

void TestToldMotion::aTimestepThatIsRightIsTold()
{
    const auto n = numbersIn(body("L42T2", QStringLiteral("c.velocity * math.min(h, 1 / 60)"), fall,
                                  "With some timesteps the way of circle 1 is not v"),
                             "With the velocity (#, #) m/s and Δt = 1/# s the way of a step is "
                             "(#, #) m; v Δt is (#, #) m. With Δt = 1/# s it goes v Δt.");
    QCOMPARE(n.size(), std::size_t{8});
    QVERIFY(n[2] < 60.0 && n[7] >= 60.0);
    QVERIFY(isNear(Vec2{n[3], n[4]}, Vec2{n[0], n[1]} / 60.0));
}

/// What lays slow circles to rest stops one that starts at rest with short timesteps alone.
void TestToldMotion::aVelocityThatIsOddIsNoWay()
{
    const LawProgram sleeper{
        .move = QStringLiteral("c.velocity = c.velocity + gravity * h "
                               "if c.velocity:length() < 0.1 then c.velocity = vec(0, 0) end "
                               "c.position = c.position + c.velocity * h")};
    const QString all = bodyOfProgram("L42T17", written(sleeper, structures[0]));
    QVERIFY2(!all.isEmpty() && !all.contains(QString::fromUtf8("v Δt")), qPrintable(all));
}

/// The old place is kept once: from then on no step adds to the one before.
void TestToldMotion::stepsFromTheStartAreTold()
{
    const LawProgram program{.start = QStringLiteral("at = {}"),
                             .move = QStringLiteral("at[c.index] = at[c.index] or c.position "
                                                    "c.velocity = c.velocity + gravity * h "
                                                    "c.position = at[c.index] + c.velocity * h")};
    const auto n = numbersIn(
        bodyOfProgram("L42T17", written(program, structures[1]),
                      "Every step moves both circles on from the place of the start"),
        "Started with (#, #) m/s, it is (#, #) m from its start after the first step of 1/# s, and "
        "(#, #) m after the second.");
    QCOMPARE(n.size(), std::size_t{7});
    QVERIFY(isNear(n[2], n[5]));
    QVERIFY(isNear(n[6], n[3] - 9.81 / (n[4] * n[4])));
}

/// What is kept once is right in the first step, and only there.
void TestToldMotion::aRightFirstStepIsNotBlamed()
{
    const LawProgram once{.start = QStringLiteral("fallen = false"),
                          .move = QStringLiteral("c.position = c.position + c.velocity * h "
                                                 "if not fallen then "
                                                 "c.velocity = c.velocity + gravity * h end "
                                                 "fallen = true")};
    const auto n = numbersIn(
        bodyOfProgram("L42T3", written(once, structures[0]),
                      "Only the first step changes the velocity of circle 1 rightly"),
        "Thrown with (#, #) m/s, it has (#, #) m/s one step of 1/# s later, which is right; in the "
        "next step that changes by (#, #) m/s, and gravity gives it (#, #) m/s.");
    QCOMPARE(n.size(), std::size_t{9});
    QVERIFY(isNear(n[3], n[1] - 9.81 / n[4]) && n[6] == 0.0 && isNear(n[8], -9.81 / n[4]));
    // Where nothing pulls, a step that changes nothing is as right.
    const LawProgram later{.start = QStringLiteral("begun = false"),
                           .move = QStringLiteral("c.position = c.position + c.velocity * h "
                                                  "if begun then c.velocity = 0.5 * c.velocity end "
                                                  "begun = true")};
    const QString said = bodyOfProgram("L42T2", written(later, structures[0]));
    const auto kept = numbersIn(said, "Thrown with (#, #) m/s, it has (#, #) m/s one step of 1/# s "
                                      "later, which is right; in the next step that changes by (#, "
                                      "#) m/s, and gravity gives it (#, #) m/s.");
    QVERIFY2(kept.size() == 9, qPrintable(said));
    QVERIFY(kept[2] == kept[0] && isNear(kept[5], -0.5 * kept[0]) && kept[8] == 0.0);
}

/// Two steps at once, and none in the next one.
void TestToldMotion::stepsThatAlternateAreTold()
{
    const QString twice = QStringLiteral("(step % 2 == 0 and 2 or 0) * ");
    const QString said =
        body("L42T4", twice + way, twice + fall, "Not every step of both circles is made alike");
    QVERIFY(said.contains(QLatin1String("what your program counts")));
    const QString late = body("L42T4", way, fall + QStringLiteral(" * (time > 1 and 2 or 1)"),
                              "The step of both circles depends on how long the run has lasted");
    QVERIFY(!late.isEmpty());
}

void TestToldMotion::stepsThatAreUnlikeAreTold_data()
{
    QTest::addColumn<QString>("asked");
    QTest::addColumn<QList<double>>("falls"); // in the first four steps, of g Δt
    QTest::newRow("every second") << "n % 2 == 0" << QList<double>{0, 1, 0, 1};
    QTest::newRow("every third") << "n % 3 == 0" << QList<double>{0, 0, 1, 0};
    QTest::newRow("all but every third") << "n % 3 ~= 0" << QList<double>{1, 1, 0, 1};
    QTest::newRow("from the third on") << "n > 2" << QList<double>{0, 0, 1, 1};
}

/// The second step tells the law of none but itself: neither is the first one odd, nor is there no
/// gravity.
void TestToldMotion::stepsThatAreUnlikeAreTold()
{
    QFETCH(QString, asked);
    QFETCH(QList<double>, falls);
    const QString program =
        QStringLiteral("local n = 0 ")
        + written({.circles = 1,
                   .move = QStringLiteral("n = n + 1 c.position = c.position + c.velocity * h "
                                          "if %1 then c.velocity = c.velocity + gravity * h end")
                               .arg(asked)},
                  structures[0]);
    const auto n = numbersIn(
        bodyOfProgram("L42T3", program, "Not every step of circle 1 is made alike"),
        "Started with (#, #) m/s, in the first four steps of 1/# s its velocity changes by (#, #), "
        "(#, #), (#, #) and (#, #) m/s; (#, #) m/s is right in each.");
    QCOMPARE(n.size(), std::size_t{13});
    QVERIFY(isNear(n[12], -9.81 / n[2]));
    for (std::size_t k = 0; k < 4; ++k)
        QVERIFY(n[3 + 2 * k] == 0.0 && isNear(n[4 + 2 * k], falls[qsizetype(k)] * n[12]));
}

/// Of steps that are half as long as those that it makes every second one does nothing: no number
/// stands for the timestep in each.
void TestToldMotion::timeThatIsSavedUpIsTold()
{
    const QString program =
        QStringLiteral("local saved = 0 ")
        + written({.circles = 1,
                   .move = QStringLiteral("saved = saved + h if saved > 0.99 / 60 then "
                                          "saved = saved - 1 / 60 "
                                          "c.position = c.position + c.velocity / 60 "
                                          "c.velocity = c.velocity + gravity / 60 end")},
                  structures[0]);
    const QString said =
        bodyOfProgram("L42T3", program, "Not every step of circle 1 is made alike");
    const auto n = numbersIn(said, "in the first four steps of 1/# s its velocity changes by (#, "
                                   "#), (#, #), (#, #) and (#, #) m/s; (#, #) m/s is right in "
                                   "each.");
    QVERIFY2(n.size() == 11 && n[0] == 120.0, qPrintable(said));
    for (std::size_t k = 0; k < 4; ++k)
        QVERIFY(isNear(n[2 + 2 * k], k % 2 == 0 ? 0.0 : -9.81 / 60.0));
}

/// The whole time since the start takes the place of that of one step.
void TestToldMotion::stepsThatGrowWithTheirNumberAreTold()
{
    const QString grown = QStringLiteral("From step to step that grows by the same");
    const QString far =
        bodyOfProgram("L42T2",
                      QStringLiteral("local t = 0 ")
                          + written({.circles = 1,
                                     .move = QStringLiteral("t = t + h "
                                                            "c.position = c.position + "
                                                            "c.velocity * t")},
                                    structures[0]),
                      "Not every step of circle 1 is made alike");
    const auto ways = numbersIn(far, "in the first four steps of 1/# s it goes (#, #), (#, #), (#, "
                                     "#) and (#, #) m; (#, #) m is right in each.");
    QVERIFY2(ways.size() == 11 && far.contains(grown), qPrintable(far));
    for (std::size_t k = 0; k < 4; ++k)
        QVERIFY(isNear(ways[1 + 2 * k], double(k + 1) * ways[9]));
    // The parabola from the start without its half: the k-th step has k g Δt², and ½ is right.
    const QString deep =
        bodyOfProgram("L42X6",
                      QStringLiteral("local t, at, with = {0, 0}, {}, {} ")
                          + written({.move = QStringLiteral(
                                         "local i = c.index t[i] = t[i] + h "
                                         "at[i] = at[i] or c.position with[i] = with[i] or "
                                         "c.velocity c.position = at[i] + with[i] * t[i] + gravity "
                                         "* (t[i] * t[i]) c.velocity = with[i] + gravity * t[i]")},
                                    structures[0]),
                      "Not every step of circle 2 is made alike");
    const auto more =
        numbersIn(deep, "in the first four steps of 1/# s it goes (#, #), (#, #), (#, "
                        "#) and (#, #) m more than is right");
    QVERIFY2(more.size() == 9 && deep.contains(grown), qPrintable(deep));
    for (std::size_t k = 0; k < 4; ++k)
        QVERIFY(isNear(more[2 + 2 * k], -(double(k) + 0.5) * 9.81 / (more[0] * more[0])));
}

/// What is kept of the step before is not there yet in the first.
void TestToldMotion::aFirstStepOfItsOwnIsTold()
{
    const char *headline = "The first step of circle 1 is made in another way";
    const auto with = [&](const QString &place, const QString &velocity) {
        QString program = QStringLiteral("local begun = false ")
                          + written({.circles = 1,
                                     .move = QStringLiteral("c.position = c.position + %1 "
                                                            "c.velocity = c.velocity + %2 "
                                                            "begun = true")
                                                 .arg(place, velocity)},
                                    structures[0]);
        return bodyOfProgram("L42T3", program, headline);
    };
    const auto turn =
        numbersIn(with(way, QStringLiteral("(begun and 1 or 0) * gravity * h")),
                  "Started with (#, #) m/s, it has (#, #) m/s after the first step of 1/# s; made "
                  "as the second is, that step gives it (#, #) m/s.");
    QCOMPARE(turn.size(), std::size_t{7});
    QVERIFY(turn[3] == turn[1]);
    QVERIFY(isNear(turn[6], turn[1] - 9.81 / turn[4]));
    const auto went = numbersIn(with(QStringLiteral("(begun and 1 or 0.5) * c.velocity * h"), fall),
                                "Started with (#, #) m/s, it goes (#, #) m in the first step of "
                                "1/# s; made as the second is, that step goes (#, #) m.");
    QCOMPARE(went.size(), std::size_t{7});
    QVERIFY(isNear(went[2], 0.5 * went[5]));
    QVERIFY(isNear(went[5], went[0] / went[4]));
    QVERIFY(with(way, fall).isEmpty());
}

/// Who keeps its state itself, goes back to the old place at walls and falls so fast that it comes
/// to the floor within a few steps: those before are made alike.
void TestToldMotion::aWallIsNoOddStep()
{
    const QString program =
        QStringLiteral("local s = {}\n"
                       "function on_load()\n"
                       "  gravity = vec(0, -9.81)\n"
                       "  circle1.velocity = vec(2, 0)\n"
                       "  s.p, s.v = circle1.position, circle1.velocity\n"
                       "end\n"
                       "function on_update(h)\n"
                       "  local old, r = s.p, circle1.radius\n"
                       "  s.p = s.p + s.v * h\n"
                       "  s.v = s.v + gravity * h * 60\n"
                       "  local x = math.abs(s.p.x) > 4 - r and s.p.x * s.v.x > 0\n"
                       "  local y = math.abs(s.p.y) > 4 - r and s.p.y * s.v.y > 0\n"
                       "  s.v = vec(x and -s.v.x or s.v.x, y and -s.v.y or s.v.y)\n"
                       "  if x or y then s.p = old end\n"
                       "  circle1.position, circle1.velocity = s.p, s.v\n"
                       "end\n");
    QVERIFY(bodyOfProgram("L42T3", program, "Not every step").isEmpty());
    QVERIFY(!bodyOfProgram("L42T3", program, "The velocity of circle 1 gets 60 times").isEmpty());
}

QTEST_GUILESS_MAIN(TestToldMotion)
#include "test_told_motion.moc"
