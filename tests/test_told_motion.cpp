// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"

#include "tests/told_flight.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on the way of a step, and on its method, tell are those that its law
/// makes.
class TestToldMotion : public ToldFlight
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void wayOfAStepIsTold_data();
    void wayOfAStepIsTold();
    void fallIsNoPartOfTheWay_data();
    void fallIsNoPartOfTheWay();
    void whoMovesInTheOwnSceneAloneIsTold();
    void crossedWayIsTold_data();
    void crossedWayIsTold();
    void wrongWayBesideAMethodIsTold();
    void aTimestepThatIsRightIsTold();
    void stepsFromTheStartAreTold();
    void aRightFirstStepIsNotBlamed();
    void aFirstStepOfItsOwnIsTold();
    void stepsThatAlternateAreTold();
    void methodIsTold_data();
    void methodIsTold();
    void signOfTheHalfIsTold();
    void methodsOfTwoAreTold();
    void anyMethodInPartsIsRight_data();
    void anyMethodInPartsIsRight();
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

void TestToldMotion::fallIsNoPartOfTheWay_data()
{
    QTest::addColumn<double>("share"); // of g h² in the way of a step, beside twice v h
    QTest::newRow("all of it twice") << 1.0;
    QTest::newRow("the velocity alone") << 0.5;
}

