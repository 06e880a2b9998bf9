// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/question_lines.h"
#include "tests/line_test.h"

#include "tasks/reading/lab_reader.h"

using namespace cradle;
using namespace cradle::programs;

/// Where a value is wrong that the last assignment only applies, the line that works it out is
/// marked.
class TestAppliedLine : public LineTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void findingMarksTheLine_data();
    void findingMarksTheLine() { compareLine(); }
    void branchThatIsNotTakenIsFound();
};

void TestAppliedLine::findingMarksTheLine_data()
{
    addColumns();
    const QString walls = QString::fromLatin1(walled);
    const char *kick = "  circle1.velocity = circle1.velocity + gravity * h";
    rowOfStep("acceleration with a name", "L42T5", walls, kick,
              "  local a = gravity + vec(0.5, 0)\n"
              "  circle1.velocity = circle1.velocity + a * h");
    rowOfStep("acceleration that is right", "L42T5", walls, kick,
              "  circle1.velocity = circle1.velocity + gravity * 1.1 * h local a = gravity");
    rowOfStep("what a function gives", "L42T5", walls, kick,
              "  local function pull() return (gravity + vec(0.5, 0)) * h end\n"
              "  circle1.velocity = circle1.velocity + pull()");
    rowOfStep("what a named function gives", "L42T5", walls, kick,
              "  local function pull(c, k) return gravity * k + 0.1 * k * c.velocity end\n"
              "  circle1.velocity = circle1.velocity + pull(circle1, h)");
    const QString shared = QString::fromLatin1(called);
    rowOfStep("what a function gives both circles", "L42T16", shared,
              "m * u + w * k + restitution * w * (k - u)",
              "restitution * (m * u + w * k + w * (k - u))");
    rowOfStep("what it is given for one of them", "L42T16", shared,
              "after(circle2.mass, u2, circle1.mass, u1)",
              "after(circle2.mass, u2, circle2.mass, u1)");
    const QString flight =
        QStringLiteral("function on_load()\n  circle1.velocity = vec(2, 0)\nend\n"
                       "function on_update(h)\n  circle1.position = "
                       "circle1.position + circle1.velocity * h\nend");
    rowOfStep("way with a name", "L42T1", flight,
              "  circle1.position = circle1.position + circle1.velocity * h",
              "  local way = vec(circle1.velocity:length(), circle1.velocity:length()) * h\n"
              "  circle1.position = circle1.position + way");
    const QString turns = QStringLiteral(
        "local function keep(c, old)\n  local p, v, r = c.position, c.velocity, c.radius\n"
        "  if (p.x + r > square.right and v.x > 0)\n"
        "    or (p.x - r < square.left and v.x < 0) then\n"
        "    c.position = vec(old.x, p.y)\n    v = vec(-v.x, v.y)");
    QString called = turns;
    called.replace(QLatin1String("vec(-v.x, v.y)"), QLatin1String("vec(turned(v.x), v.y)"));
    rowOfStep("what a function returns", "L42T5", walls, qPrintable(turns),
              qPrintable(QStringLiteral("local function turned(u) return -u * math.abs(u) end\n")
                         + called));
    const QString answers = QString::fromLatin1(R"lua(function on_load()
  gravity = vec(0, 0)
  circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0)
  circle2.position, circle2.velocity = vec(2, 2), vec(0, 0)
end
local function walls(c)
  local p, v, w = c.position, c.velocity, square.half_width - c.radius
  if math.abs(p.x) > w and p.x * v.x > 0 then v = vec(-v.x, v.y) end
  if math.abs(p.y) > w and p.y * v.y > 0 then v = vec(v.x, -v.y) end
  c.velocity = v
end
local function unit(v)
  if v:length() == 0 then return vec(0, 0) end
  return v:normalized()
end
function on_update(h)
  for _, c in ipairs(circles) do
    walls(c)
    c.position = c.position + c.velocity * h
  end
  local a, b = circle1, circle2
  local d = b.position - a.position
  if d:length() < a.radius + b.radius and (a.velocity - b.velocity):dot(d) > 0 then
    a.velocity, b.velocity = b.velocity, a.velocity
  end
end
)lua");
    rowOfStep("a function that is right", "L42T10", answers,
              "a.velocity, b.velocity = b.velocity, a.velocity",
              "a.velocity, b.velocity = unit(a.velocity) * b.velocity:length(), "
              "unit(b.velocity) * a.velocity:length()");
    row("a margin with a name", frame, "  if d:length() >= a.radius + b.radius then",
        "  local margin = 0.1\n  if d:length() >= a.radius + b.radius + margin then");
}

void TestAppliedLine::branchThatIsNotTakenIsFound()
{
    const QString source = QStringLiteral("if u > 0 then\n  if w then x = 1 end\n  y = 2\nelse\n"
                                          "  for i = 1, 2 do end\n  z = 3\nend\nz = 4");
    const ProgramLines program(source);
    QCOMPARE(avoidedLine(program, 1, true), 6);
    QCOMPARE(avoidedLine(program, 1, false), 2);
    QCOMPARE(avoidedLine(program, 2, true), 0); // there is none
    const QString empty = QStringLiteral("if u > 0 then\n  x = 1\nelse\nend\nz = 4");
    QCOMPARE(avoidedLine(ProgramLines(empty), 1, true), 0);
}

QTEST_GUILESS_MAIN(TestAppliedLine)

#include "test_applied_line.moc"
