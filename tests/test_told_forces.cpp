// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"

#include "tests/told_flight.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on what besides gravity changes a velocity in the open tell are those
/// that the law of the program makes.
class TestToldForces : public ToldFlight
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void oneThatFallsIsTurnedByTheFloor();
    void eInTheOpenIsTold();
    void forceByVelocityOrPlaceIsTold_data();
    void forceByVelocityOrPlaceIsTold();
    void aSpeedThatIsCutIsTold();
    void aConditionOnTheVelocityIsTold();
    void aConditionThatOneGravityShowsIsTold();
    void forcesOfTwoCirclesAreToldApart();
    void oneThatIsThrownFromRestIsTold();
    void aVelocityThatGrowsWithoutGravityIsTold();
};

/// A floor that asks "below it or on the way down" turns whatever falls.
void TestToldForces::oneThatFallsIsTurnedByTheFloor()
{
    const auto n = numbersIn(body("L42T4", way,
                                  QStringLiteral("gravity * h if c.velocity.y < 0 then "
                                                 "c.velocity = vec(c.velocity.x, -c.velocity.y) "
                                                 "end"),
                                  "Far from the floor something turns both circles round"),
                             "Thrown straight towards the floor with (#, #) m/s from (#, #) m, "
                             "circle # has (#, #) m/s one step of 1/# s later. So it is from all "
                             "places tried; thrown the other way it goes on as it should.");
    QCOMPARE(n.size(), std::size_t{8});
    QVERIFY(n[0] == 0.0 && n[1] < 0.0 && n[5] == 0.0 && isNear(n[6], 9.81 / n[7] - n[1]));
}

void TestToldForces::eInTheOpenIsTold()
{
    const QString program =
        written({.move = QStringLiteral("c.velocity = (c.velocity + gravity * h) * "
                                        "(1 - (1 - restitution) * h) "
                                        "c.position = c.position + c.velocity * h"),
                 .walls = wallsOf(wallWays[1])},
                structures[1]);
    const LawBench bench(task(QStringLiteral("L42T17")));
    const MeasuredLaws own(&program, bench.ground);
    const auto found = flightDeviations(own.flight(), bench.right.flight(), bench.ground);
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY(found.front().hidesHits);
    const auto n = numbersIn(bodyOf(found, QStringLiteral("e changes the velocity of both circles "
                                                          "away from any hit")),
                             "Started with (#, #) m/s, it has (#, #) m/s two steps of 1/# s later "
                             "with e = #, and (#, #) m/s with e = 1; nothing is near.");
    QCOMPARE(n.size(), std::size_t{8});
    const double h = 1.0 / n[4];
    QVERIFY(isNear(n[2], n[0] * std::pow(1.0 - (1.0 - n[5]) * h, 2)) && n[2] < n[6]);
    // It shows with that e alone.
    QVERIFY(isNear(found.front().moment.stage.preset.restitution, n[5]));
}

void TestToldForces::forceByVelocityOrPlaceIsTold_data()
{
    QTest::addColumn<QString>("force");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<QString>("told");
    const auto row = [](const char *force, const char *headline, const char *told) {
        QTest::newRow(force) << QString::fromUtf8(force) << QString::fromUtf8(headline)
                             << QString::fromUtf8(told);
    };
    const char *slower = "Something slows both circles down on the way";
    const char *inY = "Something slows both circles down on the way (only in y)";
    row("-0.2 * c.velocity", slower,
        "With Δt = 1/60 s it is accelerated by -0.2 m/s² for every m/s of its velocity; 0 is "
        "right.");
    row("0.3 * c.velocity", "Something makes both circles faster on the way",
        "With Δt = 1/60 s it is accelerated by 0.3 m/s² for every m/s of its velocity; 0 is "
        "right.");
    row("-vec(0, 0.4 * c.velocity.y)", inY,
        "With Δt = 1/60 s it is accelerated in y by -0.4 m/s² for every m/s of its velocity in y; "
        "0 is right.");
    row("vec(-0.1 * c.velocity.x, 0.4 * c.velocity.y)",
        "The velocity of both circles changes by itself otherwise than asked",
        "With Δt = 1/60 s it is accelerated by -0.1 m/s² for every m/s of its velocity in x, and "
        "by 0.4 m/s² for every m/s in y; 0 and 0 are right.");
    // A tenth of the velocity, however long the step is.
    row("-0.1 * c.velocity / h", slower,
        "With Δt = 1/60 s it is accelerated by -6 m/s² for every m/s of its velocity; 0 is right. "
        "In a step of 1/120 s it keeps as much of it, 0.9 times: so what happens in a second "
        "depends "
        "on Δt.");
    row("-vec(2 * c.velocity.x / h, 0)",
        "Far from everything the velocity of both circles turns round (only in x)",
        "It had (-1.13, 0.547) m/s, and (1.13, 0.383) m/s one step of 1/60 s later, with nothing "
        "near that it could hit. Look at the lines that turn it, and at what is asked before them: "
        "is it true although nothing touches?");
    row("-vec(0.3 * c.position.x, 0.7 * c.position.y)",
        "The acceleration of both circles depends on the place",
        "At rest under gravity (0, -9.81) m/s² it is accelerated by (0.411, -10.4) m/s² at (-1.37, "
        "0.83) m and by (0.318, -10.2) m/s² at (-1.06, 0.6) m; (0, -9.81) and (0, -9.81) m/s² are "
        "right.");
}

