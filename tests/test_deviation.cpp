// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/deviation.h"

#include <QTest>

using namespace cradle;

using Kind = TimestepPattern::Kind;
using Factors = std::vector<std::pair<double, double>>;

Q_DECLARE_METATYPE(Kind)
Q_DECLARE_METATYPE(Factors)

/// Numbers of findings in words, and how a factor depends on the timestep.
class TestDeviation : public QObject
{
    Q_OBJECT
private slots:
    void numbersAreBrief_data();
    void numbersAreBrief();
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
    QTest::newRow("no noise") << 6e-6 << QStringLiteral("0.000006");
    QTest::newRow("small, without exponent") << -4.5e-5 << QStringLiteral("-0.000045");
    // 9.81/60 = 0.1635 lies between two figures.
    QTest::newRow("between two figures") << 0.1635 - 1e-12 << QStringLiteral("0.164");
    QTest::newRow("nearly a thousand") << 999.7 << QStringLiteral("1000");
    QTest::newRow("a little") << 2.34e-5 << QStringLiteral("0.000023");
    QTest::newRow("hardly anything") << 2e-8 << QStringLiteral("0");
    QTest::newRow("below a thousand") << 999.4 << QStringLiteral("999");
    QTest::newRow("a thousand") << 1001.2 << QStringLiteral("1001");
    QTest::newRow("large") << -123456.7 << QStringLiteral("-123457");
    QTest::newRow("a million") << 2e6 << QStringLiteral("2e+06");
}

void TestDeviation::numbersAreBrief()
{
    QFETCH(double, value);
    QTEST(brief(value), "text");
    QCOMPARE(brief(Vec2{value, 2.0}), QStringLiteral("(%1, 2)").arg(brief(value)));
}

void TestDeviation::circlesAreNamed()
{
    QCOMPARE(briefTimestep(1.0 / 60.0), QStringLiteral("1/60"));
    QCOMPARE(briefTimestep(0.015), QStringLiteral("0.015"));
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
