// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/deviation.h"

#include "tasks/judging/flight_comparison.h"

#include <QTest>

using namespace cradle;

using Kind = TimestepPattern::Kind;
using Factors = std::vector<std::pair<double, double>>;

/// Numbers of findings in words, and how a factor depends on the timestep.
class TestDeviation : public QObject
{
    Q_OBJECT
private slots:
    void numbersAreBrief_data();
    void numbersAreBrief();
    void timestepsAreParts_data();
    void timestepsAreParts();
    void methodsAreNamed_data();
    void methodsAreNamed();
    void circlesAreNamed();
    void patternIsTold_data();
    void patternIsTold();
};

void TestDeviation::numbersAreBrief_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("a third") << 1.0 / 3.0 << QStringLiteral("0.333");
    QTest::newRow("noise") << -0.9e-7 << QStringLiteral("0");
    QTest::newRow("less than is written") << -4.9e-7 << QStringLiteral("0");
    QTest::newRow("the least written") << 5.1e-7 << QStringLiteral("0.000001");
    QTest::newRow("no noise") << 6e-6 << QStringLiteral("0.000006");
    QTest::newRow("small, without exponent") << -4.5e-5 << QStringLiteral("-0.000045");
    // 9.81/60 = 0.1635 lies between two figures.
    QTest::newRow("between two figures") << 0.1635 - 1e-12 << QStringLiteral("0.164");
    QTest::newRow("as near as noise comes") << 0.1635 * (1.0 - 0.5e-9) << QStringLiteral("0.164");
    QTest::newRow("below") << 0.1635 * (1.0 - 5e-9) << QStringLiteral("0.163");
    QTest::newRow("nearly a thousand") << 999.7 << QStringLiteral("1000");
    QTest::newRow("a little") << 2.34e-5 << QStringLiteral("0.000023");
    QTest::newRow("hardly anything") << 2e-8 << QStringLiteral("0");
    QTest::newRow("below a thousand") << 999.4 << QStringLiteral("999");
    QTest::newRow("a thousand") << 1001.2 << QStringLiteral("1001");
    QTest::newRow("large") << -123456.7 << QStringLiteral("-123457");
    QTest::newRow("one") << 1.0 << QStringLiteral("1");
    QTest::newRow("nearly one") << 0.9996 << QStringLiteral("1");
    QTest::newRow("below a million") << 999999.0 << QStringLiteral("999999");
    QTest::newRow("a million") << 2e6 << QStringLiteral("2e+06");
}

void TestDeviation::numbersAreBrief()
{
    QFETCH(double, value);
    QTEST(brief(value), "text");
    QCOMPARE(brief(Vec2{value, 2.0}), QStringLiteral("(%1, 2)").arg(brief(value)));
}

void TestDeviation::timestepsAreParts_data()
{
    QTest::addColumn<double>("parts"); // of a second
    QTest::addColumn<QString>("text");
    QTest::newRow("of 1/60 s") << 60.0 << QStringLiteral("1/60");
    QTest::newRow("but for rounding") << 60.0 + 0.5e-6 << QStringLiteral("1/60");
    QTest::newRow("another number") << 60.0 + 2e-6 << QStringLiteral("0.0167");
    QTest::newRow("nearly two thirds more") << 66.67 << QStringLiteral("0.015");
}

void TestDeviation::timestepsAreParts()
{
    QFETCH(double, parts);
    QTEST(briefTimestep(1.0 / parts), "text");
}

void TestDeviation::methodsAreNamed_data()
{
    QTest::addColumn<double>("share"); // of g Δt² by which a step goes on
    QTest::addColumn<QString>("text");
    const QString euler = methodName(0.0);
    const QString symplectic = methodName(1.0);
    const QString parabola = methodName(0.5);
    QVERIFY(euler != symplectic && parabola != euler && parabola != symplectic);
    const std::pair<double, QString> methods[] = {{0.0, euler}, {0.5, parabola}, {1.0, symplectic}};
    for (const auto &[share, name] : methods) {
        QVERIFY(!name.isEmpty());
        for (const double sign : {-1.0, 1.0}) {
            QTest::addRow("%g, blurred by %g", share, sign) << share + sign * 0.9e-3 << name;
            QTest::addRow("off %g by %g", share, sign) << share + sign * 1.1e-3 << QString();
        }
    }
}

void TestDeviation::methodsAreNamed()
{
    QFETCH(double, share);
    QTEST(methodName(share), "text");
}

void TestDeviation::circlesAreNamed()
{
    QCOMPARE(circleNames({1}, 3), QStringLiteral("circle 2"));
    QCOMPARE(circleNames({0, 1}, 2), QStringLiteral("both circles"));
    QCOMPARE(circleNames({0, 1, 2}, 3), QStringLiteral("all circles"));
    QCOMPARE(circleNames({0, 2}, 3), QStringLiteral("the circles 1, 3"));
}

void TestDeviation::patternIsTold_data()
{
    QTest::addColumn<Factors>("factors");
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<double>("value");
    constexpr double a = 1.0 / 60.0; // s
    constexpr double b = 1.0 / 25.0;
    QTest::newRow("nothing measured") << Factors{} << Kind::Constant << 1.0;
    QTest::newRow("right") << Factors{{a, 1.0}, {b, 1.0}} << Kind::Constant << 1.0;
    QTest::newRow("twice as much") << Factors{{a, 2.0}, {b, 2.0}} << Kind::Constant << 2.0;
    QTest::newRow("divided by h") << Factors{{a, 3600.0}, {b, 625.0}} << Kind::Divided << 1.0;
    QTest::newRow("h forgotten") << Factors{{a, 60.0}, {b, 25.0}} << Kind::Forgotten << 1.0;
    QTest::newRow("h twice") << Factors{{a, a}, {b, b}} << Kind::Squared << 1.0;
    QTest::newRow("0.02 s for h") << Factors{{a, 0.02 / a}, {b, 0.02 / b}} << Kind::Fixed << 0.02;
    QTest::newRow("-0.02 s for h")
        << Factors{{a, -0.02 / a}, {b, -0.02 / b}} << Kind::Other << -0.02 / a;
    QTest::newRow("1.5 h²") << Factors{{a, 1.5 * a}, {b, 1.5 * b}} << Kind::Other << 1.5 * a;
    QTest::newRow("alike but for noise")
        << Factors{{a, 2.0}, {b, 2.00001}} << Kind::Constant << 2.0;
    QTest::newRow("not alike") << Factors{{a, 2.0}, {b, 2.01}} << Kind::Other << 2.0;
}

void TestDeviation::patternIsTold()
{
    QFETCH(Factors, factors);
    const TimestepPattern pattern = patternOf(factors);
    QTEST(pattern.kind, "kind");
    QTEST(pattern.value, "value");
}

QTEST_APPLESS_MAIN(TestDeviation)
#include "test_deviation.moc"
