// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"

#include "tests/told_flight.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings tell of steps that are not made alike: the first, every second, later
/// ones.
class TestToldSteps : public ToldFlight
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void stepsFromTheStartAreTold();
    void aRightFirstStepIsNotBlamed();
    void stepsThatAlternateAreTold();
    void stepsThatAreUnlikeAreTold_data();
    void stepsThatAreUnlikeAreTold();
    void timeThatIsSavedUpIsTold();
    void stepsThatGrowWithTheirNumberAreTold();
    void aFirstStepOfItsOwnIsTold();
    void aWallIsNoOddStep();
    void aVelocityThatIsNotWrittenIsNoOddStep();
};

/// The old place is kept once: from then on no step adds to the one before.
void TestToldSteps::stepsFromTheStartAreTold()
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
void TestToldSteps::aRightFirstStepIsNotBlamed()
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
void TestToldSteps::stepsThatAlternateAreTold()
{
    const QString twice = QStringLiteral("(step % 2 == 0 and 2 or 0) * ");
    const QString said =
        body("L42T4", twice + way, twice + fall, "Not every step of both circles is made alike");
    QVERIFY(said.contains(QLatin1String("what your program counts")));
    const QString late = body("L42T4", way, fall + QStringLiteral(" * (time > 1 and 2 or 1)"),
                              "The step of both circles depends on how long the run has lasted");
    QVERIFY(!late.isEmpty());
}

void TestToldSteps::stepsThatAreUnlikeAreTold_data()
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
void TestToldSteps::stepsThatAreUnlikeAreTold()
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
void TestToldSteps::timeThatIsSavedUpIsTold()
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
void TestToldSteps::stepsThatGrowWithTheirNumberAreTold()
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
void TestToldSteps::aFirstStepOfItsOwnIsTold()
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
void TestToldSteps::aWallIsNoOddStep()
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

/// Its ways are those of a velocity of its own, and right after that: wrong is that the circle's
/// stays as it was.
void TestToldSteps::aVelocityThatIsNotWrittenIsNoOddStep()
{
    const QString program = QStringLiteral("local v = vec(0, 0)\n"
                                           "function on_load()\n"
                                           "  gravity = vec(0, -9.81)\n"
                                           "  circle1.velocity = vec(2, 0)\n"
                                           "  v = circle1.velocity\n"
                                           "end\n"
                                           "function on_update(h)\n"
                                           "  circle1.position = circle1.position + v * h\n"
                                           "  v = v + gravity * h\n"
                                           "end\n");
    QVERIFY(bodyOfProgram("L42T3", program, "Not every step").isEmpty());
    QVERIFY(!bodyOfProgram("L42T3", program).isEmpty());
}

QTEST_GUILESS_MAIN(TestToldSteps)
#include "test_told_steps.moc"
