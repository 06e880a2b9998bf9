// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/student_script.h"
#include "tests/sanitized.h"
#include "tests/script_run.h"

#include <vector>

using namespace cradle;
using namespace cradle::programs;

/// Nothing of a run depends on the machine, its clock or the addresses of the day.
class TestSameVerdict : public QObject
{
    Q_OBJECT
private slots:
    void addressesAreRefused_data();
    void addressesAreRefused();
    void percentBeforeAPIsWelcome();
    void everyRunShowsTheSame_data();
    void everyRunShowsTheSame();
    void sortKeepsEqualsInOrder();
    void pairsHasAnOrder_data();
    void pairsHasAnOrder();
    void pairsOfWhatHasNoOrderIsRefused_data();
    void pairsOfWhatHasNoOrderIsRefused();
    void costlyWorkEndsByCount_data();
    void costlyWorkEndsByCount();
};

namespace {

/// A run with its heap elsewhere than that before.
struct Elsewhere {
    ScriptRun run{};
    qint64 instructions = 0;
};

Elsewhere runElsewhere(const QString &source, int steps)
{
    static std::vector<std::unique_ptr<StudentScript>> others;
    Preset scene = scriptScene();
    others.push_back(
        std::make_unique<StudentScript>(lua("t = {} for i = 1, 999 do t[i] = {} end")));
    (void)others.back()->begin(scene);

    StudentScript program(source);
    Elsewhere made;
    Preset own = scriptScene();
    made.run.error = program.begin(own);
    World world = initialWorld(own);
    for (int i = 0; i < steps && !made.run.error && program.moves(); ++i) {
        made.run.error = program.advance(world, 0.125);
        ++world.step;
    }
    made.run.world = world;
    made.run.output = program.takeOutput();
    made.instructions = program.instructions();
    return made;
}

} // namespace

void TestSameVerdict::addressesAreRefused_data()
{
    QTest::addColumn<QString>("format");
    for (const char *format : {"'%p'", "'%20p'", "'%-20p'", "'%020p'", "'%.3p'", "'% p'", "'%+#p'",
                               "'%d%%%p', 1", "'%5' .. 'p'", "'100%% %p'"})
        QTest::newRow(format) << lua(format);
}

void TestSameVerdict::addressesAreRefused()
{
    QFETCH(QString, format);
    const QString words = lua("%p of string.format is not part of the lab's Lua");
    VERIFY_STOPS(runScript(lua("\nlocal s = string.format(%1, {})").arg(format)), 2, words);
    VERIFY_STOPS(runScript(lua("\nlocal f = ('').format\nf(%1, print)").arg(format)), 3, words);
}

void TestSameVerdict::percentBeforeAPIsWelcome()
{
    const ScriptRun run = runScript(lua("print(string.format('%d%%p %s%%', 5, 'p'))"));
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text, lua("5%p p%\n"));
}

void TestSameVerdict::everyRunShowsTheSame_data()
{
    QTest::addColumn<QString>("source");
    const auto row = [](const char *name, const char *source) {
        QTest::newRow(name) << lua(source);
    };
    row("texts of all values",
        "for _, v in ipairs({{}, print, function() end, circle1, circles, square, vec(1, 2), "
        "math, draw, 'a', 1, 1.5, true}) do\n"
        "  print(tostring(v), string.format('%s', v), type(v), v)\n"
        "end");
    row("caught errors",
        "for _, f in ipairs({function() error({}) end, function() return {} < {} end,\n"
        "    function() return {} .. 'a' end, function() return print + 1 end,\n"
        "    function() return ('x'):format() end, function() return circle1.foo end,\n"
        "    function() return table.concat({{}}) end, function() local t = nil; t[{}] = 1 end}) "
        "do\n"
        "  print(select(2, pcall(f)))\n"
        "end");
    row("sort by a comparator that contradicts itself",
        "local t = {} for i = 1, 3000 do t[i] = i * 7919 % 3001 end\n"
        "pcall(table.sort, t, function(a, b) return (a * b) % 3 > 0 end)\n"
        "print(table.concat(t, ' '))");
    row("sort with equals", "local t = {} for i = 1, 3000 do t[i] = {i % 5, i} end\n"
                            "table.sort(t, function(a, b) return a[1] < b[1] end)\n"
                            "for i = 1, 3000 do t[i] = t[i][2] end print(table.concat(t, ' '))");
    row("random numbers", "math.randomseed() for i = 1, 9 do print(math.random()) end");
    row("pairs",
        "local t = {} for i = 1, 99 do t['k' .. i] = i t[i / 2] = i t[vec(i, -i)] = i end\n"
        "t[circle2] = 'c2' t[circle1] = 'c1' t[true] = 1 t[false] = 2 t[print] = 3\n"
        "for k, v in pairs(t) do print(k, v) end");
}

void TestSameVerdict::everyRunShowsTheSame()
{
    QFETCH(QString, source);
    const Elsewhere first = runElsewhere(source, 0);
    VERIFY_RUNS(first.run);
    QVERIFY(!first.run.output.text.isEmpty());
    QVERIFY(!first.run.output.text.contains(lua("0x")));
    for (int i = 0; i < 5; ++i) {
        const Elsewhere again = runElsewhere(source, 0);
        QCOMPARE(again.run.output, first.run.output);
        QCOMPARE(again.instructions, first.instructions);
    }
}

