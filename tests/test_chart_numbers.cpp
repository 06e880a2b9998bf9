// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/nice_scale.h"
#include "views/number_text.h"

#include <QTest>

using namespace cradle;

class TestChartNumbers final : public QObject
{
    Q_OBJECT
private slots:
    void rangeGrowsAtOnceAndRests();
    void niceStepsAre125();
    void numbersAreWritten_data();
    void numbersAreWritten();
};

void TestChartNumbers::rangeGrowsAtOnceAndRests()
{
    SteadyRange range;
    range.fit(0.0, 90.0, 90.0);
    const AxisScale first = range.scale(5, 0.0);
    range.fit(0.0, 60.0, 90.0);
    QCOMPARE(range.scale(5, 0.0), first);
    range.fit(0.0, 150.0, 150.0);
    QVERIFY(range.scale(5, 0.0).high >= 150.0);
    range.fit(0.0, 10.0, 150.0);
    QVERIFY(range.scale(5, 0.0).high < 20.0);
}

void TestChartNumbers::niceStepsAre125()
{
    QCOMPARE(niceStep(0.03), 0.05);
    QCOMPARE(niceStep(1.0), 1.0);
    QCOMPARE(niceStep(1.1), 2.0);
    QCOMPARE(niceStep(700.0), 1000.0);
    QCOMPARE(niceStep(0.0), 1.0);
}

void TestChartNumbers::numbersAreWritten_data()
{
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("wanted");
    QTest::newRow("fixed") << fixedNumber(1.73494) << QStringLiteral("1.7349");
    QTest::newRow("no minus zero") << fixedNumber(-1e-9) << QStringLiteral("0.0000");
    QTest::newRow("narrow") << fixedNumber(-123.45678, 8) << QStringLiteral("-123.457");
    QTest::newRow("large") << fixedNumber(-1234567.0) << QStringLiteral("-1.235e+06");
    QTest::newRow("short") << shortNumber(522.7612) << QStringLiteral("522.8");
    QTest::newRow("one decimal") << shortNumber(-31815.23) << QStringLiteral("−31815.2");
    QTest::newRow("no decimal") << shortNumber(131815.2) << QStringLiteral("131815");
    QTest::newRow("four digits") << fourDigits(261.3805) << QStringLiteral("261.4");
    QTest::newRow("four digits, large") << fourDigits(123456.0) << QStringLiteral("1.2e+05");
    QTest::newRow("full") << fullNumber(-1.9973) << QStringLiteral("−1.9973");
    QTest::newRow("short, small") << shortNumber(0.0123456) << QStringLiteral("0.012");
    QTest::newRow("noise") << shortNumber(1e-12, 500.0) << QStringLiteral("0");
    QTest::newRow("power") << withPower(shortNumber(-2.9612e6)) << QStringLiteral("−2.96·10⁶");
    QTest::newRow("small power") << withPower(shortNumber(1.234e-5)) << QStringLiteral("1.23·10⁻⁵");
    QTest::newRow("no power") << withPower(shortNumber(522.76)) << QStringLiteral("522.8");
    QTest::newRow("no number") << withPower(QStringLiteral("–")) << QStringLiteral("–");
    QTest::newRow("label") << withNumber(QStringLiteral("sum p_x"), QStringLiteral("−33.5"))
                           << QStringLiteral("sum p_x: −33.5");
    QTest::newRow("label, Arabic")
        << withNumber(QStringLiteral("المجموع p_x"), QStringLiteral("−33.5"))
        << QStringLiteral("المجموع p_x: \u2066−33.5\u2069");
    QTest::newRow("tick, large") << tickNumber(1e7, 5e6) << QStringLiteral("10⁷");
    QTest::newRow("tick, large, below zero") << tickNumber(-1e7, 5e6) << QStringLiteral("−10⁷");
    QTest::newRow("tick, large too") << tickNumber(5e6, 5e6) << QStringLiteral("5·10⁶");
    QTest::newRow("tick") << tickNumber(0.6000000001, 0.2) << QStringLiteral("0.6");
    QTest::newRow("tick at zero") << tickNumber(-1e-17, 0.2) << QStringLiteral("0");
}

void TestChartNumbers::numbersAreWritten()
{
    QFETCH(QString, written);
    QFETCH(QString, wanted);
    QCOMPARE(written, wanted);
}

QTEST_MAIN(TestChartNumbers)

#include "test_chart_numbers.moc"
