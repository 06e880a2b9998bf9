// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/expression.h"

#include <QTest>

#include <cmath>

using namespace cradle;

/// Numbers that are written as expressions.
class TestExpression : public QObject
{
    Q_OBJECT
private slots:
    void comesToItsNumber_data();
    void comesToItsNumber();
    void saysWhatIsWrong_data();
    void saysWhatIsWrong();
    void unitsAreTurnedIntoWhatIsAsked_data();
    void unitsAreTurnedIntoWhatIsAsked();
    void partsOfAUnitKeepTheirDecimals();
    void wrongUnitsAreSaid_data();
    void wrongUnitsAreSaid();
    void ownNamesAreNoValues();
};

void TestExpression::comesToItsNumber_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("number");
    QTest::newRow("number") << QStringLiteral("2.5e-3") << 0.0025;
    QTest::newRow("fraction") << QStringLiteral("1/60") << 1.0 / 60.0;
    QTest::newRow("product before sum") << QStringLiteral("1 + 2*3") << 7.0;
    QTest::newRow("left to right") << QStringLiteral("8 - 3 - 2") << 3.0;
    QTest::newRow("power before sign") << QStringLiteral("-2^2") << -4.0;
    QTest::newRow("power to the right") << QStringLiteral("2^3^2") << 512.0;
    QTest::newRow("negative power") << QStringLiteral("2^-1") << 0.5;
    QTest::newRow("parentheses") << QStringLiteral("(1 + 2)*3") << 9.0;
    QTest::newRow("rack") << QStringLiteral("1 + 0.42*cos(pi/6)")
                          << 1.0 + 0.42 * 0.86602540378443864676;
    QTest::newRow("two arguments") << QStringLiteral("max(2, min(5, 3))") << 3.0;
    QTest::newRow("value") << QStringLiteral("2*k + k_2") << 3.2;
    QTest::newRow("deep") << QString(49, u'(') + u'1' + QString(49, u')') << 1.0;
    QTest::newRow("as long as may be") << QString(399, u' ') + u'1' << 1.0;
    QTest::newRow("fraction slash") << QStringLiteral("3\u20444") << 0.75;
    QTest::newRow("minus sign") << QStringLiteral("\u22121.5") << -1.5;
}

void TestExpression::comesToItsNumber()
{
    QFETCH(QString, text);
    QFETCH(double, number);
    const auto value = evaluated(text, {{QStringLiteral("k"), 0.6}, {QStringLiteral("k_2"), 2.0}});
    QVERIFY2(value.ok(), value ? "" : qPrintable(value.error().message));
    QCOMPARE(*value, number);
}

void TestExpression::saysWhatIsWrong_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("part");
    QTest::newRow("empty") << QStringLiteral("") << QStringLiteral("something is missing");
    QTest::newRow("unknown name") << QStringLiteral("2*kk") << QStringLiteral("no value called kk");
    QTest::newRow("two numbers") << QStringLiteral("1 2") << QStringLiteral("not expected");
    QTest::newRow("open parenthesis")
        << QStringLiteral("2*(1 + 3") << QStringLiteral("closing parenthesis");
    QTest::newRow("no argument") << QStringLiteral("sin")
                                 << QStringLiteral("parenthesis behind sin");
    QTest::newRow("one argument of two") << QStringLiteral("max(1)") << QStringLiteral("comma");
    QTest::newRow("infinite") << QStringLiteral("1/0") << QStringLiteral("no finite number");
    QTest::newRow("no number at all")
        << QStringLiteral("sqrt(-1)") << QStringLiteral("no finite number");
    QTest::newRow("deep") << QString(200, u'(') << QStringLiteral("too deep");
    QTest::newRow("a little too deep")
        << QString(50, u'(') + u'1' + QString(50, u')') << QStringLiteral("too deep");
    QTest::newRow("its first letters")
        << QString(100, u'(') << QStringLiteral("“%1” is no number").arg(QString(60, u'('));
    QTest::newRow("the next letters")
        << QStringLiteral("1 %1").arg(QString(20, u'x'))
        << QStringLiteral("“%1” is not expected").arg(QString(12, u'x'));
    QTest::newRow("no letters at all")
        << QStringLiteral("1 + %1").arg(QString(20, u'?'))
        << QStringLiteral("“%1” is not expected").arg(QString(12, u'?'));
    QTest::newRow("signs") << QString(300, u'-') << QStringLiteral("too deep");
    QTest::newRow("long") << QString(401, u'1') << QStringLiteral("at most 400");
}

void TestExpression::saysWhatIsWrong()
{
    QFETCH(QString, text);
    QFETCH(QString, part);
    const auto value = evaluated(text);
    QVERIFY(!value.ok());
    QVERIFY2(value.error().message.contains(part), qPrintable(value.error().message));
}

