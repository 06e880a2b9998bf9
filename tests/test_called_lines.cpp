// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/called_lines.h"
#include "tasks/judging/lone_lines.h"
#include "tasks/judging/program_rows.h"
#include "tasks/judging/telling_lines.h"

#include <QTest>

using namespace cradle;

/// The line at fault where another only calls what is wrong, takes it or lacks it.
class TestCalledLines : public QObject
{
    Q_OBJECT
private slots:
    void functionIsAsked_data();
    void functionIsAsked();
    void callIsOfOneCircle_data();
    void callIsOfOneCircle();
    void timestepIsGiven_data();
    void timestepIsGiven();
    void turnIsNotWritten_data();
    void turnIsNotWritten();
    void wallIsNamed_data();
    void wallIsNamed();
    void hitIsRemembered_data();
    void hitIsRemembered();
};

void TestCalledLines::functionIsAsked_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("suspect");
    QTest::addColumn<int>("topic");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const char *program, Suspect suspect, int line,
                        Topic topic = Topic::Other) {
        QTest::newRow(name) << QString::fromUtf8(program) << int(suspect) << int(topic) << line;
    };
    const char *gap = "function gap(a, b)\n  return d - a.radius - b.radius\nend\n"
                      "if gap(a, b) < 0 then x() end";
    row("what is less than nothing", gap, Suspect::Reach, 2);
    row("no reach", gap, Suspect::Question, 0);
    row("a distance", gap, Suspect::Question, 2, Topic::Distance);
    const char *beside = "function far(a, b)\n  return (b - a):length()\nend\n"
                         "if far(a, b) < circle1.radius then y = 1 end";
    row("a radius beside it", beside, Suspect::Reach, 0);
    row("the distance beside a radius", beside, Suspect::Reach, 2, Topic::Distance);
    row("a sum beside it", "function far(a)\n  return a:length()\nend\nif far(a) < k + l then",
        Suspect::Reach, 0);
    row("two ways back",
        "function gap(a)\n  if a then return 1 end\n  return 2\nend\nif gap(a) < 0 then",
        Suspect::Reach, 0);
    row("two functions",
        "function f(a)\n  return 1\nend\nfunction g(a)\n  return 2\nend\n"
        "if f(a) < g(b) then",
        Suspect::Reach, 0);
    row("none", "function f(a)\n  return 1\nend\nif h(a) < 0 then", Suspect::Reach, 0);
    row("what is given nothing", "function f()\n  return 1\nend\nif f() < 0 then", Suspect::Reach,
        0);
    row("itself", "function f(a)\n  x = 1\n  if f(a) < 0 then return 1 end end", Suspect::Reach, 0);
}

void TestCalledLines::functionIsAsked()
{
    QFETCH(QString, program);
    QFETCH(int, suspect);
    QFETCH(int, topic);
    LawDeviation deviation;
    deviation.suspect = Suspect(suspect);
    deviation.topic = Topic(topic);
    const ProgramLines lines(program);
    QTEST(askedOfFunction(deviation, lines, lines.count()), "line");
    QCOMPARE(askedOfFunction(deviation, lines, 0), 0);
    QCOMPARE(askedOfFunction(deviation, lines, lines.count() + 1), 0);
}

void TestCalledLines::callIsOfOneCircle_data()
{
    QTest::addColumn<QString>("calls");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const char *calls, int line) {
        QTest::newRow(name) << QString::fromUtf8(calls) << line;
    };
    row("each with its number", "kick(circle1, h)\n  kick(circle2, h / 2)", 6);
    row("the first of two", "kick(circle2, h)\n  kick(circle1, h)\n  kick(circle2, h)", 5);
    row("of a list", "kick(circles[1], h)\n  kick(circles[2], h)", 6);
    row("for that one alone", "kick(circle2, h)", 0);
    row("for the other alone", "kick(circle1, h)", 0);
    row("for all", "for i = 1, 2 do kick(circles[i], h) end", 0);
    row("for any", "kick(circle1, h)\n  kick(c, h)\n  kick(circle2, h)", 0);
    row("by another name", "other = kick\n  kick(circle1, h)\n  kick(circle2, h)", 0);
}

