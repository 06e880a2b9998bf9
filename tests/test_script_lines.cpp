// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/script/student_script.h"

using namespace cradle;
using namespace cradle::programs;

/// An update of a program line by line.
class TestScriptLines : public QObject
{
    Q_OBJECT
private slots:
    void linesComeInOrder();
    void localsAndCirclesAreThoseOfTheLine();
    void calledFunctionsAreEntered();
    void errorInTheMiddleEndsTheUpdate();
    void errorInsideProtectedCallGoesOn();
    void stepTakesOverWhatWasDone_data();
    void stepTakesOverWhatWasDone();
    void droppedLinesLeaveNothing();
    void nothingToStepThroughIsSaid();
    void limitsHoldInALine_data();
    void limitsHoldInALine();

private:
    [[nodiscard]] static std::vector<int> linesOf(StudentScript &program, const World &world);
    void start(const char *source);

    std::unique_ptr<StudentScript> m_program;
    World m_world;
};

std::vector<int> TestScriptLines::linesOf(StudentScript &program, const World &world)
{
    std::vector<int> lines;
    for (auto pause = program.beginLines(world, 0.5); pause.line > 0; pause = program.nextLine()) {
        lines.push_back(pause.line);
        if (pause.error || lines.size() > 100)
            break;
    }
    return lines;
}

void TestScriptLines::start(const char *source)
{
    m_program = std::make_unique<StudentScript>(lua(source));
    Preset scene = scriptScene();
    const auto error = m_program->begin(scene);
    QVERIFY2(!error, error ? error->message.toUtf8().constData() : "");
    m_world = initialWorld(scene);
}

void TestScriptLines::linesComeInOrder()
{
    start(R"lua(function on_update(dt)
  local a = 1

  for i = 1, 2 do
    a = a + i
  end
  if a > 100 then
    a = 0
  end
  circle1.position = vec(a, 0)
end)lua");
    QCOMPARE(linesOf(*m_program, m_world), (std::vector<int>{2, 4, 5, 4, 5, 4, 7, 10, 11}));
}

void TestScriptLines::localsAndCirclesAreThoseOfTheLine()
{
    start(R"lua(function on_update(dt)
  local v = circle1.velocity
  circle1.position = vec(0, 1)
  local name = "ball"
  circle1.velocity = -v
end)lua");
    auto pause = m_program->beginLines(m_world, 0.5);
    QCOMPARE(pause.line, 2);
    QCOMPARE(pause.locals, (std::vector<ProgramValue>{{lua("dt"), lua("0.5")}}));
    QCOMPARE(pause.circles, m_world.circles);
    pause = m_program->nextLine();
    QCOMPARE(pause.locals.back(), (ProgramValue{lua("v"), lua("(2, 0)")}));
    pause = m_program->nextLine();
    QCOMPARE(pause.line, 4);
    QCOMPARE(pause.circles[0].position, (Vec2{0.0, 1.0}));
    QCOMPARE(pause.circles[0].velocity, (Vec2{2.0, 0.0}));
    pause = m_program->nextLine();
    QCOMPARE(pause.locals.back(), (ProgramValue{lua("name"), lua("\"ball\"")}));
    pause = m_program->nextLine();
    QCOMPARE(pause.line, 6);
    pause = m_program->nextLine();
    QCOMPARE(pause.line, 0);
    QVERIFY(!pause.error);
    QCOMPARE(pause.circles[0].velocity, (Vec2{-2.0, 0.0}));
}

void TestScriptLines::calledFunctionsAreEntered()
{
    start(R"lua(local function move(c, dt)
  c.position = c.position + c.velocity * dt
end
function on_update(dt)
  for _, c in ipairs(circles) do
    move(c, dt)
  end
  table.sort({3, 1, 2})
end)lua");
    QCOMPARE(linesOf(*m_program, m_world), (std::vector<int>{5, 6, 2, 3, 5, 6, 2, 3, 5, 7, 8, 9}));
}

void TestScriptLines::errorInTheMiddleEndsTheUpdate()
{
    start("function on_update(dt)\n  local a = 1\n  a.b = 2\n  a = 3\nend");
    (void)m_program->beginLines(m_world, 0.5);
    auto pause = m_program->nextLine();
    QCOMPARE(pause.line, 3);
    QVERIFY(!pause.error);
    pause = m_program->nextLine();
    QVERIFY(pause.error);
    QCOMPARE(pause.line, 3);
    QCOMPARE(pause.error->line, 3);
    QCOMPARE(pause.error->step, 1);
    QVERIFY(pause.error->message.contains(lua("`a` is number")));
    QCOMPARE(pause.error->locals.back(), (ProgramValue{lua("a"), lua("1")}));
    QCOMPARE(m_program->nextLine().line, 0);
}

