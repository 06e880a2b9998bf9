// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/script/student_script.h"

using namespace cradle;
using namespace cradle::programs;

/// What one update of a program assigns and which of its lines run.
class TestScriptTrace : public QObject
{
    Q_OBJECT
private slots:
    void traceNamesTheLinesThatMove();
    void traceTellsFieldsAndWhetherTheyChanged();
    void whatThePinnedSceneKeepsIsNotChanged();
    void traceTellsTheCallsThatLedThere();
    void traceOfVeryManyAssignmentsEndsWithTheLast();
    void linesOfAnUpdateAreThoseThatRan();
    void traceOfAFailingStepIsWhatItDid();
    void startTellsWhatOnLoadSets();

private:
    void start(const char *source);

    using Field = Assignment::Field;

    std::unique_ptr<StudentScript> m_program;
    World m_world;
};

void TestScriptTrace::start(const char *source)
{
    m_program = std::make_unique<StudentScript>(lua(source));
    Preset scene = scriptScene();
    const auto error = m_program->begin(scene);
    QVERIFY2(!error, error ? error->message.toUtf8().constData() : "");
    m_world = initialWorld(scene);
}

void TestScriptTrace::traceNamesTheLinesThatMove()
{
    start(R"lua(local function move(c, dt)
  c.position = c.position + c.velocity * dt
end
function on_update(dt)
  for _, c in ipairs(circles) do move(c, dt) end
  circle2.velocity = vec(0, 0)
  circle1.mass = 3
end)lua");
    const World before = m_world;
    // Circle 2 rests: it is moved by nothing, and its velocity stays.
    const std::vector<Assignment> wanted{{0, 2, Field::Position, true, {5}},
                                         {1, 2, Field::Position, false, {5}},
                                         {1, 6, Field::Velocity, false, {}}};
    QCOMPARE(m_program->trace(m_world, 0.5), wanted);
    QCOMPARE(m_world, before);
    // The trace is written only then.
    QVERIFY(!m_program->advance(m_world, 0.5));
    QCOMPARE(m_program->trace(m_world, 0.5), wanted);
}

void TestScriptTrace::traceTellsFieldsAndWhetherTheyChanged()
{
    start(R"lua(function on_update(dt)
  circle1.velocity = vec(2, 0)
  circle1.velocity = vec(2, 1e-300)
  circle1.velocity = vec(2, -0.0)
  circle1.velocity = vec(2, 0)
  circle1.radius = 0.3
  circle1.radius = 0.3
  circle2.density = circle2.density * 2
  circle2.position = circle2.position + vec(1, 0)
end)lua");
    const std::vector<Assignment> wanted{
        {0, 2, Field::Velocity, false, {}}, {0, 3, Field::Velocity, true, {}},
        {0, 4, Field::Velocity, true, {}},  {0, 5, Field::Velocity, false, {}},
        {0, 6, Field::Radius, true, {}},    {0, 7, Field::Radius, false, {}},
        {1, 8, Field::Density, true, {}},   {1, 9, Field::Position, true, {}}};
    QCOMPARE(m_program->trace(m_world, 0.5), wanted);
}

void TestScriptTrace::whatThePinnedSceneKeepsIsNotChanged()
{
    start("function on_update(dt)\n  circle1.radius = 3\n  circle1.velocity = vec(9, 9)\nend");
    m_program->setPinned(true);
    Preset scene = scriptScene();
    QVERIFY(!m_program->begin(scene));
    const std::vector<Assignment> wanted{{0, 2, Field::Radius, false, {}},
                                         {0, 3, Field::Velocity, true, {}}};
    QCOMPARE(m_program->trace(m_world, 0.5), wanted);
}

