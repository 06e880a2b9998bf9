// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/measured_flight.h"

#include "tests/law_programs.h"

using namespace cradle;
using namespace cradle::programs;

/// What is read from a few short flights: which velocity moves what, and how alike two programs
/// are.
class TestFlightReading : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void partsMayMoveEachOther_data();
    void partsMayMoveEachOther();
    void ownSceneTellsOfEveryCircle();

private:
    [[nodiscard]] LawBench bench(const char *step) const
    {
        return LawBench(task(QLatin1String(step)));
    }
};

void TestFlightReading::partsMayMoveEachOther_data()
{
    QTest::addColumn<QString>("velocity"); // that moves it
    QTest::addColumn<int>("crossing");
    using Crossing = Flight::Crossing;
    QTest::newRow("its own") << "c.velocity" << int(Crossing::None);
    QTest::newRow("x for both") << "vec(c.velocity.x, c.velocity.x)" << int(Crossing::XMovesY);
    QTest::newRow("y for both") << "vec(c.velocity.y, c.velocity.y)" << int(Crossing::YMovesX);
    QTest::newRow("exchanged") << "vec(c.velocity.y, c.velocity.x)" << int(Crossing::Exchanged);
    QTest::newRow("x alone") << "vec(c.velocity.x, 0)" << int(Crossing::None);
    QTest::newRow("half of it") << "0.5 * c.velocity" << int(Crossing::None);
}

void TestFlightReading::partsMayMoveEachOther()
{
    QFETCH(QString, velocity);
    QFETCH(int, crossing);
    const LawBench step = bench("L42T7");
    const QString program = written({.move = QStringLiteral("c.position = c.position + %1 * h "
                                                            "c.velocity = c.velocity + gravity * h")
                                                 .arg(velocity)},
                                    structures[0]);
    const MeasuredFlight measured(&program, step.ground);
    for (const int circle : {0, 1}) {
        const Flight &flight = measured.at({0.0, -9.81}, step.ground.timesteps.front(), circle);
        QCOMPARE(int(flight.crossing), crossing);
    }
}

/// Air that brakes by the density, which is another one there for one of the circles alone.
void TestFlightReading::ownSceneTellsOfEveryCircle()
{
    const LawBench step = bench("L42T17");
    const auto braked = [](int circle, int density) {
        return written({.start = QStringLiteral("circle1.velocity, circle2.velocity = vec(1, 0), "
                                                "vec(1, 0) circle%1.density = %2")
                                     .arg(circle)
                                     .arg(density),
                        .move = QStringLiteral("c.velocity = c.velocity + (gravity - 0.3 * "
                                               "c.density * c.velocity) * h "
                                               "c.position = c.position + c.velocity * h")},
                       structures[3]);
    };
    for (const int circle : {1, 2}) {
        const QString one = braked(circle, 1);
        const QString two = braked(circle, 2);
        const MeasuredFlight light(&one, step.ground);
        const MeasuredFlight same(&one, step.ground);
        const MeasuredFlight dense(&two, step.ground);
        QVERIFY(!light.own().accelerations.empty());
        QVERIFY(light.isLike(same));
        QVERIFY(!light.isLike(dense));
        QVERIFY(!dense.isLike(light));
    }
}

QTEST_GUILESS_MAIN(TestFlightReading)
#include "test_flight_reading.moc"
