// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/runs/observation.h"
#include "tasks/script/student_script.h"

using namespace cradle;
using namespace cradle::programs;

/// What becomes of the errors of a program: their place, their words, and what was before.
class TestScriptErrors : public QObject
{
    Q_OBJECT
private slots:
    void errorTellsItsPlace();
    void vectorsAreNamedByTheirVeryLine();
    void errorInLoadIsOfStepZero();
    void errorsOfAnyTypeAreSaid_data();
    void errorsOfAnyTypeAreSaid();
    void syntaxErrorTellsItsLine_data();
    void syntaxErrorTellsItsLine();
    void statesBeforeTheFailingStepAreKept();
    void impossibleStartOfTheLawsIsRefused();
    void updateThatIsNoFunctionIsRefused_data();
    void updateThatIsNoFunctionIsRefused();
};

void TestScriptErrors::errorTellsItsPlace()
{
    const ScriptRun run = runScript(lua(R"lua(
local function half(speed)
  local twice = speed * 2
  return speed.x / twice
end
function on_update(dt)
  if step == 30 then
    half(3)
  end
end)lua"),
                                    60);
    VERIFY_STOPS(run, 4, lua("`speed` is number"));
    QCOMPARE(run.error->kind, ProgramError::Kind::Runtime);
    QCOMPARE(run.error->step, 31);
    QCOMPARE(run.error->time, 0.5);
    const std::vector<ProgramValue> locals{{lua("speed"), lua("3")}, {lua("twice"), lua("6")}};
    QCOMPARE(run.error->locals, locals);
    QCOMPARE(run.world.step, 30);
}

void TestScriptErrors::vectorsAreNamedByTheirVeryLine()
{
    const ScriptRun own = runScript(lua("local t = {}\nfunction on_update(dt)\n  t.x = 1\n"
                                        "  circle1.velocity.y = 2\n  t.y = 3\nend"),
                                    1);
    VERIFY_STOPS(own, 4, lua("circle1.velocity = vec(circle1.velocity.x, 2)"));
    const ScriptRun none =
        runScript(lua("local t = {}\nlocal p = vec(1, 2)\nfunction on_update(dt)\n"
                      "  t.y = 1\n  p['x'] = 2\n  t.y = 3\nend"),
                  1);
    VERIFY_STOPS(none, 5, lua("circle1.position = vec(…, circle1.position.y)"));
}

void TestScriptErrors::errorInLoadIsOfStepZero()
{
    const ScriptRun run = runScript(lua("function on_load()\n  local a = 1\n  a()\nend"), 1);
    VERIFY_STOPS(run, 3, lua("`a` is number, not a function"));
    QCOMPARE(run.error->step, 0);
    QCOMPARE(run.error->locals.front(), (ProgramValue{lua("a"), lua("1")}));
}

void TestScriptErrors::errorsOfAnyTypeAreSaid_data()
{
    QTest::addColumn<QString>("statement");
    QTest::addColumn<QString>("words");
    QTest::newRow("text") << lua("error('no mass')") << lua("no mass");
    QTest::newRow("text blamed on the caller") << lua("error('no mass', 2)") << lua("no mass");
    QTest::newRow("letters of a terminal") << lua("error('no\\27\\tmass')") << lua("no  mass");
    QTest::newRow("bytes that are no text") << lua("error('no\\xffmass')") << lua("no mass");
    QTest::newRow("number") << lua("error(42)") << lua("42");
    QTest::newRow("nil") << lua("error()") << lua("error with nil");
    QTest::newRow("table") << lua("error({})") << lua("error with a table");
    QTest::newRow("function") << lua("error(print)") << lua("error with a function");
    QTest::newRow("boolean") << lua("error(false)") << lua("error with false");
    QTest::newRow("vector") << lua("error(vec(1, 2))") << lua("error with the vector (1, 2)");
    QTest::newRow("circle") << lua("error(circle1)") << lua("error with circle1");
    QTest::newRow("failed assertion") << lua("assert(false)") << lua("assertion failed!");
    QTest::newRow("assertion with words") << lua("assert(nil, 'no e')") << lua("no e");
    QTest::newRow("assertion with a table") << lua("assert(nil, {})") << lua("error with a table");
}

