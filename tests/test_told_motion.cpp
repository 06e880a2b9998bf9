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

QTEST_GUILESS_MAIN(TestToldMotion)
#include "test_told_motion.moc"
