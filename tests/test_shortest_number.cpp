// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/shortest_number.h"

#include <QTest>

using namespace cradle;

class TestShortestNumber : public QObject
{
    Q_OBJECT
private slots:
    void keepsFractions_data();
    void keepsFractions();
    void readsBackToTheSameNumber();
};

void TestShortestNumber::keepsFractions_data()
{
    QTest::addColumn<double>("number");
    QTest::addColumn<QString>("text");
    const auto row = [](const char *text, double number) {
        QTest::newRow(text) << number << QString::fromUtf8(text);
    };
    row("1/60", 1.0 / 60.0);
    row("1/44100", 1.0 / 44100.0);
    row("1/64", 0.015625);
    row("2/3", 2.0 / 3.0);
    row("-5/3", -5.0 / 3.0);
    row("355/113", 355.0 / 113.0);
    // What is short as a decimal is one.
    row("0", 0.0);
    row("3", 3.0);
    row("0.05", 1.0 / 20.0);
    row("0.125", 1.0 / 8.0);
    row("-0.75", -0.75);
    row("0.017", 0.017);
    row("9.81", 9.81);
    row("1e-09", 1e-9);
    // No fraction to the last bit.
    row("0.30000000000000004", 0.1 + 0.2);
    row("0.3333333333333", 0.3333333333333);
    row("0.7071067811865476", 0.70710678118654757);
}

void TestShortestNumber::keepsFractions()
{
    QFETCH(double, number);
    QTEST(fractionOrNumber(number), "text");
}

void TestShortestNumber::readsBackToTheSameNumber()
{
    for (int n = 1; n <= 1000; n += 7) {
        for (int m = -999; m <= 999; m += 13) {
            const double number = double(m) / n;
            const QStringList parts = fractionOrNumber(number).split(QLatin1Char('/'));
            const double below = parts.size() == 2 ? parts[1].toDouble() : 1.0;
            QCOMPARE(parts[0].toDouble() / below, number);
        }
    }
}

QTEST_APPLESS_MAIN(TestShortestNumber)
#include "test_shortest_number.moc"