void TestToldForces::forceByVelocityOrPlaceIsTold()
{
    QFETCH(QString, force);
    QFETCH(QString, headline);
    QFETCH(QString, told);
    const LawProgram program{.move = QStringLiteral("local a = gravity + %1 "
                                                    "c.position = c.position + c.velocity * h "
                                                    "c.velocity = c.velocity + a * h")
                                         .arg(force)};
    QCOMPARE(bodyOfProgram("L42T4", written(program, structures[0]), headline.toUtf8().constData()),
             told);
}

/// At most 1 m/s, and then gravity: what is left without that has the direction of the throw.
void TestToldForces::aSpeedThatIsCutIsTold()
{
    const auto n = numbersIn(
        body("L42T4", way,
             QStringLiteral("gravity * h - c.velocity * (1 - math.min(1, 1 / "
                            "c.velocity:length()))")),
        "Thrown with (#, #) m/s, it has (#, #) m/s one step of 1/# s later, far from every wall "
        "and every other circle; gravity gives it (#, #) m/s in a step.");
    QCOMPARE(n.size(), std::size_t{7});
    QVERIFY(isNear(Vec2{n[5], n[6]}, Vec2{0.0, -9.81 / n[4]}));
    const Vec2 thrown{n[0], n[1]};
    QVERIFY(length(thrown) > 1.0);
    QVERIFY(length(Vec2{n[2], n[3]} - Vec2{n[5], n[6]} - normalized(thrown)) < 0.01);
}

/// Who moves to the left is not pulled.
void TestToldForces::aConditionOnTheVelocityIsTold()
{
    const auto n = numbersIn(
        body("L42T4", way, QStringLiteral("(c.velocity.x > 0.6 and gravity * h or vec(0, 0))")),
        "Under gravity (#, #) m/s² and with the velocity (#, #) m/s it changes by (#, #) m/s in a "
        "step of 1/# s, with (#, #) m/s by (#, #) m/s; (#, #) and (#, #) m/s are right.");
    QCOMPARE(n.size(), std::size_t{15});
    const Vec2 right{0.0, -9.81 / n[6]};
    QVERIFY(isNear(Vec2{n[4], n[5]}, n[2] > 0.6 ? right : Vec2{}));
    QVERIFY(isNear(Vec2{n[9], n[10]}, n[7] > 0.6 ? right : Vec2{}));
    QVERIFY(isNear(Vec2{n[11], n[12]}, right) && isNear(Vec2{n[13], n[14]}, right));
    QVERIFY((n[2] > 0.6) != (n[7] > 0.6));
}

/// Who is slow is held, which a step of a weak gravity does not leave again.
void TestToldForces::aConditionThatOneGravityShowsIsTold()
{
    const auto n = numbersIn(
        body("L42T3", way,
             QStringLiteral("gravity * h - (math.abs(c.velocity.y) < 0.1 and "
                            "vec(0, c.velocity.y) or vec(0, 0))"),
             "The acceleration of circle 1 depends wrongly on the velocity"),
        "Under gravity (#, #) m/s² and with the velocity (#, #) m/s it changes by (#, #) m/s in a "
        "step of 1/# s, with (#, #) m/s by (#, #) m/s; (#, #) and (#, #) m/s are right.");
    QCOMPARE(n.size(), std::size_t{15});
    QVERIFY(std::abs(n[3]) > 0.1 && std::abs(n[8]) < 0.1);
    QVERIFY(isNear(n[5], n[1] / n[6]));
    QVERIFY(isNear(n[14], n[1] / n[6]));
    QVERIFY(std::abs(n[10]) < 1e-9);
}

void TestToldForces::forcesOfTwoCirclesAreToldApart()
{
    const QString wind = QStringLiteral("(gravity + vec(c.index == 1 and 1 or -1, 0)) * h");
    for (const auto &[circle, more] : {std::pair(1, 1.0), std::pair(2, -1.0)}) {
        const QString headline =
            QStringLiteral("Something besides gravity accelerates circle %1").arg(circle);
        const auto n = numbersIn(body("L42T4", way, wind, qPrintable(headline)),
                                 "Each time that is (#, #) m/s² more than gravity gives.");
        QCOMPARE(n, (std::vector<double>{more, 0.0}));
    }
    QVERIFY(!body("L42T4", way, QStringLiteral("(gravity + vec(1, 0)) * h"),
                  "Something besides gravity accelerates both circles")
                 .isEmpty());
}

/// The speed is that of a fall from 2 m, wherever it is: at rest nothing is there to begin with.
void TestToldForces::oneThatIsThrownFromRestIsTold()
{
    const LawProgram program{.move =
                                 QStringLiteral("c.position = c.position + c.velocity * h "
                                                "c.velocity = c.velocity + gravity * h "
                                                "c.velocity = c.velocity:normalized() "
                                                "* math.sqrt(2 * 9.81 * (2 - c.position.y) + 4)")};
    const auto n = numbersIn(
        bodyOfProgram("L42T3", written(program, structures[0]),
                      "The velocity of circle 1 changes far from everything"),
        "Let go at rest, it has (#, #) m/s one step of 1/# s later, far from every wall and every "
        "other circle; gravity gives it (#, #) m/s in a step.");
    QCOMPARE(n.size(), std::size_t{5});
    QVERIFY(n[1] < -1.0);
    QVERIFY(isNear(n[4], -9.81 / n[2]));
}

void TestToldForces::aVelocityThatGrowsWithoutGravityIsTold()
{
    const auto n = numbersIn(body("L42T1", way, QStringLiteral("vec(2, 0) * h"),
                                  "The velocity of circle 1 changes although no force acts"),
                             "The acceleration is (#, #) m/s², under gravity (#, #)");
    QCOMPARE(n, (std::vector<double>{2.0, 0.0, 0.0, 0.0}));
}

QTEST_GUILESS_MAIN(TestToldForces)
#include "test_told_forces.moc"
