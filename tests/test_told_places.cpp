// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"

#include "tests/told_numbers.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// Steps that do not go on from the place where the circle is are told as that, and not as what
/// they seem to make of the velocity.
class TestToldPlaces : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void placeOfAStepIsTold_data();
    void placeOfAStepIsTold();
};

void TestToldPlaces::placeOfAStepIsTold_data()
{
    QTest::addColumn<QString>("after");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<bool>("followsX"); ///< of the place and way: what becomes x is that of x
    QTest::addColumn<bool>("followsY");
    QTest::newRow("y for x") << "c.position = vec(was.y + c.velocity.x * h, c.position.y)"
                             << "A step takes y for x in the place of both circles" << false
                             << true;
    QTest::newRow("x for y") << "c.position = vec(c.position.x, was.x + c.velocity.y * h)"
                             << "A step takes x for y in the place of both circles" << true
                             << false;
    QTest::newRow("exchanged") << "c.position = vec(was.y + c.velocity.x * h, "
                                  "was.x + c.velocity.y * h)"
                               << "A step exchanges x and y in the place of both circles" << false
                               << false;
    QTest::newRow("floor everywhere")
        << "if c.position.y - c.radius < square.top then "
           "c.position = vec(c.position.x, square.bottom + c.radius) end"
        << "Every step puts both circles at the same y" << true << false;
    QTest::newRow("right wall everywhere")
        << "if c.position.x + c.radius > square.left then "
           "c.position = vec(square.right - c.radius, c.position.y) end"
        << "Every step puts both circles at the same x" << false << true;
    QTest::newRow("corner everywhere")
        << "c.position = vec(square.right - c.radius, square.top - c.radius)"
        << "Every step puts both circles at the same place" << false << false;
    QTest::newRow("right") << ""
                           << "" << true << true;
}

void TestToldPlaces::placeOfAStepIsTold()
{
    QFETCH(QString, after);
    QFETCH(QString, headline);
    QFETCH(bool, followsX);
    QFETCH(bool, followsY);
    for (const char *step : {"L42T8", "L42T12", "L42T17"}) {
        for (const Structure &structure : structures) {
            const LawBench bench(task(QLatin1String(step)));
            const QString program =
                written({.move = QStringLiteral("local was = c.position c.velocity = c.velocity + "
                                                "gravity * h c.position = "
                                                "c.position + c.velocity * h ")
                                 + after},
                        structure);
            const MeasuredLaws own(&program, bench.ground);
            const auto found = flightDeviations(own.flight(), bench.right.flight(), bench.ground);
            if (headline.isEmpty()) {
                QVERIFY2(found.empty(), qPrintable(found.empty() ? QString() : found[0].message));
                continue;
            }
            QCOMPARE(found.size(), std::size_t{1});
            const auto n = numbersIn(bodyOf(found, headline),
                                     "Started at (#, #) m with (#, #) m/s, it is at (#, #) m one "
                                     "step of 1/# s later.");
            QVERIFY2(n.size() == 7, qPrintable(found[0].message));
            const double h = 1.0 / n[6];
            const Vec2 g = bench.ground.gravities.front();
            const Vec2 goal = Vec2{n[0], n[1]} + h * (Vec2{n[2], n[3]} + h * g);
            QCOMPARE(isNear(n[4], goal.x), followsX);
            QCOMPARE(isNear(n[5], goal.y), followsY);
        }
    }
}

QTEST_GUILESS_MAIN(TestToldPlaces)
#include "test_told_places.moc"
