// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/program_rows.h"
#include "tasks/judging/telling_lines.h"

#include <QTest>

using namespace cradle;

/// The line whose text alone tells that it is to blame, by what is said of a program.
class TestTellingLines : public QObject
{
    Q_OBJECT
private slots:
    void lineIsTold_data();
    void lineIsTold();
    void rightMassesAreNotToBlame();
    void whatIsKeptIsOfTheStart_data();
    void whatIsKeptIsOfTheStart();
    void missingWallIsGivenOthersAlone_data();
    void missingWallIsGivenOthersAlone();
    void linesWithRestitutionComeAlone_data();
    void linesWithRestitutionComeAlone();
};

void TestTellingLines::lineIsTold_data()
{
    QTest::addColumn<int>("suspect");
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, Suspect suspect, const char *program, int line) {
        QTest::newRow(name) << int(suspect) << QString::fromUtf8(program) << line;
    };
    const Suspect masses = Suspect::Masses;
    row("a mass", masses, "a = 1\nm1 = c.density * c.radius ^ 2\nm2 = b\nprint(m1, m2, a)", 2);
    row("the first line", masses, "m1 = c.density * c.radius ^ 2\nprint(m1)", 1);
    row("most worked out", masses,
        "m1 = c.density * c.radius\nm2 = c.density * pi * c.radius ^ 2\nprint(m1, m2)", 2);
    row("the first of two alike", masses,
        "m1 = a.density * a.radius ^ 3\nm2 = b.density * b.radius ^ 3\nprint(m1, m2)", 1);
    row("without density or power", masses, "r = a.radius + b.radius\nd = r * 2\nprint(d)", 0);
    row("comparison", masses, "if a.radius ^ 2 < b.radius ^ 2 then x = 1 end", 0);
    row("velocity", masses, "a.velocity = a.velocity * a.density * a.radius ^ 3", 0);
    row("copies", masses,
        "local r = c.radius\nlocal rho = c.density\nlocal m = rho * r * r\nprint(m)", 3);
    row("nobody calls it", masses,
        "function unused()\n  return c.density * c.radius ^ 3\nend\nk = c.density * "
        "c.radius\nprint(k)",
        4);
    row("nobody calls the next", masses,
        "k = c.density * c.radius\nfunction unused()\n  m = c.density * c.radius ^ "
        "3\nend\nprint(k)",
        1);
    row("nobody calls a named one", masses, "function unused()\n  m1 = 2\nend\nm2 = 3\nprint(m2)",
        4);
    row("named", masses, "a = 1\nm1 = 2\nprint(a, m1)", 2);
    row("named in words", masses, "mass_a = 2\nprint(mass_a)", 1);
    row("named like one", masses, "most = 2\nprint(most)", 0);
    row("two named", masses, "m1 = 2\nx = 3\nm2 = x\nprint(m1, m2, x)", 0);
    row("two on a line", masses, "x = 1\nm1, m2 = 2, 3\nprint(x, m1, m2)", 2);
    row("worked out of masses", masses, "m1 = 2\nmass = m1 + 1\nprint(mass, m1)", 1);
    row("copy of e", Suspect::Copy, "x = 1\nlocal e = restitution\ny = e", 2);
    row("copy of gravity's part", Suspect::Copy, "  g = gravity.y", 1);
    row("worked out of e too early", Suspect::Copy,
        "local k = 1 + restitution\nfunction on_load()\n  restitution = 0.5\nend", 1);
    row("worked out of e in time", Suspect::Copy,
        "function on_load()\n  restitution = 0.5\n  k = 1 + restitution\nend", 0);
    row("of a radius, too early", Suspect::Copy,
        "local far = a.radius + b.radius\nfunction on_load()\n  b.radius = 0.4\nend", 1);
    row("of a radius in a function, too early", Suspect::Copy,
        "local function size(c) return c.radius ^ 3 end\nfunction on_load()\n  m = size(b)\n  "
        "b.radius = 0.4\nend",
        3);
    row("of radii in a table, too early", Suspect::Copy,
        "local far = { a.radius, b.radius }\nfunction on_load()\n  b.radius = 0.4\nend", 1);
    row("above on_load in time, not in text", Suspect::Copy,
        "function on_load()\n  b.radius = 0.4\nend\nlocal far = a.radius + b.radius", 4);
    row("of a radius in a function that is only made", Suspect::Copy,
        "local function maker(c)\n  return function()\n    return c.radius\n  end\nend\n"
        "local size = maker(b)\nlocal far = b.radius\nfunction on_load()\n  b.radius = 0.4\nend",
        7);
    row("of radii in a list, too early", Suspect::Copy,
        "function on_load()\n  k = 1\n  r[i] = circles[i].radius\n  circle2.radius = 0.4\nend", 3);
    row("of radii in a list, in time", Suspect::Copy,
        "function on_load()\n  circle2.radius = 0.4\n  r[i] = circles[i].radius\nend", 0);
    row("of places in a list, too early", Suspect::Begun,
        "function on_load()\n  x[i], y[i] = c.position.x, c.position.y\n"
        "  circles[i].position = vec(1, 2)\nend",
        2);
    row("in every step", Suspect::Copy,
        "function on_update()\n  far = a.radius\nend\nfunction on_load()\n  a.radius = 1\nend", 0);
    row("more than a copy", Suspect::Copy, "g = gravity.y * 2\nh = gravitation", 0);
    row("kept, or worked out", Suspect::Kept, "x = 1\nn = n or f()\nprint(n, x)", 2);
    row("another or", Suspect::Kept, "n = k or f()", 0);
    row("if there is none", Suspect::Kept, "x = 1\nif not memo.e then\nmemo.e = 2\nend", 2);
    for (const Suspect other :
         {Suspect::Omission, Suspect::Answer, Suspect::Question, Suspect::Reach, Suspect::Formula})
        row(qPrintable(QStringLiteral("nothing of %1").arg(int(other))), other,
            "m = c.density * c.radius ^ 3\ne = restitution\nn = n or 2\nprint(m, e)", 0);
}

