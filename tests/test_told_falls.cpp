// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"

#include "tests/told_flight.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on what gravity does in a step tell are those that the law makes.
class TestToldFalls : public ToldFlight
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void fallOfAStepIsTold_data();
    void fallOfAStepIsTold();
    void fallThatHangsOnTheCircleIsTold_data();
    void fallThatHangsOnTheCircleIsTold();
    void gravityOnThePlaceIsTold();
    void whatComesToAWallAtOnceIsToldOfLess_data();
    void whatComesToAWallAtOnceIsToldOfLess();
    void oneThatStaysAtRestIsTold();
    void aNumberForGravityIsTold();
    void anOldCopyOfGravityIsTold();
    void aTimestepThatFallsRightlyIsTold();
    void nothingIsToldOfWhoIsNotThere();
};

void TestToldFalls::fallOfAStepIsTold_data()
{
    QTest::addColumn<QString>("velocity");
    QTest::addColumn<Vec2>("change"); // of the velocity, of g h^power
    QTest::addColumn<double>("power");
    QTest::newRow("without time") << "gravity" << Vec2{0, -1} << 0.0;
    QTest::newRow("time twice") << "gravity * h * h" << Vec2{0, -1} << 2.0;
    QTest::newRow("a sixtieth") << "gravity / 60" << Vec2{0, -1.0 / 60} << 0.0;
    QTest::newRow("half") << "gravity * h / 2" << Vec2{0, -0.5} << 1.0;
    QTest::newRow("upward") << "-1 * gravity * h" << Vec2{0, 1} << 1.0;
    QTest::newRow("three times") << "3 * gravity * h" << Vec2{0, -3} << 1.0;
    QTest::newRow("sideways") << "vec(gravity.y, 0) * h" << Vec2{-1, 0} << 1.0;
    QTest::newRow("none") << "vec(0, 0)" << Vec2{0, 0} << 1.0;
}

void TestToldFalls::fallOfAStepIsTold()
{
    QFETCH(QString, velocity);
    QFETCH(Vec2, change);
    QFETCH(double, power);
    const auto n = numbersIn(body("L42T4", way, velocity),
                             "Under gravity (#, #) m/s² the velocity changes by (#, #) m/s in a "
                             "step of 1/# s; it should change by (#, #) m/s.");
    QCOMPARE(n.size(), std::size_t{7});
    const double h = 1.0 / n[4];
    QVERIFY(n[0] == 0.0 && n[1] == -9.81);
    QVERIFY(isNear(Vec2{n[2], n[3]}, 9.81 * std::pow(h, power) * change));
    QVERIFY(isNear(Vec2{n[5], n[6]}, h * Vec2{0.0, -9.81}));
    QVERIFY(!isNear(Vec2{n[2], n[3]}, Vec2{n[5], n[6]}));
}

void TestToldFalls::fallThatHangsOnTheCircleIsTold_data()
{
    QTest::addColumn<QString>("factor");
    QTest::addColumn<double>(
        "times"); // where the radius is 1.25 and the density 1.5 times as large
    QTest::newRow("radius") << "c.radius / 0.2" << 1.25;
    QTest::newRow("density") << "c.density / 7.8" << 1.5;
    QTest::newRow("mass") << "c.density * c.radius ^ 3 / 0.0624" << 1.5 * std::pow(1.25, 3);
}

void TestToldFalls::fallThatHangsOnTheCircleIsTold()
{
    QFETCH(QString, factor);
    QFETCH(double, times);
    const auto n = numbersIn(
        body("L42T4", way, QStringLiteral("gravity * h * 0.5 * ") + factor),
        "Under gravity (#, #) m/s² circle # is accelerated by (#, #) m/s², and by (#, #) m/s² when "
        "its radius is 1.25 times and its density 1.5 times as large.");
    QCOMPARE(n.size(), std::size_t{7});
    QVERIFY(n[0] == 0.0 && n[1] == -9.81 && n[2] == 1.0 && n[3] == 0.0 && n[5] == 0.0);
    QVERIFY(isNear(n[4], 0.5 * -9.81));
    QVERIFY(isNear(n[6], 0.5 * -9.81 * times));
}

void TestToldFalls::gravityOnThePlaceIsTold()
{
    const auto n = numbersIn(body("L42T4", QStringLiteral("c.velocity * h + 0.25 * gravity * h"),
                                  QStringLiteral("vec(0, 0)")),
                             "Under gravity (#, #) m/s² a circle at rest is (#, #) m away after a "
                             "step of 1/# s, and its velocity is still 0.");
    QCOMPARE(n.size(), std::size_t{5});
    QVERIFY(n[0] == 0.0 && n[1] == -9.81);
    QVERIFY(isNear(Vec2{n[2], n[3]}, Vec2{0.0, 0.25 * -9.81 / n[4]}));
}

void TestToldFalls::whatComesToAWallAtOnceIsToldOfLess_data()
{
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("velocity");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<QString>("pattern");
    QTest::newRow("divided in the velocity")
        << way << "gravity / h"
        << "Gravity on both circles is divided by the timestep"
        << QString::fromUtf8("Under gravity (#, #) m/s² the velocity changes by (#, #) m/s in a "
                             "step of 1/# s");
    for (const char *step : {"gravity / 2", "gravity * (h / h / 2)"})
        QTest::newRow(step) << way + QStringLiteral(" + ") + QLatin1String(step) << fall
                            << "What gravity adds to the way of both circles does not depend on "
                            << QString::fromUtf8("Besides v Δt it goes (#, #) m in a step of 1/# "
                                                 "s under gravity (#, #) m/s²");
}