void TestSameVerdict::sortKeepsEqualsInOrder()
{
    const ScriptRun run = runScript(lua(R"lua(
local t = {}
for i = 1, 12 do t[i] = {key = i % 3, name = string.format("%x", i)} end
table.sort(t, function(a, b) return a.key < b.key end)
local names = ""
for _, v in ipairs(t) do names = names .. v.name end
print(names)
local n = {5, 3, 9, 1, 1.5, -2}
table.sort(n)
print(table.concat(n, " "))
table.sort(n, function(a, b) return a > b end)
print(table.concat(n, " "))
local empty, one = {}, {7}
table.sort(empty) table.sort(one) print(#empty, one[1]))lua"));
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text, lua("369c147a258b\n-2 1 1.5 3 5 9\n9 5 3 1.5 1 -2\n0\t7\n"));
    VERIFY_STOPS(runScript(lua("\ntable.sort(5)")), 2, lua("bad argument #1 to 'sort'"));
    VERIFY_STOPS(runScript(lua("\ntable.sort({}, 5)")), 2, lua("bad argument #2 to 'sort'"));
    VERIFY_STOPS(runScript(lua("\ntable.sort({1, {}})")), 2, lua("attempt to compare"));
}

void TestSameVerdict::pairsHasAnOrder_data()
{
    QTest::addColumn<QString>("keys");
    QTest::addColumn<QString>("order");
    QTest::newRow("circles") << lua("t[circle2] = 2 t[circle1] = 1") << lua("12");
    QTest::newRow("booleans") << lua("t[true] = 2 t[false] = 1") << lua("12");
    QTest::newRow("vectors") << lua("t[vec(1, 5)] = 3 t[vec(1, -5)] = 2 t[vec(-1, 9)] = 1")
                             << lua("123");
    QTest::newRow("kinds") << lua("t[{}] = 7 t[vec(0, 0)] = 6 t[circle1] = 5 t[true] = 4 "
                                  "t.a = 3 t[0.5] = 2 t[1] = 1")
                           << lua("1234567");
}

void TestSameVerdict::pairsHasAnOrder()
{
    QFETCH(QString, keys);
    QFETCH(QString, order);
    const ScriptRun run = runScript(
        lua("local t, s = {}, ''\n%1\nfor _, v in pairs(t) do s = s .. v end print(s)").arg(keys));
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text.trimmed(), order);
}

void TestSameVerdict::pairsOfWhatHasNoOrderIsRefused_data()
{
    QTest::addColumn<QString>("keys");
    for (const char *keys : {"{[{}] = 1, [{}] = 2}", "{[print] = 1, [pcall] = 2}",
                             "{[vec(1, 2)] = 1, [vec(1, 2)] = 2}", "{[{}] = 1, [print] = 2}"})
        QTest::newRow(keys) << lua(keys);
}

void TestSameVerdict::pairsOfWhatHasNoOrderIsRefused()
{
    QFETCH(QString, keys);
    VERIFY_STOPS(runScript(lua("\nfor k in pairs(%1) do end").arg(keys)), 2,
                 lua("pairs needs keys that have an order"));
}

void TestSameVerdict::costlyWorkEndsByCount_data()
{
    QTest::addColumn<QString>("statements");
    int count = 0;
    const auto row = [&](const char *name, const char *statements) {
        if (++count % cradle::oneOf(4) == 0)
            QTest::newRow(name) << lua(statements);
    };
    row("equal long texts", "local a, b = 'x', 'x' for i = 1, 20 do a = a .. a b = b .. b end\n"
                            "while a == b do end");
    row("order of long texts", "local a, b = 'x', 'x' for i = 1, 20 do a = a .. a b = b .. b end\n"
                               "while a <= b do end");
    row("long texts joined", "local a = 'x' for i = 1, 20 do a = a .. a end\n"
                             "while true do local b = a .. 'x' end");
    row("long text as a number", "local a = '1' for i = 1, 15 do a = a .. a end\n"
                                 "while true do local b = a + 1 end");
    row("table that is built anew for every key",
        "local t = {} for i = 1, 65536 do t[i + 0.5] = true end\n"
        "local k = 1 while true do t[k + 0.5] = nil t[k + 65536.5] = true k = k + 1 end");
    row("many values", "local t = {} for i = 1, 200000 do t[i] = i end\n"
                       "while true do local n = select('#', table.unpack(t)) end");
    row("insert", "local t = {} for i = 1, 100000 do t[i] = i end\n"
                  "while true do table.insert(t, 1, 0) end");
    row("unknown names", "local function f() return nowhere end while true do pcall(f) end");
    row("a very long unknown name",
        "local a = 'x' for i = 1, 20 do a = a .. a end\n"
        "local function f() return _ENV[a] end while true do pcall(f) end");
    row("vectors that cannot be changed",
        "local function f() circle1.position.x = 1 end while true do pcall(f) end");
    row("long numbers written",
        "while true do local s = string.format('%99.99f %99.99f', 1e308, 1e308) end");
    row("memory at its brim",
        "local t = {} for i = 1, 600000 do t[i] = {i} end while true do local x = {} end");
}

void TestSameVerdict::costlyWorkEndsByCount()
{
    QFETCH(QString, statements);
    const QString source = lua("function on_update(dt)\n%1\nend").arg(statements);
    const Elsewhere first = runElsewhere(source, 200);
    QVERIFY(first.run.error);
    QVERIFY2(first.run.error->kind == ProgramError::Kind::Time
                 || first.run.error->kind == ProgramError::Kind::Memory,
             first.run.say().constData());
    const Elsewhere again = runElsewhere(source, 200);
    QVERIFY(again.run.error);
    QCOMPARE(again.run.error->kind, first.run.error->kind);
    QCOMPARE(again.run.error->message, first.run.error->message);
    QCOMPARE(again.run.world.step, first.run.world.step);
}

QTEST_GUILESS_MAIN(TestSameVerdict)
#include "test_same_verdict.moc"
