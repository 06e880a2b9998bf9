// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/asked_values.h"
#include "tasks/judging/program_rows.h"

#include <QTest>

using namespace cradle;

/// The lines of a program: what they name, ask, work out, and which are like each other.
class TestProgramLines : public QObject
{
    Q_OBJECT
private slots:
    void timestepsAreKnown();
    void nearestBodiesComeFirst();
    void valuesThatNobodyTakesAreForgotten();
    void callsAndNewNamesAreTold_data();
    void callsAndNewNamesAreTold();
    void operandsEnd_data();
    void operandsEnd();
    void twinsAreFound();
    void placesAndNamesOfATwin();
    void rowsTellWhatTheyDo_data();
    void rowsTellWhatTheyDo();
    void functionOfALineIsFound();
    void askedValuesAreFound_data();
    void askedValuesAreFound();
    void distancesAreTold();
    void valueBehindIsTheOnlyOne_data();
    void valueBehindIsTheOnlyOne();
};

void TestProgramLines::timestepsAreKnown()
{
    const ProgramLines program(QStringLiteral("function on_update(step_time)\n  x = dt\nend"));
    QCOMPARE(program.timesteps(), (QStringList{QStringLiteral("step_time"), QStringLiteral("dt")}));
    QVERIFY(program.hasName(QStringLiteral("x")) && !program.hasName(QStringLiteral("end")));
    QCOMPARE(program.count(), 3);
    QCOMPARE(program.row(2), QStringLiteral("  x = dt"));
    QCOMPARE(program.startOf(2), qsizetype(30));
    QCOMPARE(program.source().mid(program.startOf(3)), QStringLiteral("end"));
    QCOMPARE(program.tokensOf(2).size(), std::size_t{3});
    QVERIFY(program.tokensOf(4).empty());
}

void TestProgramLines::nearestBodiesComeFirst()
{
    const QString source = QStringLiteral("far.position = p\n" // 1
                                          "\n"
                                          "b.radius = r\n" // 3
                                          "\n"             // 4
                                          "a.velocity = v\n"
                                          "\n"
                                          "c.position = self.d.position\n" // 7
                                          "e.density = 1\n");
    const ProgramLines program(source);
    const auto names = [](const char *text) {
        return QString::fromLatin1(text).split(QLatin1Char(' '));
    };
    QCOMPARE(program.bodiesNear(4), names("b a far")); // c is as far as far
    QCOMPARE(program.bodiesNear(7), names("c a b"));
    QCOMPARE(program.bodiesNear(12), names("c a b"));
    QCOMPARE(program.bodiesNear(17), names("c"));
    QCOMPARE(program.bodiesNear(19), QStringList());
}

void TestProgramLines::valuesThatNobodyTakesAreForgotten()
{
    QString source = QStringLiteral("local early = 1\n");
    source += QString(11, QLatin1Char('\n'));
    source += QStringLiteral("local n = a - b\nlocal u = 2\nx = u\nlocal later = 3\n"); // 13 to 16
    const ProgramLines program(source);
    QCOMPARE(program.forgotten(13), QStringList{QStringLiteral("early")});
    QCOMPARE(program.forgotten(14), QStringList{QStringLiteral("n")});
    QCOMPARE(program.forgotten(15), QStringList{QStringLiteral("n")});
    QCOMPARE(program.forgotten(17), (QStringList{QStringLiteral("n"), QStringLiteral("later")}));
}

void TestProgramLines::callsAndNewNamesAreTold_data()
{
    QTest::addColumn<QString>("row");
    QTest::addColumn<bool>("call");
    QTest::addColumn<QString>("news"); // names that a local statement gives
    QTest::newRow("call") << "  move(c, h)" << true << "";
    QTest::newRow("method") << "balls[1].move(h)" << true << "";
    QTest::newRow("value of a call") << "x = f(1)" << false << "";
    QTest::newRow("question") << "if f(1) then" << false << "";
    QTest::newRow("local") << "local a, b = c, d" << false << "a b";
    QTest::newRow("no local") << "a, b = c, d" << false << "";
}

void TestProgramLines::callsAndNewNamesAreTold()
{
    QFETCH(QString, row);
    QFETCH(bool, call);
    QFETCH(QString, news);
    const ProgramLines program(row);
    QCOMPARE(program.isCall(1), call);
    QStringList is;
    for (const std::size_t i : program.tokensOf(1)) {
        if (program.tokens()[i].kind == ProgramToken::Kind::Name && program.isNewName(i))
            is.append(program.tokens()[i].text);
    }
    QCOMPARE(is.join(QLatin1Char(' ')), news);
}