void TestScriptErrors::errorsOfAnyTypeAreSaid()
{
    QFETCH(QString, statement);
    QFETCH(QString, words);
    const ScriptRun run = runScript(lua("\n\n") + statement);
    VERIFY_STOPS(run, 3, words);
    QVERIFY2(!run.error->message.contains(lua("lab.lua:")), run.say().constData());
    QCOMPARE(run.error->kind, ProgramError::Kind::Runtime);
}

void TestScriptErrors::syntaxErrorTellsItsLine_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<int>("line");
    QTest::newRow("end missing") << lua("function on_load()\nif true then\nend\n") << 4;
    QTest::newRow("one end too many") << lua("function on_load()\nend\nend") << 3;
    QTest::newRow("text without end") << lua("x = 1\nprint(\"a)\n") << 2;
    QTest::newRow("foreign operator") << lua("x = 1\n\nx += 1") << 3;
    QTest::newRow("jump to nowhere") << lua("x = 1\ngoto there") << 2;
}

void TestScriptErrors::syntaxErrorTellsItsLine()
{
    QFETCH(QString, source);
    QFETCH(int, line);
    const ScriptRun run = runScript(source, 1);
    VERIFY_STOPS(run, line, QString());
    QCOMPARE(run.error->kind, ProgramError::Kind::Syntax);
    QVERIFY2(!run.error->message.contains(lua("lab.lua")), run.say().constData());
    const auto alone = findSyntaxError(source);
    QVERIFY(alone);
    QCOMPARE(alone->line, line);
    QCOMPARE(alone->message, run.error->message);
    QVERIFY(!findSyntaxError(lua("x = nil + 1")));
}

void TestScriptErrors::statesBeforeTheFailingStepAreKept()
{
    const QString program = lua(R"lua(
function on_update(dt)
  circle1.position = circle1.position + circle1.velocity * dt
  if step == 4 then
    circle1.position = circle1.position / 0
  end
end)lua");
    const Observation o = observe({QStringLiteral("preset"), scriptScene(), 1.0}, &program);
    QVERIFY(o.error);
    QCOMPARE(o.error->line, 5);
    QCOMPARE(o.error->step, 5);
    QCOMPARE(o.steps(), 4);
    QCOMPARE(o.circle(0, 4).position.x, -2.0 + 4.0 * 2.0 / 60.0);
}

void TestScriptErrors::impossibleStartOfTheLawsIsRefused()
{
    const QString load = lua("function on_load() circle1.position = vec(9, 0) end\n");
    const ScriptRun laws = runScript(load);
    VERIFY_STOPS(laws, 0, lua("after on_load the scene cannot be run"));
    VERIFY_RUNS(runScript(load + lua("function on_update() end"), 1));
}

void TestScriptErrors::updateThatIsNoFunctionIsRefused_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<int>("line");
    QTest::newRow("number") << lua("\non_update = 5") << 2;
    QTest::newRow("load that is a number") << lua("on_load = 5") << 1;
    QTest::newRow("function, then a number") << lua("function on_update() end on_update = 5") << 0;
    QTest::newRow("taken away in a step") << lua("function on_update() on_update = nil end") << 0;
    QTest::newRow("number in a step") << lua("function on_update()\non_update = 5\nend") << 0;
}

void TestScriptErrors::updateThatIsNoFunctionIsRefused()
{
    QFETCH(QString, source);
    QFETCH(int, line);
    VERIFY_STOPS(runScript(source, 3), line, lua("function"));
}

QTEST_GUILESS_MAIN(TestScriptErrors)
#include "test_script_errors.moc"