void TestCalledLines::callIsOfOneCircle()
{
    QFETCH(QString, calls);
    const QString program =
        QStringLiteral("function kick(c, h)\n  c.velocity = c.velocity + g * h\n"
                       "end\nfunction on_update(h)\n  %1\nend")
            .arg(calls);
    LawDeviation deviation;
    deviation.moment.circles = {1};
    deviation.moment.stage.pinned = false; // in the own scene
    QCOMPARE(callForOne(deviation, ProgramLines(program), 2), 0);
    deviation.moment.stage.pinned = true;
    deviation.isConditional = true;
    QCOMPARE(callForOne(deviation, ProgramLines(program), 2), 0);
    deviation.isConditional = false;
    QTEST(callForOne(deviation, ProgramLines(program), 2), "line");
    QCOMPARE(callForOne(deviation, ProgramLines(program), 5), 0);
    // What names a circle does not do the same for each.
    QString named = program;
    named.replace(QLatin1String("= c.velocity"), QLatin1String("= circle1.velocity"));
    QCOMPARE(callForOne(deviation, ProgramLines(named), 2), 0);
    deviation.moment.circles = {0, 1};
    QCOMPARE(callForOne(deviation, ProgramLines(program), 2), 0);
    deviation.moment.circles = {1};
    deviation.aspect = Aspect::Walls;
    QCOMPARE(callForOne(deviation, ProgramLines(program), 2), 0);
}

void TestCalledLines::timestepIsGiven_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("last");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const char *program, int last, int line) {
        QTest::newRow(name) << QString::fromUtf8(program) << last << line;
    };
    row("a number of the step", "function on_update()\n  local h = 1 / 60\n  p = p + v * h\nend", 3,
        2);
    row("of the file", "local H = 0.02\nfunction on_update()\n  p = p + v * H\nend", 3, 1);
    row("counted", "local t = 0\nfunction on_update()\n  t = t + 1 / 60\n  p = p0 + v * t\nend", 4,
        3);
    row("rounded", "function on_update(h)\n  h = math.floor(h * 60) / 60\n  p = p + v * h\nend", 3,
        2);
    row("that of the step", "function on_update(h)\n  p = p + v * h\nend", 2, 0);
    row("handed on", "function on_update(h)\n  local t = h\n  p = p + v * t\nend", 3, 0);
    row("nothing yet", "local h = 0\nfunction on_update()\n  p = p + v * h\nend", 3, 0);
    row("given to a function",
        "function move(h)\n  p = p + v * h\nend\nfunction on_update()\n  move(1 / 60)\nend", 2, 5);
    row("another number given",
        "function move(k, h)\n  p = p + v * h\nend\nfunction on_update(h)\n  move(2, h)\nend", 2,
        0);
    row("in a function",
        "function way(v)\n  return v / 60\nend\nfunction on_update(h)\n"
        "  p = p + way(v)\nend",
        5, 2);
    row("in none",
        "function way(v, h)\n  return v * h\nend\nfunction on_update(h)\n"
        "  p = p + way(v, h)\nend",
        5, 0);
    row("two of them",
        "local k = 2\nfunction on_update()\n  local h = 1 / 60\n  p = p + k * v * h\nend", 4, 0);
    row("a field of that name", "h = 1 / 60\nfunction on_update()\n  p = p + v * c.h\nend", 3, 0);
    row("no line", "h = 1 / 60", 0, 0);
    row("behind the program", "h = 1 / 60", 2, 0);
}

void TestCalledLines::timestepIsGiven()
{
    QFETCH(QString, program);
    QFETCH(int, last);
    QTEST(timestepGiven(ProgramLines(program), last), "line");
}

void TestCalledLines::turnIsNotWritten_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<std::vector<int>>("now");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const char *program, const std::vector<int> &now,
                        int line) {
        QTest::newRow(name) << QString::fromUtf8(program) << now << line;
    };
    const char *kept = "c.velocity = v\nif hit then\n  c.position = old\n  vx = -vx\nend";
    row("a variable", kept, {1, 2, 3, 4}, 4);
    row("that did not run", kept, {1, 2, 3}, 0);
    row("a vector", "c.velocity = v\nif hit then\n  v = vec(-v.x, v.y)\nend", {1, 2, 3}, 3);
    row("a row", "c.velocity = v\nif hit then\n  v[i] = -v[i]\nend", {1, 2, 3}, 3);
    row("by its amount", "c.velocity = v\nif hit then\n  vx = math.abs(vx)\nend", {1, 2, 3}, 3);
    row("the first", "c.velocity = v\nif hit then\n  vx = -vx\n  vy = -vy\nend", {1, 2, 3, 4}, 3);
    row("a limit", "c.velocity = v\nif hit then\n  x = -limit\nend", {1, 2, 3}, 0);
    row("a difference", "c.velocity = v\nif hit then\n  x = x - limit\nend", {1, 2, 3}, 0);
    row("a place", "c.velocity = v\nif hit then\n  c.position = vec(-c.position.x, 0)\nend",
        {1, 2, 3}, 0);
    row("that is written", "c.velocity = v\nif hit then\n  vx = -vx\n  c.velocity = vx\nend",
        {1, 2, 3, 4}, 0);
    row("in a step that sets no velocity", "c.position = p\nif hit then\n  vx = -vx\nend",
        {1, 2, 3}, 1);
    row("that sets the place in a hit", "x = 1\nif hit then\n  vx = -vx c.position = p\nend",
        {1, 2, 3}, 3);
    row("that turns none", "c.position = p\nif hit then\n  x = 2\nend", {1, 2, 3}, 0);
}

