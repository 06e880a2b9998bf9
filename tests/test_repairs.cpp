// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repairs.h"

#include "tests/tried_repairs.h"

#include <QTest>

using namespace cradle;
using namespace cradle::changes;

/// What students forget, exchange or get the wrong way round is among the small changes that are
/// tried, and each changes what it says.
class TestRepairs : public QObject
{
    Q_OBJECT
private slots:
    void mistakeIsUndone_data();
    void mistakeIsUndone();
    void mistakeOfTwoLinesIsUndone_data();
    void mistakeOfTwoLinesIsUndone();
    void anotherOfTheFunctionsOrTheirValuesIsTaken_data();
    void anotherOfTheFunctionsOrTheirValuesIsTaken();
    void lineIsMadeTheMirrorImageOfAnother_data();
    void lineIsMadeTheMirrorImageOfAnother();
    void whatIsForgottenIsTold();
};

void TestRepairs::mistakeIsUndone_data()
{
    QTest::addColumn<QString>("wrong");
    QTest::addColumn<QString>("right");
    const auto row = [](const char *wrong, const char *right) {
        QTest::addRow("%s -> %s", wrong, right)
            << QString::fromUtf8(wrong) << QString::fromUtf8(right);
    };
    // Signs.
    row("x = u + w", "x = u - w");
    row("x = u - w", "x = u + w");
    row("x = u * w", "x = u / w");
    row("x = u / w", "x = u * w");
    row("x = u * w", "x = u + w");
    row("x = -u", "x = u");
    row("x = u", "x = -(u)");
    row("x = u", "x = - u");
    row("f(u, w)", "f(- u, w)");
    row("f(u, w)", "f(u, - w)");
    row("if u < w then", "if u > w then");
    row("if u > w then", "if u < w then");
    row("if u <= w then", "if u >= w then");
    row("if u >= w then", "if u <= w then");
    // Numbers.
    row("x = 3 * u", "x = 1 * u");
    row("x = 3 * u", "x = 2 * u");
    row("x = 3 * u", "x = 0.5 * u");
    row("x = 3 * u", "x = restitution * u");
    row("x = 2 * u", "x = (1 + restitution) * u");
    row("x = 3.9 - u", "x = square.half_width - u");
    row("x = 2 * restitution * u", "x = 1 + restitution * u");
    row("x = (2 - restitution) * u", "x = (1 + restitution) * u");
    row("x = r ^ 2", "x = r ^ 3");
    row("x = r ^ 3", "x = r ^ 2");
    row("x = r ^ 3", "x = r ^ 1");
    row("x = circles[1].v", "x = circles[2].v");
    row("x = circles[2].v", "x = circles[1].v");
    row("if u > 0.2 then", "if u > a.radius then");
    row("x = v * 1 / 60", "x = v * h");
    row("x = v * 0.0166", "x = v * h");
    row("y = vec(0, -9.81)", "y = vec(0, gravity.y)");
    row("for i = 1, 2 do", "for i = 1, 3 do");
    row("for i = 1, 2 do", "for i = 1, 1 do");
    row("f(i)", "f(i - 1)");
    row("f(u, j)", "f(u, j + 1)");
    // Names.
    row("x = a.density", "x = b.density");
    row("x = b.radius", "x = a.radius");
    row("x = a.radius + b.radius", "x = a.radius + a.radius");
    row("x = a.radius + b.radius", "x = b.radius + b.radius");
    row("x = m1", "x = m2");
    row("x = m1 * m1", "x = m1 * m2");
    row("x = n.x * n.x", "x = n.x * n.y");
    row("x = va", "x = vb");
    row("x = n.x", "x = n.y"); // which the next line names
    row("x = square.left", "x = square.right");
    row("x = square.right", "x = square.left");
    row("x = square.top", "x = square.bottom");
    row("x = square.bottom", "x = square.top");
    row("x = math.max(u, w)", "x = math.min(u, w)");
    row("x = math.min(u, w)", "x = math.max(u, w)");
    row("x = math.sin(u)", "x = math.cos(u)");
    row("x = math.cos(u)", "x = math.sin(u)");
    row("x = one.v", "x = other.v");
    row("x = other.v", "x = one.v");
    row("x = restitution * u", "x = 1 * u");
    row("x = restitution * u", "x = (1 + restitution) * u");
    row("x = circles[1].density", "x = a.density");
    row("a.velocity = a.velocity + u", "b.velocity = b.velocity + u");
    row("x = m1 * m2 / m1", "x = m2 * m1 / m2");
    // Factors and terms.
    row("x = u * w * z", "x = u * w");
    row("x = u * w * z", "x = w * z");
    row("x = u + w", "x = u");
    row("x = u - w", "x = u");
    row("x = u ^ 2 + w", "x = u + w");
    row("x = u + w", "x = w");
    row("return u * w - z", "return z");
    row("x = f * 180 / math.pi", "x = f");
    row("x = u / w + z", "x = u / (w + z)");
    row("x = u * w - z", "x = u * (w - z)");
    row("x = u + w / z", "x = (u + w) / z");
    row("x = u - 3 * w / z", "x = (u - 3 * w) / z");
    row("x = (u + w) / 2", "x = (u * w / (u + w))");
    row("x = (u + w)", "x = (u * w / (u + w))");
    row("x, y = u * w, z", "x, y = u * w, z * w");
    row("x, y = u, z / w", "x, y = u / w, z / w");
    row("f(u / w, z)", "f(u / w, z / w)");
    row("x = u + h * w", "x = u");
    row("x = u - h * w / z + q", "x = u + q");
    row("x = n.x ^ 2", "x = n.x ^ 2 + n.y ^ 2");
    row("x = u + w", "x = 2 * u + w");
    row("x = u + w", "x = u + 2 * w");
    row("x = u + w", "x = u + restitution * w");
    row("x = u + w", "x = (u + w) / 2");
    row("x = u * w", "x = 2 * (u * w)");
    row("return u * w", "return 1 / (u * w)");
    row("x = j * u", "x = d * j * u"); // d is worked out and used nowhere
    row("x = v", "x = v * h");
    row("c.x = c.x + velocity", "c.x = c.x + velocity * h");
    row("x = gravity", "x = gravity * h");
    row("x = f(u)", "x = f(u) * h");
    row("x = -w", "x = -w * restitution");
    row("x = -v.x", "x = -v.x * restitution");
    row("x = a.radius", "x = a.radius * a.radius");
    row("x = a.radius", "x = a.radius * a.density");
    row("x = 4 * a.radius", "x = a.density * 4 * a.radius");
    row("return 4 * a.radius", "return a.density * 4 * a.radius");
    row("x = a.radius", "x = a.radius ^ 2");
    row("x = a.radius", "x = a.radius + b.radius");
    row("if u < w then", "if u < w ^ 2 then");
    row("if u < w then", "if u + a.radius < w then");
    row("if u < w then", "if u - b.radius < w then");
    row("if u >= w then", "if u + b.radius >= w then");
    // Conditions.
    row("if u and w then", "if u or w then");
    row("if u or w then", "if u and w then");
    row("if u and w then", "if u then");
    row("if u and w then", "if w then");
    row("if not u or w < z then", "if not u then");
    row("if u then", "if true then");
    row("if u then", "if false then");
    row("elseif u == w then", "elseif false then");
    // Vectors, lengths and walls.
    row("x = d", "x = (d):normalized()");
    row("x = d:normalized()", "x = d");
    row("x = d:length()", "x = d");
    row("x = d:normalized() * u", "x = n:normalized() * u");
    row("x = math.abs(u)", "x = (u)");
    row("x = math.abs(d.x)", "x = d:length()");
    row("x = math.abs(d.y)", "x = d:length()");
    row("x = math.atan(u, w)", "x = math.atan(w, u)");
    row("x = math.atan(u / w)", "x = math.atan(u, w)");
    row("x = math.max(u, w)", "x = math.max(u + w, u + w)");
    row("v = vec(-v.x, 0)", "v = vec(-v.x, v.y)");
    row("v = vec(0, -v.y)", "v = vec(v.x, -v.y)");
    row("p = math.max(radius, square.left)", "p = math.max(square.left + radius, square.left)");
    row("p = vec(a.radius, square.top)", "p = vec(square.right - a.radius, square.top)");
    row("x = a.velocity", "x = a.velocity - b.velocity");
    row("x = dot(b.position, n)", "x = dot(b.position - a.position, n)");
    // What is given, and whole lines.
    row("x, y = u, w", "x, y = w, u");
    row("x, y, z, v = u, w, p, q", "x, y, z, v = u, q, p, w");
    row("f(u, w * z, q)", "f(q, w * z, u)");
    row("x = {u, w}", "x = {w, u}");
    row("x = p[i] - p[k]", "x = p[k] - p[k]");
    row("x = u and w or z", "x = u and - w or z");
    row("return u, w", "return w, u");
    row("x, y = u, w", "x, y = (u) / ((u)^2 + (w)^2)^0.5, (w) / ((u)^2 + (w)^2)^0.5");
    row("x = u", "");
    row("f(u)", "");
    row("do break end", "");
    row("return", "");
}