void TestProgramLines::operandsEnd_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<int>("tokens"); // of the operand that it begins with
    QTest::newRow("name") << "a + b" << 1;
    QTest::newRow("number") << "2 * c" << 1;
    QTest::newRow("field") << "a.b.c - d" << 5;
    QTest::newRow("method") << "d:length() * 2" << 5;
    QTest::newRow("index") << "t[i + 1].x == 3" << 8;
    QTest::newRow("nested") << "f(g(1), t[2]) / 3" << 12;
    QTest::newRow("group") << "(a + b) * c" << 5;
    QTest::newRow("group with a field") << "(a + b):length() < c" << 9;
    QTest::newRow("call of the next line") << "a\n(b)" << 1;
    QTest::newRow("sign") << "- a" << 0;
    QTest::newRow("open") << "f(1" << 3;
    QTest::newRow("point at the end") << "a." << 1;
}

void TestProgramLines::operandsEnd()
{
    QFETCH(QString, source);
    QFETCH(int, tokens);
    const ProgramLines program(source);
    QCOMPARE(program.afterOperand(0), std::size_t(tokens));
    QCOMPARE(program.afterOperand(program.tokens().size()), program.tokens().size());
}

void TestProgramLines::twinsAreFound()
{
    QString source = QStringLiteral("if ax > lim then ax = lim end\n" // 1
                                    "if ay > 3 then ay = lim end\n"   // 2: a number for a name
                                    "if bx > lim then bx = lim end\n" // 3
                                    "if bx < lim then bx = lim end\n" // 4: another sign
                                    "x = y\nz = w\n");                // 5, 6: too short
    source += QString(6, QLatin1Char('\n'));
    source += QStringLiteral("if cx > lim then cx = lim end\n"   // 13
                             "if cy > lim then cy = lim end\n"); // 14
    const ProgramLines program(source);
    QCOMPARE(program.twinsOf(1), (std::vector<int>{3, 13}));
    QCOMPARE(program.twinsOf(3), (std::vector<int>{1, 13, 14}));
    QVERIFY(program.twinsOf(2).empty() && program.twinsOf(4).empty());
    QVERIFY(program.twinsOf(5).empty() && program.twinsOf(8).empty());
}

void TestProgramLines::placesAndNamesOfATwin()
{
    const QString source = QStringLiteral("first.x = 12 + u\nb.x = 3 + way");
    const ProgramLines program(source);
    const auto at = [&](const char *word) { return source.indexOf(QLatin1String(word)); };
    QCOMPARE(program.placeIn(1, 2, at("12")), std::optional(at("3 +")));
    QCOMPARE(program.placeIn(1, 2, at(" + u")), std::optional(at(" + way")));
    QCOMPARE(program.placeIn(1, 2, at("irst")), std::optional<qsizetype>());
    QCOMPARE(program.placeIn(2, 1, at("way")), std::optional(at("u\n")));
    QCOMPARE(program.inTwin(QStringLiteral("first.y - 2 * u"), 1, 2),
             QStringLiteral("b.y - 2 * way"));
    QCOMPARE(program.inTwin(QStringLiteral("us"), 1, 2), QStringLiteral("us"));
}

void TestProgramLines::rowsTellWhatTheyDo_data()
{
    QTest::addColumn<QString>("row");
    QTest::addColumn<bool>("comparing");
    QTest::addColumn<int>("work");
    QTest::addColumn<bool>("wall");
    QTest::newRow("product") << "x = a * b / c ^ 2" << false << 6 << false;
    QTest::newRow("sum") << "x = a + b - c" << false << 2 << false;
    QTest::newRow("both") << "local j = (1 + e) * u / (m1 + m2)" << false << 6 << false;
    QTest::newRow("return") << "return a * b" << false << 2 << false;
    QTest::newRow("place") << "c.position = c.position + c.velocity * h" << false << 0 << false;
    QTest::newRow("question") << "if a * b < c then" << true << 0 << false;
    QTest::newRow("equal") << "if a * b == c then" << false << 0 << false;
    QTest::newRow("at most") << "while a <= b * 2 do" << true << 0 << false;
    QTest::newRow("other") << "if a ~= b * 2 then" << false << 0 << false;
    QTest::newRow("wall") << "if x > square.right then" << true << 0 << true;
    QTest::newRow("half") << "local room = half_width - r" << false << 1 << true;
    QTest::newRow("part of a name") << "if x > topmost then" << true << 0 << false;
}

void TestProgramLines::rowsTellWhatTheyDo()
{
    QFETCH(QString, row);
    QFETCH(bool, comparing);
    QFETCH(int, work);
    QFETCH(bool, wall);
    QCOMPARE(compares(row), comparing);
    QCOMPARE(worksOut(row), work);
    QCOMPARE(asksForWall(row), wall);
    const QString local = QStringLiteral("  local gap = 1");
    QCOMPARE(takes(QStringLiteral("if gap < 0"), local), true);
    QCOMPARE(takes(QStringLiteral("if gaps < 0"), local), false);
    QCOMPARE(takes(QStringLiteral("if gap < 0"), QStringLiteral("gap = 1")), false);
    QCOMPARE(withName(QStringLiteral("a.v = a_1 * (ba - a) + va.a"), QStringLiteral("a"),
                      QStringLiteral("other")),
             QStringLiteral("other.v = a_1 * (ba - other) + va.other"));
    QCOMPARE(rowsOf(QStringLiteral("x = 1 -- one\n--\ny")),
             (QStringList{QStringLiteral("x = 1 "), QString(), QStringLiteral("y")}));
}