void TestCalledLines::turnIsNotWritten()
{
    QFETCH(QString, program);
    QFETCH(std::vector<int>, now);
    RanLines ran{{now.begin(), now.end()}, {1, 2}};
    LawDeviation deviation;
    deviation.topic = Topic::Held;
    QTEST(unwrittenTurn(deviation, ProgramLines(program), ran), "line");
    deviation.topic = Topic::Other;
    QCOMPARE(unwrittenTurn(deviation, ProgramLines(program), ran), 0);
}

void TestCalledLines::wallIsNamed_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const char *program, int line) {
        QTest::newRow(name) << QString::fromUtf8(program) << line;
    };
    row("in a question", "x = 1\nif p.y < square.bottom then x = 2 end", 2);
    row("in a call", "x = 1\nhit(square.bottom)", 2);
    row("in a table", "walls = {\n  { n, square.bottom },\n}", 2);
    row("taken for later", "x = 1\nlow = square.bottom", 0);
    row("with another", "x = 1\nif y < square.bottom or y > square.top then x = 2 end", 0);
    row("twice", "if y < square.bottom then x = 2 end\nif y < square.bottom then x = 3 end", 0);
    row("in what never runs", "function no()\n  if y < square.bottom then x = 2 end\nend", 0);
    row("of another table", "x = 1\nif y < all.bottom then x = 2 end", 0);
    row("of that circle", "x = 1\nif circle2.y < square.bottom then x = 2 end", 2);
    row("of another circle", "x = 1\nif circle1.y < square.bottom then x = 2 end", 0);
}

void TestCalledLines::wallIsNamed()
{
    QFETCH(QString, program);
    LawDeviation deviation;
    deviation.moment.circles = {1};
    QCOMPARE(lineOfWall(deviation, ProgramLines(program)), 0);
    deviation.wall = Wall::Bottom;
    QTEST(lineOfWall(deviation, ProgramLines(program)), "line");
    deviation.wall = Wall::Left;
    QCOMPARE(lineOfWall(deviation, ProgramLines(program)), 0);
}

void TestCalledLines::hitIsRemembered_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const char *program, int line) {
        QTest::newRow(name) << QString::fromUtf8(program) << line;
    };
    row("a flag",
        "was = false\nfunction on_update()\n  near = d < 1\n"
        "  if near and not was then\n    was = true\n  end\nend",
        4);
    row("nothing yet",
        "last = nil\nfunction on_update()\n  if last and x then\n    last = d\n"
        "  end\nend",
        3);
    row("what nothing notes", "was = false\nfunction on_update()\n  if not was then x = 1 end\nend",
        0);
    row("what the start does not have",
        "function on_update()\n  if not was then was = true end\nend", 0);
    row("a number", "was = 2\nfunction on_update()\n  if was then was = 3 end\nend", 0);
    row("that is only noted",
        "was = false\nfunction on_update()\n  if x then y = 1 end\n  was = x\n"
        "end",
        0);
}

void TestCalledLines::hitIsRemembered()
{
    QFETCH(QString, program);
    LawDeviation deviation;
    deviation.aspect = Aspect::Contact;
    deviation.suspect = Suspect::Question;
    deviation.topic = Topic::Memory;
    const ProgramLines lines(program);
    RanLines ran;
    for (int line = 0; line <= lines.count() + 1; ++line) // those outside are of no line
        ran.now.insert(line);
    const auto lineOf = [&](const RanLines &of) {
        return tellingLine(deviation, lines, rowsOf(program), of, 0, [](int) { return false; });
    };
    QTEST(lineOf(ran), "line");
    QCOMPARE(lineOf({}), 0);
    deviation.topic = Topic::Other;
    QCOMPARE(lineOf(ran), 0);
}

QTEST_APPLESS_MAIN(TestCalledLines)
#include "test_called_lines.moc"
