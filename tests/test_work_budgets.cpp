// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/judging/judgement.h"
#include "tasks/judging/probe.h"
#include "tasks/reading/lab_list.h"
#include "tasks/reading/lab_reader.h"

using namespace cradle;
using namespace cradle::programs;

/// What a verdict costs has bounds, counted in instructions of the program.
class TestWorkBudgets : public QObject
{
    Q_OBJECT
private slots:
    void aRunCanBeStoppedInTheMiddleOfAStep();
    void judgementHasABudget();
    void proofHasABudget();
    void probeEndsWithItsWork();
};

void TestWorkBudgets::aRunCanBeStoppedInTheMiddleOfAStep()
{
    int asked = 0;
    StudentScript program(lua("function on_update() while true do end end"),
                          {.locked = {}, .stop = [&] { return ++asked > 3; }});
    Preset scene = scriptScene();
    QVERIFY(!program.begin(scene));
    World world = initialWorld(scene);
    QVERIFY(program.advance(world, 0.1));
    QCOMPARE(asked, 4);
    QVERIFY(program.instructions() < 2000);
    // Observed, that is a shorter run, not an error of the program.
    const QString endless = lua("function on_update() if step > 4 then while true do end end end");
    asked = -20;
    const Observation o =
        observe({QStringLiteral("own"), scriptScene(), 1.0}, &endless, [&] { return ++asked > 3; });
    QVERIFY(!o.error);
    QCOMPARE(o.steps(), 5);
}

void TestWorkBudgets::judgementHasABudget()
{
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab.ok());
    const Task &task = lab->tasks.front();
    // 4 million instructions a step are allowed; in the 126th it is too much for a verdict.
    const Submission submission(
        task.preset, lua("function on_update(dt)\n  for i = 1, 4000000 do end\n"
                         "  circle1.position = circle1.position + circle1.velocity * dt\nend\n"
                         "function on_load() circle1.velocity = vec(2, 0) end"));
    SubmissionRuns runs(submission);
    const auto first = judgeTask(*lab, task, runs, 1);
    QVERIFY(first && first->error && !first->passed);
    QCOMPARE(first->error->kind, ProgramError::Kind::Time);
    QVERIFY2(first->error->message.contains(lua("500 million")), qPrintable(first->error->message));
    // What has run already for the one is counted for the other, too.
    const auto again = judgeTask(*lab, task, runs, 1);
    QCOMPARE(again->error, first->error);
    QCOMPARE(again->checks.size(), first->checks.size());
}

/// From hit to hit within a step, where r₁ + r₂ is not squared: what is changed in it goes round
/// the loop twenty times in most steps, and a measurement of that takes as much as all else.
void TestWorkBudgets::proofHasABudget()
{
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab.ok());
    const Task &task = lab->tasks[static_cast<std::size_t>(lab->indexOf(lua("L42T12")))];
    const Submission submission(task.preset, lua(R"(
local function to_wall(c)
  local best, axis = math.huge, nil
  local function ask(gap, speed, name)
    if speed > 0 and math.max(gap, 0) / speed < best then
      best, axis = math.max(gap, 0) / speed, name
    end
  end
  ask(square.right - c.radius - c.position.x, c.velocity.x, "x")
  ask(c.position.x - c.radius - square.left, -c.velocity.x, "x")
  ask(square.top - c.radius - c.position.y, c.velocity.y, "y")
  ask(c.position.y - c.radius - square.bottom, -c.velocity.y, "y")
  return best, axis
end
local function to_circle(a, b)
  local p, w = b.position - a.position, b.velocity - a.velocity
  local reach, pw, ww = a.radius + b.radius, dot(p, w), dot(w, w)
  if pw >= 0 then return math.huge end
  local under = pw * pw - ww * (dot(p, p) - reach)
  if under < 0 then return math.huge end
  return math.max(0, (-pw - math.sqrt(under)) / ww)
end
local function at_wall(c, axis)
  if axis == "x" then c.velocity = vec(-c.velocity.x, c.velocity.y) end
  if axis == "y" then c.velocity = vec(c.velocity.x, -c.velocity.y) end
end
local function meet(a, b)
  local n = (b.position - a.position):normalized()
  local s = dot(a.velocity - b.velocity, n)
  a.velocity = a.velocity - s * n
  b.velocity = b.velocity + s * n
end
function on_load()
  gravity = vec(0, 0)
  circle1.position, circle2.position = vec(-2, 2), vec(2, -2)
  circle1.velocity, circle2.velocity = vec(2, 0), vec(0, 2)
end
function on_update(dt)
  for _, c in ipairs(circles) do c.velocity = c.velocity + gravity * dt end
  local left, rounds = dt, 0
  while left > 0 and rounds < 20 do
    rounds = rounds + 1
    local t1, axis1 = to_wall(circle1)
    local t2, axis2 = to_wall(circle2)
    local tc = to_circle(circle1, circle2)
    local t = math.min(left, t1, t2, tc)
    for _, c in ipairs(circles) do c.position = c.position + c.velocity * t end
    if t == tc then meet(circle1, circle2)
    elseif t == t1 then at_wall(circle1, axis1)
    elseif t == t2 then at_wall(circle2, axis2)
    end
    left = left - t
  end
end)"));
    constexpr qint64 ample = 1'000'000'000;
    const WorkLimit limit(ample);
    const auto report = judgeTask(*lab, task, submission, 1);
    QVERIFY(report && !report->findings.empty());
    const qint64 worked = ample - WorkLimit::left();
    QVERIFY2(worked < 60'000'000, qPrintable(QString::number(worked)));
}

void TestWorkBudgets::probeEndsWithItsWork()
{
    const QString program = lua("function on_update(dt)\n  for i = 1, 100000 do end\nend");
    const auto steps = [&] {
        Probe probe(&program, {scriptScene(), true});
        int made = 0;
        while (made < 20 && probe.step())
            ++made;
        return made;
    };
    QCOMPARE(steps(), 20);
    {
        const WorkLimit limit(1'000'000);
        QVERIFY(!WorkLimit::isPassed());
        const int made = steps();
        QVERIFY2(made >= 5 && made <= 10, qPrintable(QString::number(made)));
        QVERIFY(WorkLimit::isPassed());
        {
            const WorkLimit inner(1'000'000);
            QVERIFY(!WorkLimit::isPassed());
        }
        QVERIFY(WorkLimit::isPassed());
        QCOMPARE(steps(), 0);
    }
    QCOMPARE(steps(), 20);
}

QTEST_GUILESS_MAIN(TestWorkBudgets)
#include "test_work_budgets.moc"
