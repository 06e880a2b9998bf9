// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/line_test.h"

#include "tasks/reading/lab_reader.h"

using namespace cradle;
using namespace cradle::programs;

/// Where circles or walls are met at a wrong place or moment, or a wall answers wrongly, the line
/// that asks, or works out what is asked, is marked.
class TestLineOfQuestion : public LineTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void findingMarksTheLine_data();
    void findingMarksTheLine() { compareLine(); }
};

/// The flat program, which reads the velocities of the circles before the first step only.
static QString takenOver()
{
    QString program = QString::fromLatin1(flat);
    const QString line = program.section(u'\n', 6, 7);
    program.replace(line,
                    QStringLiteral("  local ax, ay = circle1.position.x, circle1.position.y\n"
                                   "  local bx, by = circle2.position.x, circle2.position.y"));
    program.replace(QStringLiteral("function on_update(h)"),
                    QStringLiteral("function on_update(h)\n"
                                   "  local avx, avy, bvx, bvy = own[1], own[2], own[3], own[4]"));
    const qsizetype start = program.indexOf(QStringLiteral("end\n")); // of on_load
    program.insert(start, QStringLiteral("  local v = circle1.velocity\n"
                                         "  own[1], own[2] = v.x, v.y\n"
                                         "  local w = circle2.velocity\n"
                                         "  own[3], own[4] = w.x, w.y\n"));
    program.insert(program.lastIndexOf(QStringLiteral("end\n")),
                   QStringLiteral("  own[1], own[2], own[3], own[4] = avx, avy, bvx, bvy\n"));
    return QStringLiteral("own = {}\n") + program;
}

void TestLineOfQuestion::findingMarksTheLine_data()
{
    addColumns();
    row("one wall among one-line questions", flat, "bvx = math.abs(bvx)", "bvx = -math.abs(bvx)");
    row("a wall asks for the other", flat, "if by > lim2", "if ay > lim2");
    row("test of approach the wrong way round", flat, "if u > w", "if u < w");
    row("contact too early", flat, "circle2.radius then", "circle2.radius + 0.1 then");
    row("missing wall", flat, "if by < -lim2 then by = -lim2 bvy = math.abs(bvy) end", "", false);
    row("one coordinate for the distance", objects, "d:length() >=", "math.abs(d.x) >=");
    row("radii multiplied", flat, "circle1.radius + circle2.radius then",
        "circle1.radius * circle2.radius then");
    row("distance squared, sum not", objects, "d:length() >= a.radius() + b.radius()",
        "d:length_squared() >= a.radius() + b.radius()");
    row("degrees", flat, "local d = math.sqrt(dx * dx + dy * dy)",
        "local d = math.sqrt(dx * dx + dy * dy) * 180 / math.pi");
    row("second circle left out of the loop", objects, "for _, b in ipairs(balls) do b.move(h) end",
        "for i = 1, 1 do balls[i].move(h) end");
    row("setter: approach inverted", objects, "if u <= 0", "if u >= 0");
    row("setter: contact", objects, ">= a.radius() + b.radius()", ">= a.radius()");
    row("own numbers: some speed lost at a wall", flat, "bvy = math.abs(bvy)",
        "bvy = math.abs(bvy) * 0.4 + 0.1");
    row("own table: some speed lost at the walls", tables, "s.v - 2 * into * w",
        "s.v - (1 + 0.4) * into * w");
    row("own table: turned round", tables, "s.v - 2 * into * w", "-s.v");
    row("own table: depth of two that touch", tables, "local depth = a.r + b.r - (b",
        "local depth = 0.8 * (a.r + b.r) - 0.01 - (b");
    row("gap between two", weighed, "line:length() - a.radius - b.radius",
        "line:length() - 0.9 * (a.radius + b.radius) - 0.01");
    row("setter: answered once", objects, "if u <= 0 then return end",
        "if u <= 0 or balls.done then return end balls.done = true");
    row("approach faster than a threshold", weighed, "if closing <= 0", "if closing <= 0.05");
    row("setter: approach along x alone", objects, "if u <= 0 then",
        "if a.velocity().x <= b.velocity().x then");
    row("walls some mm early, by a value for all", objects, "square.half_width - c.radius\n",
        "square.half_width - 1.05 * c.radius\n");
    row("only those that go to the right", flat, "if u > w then", "if u > w and avx > 0 then");
    row("setter: only in the upper half", objects, "if u <= 0 then",
        "if u <= 0 or a.place().y < 0 then");
    row("distance of another formula", flat, "dx * dx + dy * dy)", "dx * dx)");
    row("setter: no walls of its own", objects, "for _, b in ipairs(balls) do b.walls() end", "",
        false);
    row("an answer that never comes, of walls in a list", tables, "depth < 0 and into > 0",
        "depth < 0 and into < 0");
    row("a normal too short", tables, "vec(0, 1), vec(0, -1)", "vec(0, 1), vec(0, -0.5)");
    row("a normal along two coordinates", tables, "vec(1, 0), vec", "vec(1, 1), vec");
    row("a normal the wrong way round", tables, "vec(1, 0), vec(-1, 0)", "vec(-1, 0), vec(-1, 0)");
    row("a metre too late", tables, "depth < 0 and", "depth < -1 and");
    row("the floor, at times, by another coordinate", weighed, "p.y * v.y > 0", "p.x * v.y > 0");
    rowOfStep("one circle put where the other was", "L42T5", QString::fromLatin1(walled),
              "c.position = vec(old.x, p.y)", "circle1.position = vec(old.x, p.y)");
    rowOfStep("own numbers, taken over once", "L42T12", takenOver(), "= v.x, v.y", "= v.x, v.x");
    rowOfStep("own value: turned round at floor and ceiling", "L42T5", QString::fromLatin1(walled),
              "v = vec(v.x, -v.y)", "v = -v");
}

QTEST_GUILESS_MAIN(TestLineOfQuestion)

#include "test_line_of_question.moc"
