// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/expression.h"

#include <QTest>

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
