// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"

#include "tests/told_flight.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// What findings tell of the method of a step, which gravity shows, is what its law makes.
class TestToldMethods : public ToldFlight
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void methodIsTold_data();
    void methodIsTold();
    void signOfTheHalfIsTold();
    void methodsOfTwoAreTold();
    void anyMethodInPartsIsRight_data();
    void anyMethodInPartsIsRight();
    void fallIsNoPartOfTheWay_data();
    void fallIsNoPartOfTheWay();
    void wrongWayBesideAMethodIsTold();
};

void TestToldMethods::methodIsTold_data()
{
    QTest::addColumn<double>("share"); // of g h² in the way of the first step
    QTest::addColumn<QString>("told");
    QTest::newRow("half") << 0.5 << QStringLiteral("v Δt + ½ g Δt²");
    QTest::newRow("whole") << 1.0 << QStringLiteral("v Δt + g Δt²");
    QTest::newRow("a third of it") << 0.3 << QStringLiteral("v Δt + 0.3 g Δt²");
    QTest::newRow("upward") << -0.4 << QStringLiteral("v Δt − 0.4 g Δt²");
}

void TestToldMethods::methodIsTold()
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

void TestToldMethods::signOfTheHalfIsTold()
{
    QVERIFY(!body("L42X6", QStringLiteral("c.velocity * h - 0.5 * gravity * h * h"), fall,
                  "The sign of ½ g Δt² is wrong in the motion of circle 2")
                 .isEmpty());
}

/// Each by another, where both need the same.
void TestToldMethods::methodsOfTwoAreTold()
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

void TestToldMethods::anyMethodInPartsIsRight_data()
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
void TestToldMethods::anyMethodInPartsIsRight()
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

void TestToldMethods::fallIsNoPartOfTheWay_data()
{
    QTest::addColumn<double>("share"); // of g h² in the way of a step, beside twice v h
    QTest::newRow("all of it twice") << 1.0;
    QTest::newRow("the velocity alone") << 0.5;
}

/// What gravity adds to v Δt is either as wrong as that, or said.
void TestToldMethods::fallIsNoPartOfTheWay()
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

/// By Verlet only where it comes down: v Δt is no right way there, either.
void TestToldMethods::wrongWayBesideAMethodIsTold()
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

QTEST_GUILESS_MAIN(TestToldMethods)
#include "test_told_methods.moc"