void TestRepairs::mistakeIsUndone()
{
    QFETCH(QString, wrong);
    QFETCH(QString, right);
    const bool isOfY = right.contains(QLatin1String("n.y"));
    const auto program = [&](const QString &line) {
        return around(line) + (isOfY ? QStringLiteral("\ny = 1") : QString());
    };
    const std::vector<Repair> all = tried(program(wrong));
    QVERIFY2(isTried(all, program(right)), qPrintable(right));
    QVERIFY(!isTried(all, program(wrong))); // that is none
    for (const Repair &each : all) {
        QCOMPARE(each.line, theLine);
        // One line is changed, all others are as they were.
        const QStringList before = program(wrong).split(QLatin1Char('\n'));
        const QStringList after = each.source.split(QLatin1Char('\n'));
        if (!each.alone || after.size() != before.size())
            continue;
        for (int i = 0; i < before.size(); ++i)
            QVERIFY(before[i] == after[i] || i == theLine - 1 || i == theLine);
    }
    QStringList sources;
    for (const Repair &each : all)
        sources.append(each.source);
    QCOMPARE(sources.removeDuplicates(), 0);
}

void TestRepairs::mistakeOfTwoLinesIsUndone_data()
{
    QTest::addColumn<QString>("wrong");
    QTest::addColumn<QString>("right");
    QTest::newRow("order") << "x = u\ny = x"
                           << "y = x\nx = u";
    QTest::newRow("at once") << "  p = q\n  q = p"
                             << "  p, q = q, p";
    QTest::newRow("at once, of fields") << "a.v = b.v + u\nb.v = a.v - u"
                                        << "a.v, b.v = b.v + u, a.v - u";
}

