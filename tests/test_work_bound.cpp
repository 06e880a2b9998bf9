// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/script_limits.h"
#include "tasks/script/work_bound.h"

#include "tasks/reading/lab_reader.h"
#include "tests/script_run.h"

#include <QTest>

#include <algorithm>

using namespace cradle;
using namespace cradle::programs;

class TestWorkBound : public QObject
{
    Q_OBJECT

private slots:
    void simpleProgramsHaveABound_data();
    void simpleProgramsHaveABound();
    void whatMayGoOnHasNone_data();
    void whatMayGoOnHasNone();
    void countsNeverPassTheBound();
    void theBoundChangesNoRun();
    void longTextsCount();
    void largeTablesCount();
    void sortingCounts();
    void roomOfAnEmptiedTableCounts();
    void theLimitStopsWhatBeganUncounted();
    void linesAreWalkedAsEver();
};

namespace {

/// Makes a program one that is counted, and does nothing.
const QString counted = QStringLiteral("\nlocal function never() while true do end end\n");

std::optional<qint64> boundOf(const QString &program)
{
    const QByteArray text = program.toUtf8();
    return workBound({text.constData(), static_cast<std::size_t>(text.size())}, 2);
}

/// What is counted of a program in its first \p steps.
qint64 countOf(const QString &program, int steps, const Preset &preset = scriptScene())
{
    StudentScript script(program);
    Preset scene = preset;
    if (script.begin(scene) || !script.moves())
        return script.instructions();
    World world = initialWorld(scene);
    for (int i = 0; i < steps && !script.advance(world, scene.timestep); ++i)
        ++world.step;
    return script.instructions();
}

} // namespace

void TestWorkBound::simpleProgramsHaveABound_data()
{
    QTest::addColumn<QString>("program");
    const auto row = [](const char *name, const char *program) {
        QTest::newRow(name) << lua(program);
    };
    row("nothing", "");
    row("an update", "function on_update(dt)\n circle1.position = vec(1, 2) * dt end");
    row("a function behind its end", "local function f(x) return x end\n"
                                     "function on_update(dt) f(f(dt)) end");
    row("over the circles", "for i, c in ipairs(circles) do c.mass = i end");
    row("through their numbers", "for i = 1, #circles do circles[i].mass = i end");
    row("through pairs", "for i = 1, #circles - 1 do for j = i + 1, #circles do print(j) end end");
    row("through written numbers", "local x = 0 for i = 1, 10 do x = x + i end");
    row("a field with a function's name", "local function mass(c) return c.radius end\n"
                                          "circle1.mass = mass(circle1)\n"
                                          "print(circle1.mass)");
    row("words in texts and comments",
        "-- while true do end\nprint('while', \"repeat \\\" goto\")");
    row("nested conditions", "if step then if time then print(1) else print(2) end end");
}

void TestWorkBound::simpleProgramsHaveABound()
{
    QFETCH(QString, program);
    const auto bound = boundOf(program);
    QVERIFY(bound);
    QVERIFY(*bound < 400);
    QVERIFY(!findSyntaxError(program));
    QVERIFY(takesLittle(program, 2));
}

void TestWorkBound::whatMayGoOnHasNone_data()
{
    QTest::addColumn<QString>("program");
    const auto row = [](const char *name, const char *program) {
        QTest::newRow(name) << lua(program);
    };
    row("while", "while step do end");
    row("repeat", "repeat until step");
    row("goto", "::again:: goto again");
    row("a loop to a variable", "local n = 1e9 for i = 1, n do end");
    row("a loop to a large number", "for i = 1, 1000000000 do end");
    row("a loop to an exponent", "for i = 1, 1e9 do end");
    row("a loop with a step", "for i = 1, 2, 1e-9 do end");
    row("a loop from a negative number", "for i = -1000000000, 2 do end");
    row("a loop from a variable", "local n = -1e9 for i = n, 2 do end");
    row("a loop over a list", "local t = {1} for _, x in ipairs(t) do t[#t + 1] = x end");
    row("a loop over pairs", "for k in pairs(draw) do end");
    row("other circles", "local circles = {1} for _, x in ipairs(circles) do end");
    row("circles handed over", "local function f(circles) for i = 1, #circles do end end");
    row("another ipairs", "local ipairs = pairs for i, c in ipairs(circles) do end");
    row("a loop's variable moved", "for i = 1, 2 do i = -1e9 for j = i + 1, 2 do end end");
    row("moved beside others", "for i = 1, 2 do local i, x = -1e9, 1 for j = i, 2 do end end");
    row("moved as a constant",
        "for i = 1, 2 do local i <const> = -1000000000 for j = i, 2 do end end");
    row("of the function around",
        "for i = 1, 2 do local function f(i) for j = i, 2 do end end f(-1000000000) end");
    row("a function that calls itself", "function f() f() end");
    row("two that call each other", "function f() g() end function g() f() end");
    row("called before its end", "function f() local function g() f() end g() end");
    row("a function as a value", "local function f() end local g = f g()");
    row("a function handed over", "local function f() end pcall(f)");
    row("a function without a name", "local f = function() end f()");
    row("a function of a table", "local t = {} function t.f() t.f() end");
    row("a method", "local t = {} function t:f() self:f() end");
    row("a function called with a text", "local function f() end f 'x'");
    row("a function named twice", "function f() end function f() end");
    row("by the globals", "function f() _ENV['f']() end");
    row("a text that goes on", "local x = '\\z\n' while step do end --'");
    row("a comment that ends early", "-- \r while step do end");
    row("a long comment", "--[[ ' ]] while step do end --'");
    row("a long text", "local x = [[ ' ]] while step do end --'");
    row("a text with an end of line", "local x = '\\\n' while step do end --'");
}

