// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/begun_line.h"
#include "tasks/judging/unset_line.h"

#include <QTest>

using namespace cradle;

/// The line that gives what a run begins with, or that should.
class TestStartLines : public QObject
{
    Q_OBJECT
private slots:
    void lineThatBegins_data();
    void lineThatBegins();
    void lineThatSetsNothing_data();
    void lineThatSetsNothing();
};

void TestStartLines::lineThatBegins_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("last");
    QTest::addColumn<bool>("isPosition");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const char *program, int last, int line,
                        bool isPosition = false) {
        QTest::newRow(name) << QString::fromUtf8(program) << last << isPosition << line;
    };
    row("a number", "v = 2\nfunction on_update(h)\n  circle1.velocity = vec(v, 0)\nend", 3, 1);
    row("a vector", "v = vec(2, 0)\nfunction on_update(h)\n  circle1.velocity = v\nend", 3, 1);
    row("taken over", "v = circle1.velocity\nfunction on_update(h)\n  circle1.velocity = v\nend", 3,
        0);
    row("a part of it",
        "v = circle1.velocity.x\nfunction on_update(h)\n  "
        "circle1.velocity = vec(v, 0)\nend",
        3, 0);
    row("worked out of it",
        "v = circle1.velocity * 0\nfunction on_update(h)\n  circle1.velocity = v\nend", 3, 1);
    row("worked out of the other, for a place",
        "p = circle1.velocity * 0\nfunction on_update(h)\n  circle1.position = p\nend", 3, 0, true);
    row("place", "p = circle1.position * 0\nfunction on_update(h)\n  circle1.position = p\nend", 3,
        1, true);
    row("in a table", "b = { v = vec(2, 0) }\nfunction on_update(h)\n  c.velocity = b.v\nend", 3,
        1);
    row("in a function of the start",
        "function make()\n  return { v = vec(2, 0) }\nend\nb = make()\nfunction on_update(h)\n"
        "  c.velocity = b.v\nend",
        6, 2);
    row("in a function of every step",
        "function make()\n  return { v = vec(2, 0) }\nend\nfunction on_update(h)\n  b = make()\n"
        "  c.velocity = b.v\nend",
        6, 0);
    row("in a function that nobody calls",
        "function make()\n  return { v = vec(2, 0) }\nend\nfunction on_update(h)\n"
        "  c.velocity = b.v\nend",
        5, 0);
    row("in rows",
        "x, y = {}, {}\nfunction on_load()\n  x[1], y[1] = 1, c.velocity.y\nend\n"
        "function on_update(h)\n  c.velocity = vec(x[1], y[1])\nend",
        6, 3);
    row("rows of rows",
        "function on_load()\n  v[1][2] = 3\nend\nfunction on_update(h)\n"
        "  c.velocity = vec(v[1][2], 0)\nend",
        5, 2);
    row("handed on in a step",
        "v = 2\nfunction on_update(h)\n  w = v\n  c.velocity = vec(w, 0)\nend", 4, 1);
    row("not what is worked out in a step",
        "v = 2\nfunction on_update(h)\n  w = v * h\n  c.velocity = vec(w, 0)\nend", 4, 0);
    row("not the start of the circle",
        "circle1.velocity = vec(2, 0)\nc.velocity = vec(1, 0)\nfunction on_update(h)\n"
        "  c.velocity = b.velocity\nend",
        4, 0);
    row("but that of a table with such a name",
        "b = { velocity = vec(1, 0) }\nfunction on_update(h)\n  c.velocity = b.velocity\nend", 3,
        1);
    row("nothing yet", "v = nil\nfunction on_update(h)\n  c.velocity = v\nend", 3, 0);
    row("two near", "x = 1\ny = 2\nfunction on_update(h)\n  c.velocity = vec(x, y)\nend", 4, 1);
    row("two far", "x = 1\n\n\n\ny = 2\nfunction on_update(h)\n  c.velocity = vec(x, y)\nend", 7,
        0);
}