void TestTellingLines::lineIsTold()
{
    const auto unsound = [](int) { return false; };
    QFETCH(int, suspect);
    QFETCH(QString, program);
    QFETCH(int, line);
    const QStringList rows = rowsOf(program);
    RanLines ran;
    for (int i = 0; i <= rows.size() + 1; ++i) // those outside are of no line
        ran.now.insert(i);
    LawDeviation deviation;
    deviation.suspect = Suspect(suspect);
    const ProgramLines lines(program);
    QCOMPARE(tellingLine(deviation, lines, rows, ran, 0, unsound), line);
    // The only line with an angle, where directions are wrong.
    deviation.topic = Topic::Direction;
    QCOMPARE(tellingLine(deviation, lines, rows, ran, 0, unsound), line);
    const int last = static_cast<int>(rows.size()) + 1;
    const QString turned = program + QStringLiteral("\na = math.atan(y, x)");
    QCOMPARE(tellingLine(deviation, ProgramLines(turned), rowsOf(turned), ran, 0, unsound), last);
    const QString above = QStringLiteral("a = math.atan(y, x)\n") + program;
    QCOMPARE(tellingLine(deviation, ProgramLines(above), rowsOf(above), ran, 0, unsound), 1);
    const QString twice = turned + QStringLiteral("\nb = math.acos(x)");
    RanLines all = ran;
    all.now.insert(last + 1);
    QCOMPARE(tellingLine(deviation, ProgramLines(twice), rowsOf(twice), all, 0, unsound), line);
    // The only line that rounds, where pushes are whole numbers.
    deviation.topic = Topic::Rounding;
    for (const char *rounds : {"a = x // 1", "a = math.floor(x)"}) {
        const QString whole = program + QLatin1Char('\n') + QString::fromUtf8(rounds);
        QCOMPARE(tellingLine(deviation, ProgramLines(whole), rowsOf(whole), ran, 0, unsound), last);
    }
    QCOMPARE(tellingLine(deviation, lines, rows, ran, 0, unsound), line);
    // Only lines that ran are asked.
    if (Suspect(suspect) == Suspect::Kept)
        QCOMPARE(tellingLine(deviation, lines, rows, {}, 0, unsound), 0);
}

