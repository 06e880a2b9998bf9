// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"

#include <QTest>

using namespace cradle;

/// Numbers in the messages of checks: short, and never two alike that are not.
class TestCheckFigures : public QObject
{
    Q_OBJECT
private slots:
    void figuresAreShort_data();
    void figuresAreShort();
    void figuresBesideEachOtherDiffer_data();
    void figuresBesideEachOtherDiffer();
};

void TestCheckFigures::figuresAreShort_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("a fifteenth") << 1.0 / 15.0 << QStringLiteral("0.06667");
    QTest::newRow("few digits") << -0.5 << QStringLiteral("-0.5");
    QTest::newRow("noise") << 3e-17 << QStringLiteral("0");
    QTest::newRow("just noise") << 9e-13 << QStringLiteral("0");
    QTest::newRow("just none") << -1.1e-12 << QStringLiteral("-1.1e-12");
    QTest::newRow("below a thousand") << 261.3805 << QStringLiteral("261.4");
    QTest::newRow("an energy") << 25632.712 << QStringLiteral("25633");
    QTest::newRow("a rounded thousand") << 999.99 << QStringLiteral("1000");
    QTest::newRow("a large one") << -123456.7 << QStringLiteral("-123457");
    QTest::newRow("the largest without an exponent") << 999999.0 << QStringLiteral("999999");
    QTest::newRow("a million") << 1e6 << QStringLiteral("1e+06");
    QTest::newRow("more than a million") << 1.5e6 << QStringLiteral("1.5e+06");
    QTest::newRow("absurdly large") << 1.23456e9 << QStringLiteral("1.235e+09");
}

void TestCheckFigures::figuresAreShort()
{
    QFETCH(double, value);
    QTEST(motion::figure(value), "text");
}

void TestCheckFigures::figuresBesideEachOtherDiffer_data()
{
    QTest::addColumn<Vec2>("value");
    QTest::addColumn<Vec2>("other");
    QTest::addColumn<QString>("text");
    QTest::newRow("at once") << Vec2{1.0 / 15.0, 2.0} << Vec2{0.0, 2.0}
                             << QStringLiteral("(0.06667, 2)");
    QTest::newRow("one of them") << Vec2{1.0 / 3.0, 0.2} << Vec2{1.0 / 3.0 + 1e-7, 0.9}
                                 << QStringLiteral("(0.3333, 0.2)");
    QTest::newRow("hardly") << Vec2{1.0000004, 2.0} << Vec2{1.0000014, 2.0}
                            << QStringLiteral("(1, 2)");
    QTest::newRow("hardly, the other")
        << Vec2{1.0000014, 2.0} << Vec2{1.0000004, 2.0} << QStringLiteral("(1.000001, 2)");
    QTest::newRow("noise") << Vec2{1.0 / 3.0, 2.0} << Vec2{1.0 / 3.0 + 1e-12, 2.0}
                           << QStringLiteral("(0.3333, 2)");
    QTest::newRow("energies") << Vec2{25632.71, 0.0} << Vec2{25632.76, 0.0}
                              << QStringLiteral("(25632.7, 0)");
}

void TestCheckFigures::figuresBesideEachOtherDiffer()
{
    QFETCH(Vec2, value);
    QFETCH(Vec2, other);
    QTEST(motion::figureBeside(value, other), "text");
}

QTEST_APPLESS_MAIN(TestCheckFigures)
#include "test_check_figures.moc"