void TestStartLines::lineThatBegins()
{
    QFETCH(QString, program);
    QFETCH(int, last);
    QFETCH(bool, isPosition);
    QTEST(begunLine(ProgramLines(program), last, isPosition), "line");
}

void TestStartLines::lineThatSetsNothing_data()
{
    using enum Assignment::Field;
    QTest::addColumn<QString>("program");
    QTest::addColumn<std::vector<Assignment>>("made");
    QTest::addColumn<int>("field");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const char *program, Assignment::Field field, int line,
                        const std::vector<Assignment> &made = {}) {
        QTest::newRow(name) << QString::fromUtf8(program) << made << int(field) << line;
    };
    const char *plain = "x = 1\nfunction on_load()\n  gravity = vec(0, 0)\n  y = 2\nend";
    row("set for none", plain, Radius, 2);
    row("a value of the scene", plain, Restitution, 2);
    row("no start", "x = 1\nfunction on_update(h)\nend", Radius, 0);
    row("a line that did not run", "function on_load()\n  if x then c.radius = 2 end\nend", Radius,
        0);
    row("of another field", "function on_load()\n  if x then c.radius = 2 end\nend", Density, 1);
    row("outside of the start",
        "function on_load()\nend\nfunction on_update()\n  c.radius = 2\nend", Radius, 1);
    row("above it", "c.radius = 2\nfunction on_load()\nend", Radius, 2);
    row("a key", "function on_load()\n  circles[i][key] = 2\nend", Radius, 0);
    row("a key of another table", "function on_load()\n  all[i][key] = 2\nend", Radius, 1);
    row("twice for the same", "function on_load()\n  circle1.radius = 2\n  x = 1\nend", Radius, 2,
        {{.circle = 0, .line = 2, .field = Radius}, {.circle = 0, .line = 2, .field = Radius}});
    row("another twice", "function on_load()\n  circle1.radius = 2\n  x = 1\nend", Density, 1,
        {{.circle = 0, .line = 2, .field = Radius}, {.circle = 0, .line = 2, .field = Radius}});
    row("for one by its number", "x = 1\nfunction on_load()\n  circle1.radius = 2\nend", Radius, 2,
        {{.circle = 0, .line = 3, .field = Radius}});
    row("for one of a list", "x = 1\nfunction on_load()\n  circles[1].radius = 2\nend", Radius, 2,
        {{.circle = 0, .line = 3, .field = Radius}});
    const char *loop = "function on_load()\n  y = 0\n  for i = 1, 1 do\n"
                       "    circles[i].radius = 2\n  end\nend";
    row("a loop that leaves it out", loop, Radius, 3, {{.circle = 0, .line = 4, .field = Radius}});
    row("without a loop", "function on_load()\n  i = 1\n  circles[i].radius = 2\nend", Radius, 0,
        {{.circle = 0, .line = 3, .field = Radius}});
    row("for one with a name",
        "function on_load()\n  for x = 1, 2 do c = f(x)\n  c.radius = 2\nend", Radius, 0,
        {{.circle = 0, .line = 3, .field = Radius}});
    row("elsewhere", "circle1.radius = 2\nfunction on_load()\nend\ncircle1.radius = 3", Radius, 0,
        {{.circle = 0, .line = 1, .field = Radius}});
    row("behind it", "function on_load()\nend\ncircle1.radius = 3", Radius, 0,
        {{.circle = 0, .line = 3, .field = Radius}});
}

void TestStartLines::lineThatSetsNothing()
{
    QFETCH(QString, program);
    QFETCH(std::vector<Assignment>, made);
    QFETCH(int, field);
    QTEST(unsetLine(ProgramLines(program), made, Assignment::Field(field)), "line");
}

QTEST_APPLESS_MAIN(TestStartLines)
#include "test_start_lines.moc"