void TestScriptLines::errorInsideProtectedCallGoesOn()
{
    start(R"lua(function on_update(dt)
  local ok, why = pcall(function()
    circle1.position = vec(7, 7)
    error("no")
  end)
  circle1.velocity = vec(ok and 1 or 0, 0)
end)lua");
    // The function is made in line 5, and called from line 2.
    QCOMPARE(linesOf(*m_program, m_world), (std::vector<int>{2, 5, 2, 3, 4, 6, 7}));
    QVERIFY(!m_program->advance(m_world, 0.5));
    QCOMPARE(m_world.circles[0].position, (Vec2{7.0, 7.0}));
    QCOMPARE(m_world.circles[0].velocity, (Vec2{0.0, 0.0}));
}

void TestScriptLines::stepTakesOverWhatWasDone_data()
{
    QTest::addColumn<int>("lines");
    QTest::newRow("nothing yet") << 0;
    QTest::newRow("half of it") << 2;
    QTest::newRow("all of it") << 4;
}

void TestScriptLines::stepTakesOverWhatWasDone()
{
    QFETCH(int, lines);
    start(R"lua(n = 0
function on_update(dt)
  n = n + 1
  circle1.position = vec(n, 0)
  circle1.velocity = vec(n, n)
end)lua");
    (void)m_program->beginLines(m_world, 0.5);
    for (int i = 0; i < lines; ++i)
        (void)m_program->nextLine();
    QVERIFY(!m_program->advance(m_world, 0.5));
    QCOMPARE(m_world.circles[0].velocity, (Vec2{1.0, 1.0}));
    QVERIFY(!m_program->advance(m_world, 0.5));
    QCOMPARE(m_world.circles[0].position, (Vec2{2.0, 0.0}));
}

void TestScriptLines::droppedLinesLeaveNothing()
{
    start(R"lua(function on_update(dt)
  circle1.position = circle1.position + vec(1, 0)
  circle1.velocity = vec(0, 0)
end)lua");
    m_program->dropLines();
    (void)m_program->beginLines(m_world, 0.5);
    (void)m_program->nextLine();
    m_program->dropLines();
    QCOMPARE(m_program->nextLine().line, 0);
    QVERIFY(!m_program->advance(m_world, 0.5));
    QCOMPARE(m_world.circles[0].position, (Vec2{-1.0, 2.0}));
    // Beginning anew drops what was begun, too.
    (void)m_program->beginLines(m_world, 0.5);
    (void)m_program->nextLine();
    QCOMPARE(m_program->beginLines(m_world, 0.5).circles, m_world.circles);
}

void TestScriptLines::nothingToStepThroughIsSaid()
{
    start("function on_update(dt) on_update = nil end");
    QVERIFY(!m_program->advance(m_world, 0.5));
    const auto pause = m_program->beginLines(m_world, 0.5);
    QVERIFY(pause.error);
    QCOMPARE(pause.circles, m_world.circles);
}

void TestScriptLines::limitsHoldInALine_data()
{
    QTest::addColumn<QString>("statement");
    QTest::addColumn<ProgramError::Kind>("kind");
    QTest::newRow("endless") << lua("while true do end") << ProgramError::Kind::Time;
    QTest::newRow("in a protected call")
        << lua("pcall(function() while true do end end)") << ProgramError::Kind::Time;
    QTest::newRow("memory") << lua("local s = 'x' while true do s = s .. s end")
                            << ProgramError::Kind::Memory;
}

void TestScriptLines::limitsHoldInALine()
{
    QFETCH(QString, statement);
    QFETCH(ProgramError::Kind, kind);
    start(qPrintable(lua("function on_update(dt)\n") + statement + lua("\nend")));
    auto pause = m_program->beginLines(m_world, 0.5);
    QVERIFY(!pause.error);
    // Every line has the whole allowance, so the rest is run at once.
    const auto error = m_program->advance(m_world, 0.5);
    QVERIFY(error);
    QCOMPARE(error->kind, kind);
    QCOMPARE(error->line, 2);
}

QTEST_GUILESS_MAIN(TestScriptLines)
#include "test_script_lines.moc"
