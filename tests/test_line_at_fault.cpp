// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/line_test.h"

#include "tasks/reading/lab_reader.h"

using namespace cradle;
using namespace cradle::programs;

/// Where what a hit does is wrong, the line that works it out is marked, or none if one is missing.
class TestLineAtFault : public LineTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void findingMarksTheLine_data();
    void findingMarksTheLine() { compareLine(); }
};

void TestLineAtFault::findingMarksTheLine_data()
{
    addColumns();
    row("nothing wrong", flat, "nx, ny = dx / d", "nx, ny = dx / d", false);
    row("normal of two numbers", flat, "dx / d, dy / d", "dx, dy");
    row("normal exchanged", flat, "dx / d, dy / d", "dy / d, dx / d");
    row("normal: one of two numbers", flat, "dx / d, dy / d", "dx / d, dy");
    row("speed of one circle for both", objects, "dot(a.velocity() - b.velocity(), n)",
        "dot(a.velocity(), n)");
    row("angle of a ratio", angles, "math.atan(d.y, d.x)", "math.atan(d.y / d.x)");
    row("angle by its cosine", angles, "math.atan(d.y, d.x)", "math.acos(d.x / d:length())");
    row("turned back the wrong way", angles, "turned(v, -f)", "turned(v, f)");
    row("own frame forgotten, first circle", frame, "a.velocity = base + rel - push",
        "a.velocity = rel - push");
    row("own frame forgotten, second circle", frame, "b.velocity = base + push",
        "b.velocity = push");
    row("a number in both pushes: the first", frame,
        "a.velocity = base + rel - push\n  b.velocity = base + push",
        "a.velocity = base + rel - 1.3 * push\n  b.velocity = base + 1.3 * push");
    row("lost a little before the answer", frame, "  local base = b.velocity",
        "  a.velocity = a.velocity * 0.99 local base = b.velocity");
    row("lengths that are asked to be equal", frame, "if d:length() >= a.radius + b.radius then",
        "if not (d:length() == a.radius + b.radius) then");
    rowOfStep("walls of one circle alone", "L42T5", QString::fromLatin1(walled),
              "  keep(circle1, old1)\n  keep(circle2, old2)", "  keep(circle1, old1)");
    row("what is kept, for what is given", flat, "avx * nx + avy * ny",
        "avx - (avx * nx + avy * ny)");
    row("setter: normal", objects, "d:normalized()", "d");
    row("setter: push on one", objects, "b.velocity() + u * n", "b.velocity() - u * n");
    row("own table: one of two pushes", tables, "b.v + closing * n", "b.v + 0.3 * closing * n");
    row("own numbers: a push that goes on with a speed", flat,
        "local w = bvx * nx + bvy * ny\n    if u > w then\n      avx = avx + (w - u) * nx\n"
        "      avy = avy + (w - u) * ny\n      bvx = bvx + (u - w) * nx\n"
        "      bvy = bvy + (u - w) * ny",
        "local j = (u - bvx * nx - bvy * ny) * 0.6 - 0.001\n    if j > 0 then\n"
        "      avx = avx - j * nx\n      avy = avy - j * ny\n      bvx = bvx + j * nx\n"
        "      bvy = bvy + j * ny");
    row("own numbers: along x alone", flat,
        "avx = avx + (w - u) * nx\n      avy = avy + (w - u) * ny\n"
        "      bvx = bvx + (u - w) * nx\n      bvy = bvy + (u - w) * ny",
        "avx, bvx = bvx, avx");
    row("own numbers: whole velocities", flat,
        "avx = avx + (w - u) * nx\n      avy = avy + (w - u) * ny\n"
        "      bvx = bvx + (u - w) * nx\n      bvy = bvy + (u - w) * ny",
        "avx, avy, bvx, bvy = bvx, bvy, avx, avy");
    row("e: in a line with less work than others", rebounds, "mean + e * (mean - w)",
        "mean + e * e * (mean - w)");
    row("e: multiplies all", rebounds, "mean + e * (mean - u)", "e * (mean + mean - u)");
    row("masses: nothing wrong", weighed, "2 * m", "2 * m", false);
    row("masses: numbers, and functions that nobody calls", weighed,
        "local ma, mb = mass_of(a), mass_of(b)\n  local m = ma * mb / (ma + mb)\n"
        "  local p = 2 * m * closing * n\n  push(a, -p)\n  push(b, p)",
        "local ma, mb = 1, 1.25\n  local m = ma * mb / (ma + mb)\n"
        "  local p = 2 * m * closing * n\n  a.velocity = a.velocity - p / ma\n"
        "  b.velocity = b.velocity + p / mb");
    row("push: half of one mass for the reduced one", weighed, "local m = ma * mb / (ma + mb)",
        "local m = mass_of(a) / 2");
    row("push: some of it is lost", weighed, "2 * m * closing * n",
        "(2 * m * closing - 0.01 * m) * 0.9 * n");
    row("push: applied, and worked out there", weighed,
        "local p = 2 * m * closing * n\n  push(a, -p)\n  push(b, p)",
        "local p = 0.7 * m * (closing + 0.1) * 2 * n\n  a.velocity = a.velocity - p / ma\n"
        "  b.velocity = b.velocity + p / mb");
    row("push: applied, and a factor is missing before", weighed,
        "local p = 2 * m * closing * n\n  push(a, -p)\n  push(b, p)",
        "local p = m * closing * n\n  a.velocity = a.velocity - p / ma\n"
        "  b.velocity = b.velocity + p / mb");
    row("push: worked out where it is handed on", weighed, "push(a, -p)\n  push(b, p)",
        "push(a, -(2 * m * closing - 0.01 * m) * 0.9 * n) "
        "push(b, (2 * m * closing - 0.01 * m) * 0.9 * n)");
    row("own frame: a part of what is put together", frame,
        "local push = d * (rel:dot(d) / d:length_squared())",
        "local push = d * (rel:dot(d) / d:length_squared() * 0.8 - 0.01)");
    row("setter: normal of the first hit", objects, "d:normalized()",
        "d:normalized() balls.n = balls.n or n n = balls.n");
}

QTEST_GUILESS_MAIN(TestLineAtFault)

#include "test_line_at_fault.moc"