void TestProgramLines::functionOfALineIsFound()
{
    const QStringList rows = QStringLiteral("x = 1\n"               // 1
                                            "function a()\n"        // 2
                                            "  f(function() end)\n" // 3: whole, within a
                                            "end\n"                 // 4
                                            "function b() end\n"    // 5
                                            "function c()\n"        // 6
                                            "end")                  // 7
                                 .split(QLatin1Char('\n'));
    const auto range = [&](int line) {
        const RowRange found = functionOf(rows, line);
        return std::pair(found.first, found.last);
    };
    QCOMPARE(range(1), std::pair(1, 1));
    for (const int line : {2, 3, 4, 5})
        QCOMPARE(range(line), std::pair(2, 5));
    QCOMPARE(range(6), std::pair(6, 7));
    QCOMPARE(range(7), std::pair(6, 7));
}

void TestProgramLines::askedValuesAreFound_data()
{
    QTest::addColumn<QString>("question");
    QTest::addColumn<QString>("found"); // lines, with r where it is a reach
    const auto row = [](const char *question, const char *found) {
        QTest::newRow(question) << QString::fromLatin1(question) << QString::fromLatin1(found);
    };
    row("if gap < 0 then", "3r");
    row("if gap <= 0 then", "3r");
    row("if 0 > gap then", "3r");
    row("if 0 >= gap then", "3r");
    row("if u > 0 then", "4");
    row("if gap < 0 and u > 0 then", "3r 4");
    row("if (gap < 0) or (u > 0) then", "3r 4");
    row("if gap == 0 then", "");
    row("if gap < u then", "");
    row("if gap - 1 < 0 then", "");
    row("if gap < 0 - 1 then", "");
    row("if p.gap < 0 then", "");
    row("if copy > 0 then", "");
    row("if given > 0 then", "");
    row("if elsewhere > 0 then", "");
    row("x = u < 0 and 1", "");
}

/// What was worked out in the same function above it, not a copy.
void TestProgramLines::askedValuesAreFound()
{
    QFETCH(QString, question);
    QFETCH(QString, found);
    const ProgramLines program(QStringLiteral("local elsewhere = 1 + 2\n"               // 1
                                              "function on_update(h)\n"                 // 2
                                              "  local gap = d - a.radius - b.radius\n" // 3
                                              "  local u = v:dot(n) * 2\n"              // 4
                                              "  local copy = self.v\n"                 // 5
                                              "  given = 3 * h\n"                       // 6
                                              "  %1\n"
                                              "end")
                                   .arg(question));
    const AskedValues asked(program);
    QStringList is;
    for (const AskedValue &value : asked.of(7))
        is.append(QString::number(value.line) + (value.isReach ? QStringLiteral("r") : QString()));
    QCOMPARE(is.join(QLatin1Char(' ')), found);
    QCOMPARE(asked.isJoined(7),
             question.contains(QLatin1String(" and ")) || question.contains(QLatin1String(" or ")));
    QCOMPARE(asked.asksReach(7), found.contains(QLatin1Char('r')));
}

void TestProgramLines::distancesAreTold()
{
    const ProgramLines program(QStringLiteral("local r = c.radius\n"
                                              "if d < a.radius + b.radius then\n"
                                              "if d < 2 * r then\n"
                                              "if d < reach then\n"
                                              "\n"));
    const AskedValues asked(program);
    QVERIFY(asked.asksReach(2));
    QVERIFY(asked.asksReach(3));
    QVERIFY(!asked.asksReach(4));
    QVERIFY(!asked.asksReach(5));
}

void TestProgramLines::valueBehindIsTheOnlyOne_data()
{
    QTest::addColumn<QString>("row");
    QTest::addColumn<int>("reach"); // the line of the value with a radius
    QTest::addColumn<int>("other"); // and of that without one
    QTest::newRow("a distance") << "if d:length() < room then" << 1 << 0;
    QTest::newRow("another") << "if u > 0 then" << 0 << 2;
    QTest::newRow("both") << "if u > room then" << 1 << 2;
    QTest::newRow("two") << "if u > w then" << 0 << 0;
    QTest::newRow("twice the same") << "if u * u > 1 then" << 0 << 2;
    QTest::newRow("a part of it") << "if u.x > 1 then" << 0 << 0;
    QTest::newRow("none") << "if z > 1 then" << 0 << 0;
}

void TestProgramLines::valueBehindIsTheOnlyOne()
{
    QFETCH(QString, row);
    QFETCH(int, reach);
    QFETCH(int, other);
    const ProgramLines program(QStringLiteral("local room = 4 - c.radius\n"
                                              "local u = a * n\n"
                                              "local w = b * n\n")
                               + row);
    const AskedValues asked(program);
    QCOMPARE(asked.valueBehind(4, true), reach);
    QCOMPARE(asked.valueBehind(4, false), other);
}

QTEST_GUILESS_MAIN(TestProgramLines)
#include "test_program_lines.moc"