void TestRepairs::mistakeOfTwoLinesIsUndone()
{
    QFETCH(QString, wrong);
    QFETCH(QString, right);
    QVERIFY(isTried(tried(around(wrong)), around(right)));
}

void TestRepairs::anotherOfTheFunctionsOrTheirValuesIsTaken_data()
{
    QTest::addColumn<QString>("wrong"); // line 4 of a program with two functions
    QTest::addColumn<QString>("right");
    QTest::newRow("called") << "first(p, q)"
                            << "second(p, q)";
    QTest::newRow("kept") << "methods = {first, first}"
                          << "methods = {first, second}";
    QTest::newRow("handed on") << "run(second)"
                               << "run(first)";
    QTest::newRow("named") << "use('first')"
                           << "use('second')";
}

void TestRepairs::anotherOfTheFunctionsOrTheirValuesIsTaken()
{
    QFETCH(QString, wrong);
    QFETCH(QString, right);
    const QString functions = QStringLiteral("function first(s, t) return s.v - t.v end\n"
                                             "function second(s, t) return t.v - s.v end\n"
                                             "function run(f) return f end\n");
    QVERIFY(isTried(tried(functions + wrong, {4}), functions + right));
    QVERIFY(
        isTried(tried(functions, {1}), QString(functions).replace(QLatin1String("return s.v"),
                                                                  QLatin1String("return t.v"))));
}

void TestRepairs::lineIsMadeTheMirrorImageOfAnother_data()
{
    QTest::addColumn<QString>("wrong"); // its second line is changed
    QTest::addColumn<QString>("right");
    QTest::newRow("numbers") << "m1 = u * va + vb\nm2 = u * vb"
                             << "m1 = u * va + vb\nm2 = u * vb + va";
    QTest::newRow("a call") << "f(m1, 2 * va)\nf(m1, va)"
                            << "f(m1, 2 * va)\nf(m1, va)";
    QTest::newRow("coordinates") << "p.x = q.x * 2\np.y = q.x * 2"
                                 << "p.x = q.x * 2\np.y = q.y * 2";
    QTest::newRow("places in a list") << "s[1].v = s[2].u\ns[2].v = s[2].u"
                                      << "s[1].v = s[2].u\ns[2].v = s[1].u";
}

void TestRepairs::lineIsMadeTheMirrorImageOfAnother()
{
    QFETCH(QString, wrong);
    QFETCH(QString, right);
    const auto all = tried(around(wrong), {theLine + 1});
    const auto told = std::find_if(all.begin(), all.end(), [&](const Repair &each) {
        return withoutSpaces(each.source) == withoutSpaces(around(right));
    });
    QCOMPARE(told != all.end(), wrong != right);
    if (wrong != right) {
        QVERIFY(told->told);
        QCOMPARE(told->line, theLine + 1);
    }
}

void TestRepairs::whatIsForgottenIsTold()
{
    const auto isTold = [](const QString &wrong, const QString &right) {
        const auto all = tried(around(wrong));
        return std::any_of(all.begin(), all.end(), [&](const Repair &each) {
            return each.told && withoutSpaces(each.source) == withoutSpaces(around(right));
        });
    };
    // d is worked out and used nowhere.
    QVERIFY(isTold(QStringLiteral("x = u * m1"), QStringLiteral("x = d * u * m1")));
    QVERIFY(isTold(QStringLiteral("x = u * m1"), QStringLiteral("x = u * m1 / d")));
    QVERIFY(isTold(QStringLiteral("x = u * m1"), QStringLiteral("x = d")));
    QVERIFY(isTold(QStringLiteral("if u < w then"), QStringLiteral("if u < w and d then")));
    QVERIFY(!isTold(QStringLiteral("x = u * m1"), QStringLiteral("x = u")));
}

QTEST_GUILESS_MAIN(TestRepairs)
#include "test_repairs.moc"
