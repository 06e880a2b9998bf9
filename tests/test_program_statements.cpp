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
