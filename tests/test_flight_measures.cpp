// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/reading/lab_list.h"
#include "tests/flight_moves.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::integration;

/// What is measured of the free motion of a program is what the program does.
class TestFlightMeasures : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void lawIsMeasured_data();
    void lawIsMeasured();
    void methodsAreNotAlike();
    void followerHasALeader();
    void springPullsTowardsTheMiddle();
    void onePartMayBeSetAnew();

private:
    [[nodiscard]] LawBench bench(const char *step) const
    {
        return LawBench(task(QLatin1String(step)));
    }
};

namespace {

/// Of a motion, in terms of v h, a h² and g.
struct Law {
    double way = 1.0;
    double share = 0.0;
    double fall = 1.0;
    double growth = 0.0; // 1/s
};

} // namespace

void TestFlightMeasures::lawIsMeasured_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<double>("way");
    QTest::addColumn<double>("share");
    QTest::addColumn<double>("fall");
    QTest::addColumn<double>("growth");
    const auto rows = [](const char *name, const QString &move, const Law &law) {
        for (const Structure &structure : structures)
            QTest::addRow("%s, %s", name, structure.name)
                << written({.move = move}, structure) << law.way << law.share << law.fall
                << law.growth;
    };
    rows("Euler", euler, {});
    rows("symplectic Euler", symplectic, {.share = 1.0});
    rows("Verlet", verlet, {.share = 0.5});
    rows("half of the way",
         QStringLiteral("c.position = c.position + c.velocity * h / 2 "
                        "c.velocity = c.velocity + gravity * h"),
         {.way = 0.5});
    rows("gravity twice",
         QStringLiteral("c.position = c.position + c.velocity * h "
                        "c.velocity = c.velocity + 2 * gravity * h"),
         {.fall = 2.0});
    rows("air",
         QStringLiteral("c.position = c.position + c.velocity * h "
                        "c.velocity = c.velocity + (gravity - 0.3 * c.velocity) * h"),
         {.growth = -0.3});
}

void TestFlightMeasures::lawIsMeasured()
{
    QFETCH(QString, program);
    QFETCH(double, way);
    QFETCH(double, share);
    QFETCH(double, fall);
    QFETCH(double, growth);
    const LawBench step = bench("L42T7");
    const MeasuredFlight measured(&program, step.ground);
    const Vec2 g{0.0, -9.81};
    for (const double h : step.ground.timesteps) {
        for (int circle = 0; circle < 2; ++circle) {
            const Flight &flight = measured.at(g, h, circle);
            QVERIFY(flight.isKnown);
            QVERIFY(std::abs(flight.way.x - way) < 1e-9 && std::abs(flight.way.y - way) < 1e-9);
            QVERIFY(std::abs(*flight.share(h) - share) < 1e-6);
            QVERIFY(length(flight.acceleration - fall * g) < 1e-9);
            QVERIFY(std::abs(flight.growth.x - growth) < 1e-9
                    && std::abs(flight.growth.y - growth) < 1e-9);
        }
    }
}

/// Two programs fly alike if they go by one method; methods differ by what gravity adds to a
/// step, and a drift is none.
void TestFlightMeasures::methodsAreNotAlike()
{
    const LawBench step = bench("L42T17");
    std::vector<QString> programs;
    const QString drifting = symplectic + QStringLiteral(" c.position = c.position + vec(0, 1e-4)");
    for (const QString &move : {euler, symplectic, verlet, drifting})
        programs.push_back(written({.move = move}, structures[3]));
    for (const QString &a : programs) {
        for (const QString &b : programs) {
            const MeasuredLaws first(&a, step.ground);
            const MeasuredLaws second(&b, step.ground);
            QCOMPARE(first.flight().isLike(second.flight()), a == b);
        }
    }
}

/// A circle that moves on by the velocity of another has that for its leader.
void TestFlightMeasures::followerHasALeader()
{
    const LawBench step = bench("L42T17");
    const QString program =
        QStringLiteral("function on_update(h) "
                       "circle1.velocity = circle1.velocity + gravity * h "
                       "circle2.velocity = circle2.velocity + gravity * h "
                       "circle2.position = circle2.position + circle1.velocity * h "
                       "circle1.position = circle1.position + circle1.velocity * h end");
    const MeasuredLaws own(&program, step.ground);
    for (const Vec2 gravity : step.ground.gravities) {
        const auto &flights = own.flight().at(gravity, step.ground.timesteps.front());
        QCOMPARE(flights[0].leader, -1);
        QCOMPARE(flights[1].leader, 0);
    }
}

/// A spring of 0.3/s² in x and 0.7/s² in y.
void TestFlightMeasures::springPullsTowardsTheMiddle()
{
    const LawBench step = bench("L42T7");
    const QString program =
        written({.move = QStringLiteral("c.velocity = c.velocity + (gravity - "
                                        "vec(0.3 * c.position.x, 0.7 * c.position.y)) * h "
                                        "c.position = c.position + c.velocity * h")},
                structures[3]);
    const MeasuredFlight measured(&program, step.ground);
    const Flight &flight = measured.at({0.0, -9.81}, step.ground.timesteps.front(), 0);
    QVERIFY(std::abs(flight.pull.x + 0.3) < 1e-3);
    QVERIFY(std::abs(flight.pull.y + 0.7) < 1e-3);
    QVERIFY(!flight.isKnown);
}

/// Whoever sets x anew in every step still falls.
void TestFlightMeasures::onePartMayBeSetAnew()
{
    const LawBench step = bench("L42T7");
    const double h = step.ground.timesteps.front();
    for (const bool isX : {true, false}) {
        const QString velocity = isX ? QStringLiteral("vec(2, c.velocity.y + gravity.y * h)")
                                     : QStringLiteral("vec(c.velocity.x, -1)");
        const QString program =
            written({.move = QStringLiteral("c.velocity = %1 c.position = c.position + "
                                            "c.velocity * h")
                                 .arg(velocity)},
                    structures[3]);
        const MeasuredFlight measured(&program, step.ground);
        const Flight &flight = measured.at({0.0, -9.81}, h, 0);
        QVERIFY(!flight.resets);
        QCOMPARE(flight.resetsX, isX);
        QCOMPARE(flight.resetsY, !isX);
        QVERIFY(!flight.isKnown);
    }
}

QTEST_GUILESS_MAIN(TestFlightMeasures)
#include "test_flight_measures.moc"