/// Of a gravity so weak that no wall takes part.
void TestToldFalls::whatComesToAWallAtOnceIsToldOfLess()
{
    QFETCH(QString, place);
    QFETCH(QString, velocity);
    QFETCH(QString, headline);
    QFETCH(QString, pattern);
    const LawProgram program{.move = QStringLiteral("c.position = c.position + %1 "
                                                    "c.velocity = c.velocity + %2")
                                         .arg(place, velocity),
                             .walls = wallsOf(wallWays[1])};
    for (const char *step : {"L42T4", "L42T17"}) {
        const auto n = numbersIn(
            bodyOfProgram(step, written(program, structures[1]), headline.toUtf8().constData()),
            pattern.toUtf8().constData());
        QCOMPARE(n.size(), std::size_t{5});
        const bool isVelocity = velocity != fall;
        const double g = isVelocity ? n[1] : n[4];
        QVERIFY(g < 0.0 && g > -0.1);
        QVERIFY(isNear(isVelocity ? n[3] : n[1], isVelocity ? g * n[4] : 0.5 * g));
    }
}

/// Who is slow is stopped in flight, too: let go at rest, it stays.
void TestToldFalls::oneThatStaysAtRestIsTold()
{
    const auto n = numbersIn(body("L42T4", way,
                                  QStringLiteral("gravity * h if c.velocity:length() < 0.5 then "
                                                 "c.velocity = vec(0, 0) end"),
                                  "Gravity leaves both circles at rest"),
                             "Let go at rest, it has (#, #) m/s one step of 1/# s later, far from "
                             "every wall and every other circle; gravity gives it (#, #) m/s in a "
                             "step. Thrown with (#, #) m/s it goes on as it should.");
    QCOMPARE(n.size(), std::size_t{7});
    QVERIFY(n[0] == 0.0 && n[1] == 0.0 && isNear(n[4], -9.81 / n[2]));
}

void TestToldFalls::aNumberForGravityIsTold()
{
    const auto n = numbersIn(body("L42T17", way, QStringLiteral("vec(0.5, -3) * h")),
                             "The acceleration is (#, #) m/s², under gravity (#, #) and "
                             "under (#, #) m/s² alike.");
    QCOMPARE(n.size(), std::size_t{6});
    QVERIFY(isNear(Vec2{n[0], n[1]}, Vec2{0.5, -3.0}));
    QVERIFY(!isNear(Vec2{n[2], n[3]}, Vec2{n[4], n[5]}));
}

void TestToldFalls::anOldCopyOfGravityIsTold()
{
    const LawProgram old{.start = QStringLiteral("pull = gravity gravity = vec(0, -9.81)"),
                         .move = QStringLiteral("c.velocity = c.velocity + pull * h "
                                                "c.position = c.position + c.velocity * h")};
    const auto n = numbersIn(bodyOfProgram("L42T17", written(old, structures[3])),
                             "In your own scene gravity is (#, #) m/s², and the velocity changes "
                             "by (#, #) m/s in a second.");
    QCOMPARE(n.size(), std::size_t{4});
    QVERIFY(n[0] == 0.0 && n[1] == -9.81);
    QVERIFY(isNear(Vec2{n[2], n[3]}, task(QStringLiteral("L42T17")).preset.gravity));
}

/// At most a sixtieth of a second.
void TestToldFalls::aTimestepThatFallsRightlyIsTold()
{
    const auto n = numbersIn(
        body("L42T3", way, QStringLiteral("gravity * math.min(h, 1 / 60)"),
             "How gravity acts on circle 1 depends on the timestep"),
        "Under gravity (#, #) m/s² the velocity changes by (#, #) m/s in a step of 1/# s; it "
        "should change by (#, #) m/s. In one of 1/# s it changes as it should.");
    QCOMPARE(n.size(), std::size_t{8});
    QCOMPARE(n[4], 30.0);
    QVERIFY(isNear(n[3], -9.81 / 60) && isNear(n[6], -9.81 / 30));
    QVERIFY(n[7] >= 60.0);
}

/// The own scene has one circle, where the step asks for two.
void TestToldFalls::nothingIsToldOfWhoIsNotThere()
{
    const Task &step = task(QStringLiteral("L42T17"));
    Preset alone = step.preset;
    alone.circles.resize(1);
    const Ground ground(step, alone);
    const MeasuredLaws right(&step.solution, ground);
    const LawProgram old{.start = QStringLiteral("pull = gravity gravity = vec(0, -9.81)"),
                         .move = QStringLiteral("c.velocity = c.velocity + pull * h "
                                                "c.position = c.position + c.velocity * h")};
    const QString program = written(old, structures[3]);
    const MeasuredLaws own(&program, ground);
    const auto found = flightDeviations(own.flight(), right.flight(), ground);
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(found.front().moment.circles, std::vector<int>{0});
}

QTEST_GUILESS_MAIN(TestToldFalls)
#include "test_told_falls.moc"
