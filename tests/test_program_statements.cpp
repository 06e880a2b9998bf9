// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/program_statements.h"

#include <QTest>

using namespace cradle;

/// The statements of a program, as its tokens tell them.
class TestProgramStatements : public QObject
{
    Q_OBJECT
private slots:
    void assignmentsAreFound_data();
    void assignmentsAreFound();
    void functionsAreFound();
    void innermostFunctionIsTold();
    void unusedFunctionsAreDead_data();
    void unusedFunctionsAreDead();
    void copiesAreFound_data();
    void copiesAreFound();
    void valuesAreNamedOnce_data();
    void valuesAreNamedOnce();
};

namespace {

/// The tokens of a range with spaces between.
QString textOf(const ProgramLines &program, std::size_t from, std::size_t to)
{
    QStringList words;
    for (std::size_t i = from; i < to; ++i)
        words.append(program.tokens()[i].text);
    return words.join(QLatin1Char(' '));
}

QStringList lines(const std::set<int> &all)
{
    QStringList numbers;
    for (const int line : all)
        numbers.append(QString::number(line));
    return numbers;
}

} // namespace

void TestProgramStatements::assignmentsAreFound_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("found"); // line: target = value; * marks a field, > handed on
    const auto row = [](const char *source, const char *found) {
        QTest::newRow(source) << QString::fromUtf8(source) << QString::fromUtf8(found);
    };
    row("x = 1", "1: x = 1");
    row("local x = a + b * c", "1: x = a + b * c");
    row("local x, y = a, b", "1: x = > a|1: y = > b");
    row("a.v, b.v = b.v, a.v", "1: * a . v = > b . v|1: * b . v = > a . v");
    row("x, y = f()", "1: x = |1: y = ");
    row("x = f(1, 2)", "1: x = f ( 1 , 2 )");
    row("circles[1].v = w", "1: * circles [ 1 ] . v = > w");
    row("circles[1].v = old[1]", "1: * circles [ 1 ] . v = > old [ 1 ]");
    row("circles[1].v = old[2]", "1: * circles [ 1 ] . v = old [ 2 ]");
    row("c.p = vec(x, self.y)", "1: * c . p = > vec ( x , self . y )");
    row("c.p = norm(x)", "1: * c . p = norm ( x )");
    row("x = -y", "1: x = - y");
    row("x = not y == 2", "1: x = not y == 2");
    row("x = nil y = true", "1: x = nil|1: y = true");
    row("x = a .. b\ny = #t", "1: x = a .. b|2: y = # t");
    row("x = a and b or c", "1: x = a and b or c");
    row("t = {radius = r, v = 2}", "1: t = |1: * radius = > r|1: * v = 2");
    row("for i = 1, 3 do x = i end", "1: x = > i");
    row("if x == 1 then y = 2 end", "1: y = 2");
    row("x =\n  1", "1: x = 1");
    row("f(a)[1] = 2", "");
    row("t[1] = 2", "");
}

void TestProgramStatements::assignmentsAreFound()
{
    QFETCH(QString, source);
    QFETCH(QString, found);
    const ProgramLines program(source);
    QStringList is;
    for (const ProgramAssignment &each : assignmentsOf(program)) {
        is.append(QStringLiteral("%1: %2%3 = %4%5")
                      .arg(each.line)
                      .arg(each.isField ? QStringLiteral("* ") : QString(),
                           textOf(program, each.target, each.last + 1),
                           isHandedOn(program, each) ? QStringLiteral("> ") : QString(),
                           textOf(program, each.from, each.to)));
        QCOMPARE(each.name, program.tokens()[each.last].text);
    }
    QCOMPARE(is.join(QLatin1Char('|')), found);
}

