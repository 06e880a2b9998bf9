// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/program_functions.h"

#include <QTest>

using namespace cradle;

/// The functions and blocks of a program, as its tokens tell them.
class TestProgramFunctions : public QObject
{
    Q_OBJECT
private slots:
    void functionsAreFound();
    void innermostFunctionIsTold();
    void unusedFunctionsAreDead_data();
    void unusedFunctionsAreDead();
    void linesOfTheStartAreKnown();
    void blocksEndWhereTheyClose_data();
    void blocksEndWhereTheyClose();
    void argumentsAreParted_data();
    void argumentsAreParted();
    void theLastValueAboveIsFound();
};

namespace {

QStringList lines(const std::set<int> &all)
{
    QStringList numbers;
    for (const int line : all)
        numbers.append(QString::number(line));
    return numbers;
}

/// Of the first token that is \p word.
std::size_t placeOf(const ProgramLines &program, const char *word)
{
    std::size_t i = 0;
    while (i < program.tokens().size() && !program.is(i, word))
        ++i;
    return i;
}

} // namespace

void TestProgramFunctions::functionsAreFound()
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

void TestProgramFunctions::innermostFunctionIsTold()
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

void TestProgramFunctions::unusedFunctionsAreDead_data()
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

void TestProgramFunctions::unusedFunctionsAreDead()
{
    QFETCH(QString, source);
    QFETCH(QString, dead);
    QCOMPARE(lines(deadLines(ProgramLines(source))).join(QLatin1Char('|')), dead);
}

void TestProgramFunctions::linesOfTheStartAreKnown()
{
    const QString source = QStringLiteral("x = 1\nfunction on_load()\n  y = 2\nend\n"
                                          "function on_update(h)\n  z = 3\nend\nw = 4");
    const auto functions = functionsOf(ProgramLines(source));
    const bool expected[] = {true, true, true, true, false, false, false, true};
    for (int line = 1; line <= 8; ++line)
        QCOMPARE(isOfStart(functions, line), expected[line - 1]);
}

void TestProgramFunctions::blocksEndWhereTheyClose_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<int>("line"); // 0: never
    QTest::newRow("if") << "if a then\nb()\nend\nc()" << 3;
    QTest::newRow("with another inside") << "if a then\nfor i = 1, 2 do\nb()\nend\nend" << 5;
    QTest::newRow("a loop's condition opens none") << "do while a do\nb()\nend\nend" << 4;
    QTest::newRow("repeat") << "if a then\nrepeat\nb()\nuntil c\nend" << 5;
    QTest::newRow("a function") << "do f(function()\nend)\nend" << 3;
    QTest::newRow("left open") << "if a then\nb()" << 0;
}

void TestProgramFunctions::blocksEndWhereTheyClose()
{
    QFETCH(QString, source);
    QFETCH(int, line);
    const ProgramLines program(source);
    const std::size_t end = endOfBlock(program, 0);
    QCOMPARE(end < program.tokens().size() ? program.tokens()[end].line : 0, line);
}

void TestProgramFunctions::argumentsAreParted_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("given"); // of f, parted by |
    QTest::newRow("none") << "f()"
                          << "";
    QTest::newRow("one") << "f(a + b)"
                         << "a + b";
    QTest::newRow("a call within") << "f(g(1, 2), -c.v)"
                                   << "g ( 1 , 2 ) | - c . v";
    QTest::newRow("a name alone") << "x = f"
                                  << "";
}

void TestProgramFunctions::argumentsAreParted()
{
    QFETCH(QString, source);
    QFETCH(QString, given);
    const ProgramLines program(source);
    QStringList all;
    for (const TokenRange &range : argumentsOf(program, placeOf(program, "f"))) {
        QStringList words;
        for (std::size_t i = range.from; i < range.to; ++i)
            words.append(program.tokens()[i].text);
        all.append(words.join(QLatin1Char(' ')));
    }
    QCOMPARE(all.join(QLatin1String(" | ")), given);
}

void TestProgramFunctions::theLastValueAboveIsFound()
{
    const QString source = QStringLiteral("function f(a)\n"    // 1
                                          "  p = a * 2\n"      // 2
                                          "  p = p + 1\n"      // 3
                                          "  p = a\n"          // 4, another's value
                                          "  self.p = 3 * a\n" // 5, a field
                                          "  use(p)\n"         // 6
                                          "  p = 7 * a\n"      // 7, below
                                          "end\n"              // 8
                                          "function g()\n"     // 9
                                          "  p = 8 * 2\n"      // 10, elsewhere
                                          "end\n");            // 11
    const ProgramLines program(source);
    const auto assignments = assignmentsOf(program);
    const auto functions = functionsOf(program);
    const auto at = [&](int line, auto counts) {
        const ProgramAssignment *found =
            lastAbove(line, QStringLiteral("p"), program, assignments, functions, counts);
        return found ? found->line : 0;
    };
    const auto any = [](const ProgramAssignment &) { return true; };
    QCOMPARE(at(6, any), 3);
    QCOMPARE(at(8, any), 7);
    QCOMPARE(at(2, any), 0);
    QCOMPARE(at(6, [](const ProgramAssignment &each) { return each.line < 3; }), 2);
}

QTEST_GUILESS_MAIN(TestProgramFunctions)
#include "test_program_functions.moc"