void TestScriptTrace::traceTellsTheCallsThatLedThere()
{
    start(R"lua(local function flip(c)
  c.velocity = vec(-c.velocity.x, 0)
end
local function bounce(c)
  if c.index == 1 then
    flip(c)
  end
end
function on_update(dt)
  for i = 1, #circles do
    bounce(circles[i])
  end
  pcall(flip, circle1)
  table.sort({1, 2}, function(a, b)
    flip(circle1)
    return a < b
  end)
  return flip(circle1)
end)lua");
    const std::vector<Assignment> trace = m_program->trace(m_world, 0.5);
    QVERIFY(trace.size() >= 4);
    using Calls = std::vector<int>;
    QCOMPARE(trace[0].calls, (Calls{11, 6}));
    QCOMPARE(trace[1].calls, (Calls{13}));
    // A library function in between is none of the program's.
    QCOMPARE(trace[2].calls, (Calls{14, 15}));
    // What made a tail call has left.
    QCOMPARE(trace.back().calls, Calls{});
    for (const Assignment &assignment : trace)
        QCOMPARE(assignment.line, 2);
}

void TestScriptTrace::traceOfVeryManyAssignmentsEndsWithTheLast()
{
    start(R"lua(local function deep(n)
  if n > 0 then
    deep(n - 1)
    return
  end
  circle1.velocity = vec(1, 0)
end
function on_update(dt)
  for i = 1, 100000 do circle1.velocity = vec(i, 0) end
  deep(1000)
end)lua");
    const std::vector<Assignment> trace = m_program->trace(m_world, 0.5);
    QVERIFY(trace.size() <= 20'000);
    QCOMPARE(trace.back().line, 6);
    QVERIFY(!trace.back().calls.empty() && trace.back().calls.size() <= 100);
    QCOMPARE(trace.back().calls.back(), 3);
    QCOMPARE(trace.front().line, 9);
}

void TestScriptTrace::linesOfAnUpdateAreThoseThatRan()
{
    start(R"lua(local function still(c)
  return c.velocity == vec(0, 0)
end
function on_update(dt)
  for i = 1, #circles do
    if still(circles[i]) then
      circles[i].radius = 1
    elseif step == 7 then
      circles[i].radius = 2
    end
  end
end
local never = 1)lua");
    QCOMPARE(m_program->linesOf(m_world, 0.5), (std::vector<int>{2, 5, 6, 7, 8, 12}));
    QCOMPARE(m_program->linesOf(m_world, 0.5), (std::vector<int>{2, 5, 6, 7, 8, 12}));
    m_world.step = 7;
    QCOMPARE(m_program->linesOf(m_world, 0.5), (std::vector<int>{2, 5, 6, 7, 8, 9, 12}));
    start("function on_update(dt)\n  circle1.position = 5\n  circle1.radius = 1\nend");
    QCOMPARE(m_program->linesOf(m_world, 0.5), (std::vector<int>{2}));
}

void TestScriptTrace::traceOfAFailingStepIsWhatItDid()
{
    start("function on_update(dt)\n  circle1.position = vec(0, 0)\n  circle1.position = 5\nend");
    QCOMPARE(m_program->trace(m_world, 0.5),
             (std::vector<Assignment>{{0, 2, Field::Position, true, {}}}));
}

void TestScriptTrace::startTellsWhatOnLoadSets()
{
    StudentScript program(QStringLiteral("local function place(c)\n"
                                         "  c.position = vec(1, 2)\n"
                                         "end\n"
                                         "function on_load()\n"
                                         "  gravity = vec(0, -9.81)\n"
                                         "  restitution = 0.5\n"
                                         "  place(circle1)\n"
                                         "  error('enough')\n"
                                         "  gravity = vec(0, 0)\n"
                                         "end\n"));
    Preset scene;
    scene.circles.resize(1);
    using enum Assignment::Field;
    const std::vector<Assignment> wanted{
        {.circle = -1, .line = 5, .field = Gravity, .changed = true, .calls = {}},
        {.circle = -1, .line = 6, .field = Restitution, .changed = true, .calls = {}},
        {.circle = 0, .line = 2, .field = Position, .changed = true, .calls = {7}}};
    QCOMPARE(program.traceStart(scene), wanted);
}

QTEST_GUILESS_MAIN(TestScriptTrace)
#include "test_script_trace.moc"