void TestProgramStatements::functionsAreFound()
{
    const QString source = QStringLiteral("local function move(c, h)\n"       // 1
                                          "  if c then\n"                     // 2
                                          "    for i = 1, 2 do f(i) end\n"    // 3
                                          "  end\n"                           // 4
                                          "end\n"                             // 5
                                          "function self.push(v) v = 1 end\n" // 6
                                          "local turn = function(a, b)\n"     // 7
                                          "  repeat a = b until a\n"          // 8
                                          "  while a do b() end\n"            // 9
                                          "end\n"                             // 10
                                          "each(function(x)\n"                // 11
                                          "  return x\n"                      // 12
                                          "end)\n"                            // 13
                                          "function open()\n");               // 14
    const ProgramLines program(source);
    QStringList is;
    for (const ProgramFunction &each : functionsOf(program))
        is.append(QStringLiteral("%1(%2) %3-%4")
                      .arg(each.name, each.parameters.join(QLatin1Char(',')))
                      .arg(each.first)
                      .arg(each.last));
    QCOMPARE(is, (QStringList{QStringLiteral("move(c,h) 1-5"), QStringLiteral("push(v) 6-6"),
                              QStringLiteral("turn(a,b) 7-10"), QStringLiteral("(x) 11-13"),
                              QStringLiteral("open() 14-15")}));
}

void TestProgramStatements::innermostFunctionIsTold()
{
    const QString source = QStringLiteral("x = 1\nfunction outer()\n  local inner = function()\n"
                                          "    y = 2\n  end\n  z = 3\nend\nw = 4");
    const auto functions = functionsOf(ProgramLines(source));
    const char *expected[] = {"", "outer", "inner", "inner", "inner", "outer", "outer", ""};
    for (int line = 1; line <= 8; ++line) {
        const ProgramFunction *function = functionAt(functions, line);
        QCOMPARE(function ? function->name : QString(), QLatin1String(expected[line - 1]));
    }
}

void TestProgramStatements::unusedFunctionsAreDead_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("dead");
    QTest::newRow("used") << "function a()\nend\nfunction on_update(h)\n  a()\nend"
                          << "";
    QTest::newRow("unused") << "function a()\nend\nfunction on_update(h)\nend"
                            << "1|2";
    QTest::newRow("only by itself") << "function a()\n  a()\nend\nfunction on_load()\nend"
                                    << "1|2|3";
    QTest::newRow("only by a dead one")
        << "function a()\nend\nfunction b()\n  a()\nend\nfunction on_load()\nend"
        << "1|2|3|4|5";
    QTest::newRow("without a name") << "each(function()\n  x = 1\nend)"
                                    << "";
    QTest::newRow("given on") << "local a = function()\nend\non_update = a"
                              << "";
}

void TestProgramStatements::unusedFunctionsAreDead()
{
    QFETCH(QString, source);
    QFETCH(QString, dead);
    QCOMPARE(lines(deadLines(ProgramLines(source))).join(QLatin1Char('|')), dead);
}

void TestProgramStatements::copiesAreFound_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("copies");
    QTest::newRow("local") << "local r = circle1.radius"
                           << "r";
    QTest::newRow("field") << "self.r = c.radius"
                           << "r";
    QTest::newRow("in a table") << "t = {size = c.radius, d = c.density}"
                                << "size";
    QTest::newRow("several") << "local r, x, s = a.radius, a.x, b.radius"
                             << "r|s";
    QTest::newRow("worked out") << "local r = 2 * c.radius"
                                << "";
    QTest::newRow("another field") << "local r = c.position"
                                   << "";
    QTest::newRow("from calls") << "local r, s = radii()"
                                << "";
}

void TestProgramStatements::copiesAreFound()
{
    QFETCH(QString, source);
    QFETCH(QString, copies);
    const ProgramLines program(source);
    QCOMPARE(copiesOf(program, assignmentsOf(program), {QStringLiteral("radius")})
                 .join(QLatin1Char('|')),
             copies);
}

void TestProgramStatements::valuesAreNamedOnce_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("values");
    QTest::newRow("names") << "a + b * a"
                           << "a|b";
    QTest::newRow("last of each") << "self.v + c.position.x"
                                  << "v|x";
    QTest::newRow("no functions") << "math.sqrt(d) + n:length()"
                                  << "d";
    QTest::newRow("no tables") << "list[i] - 2"
                               << "i";
    QTest::newRow("none") << "2 * 'a'"
                          << "";
}

void TestProgramStatements::valuesAreNamedOnce()
{
    QFETCH(QString, source);
    QFETCH(QString, values);
    const ProgramLines program(source);
    QCOMPARE(valuesIn(program, 0, program.tokens().size()).join(QLatin1Char('|')), values);
}

QTEST_GUILESS_MAIN(TestProgramStatements)
#include "test_program_statements.moc"