/// What gravity adds to v Δt is either as wrong as that, or said.
void TestToldMotion::fallIsNoPartOfTheWay()
{
    QFETCH(double, share);
    const QString said =
        body("L42X6",
             QStringLiteral(
                 "(c.index == 1 and c.velocity * h or 2 * c.velocity * h + %1 * gravity * h * h)")
                 .arg(share),
             fall, "Every step moves circle 2 twice as far");
    const auto right = numbersIn(said, "With the velocity (#, #) m/s and Δt = 1/# s the way of a "
                                       "step is (#, #) m; (#, #) m is right.");
    const auto apart = numbersIn(said, "With the velocity (#, #) m/s and Δt = 1/# s the way of a "
                                       "step is (#, #) m, of which (#, #) m are not of the "
                                       "velocity; v Δt is (#, #) m.");
    const bool isAll = share == 1.0;
    const auto &n = isAll ? right : apart;
    QVERIFY2(n.size() == std::size_t(isAll ? 7 : 9), qPrintable(said));
    const double h = 1.0 / n[2];
    const Vec2 v{n[0], n[1]};
    const Vec2 pull = 9.81 * h * h * Vec2{0, -1};
    QVERIFY(isNear(Vec2{n[3], n[4]}, 2.0 * h * v + share * pull));
    QVERIFY(isNear(Vec2{n[5], n[6]}, isAll ? h * v + 0.5 * pull : share * pull));
    if (!isAll)
        QVERIFY(isNear(Vec2{n[7], n[8]}, h * v));
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

void TestToldMotion::crossedWayIsTold_data()
{
    QTest::addColumn<QString>("velocity");
    QTest::addColumn<QString>("headline");
    QTest::newRow("x for both") << "vec(c.velocity.x, c.velocity.x)"
                                << "The x part of the velocity moves both circles in y";
    QTest::newRow("y for both") << "vec(c.velocity.y, c.velocity.y)"
                                << "The y part of the velocity moves both circles in x";
    QTest::newRow("exchanged") << "vec(c.velocity.y, c.velocity.x)"
                               << "x and y of the velocity are exchanged where both circles moves";
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

/// By Verlet only where it comes down: v Δt is no right way there, either.
void TestToldMotion::wrongWayBesideAMethodIsTold()
{
    const QString said = body("L42X6",
                              QStringLiteral("(c.velocity.y > 0 and 0.5 or 1) * c.velocity * h + "
                                             "gravity * (h * h / 2)"),
                              fall, "The way of circle 2 in a step is wrong");
    const auto n = numbersIn(
        said, "With the velocity (#, #) m/s and Δt = 1/# s the way of a step is (#, #) m, "
              "with (#, #) m/s (#, #) m; (#, #) and (#, #) m are "
              "right. Let go at rest, it goes as it should.");
    QCOMPARE(n.size(), std::size_t{13});
    const double h = 1.0 / n[2];
    const auto right = [&](double x, double y) {
        return h * Vec2{x, y} + Vec2{0.0, -0.5 * 9.81 * h * h};
    };
    QVERIFY(isNear(Vec2{n[9], n[10]}, right(n[0], n[1])));
    QVERIFY(isNear(Vec2{n[11], n[12]}, right(n[5], n[6])));
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

void TestToldMotion::methodIsTold_data()
{
    QTest::addColumn<double>("share"); // of g h² in the way of the first step
    QTest::addColumn<QString>("told");
    QTest::newRow("half") << 0.5 << QStringLiteral("v Δt + ½ g Δt²");
    QTest::newRow("whole") << 1.0 << QStringLiteral("v Δt + g Δt²");
    QTest::newRow("a third of it") << 0.3 << QStringLiteral("v Δt + 0.3 g Δt²");
    QTest::newRow("upward") << -0.4 << QStringLiteral("v Δt − 0.4 g Δt²");
}

void TestToldMotion::methodIsTold()
{
    QFETCH(double, share);
    QFETCH(QString, told);
    const QString said =
        body("L42T4", QStringLiteral("c.velocity * h + %1 * gravity * h * h").arg(share), fall);
    QVERIFY2(
        said.startsWith(
            QStringLiteral(
                "Under gravity (0, -9.81) m/s² the way of a step is %1, with v from before it.")
                .arg(told)),
        qPrintable(said));
}

void TestToldMotion::signOfTheHalfIsTold()
{
    QVERIFY(!body("L42X6", QStringLiteral("c.velocity * h - 0.5 * gravity * h * h"), fall,
                  "The sign of ½ g Δt² is wrong in the motion of circle 2")
                 .isEmpty());
}

/// Each by another, where both need the same.
void TestToldMotion::methodsOfTwoAreTold()
{
    int told = 0;
    for (const Task &each : m_lab.tasks) {
        const LawBench bench(each);
        if (!bench.ground.sameIntegrator || bench.ground.flights.size() != 2
            || bench.ground.flights[0].shares != bench.ground.flights[1].shares
            || bench.ground.flights[0].shares.size() < 2)
            continue;
        const QString program =
            written({.move = QStringLiteral("c.position = c.position + c.velocity * h + "
                                            "(c.index == 1 and 0 or 1) * gravity * h * h "
                                            "c.velocity = c.velocity + gravity * h")},
                    structures[1]);
        const MeasuredLaws own(&program, bench.ground);
        const QString said =
            bodyOf(flightDeviations(own.flight(), bench.right.flight(), bench.ground),
                   QStringLiteral("The circles move by different methods"));
        QVERIFY2(said.contains(
                     QString::fromUtf8("circle 1 moves by Euler, with the way v Δt in a step, and "
                                       "circle 2 by symplectic Euler, with v Δt + g Δt²;")),
                 qPrintable(each.id + said));
        ++told;
    }
    QVERIFY(told > 0);
}

void TestToldMotion::anyMethodInPartsIsRight_data()
{
    QTest::addColumn<double>("share"); // of g h² in the way of a step
    QTest::addColumn<bool>("right");
    // One or the other Euler in n equal parts: ½ ± 1/2n.
    QTest::newRow("two parts") << 0.75 << true;
    QTest::newRow("two parts, old velocity") << 0.25 << true;
    QTest::newRow("three parts") << 2.0 / 3.0 << true;
    QTest::newRow("nineteen parts") << 0.5 + 0.5 / 19.0 << true;
    QTest::newRow("two and a half parts") << 0.7 << false;
    QTest::newRow("ten and a half parts") << 0.5 + 0.5 / 10.5 << false;
    QTest::newRow("hardly less than the whole") << 0.96 << false;
    QTest::newRow("more than the whole") << 1.3 << false;
    QTest::newRow("upward") << -0.2 << false;
    // So many that it is not told from the exact parabola.
    QTest::newRow("thirty and a half parts") << 0.5 + 0.5 / 30.5 << true;
}

/// In every step that names no method.
void TestToldMotion::anyMethodInPartsIsRight()
{
    QFETCH(double, share);
    QFETCH(bool, right);
    int told = 0;
    for (const Task &each : m_lab.tasks) {
        const LawBench bench(each);
        const auto &flights = bench.ground.flights;
        const bool falls = std::any_of(bench.ground.gravities.begin(), bench.ground.gravities.end(),
                                       [](Vec2 g) { return g != Vec2{}; });
        if (flights.empty() || !flights.front().asked || !flights.front().isAnyMethod || !falls)
            continue;
        const QString program =
            written({.move = QStringLiteral("c.position = c.position + c.velocity * h + "
                                            "%1 * gravity * h * h "
                                            "c.velocity = c.velocity + gravity * h")
                                 .arg(share, 0, 'g', 17)},
                    structures[0]);
        const MeasuredLaws own(&program, bench.ground);
        const auto found = flightDeviations(own.flight(), bench.right.flight(), bench.ground);
        QVERIFY2(found.empty() == right, qPrintable(each.id));
        ++told;
    }
    QVERIFY(told > 0);
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

QTEST_GUILESS_MAIN(TestToldMotion)
#include "test_told_motion.moc"
