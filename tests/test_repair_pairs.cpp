// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repairs.h"

#include "tests/tried_repairs.h"

#include <QTest>

using namespace cradle;
using namespace cradle::changes;

/// What is said of one of two is tried of the other: under which names, and with which sign.
class TestRepairPairs : public QObject
{
    Q_OBJECT
private slots:
    void mistakeInTheSecondLineIsUndone_data();
    void mistakeInTheSecondLineIsUndone();
    void whoTakesWhatHasChangedIsMarked();
};

void TestRepairPairs::mistakeInTheSecondLineIsUndone_data()
{
    QTest::addColumn<QString>("wrong"); // its second line is changed
    QTest::addColumn<QString>("right");
    QTest::addColumn<bool>("isTried");
    const auto row = [](const char *name, const char *first, const char *wrong, const char *right,
                        bool tried = true) {
        const QString before = QString::fromLatin1(first) + QLatin1Char('\n');
        QTest::newRow(name) << before + QString::fromLatin1(wrong)
                            << before + QString::fromLatin1(right) << tried;
    };
    // Names that go together by what they are given, or by how they end.
    row("declared together", "local mine, yours = a.v, b.v", "x = mine", "x = yours");
    row("given other things", "local mine, yours = a.v, b.v * 2", "x = mine", "x = yours", false);
    row("given the same", "local mine, yours = a.v, a.v", "x = mine", "x = yours", false);
    row("the second alone has a number", "local speed, speed2 = 1, 2", "x = speed", "x = speed2");
    row("the first has none", "local speed, speed2 = 1, 2", "x = speed2", "x = speed");
    row("p and q", "local mp, mq = 1, 2", "x = mp", "x = mq");
    // A push on the other points the other way.
    row("opposed", "a.v = a.v - j / m1 * n", "b.v = b.v + n", "b.v = b.v + j / m2 * n");
    row("within brackets it is the same", "a.v = a.v - 2 / (m1 + m2) * n", "b.v = b.v",
        "b.v = b.v + 2 / (m2 + m1) * n");
    row("one value of two", "", "local x1, x2 = 2 * m2 / (m1 + m2), m1", // of the own line
        "local x1, x2 = 2 * m2 / (m1 + m2), 2 * m1 / (m2 + m1)");
    row("one of two that are returned", "function f() u = 1 end",
        "return nx * nx * u + nx * ny * v, ny * nx * u + nx * nx * v",
        "return nx * nx * u + nx * ny * v, ny * ny * u + ny * nx * v");
    row("the first of two", "", "local x1, x2 = m2, 2 * m1", "local x1, x2 = 2 * m2, 2 * m1");
    row("turned round, the first", "", "local x, y = u - w, v", "local x, y = -(u - w), v");
    row("turned round, the second", "", "local x, y = u, v - w", "local x, y = u, -(v - w)");
    row("indices exchanged", "", "x = k + u[2] - u[1]", "x = k + u[1] - u[2]");
    row("masses exchanged", "local a, b = 1, 2", "x = a.v * b.m + b.v * a.m",
        "x = a.v * a.m + b.v * b.m");
    row("said of one alone", "local a, b = 1, 2", "x = a.v * a.m + a.v * 2", "x = a.v * b.m",
        false);
    row("in two lines", "", "c1.f = u * 3\nc2.f = v / 5", "c2.f = u * 3\nc1.f = v / 5");
    row("in two lines, of both", "", "c1.f = u * c2.m\nc2.f = v / 5",
        "c2.f = u * c1.m\nc1.f = v / 5", false);
    // What a line built alike has in that place.
    row("half of a step", "kick(b, dt / 2)", "kick(a, dt)", "kick(a, dt / 2)");
    row("a whole step", "local k4 = f(y + k3 * h)", "local k3 = f(y + k2 * (h / 2))",
        "local k3 = f(y + k2 * h)");
    row("built otherwise", "push(b, n, dt / 2, 3)", "kick(a, dt)", "kick(a, n, dt / 2, 3)", false);
    row("of pairs", "for i = 1, #circles do", "for j = i, #circles do",
        "for j = i + 1, #circles do");
    row("called an inverse", "", "c.inv_m = m + 3", "c.inv_m = 1 / (m + 3)");
    row("returned by what is called so", "local function invMass(m)", "return m + 3 end",
        "return 1 / (m + 3) end");
    row("returned by another", "local function mass(m)", "return m + 3 end",
        "return 1 / (m + 3) end", false);
    row("not called one", "", "c.mass = m + 3", "c.mass = 1 / (m + 3)", false);
    // What follows from two.
    row("what two share", "", "x = m1 * m2", "x = m1 * m2 / (m1 + m2)");
    row("of no two", "", "x = m1 * va", "x = m1 * va / (m1 + va)", false);
    row("divided already", "", "x = m1 * m2 / u", "x = m1 * m2 / (m1 + m2) / u", false);
    row("square of a sum", "", "if u < r[1] ^ 2 + r[2] ^ 2 then", "if u < (r[1] + r[2]) ^ 2 then");
    row("part of a step", "for i = 1, 8 do", "local s = h", "local s = h / 8");
    row("part of a step, by name", "for i = 1, k do", "local s = h", "local s = h / k");
    row("twice, at both places", "", "x = vec(u - va * d, w - va * n)",
        "x = vec(u - 2 * va * d, w - 2 * va * n)");
}

void TestRepairPairs::mistakeInTheSecondLineIsUndone()
{
    QFETCH(QString, wrong);
    QFETCH(QString, right);
    QFETCH(bool, isTried);
    const auto all = tried(around(wrong), {theLine + 1});
    QCOMPARE(changes::isTried(all, around(right)), isTried);
    for (const Repair &each : all)
        QCOMPARE(each.line, theLine + 1);
}

void TestRepairPairs::whoTakesWhatHasChangedIsMarked()
{
    const auto all = tried(around(QStringLiteral("a.v = b.v\nb.v = a.v")));
    const QString right = around(QStringLiteral("a.v, b.v = b.v, a.v"));
    const auto found = std::find_if(all.begin(), all.end(), [&](const Repair &each) {
        return withoutSpaces(each.source) == withoutSpaces(right);
    });
    QVERIFY(found != all.end());
    QCOMPARE(found->line, theLine + 1);
}

QTEST_GUILESS_MAIN(TestRepairPairs)
#include "test_repair_pairs.moc"