void TestExpression::unitsAreTurnedIntoWhatIsAsked_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<double>("number");
    const auto row = [](const char *text, const char *unit, double number) {
        QTest::addRow("%s in %s", text, unit)
            << QString::fromUtf8(text) << QString::fromUtf8(unit) << number;
    };
    row("35 cm", "m", 0.35);
    row("1 m + 20 cm", "m", 1.2);
    row("36 km/h", "m/s", 10.0);
    row("9.81 m/s^2", "m/s²", 9.81);
    row("9.81 m/s²", "m/s²", 9.81);
    row("1/60 s", "s", 1.0 / 60.0);
    row("20 ms", "s", 0.02);
    row("10 m / 4 s", "m/s", 2.5);
    row("2 * 9.81 m/s² * 3 s", "m/s", 58.86);
    row("sqrt(2 * 9.81 m/s² * 5 m)", "m/s", 9.904544411531507);
    row("(2 m)^2 / 1 m", "m", 4.0);
    row("(2 m)^2/1 m", "m", 4.0);
    row("7800 kg/m³", "1000 kg/m³", 7.8);
    row("7.8 t/m³", "· 1000 kg/m³", 7.8);
    row("261.4 kg * 2 m/s", "kg m/s", 522.8);
    row("0.5 * 2 kg * (3 m/s)^2", "J", 9.0);
    row("2 m * sin(30°)", "m", 1.0);
    row("max(20 cm, 0.1 m)", "m", 0.2);
    row("-(3 + 4) cm", "m", -0.07);
    // Without a unit a number is in the one that is asked for; of a value nobody knows it.
    row("0.2", "m", 0.2);
    row("k + 20 cm", "m", 0.8);
    row("sqrt(k) * 20 cm", "cm", 0.2 * std::sqrt(0.6));
    row("sin(k) * 20 cm", "cm", 20.0 * std::sin(0.6));
    row("abs(-20 cm)", "cm", 20.0);
    row("2 * k", "m/s", 1.2);
    row("1 m/s * k", "m", 0.6);
    row("3 m / s", "m", 1.5); // s is a value here
    // Where none is asked for it is that of the SI.
    row("20 cm", "", 0.2);
    row("50 %", "", 0.5);
    row("20", "px", 20.0);
}

void TestExpression::unitsAreTurnedIntoWhatIsAsked()
{
    QFETCH(QString, text);
    QFETCH(QString, unit);
    QFETCH(double, number);
    QMap<QString, double> values{{QStringLiteral("k"), 0.6}};
    if (text == QStringLiteral("3 m / s"))
        values.insert(QStringLiteral("s"), 2.0);
    const auto value = evaluated(text, values, unit);
    QVERIFY2(value.ok(), value ? "" : qPrintable(value.error().message));
    QCOMPARE(*value, number);
}

/// To the bit, though a power of a part of a unit is rounded.
void TestExpression::partsOfAUnitKeepTheirDecimals()
{
    const auto inSi = [](const char *text) {
        return *evaluated(QString::fromUtf8(text), {}, QString());
    };
    QVERIFY(inSi("35 cm") == 0.35);
    QVERIFY(inSi("5 dm²") == 0.05);
    QVERIFY(inSi("3 cm³") == 3e-6);
    QVERIFY(inSi("0.3 cm³") == 3e-7);
}

void TestExpression::wrongUnitsAreSaid_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("part");
    const auto row = [](const char *text, const char *part) {
        QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(part);
    };
    row("2 s", "it is in s; m is right here");
    row("9.81 m/s²", "it is in m/s²; m is right here");
    row("3 kg + 2 m", "kg and m stand side by side");
    row("max(1 m, 2 s)", "m and s stand side by side");
    row("sin(2 m)", "sin is taken of a number without a unit, not of one in m");
    row("2^(1 m)", "a power with that unit is none");
    row("sqrt(2 m)", "a power with that unit is none");
    row("(2 m) m", "there is a unit too many");
    row("1 / 60 s", "it is in 1/s; m is right here");
    row("2 m²s", "“²s” is not expected there");
    row("2 furlong", "“furlong” is not expected there");
}

void TestExpression::wrongUnitsAreSaid()
{
    QFETCH(QString, text);
    QFETCH(QString, part);
    const auto value = evaluated(text, {}, QStringLiteral("m"));
    QVERIFY(!value.ok());
    QVERIFY2(value.error().message.contains(part), qPrintable(value.error().message));
}

void TestExpression::ownNamesAreNoValues()
{
    QVERIFY(isValueName(QStringLiteral("k")) && isValueName(QStringLiteral("drag_2")));
    QVERIFY(!isValueName(QStringLiteral("pi")) && !isValueName(QStringLiteral("sin"))
            && !isValueName(QStringLiteral("max")));
    QVERIFY(!isValueName(QStringLiteral("2k")) && !isValueName(QStringLiteral(""))
            && !isValueName(QStringLiteral("a b")));
}

QTEST_GUILESS_MAIN(TestExpression)

#include "test_expression.moc"