void TestTellingLines::rightMassesAreNotToBlame()
{
    const QString program = QStringLiteral("c.mass = pi * c.density * c.radius ^ 3\n"
                                           "m1 = a.density * a.radius\nprint(m1)");
    const auto lineOf = [&](int sound) {
        LawDeviation deviation;
        deviation.suspect = Suspect::Masses;
        return tellingLine(deviation, ProgramLines(program), rowsOf(program), {}, 0,
                           [&](int line) { return line == sound; });
    };
    QCOMPARE(lineOf(0), 1);
    QCOMPARE(lineOf(1), 2);
}

void TestTellingLines::whatIsKeptIsOfTheStart_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("last");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const char *program, int last, int line) {
        QTest::newRow(name) << QString::fromUtf8(program) << last << line;
    };
    row("a normal of the start", "local n = b.p - a.p\nfunction on_update()\n  x = s * n\nend", 3,
        1);
    row("of on_load", "function on_load()\n  c.old = c.position\nend\nx = c.old", 4, 2);
    row("another field of that name", "old = c.position\nx = c.old", 2, 0);
    row("numbers", "local k = 2\nx = k * u", 2, 0);
    row("nothing yet", "local k = nil\nx = k * u", 2, 0);
    row("what circles have", "c.velocity = vec(2, 0)\nx = c.velocity", 2, 0);
    row("two of them", "local n = f(1)\nlocal s = f(2)\nx = s * n", 3, 0);
    row("worked out in a step", "function on_update()\n  n = b - a\n  x = s * n\nend", 3, 0);
    row("no line", "local n = b.p - a.p", 0, 0);
    row("behind the program", "local n = b.p - a.p", 2, 0);
}

void TestTellingLines::whatIsKeptIsOfTheStart()
{
    QFETCH(QString, program);
    QFETCH(int, last);
    LawDeviation deviation;
    deviation.suspect = Suspect::Kept;
    QTEST(tellingLine(deviation, ProgramLines(program), rowsOf(program), {}, last,
                      [](int) { return false; }),
          "line");
}

void TestTellingLines::missingWallIsGivenOthersAlone_data()
{
    QTest::addColumn<QString>("calls");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const char *calls, int line) {
        QTest::newRow(name) << QString::fromLatin1(calls) << line;
    };
    row("of circle 1", "walls(circle1)", 5);
    row("of circle 1 by its number", "walls(circles[1])", 5);
    row("the last", "walls(circle1)\nwalls(circle1)", 6);
    row("of both", "walls(circle1)\nwalls(circle2)", 0);
    row("of all", "for _, c in ipairs(circles) do walls(c) end", 0);
    row("handed on", "move(circle1)\nend\nfunction move(c)\n  walls(c)", 5);
    row("handed on for both", "move(circle1)\nmove(circle2)\nend\nfunction move(c)\n  walls(c)", 0);
    row("within what is called for both",
        "move(circle1)\nmove(circle2)\nend\nfunction move(c)\n  walls(circle1)", 9);
}

void TestTellingLines::missingWallIsGivenOthersAlone()
{
    QFETCH(QString, calls);
    const QString program = QStringLiteral("function walls(c)\n  if c.x > square.right then\n"
                                           "  end end\nfunction on_update()\n%1\nend")
                                .arg(calls);
    LawDeviation deviation;
    deviation.aspect = Aspect::Walls;
    deviation.suspect = Suspect::Omission;
    deviation.moment.circles = {1};
    QTEST(tellingLine(deviation, ProgramLines(program), rowsOf(program), {}, 0,
                      [](int) { return false; }),
          "line");
}

void TestTellingLines::linesWithRestitutionComeAlone_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<std::vector<int>>("lines");
    QTest::newRow("one") << QStringLiteral("a = 1\nb = restitution\nc = 3") << std::vector<int>{2};
    QTest::newRow("none") << QStringLiteral("a = 1\nb = 2\nc = 3") << std::vector<int>{1, 2, 3};
    QTest::newRow("a copy") << QStringLiteral("e = restitution\nb = 2\nc = e * 3")
                            << std::vector<int>{1, 3};
}

void TestTellingLines::linesWithRestitutionComeAlone()
{
    QFETCH(QString, program);
    QFETCH(std::vector<int>, lines);
    QCOMPARE(withRestitution({1, 2, 3}, rowsOf(program), ProgramLines(program)), lines);
}

QTEST_APPLESS_MAIN(TestTellingLines)
#include "test_telling_lines.moc"