void TestWorkBound::whatMayGoOnHasNone()
{
    QFETCH(QString, program);
    QVERIFY(!findSyntaxError(program));
    QVERIFY(!takesLittle(program, 2));
}

void TestWorkBound::countsNeverPassTheBound()
{
    const auto lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab);
    constexpr int steps = 100;
    int bounded = 0;
    for (const Task &task : lab->tasks) {
        QStringList programs{task.solution};
        for (const KnownScript &mistake : task.mistakes)
            programs.append(mistake.source);
        for (const QString &program : programs) {
            const auto bound = boundOf(program);
            if (!bound || !takesLittle(program, 2))
                continue;
            ++bounded;
            // The file and on_load are calls, too.
            const qint64 count = countOf(program + counted, steps, task.preset);
            QVERIFY2(count <= (steps + 2) * *bound + 100, qPrintable(task.id));
            QVERIFY(count > 0);
            // Left: what is charged, such as the names of new fields.
            QVERIFY(countOf(program, steps, task.preset) < count / 2);
        }
    }
    QVERIFY(bounded > 50);
}

void TestWorkBound::theBoundChangesNoRun()
{
    const QString program = lua("local function fall(c, dt)\n"
                                "  c.velocity = c.velocity + gravity * dt\n"
                                "  c.position = c.position + c.velocity * dt\n"
                                "end\n"
                                "function on_update(dt)\n"
                                "  for i = 1, #circles do fall(circles[i], dt) end\n"
                                "  print(step, circle1.position)\n"
                                "  if step == 40 then print(circle1.mass) end\n"
                                "end");
    QVERIFY(takesLittle(program, 2));
    QVERIFY(!takesLittle(program + counted, 2));
    const ScriptRun quick = runScript(program, 60);
    const ScriptRun slow = runScript(program + counted, 60);
    QVERIFY(quick.error);
    QCOMPARE(quick.error->line, 8);
    QCOMPARE(quick.error->step, 41);
    QCOMPARE(*quick.error, *slow.error);
    QCOMPARE(quick.world, slow.world);
    QCOMPARE(quick.output, slow.output);
}

void TestWorkBound::longTextsCount()
{
    const QString program = lua("local text = 'abcdefgh'\n"
                                "function on_update(dt)\n"
                                "  text = text .. 'abcdefgh'\n"
                                "end");
    QVERIFY(takesLittle(program, 2));
    QCOMPARE(countOf(program, 100), 0);
    QVERIFY(countOf(program, 1000) > 0);
    // One that is written so counts from the start.
    QVERIFY(
        countOf(lua("text = '%1'\nfunction on_update(dt) end").arg(QString(2000, QLatin1Char('a'))),
                1000)
        > 0);
}

void TestWorkBound::largeTablesCount()
{
    const QString program = lua("local places = {}\n"
                                "function on_update(dt)\n"
                                "  places[#places + 1] = circle1.position\n"
                                "end");
    QVERIFY(takesLittle(program, 2));
    QCOMPARE(countOf(program, 1000), 0);
    QVERIFY(countOf(program, 10'000) > 0);
}

void TestWorkBound::sortingCounts()
{
    const QString program = lua("local list = {3, 1, 2}\n"
                                "function on_update(dt)\n"
                                "  table['sort'](list)\n"
                                "end");
    QVERIFY(takesLittle(program, 2));
    QVERIFY(countOf(program, 1) > 0);
}

void TestWorkBound::roomOfAnEmptiedTableCounts()
{
    const ScriptRun run = runScript(lua("local t = {}\n"
                                        "function on_load()\n"
                                        "  for i = 1, 100000 do t[i + 0.5] = true end\n"
                                        "  for i = 1, 100000 do t[i + 0.5] = nil end\n"
                                        "end\n"
                                        "function on_update(dt)\n"
                                        "  for i = 1, 10000 do pairs(t) end\n"
                                        "end"),
                                    1);
    QVERIFY(run.error);
    QCOMPARE(run.error->kind, ProgramError::Kind::Time);
}

void TestWorkBound::theLimitStopsWhatBeganUncounted()
{
    QString program = lua("local text = 'abcdefgh'\nfunction on_update(dt)\n");
    // 8 bytes, doubled 22 times: 32 MiB, which counts for 32 thousand an instruction.
    for (int i = 0; i < 22; ++i)
        program += lua("text = text .. text\n");
    for (int i = 0; i < 300; ++i)
        program += lua("step_text = text\n");
    program += lua("end\n");
    QVERIFY(takesLittle(program, 2));
    const ScriptRun run = runScript(program, 1);
    QVERIFY(run.error);
    QCOMPARE(run.error->kind, ProgramError::Kind::Time);
    QVERIFY(run.error->line > 24);
    QCOMPARE(*runScript(program, 1).error, *run.error);
}

void TestWorkBound::linesAreWalkedAsEver()
{
    const QString program =
        lua("local text = 'abcdefgh'\n"
            "function on_update(dt)\n"
            "  for i = 1, 9 do if #text < 1024 then text = text .. text end end\n"
            "  circle1.position = vec(1, 1)\n"
            "end");
    QVERIFY(takesLittle(program, 2));
    StudentScript script(program);
    Preset scene = scriptScene();
    QVERIFY(!script.begin(scene));
    World world = initialWorld(scene);
    QCOMPARE(script.linesOf(world, 0.125), (std::vector<int>{3, 4, 5}));
    // Its text is long since, so that it is counted from the next step on.
    const qint64 before = script.instructions();
    for (int i = 0; i < 20; ++i)
        QVERIFY(!script.advance(world, 0.125));
    QVERIFY(script.instructions() > before + 1000);
}

QTEST_GUILESS_MAIN(TestWorkBound)
#include "test_work_bound.moc"
