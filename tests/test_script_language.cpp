// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/script/student_script.h"

using namespace cradle;
using namespace cradle::programs;

/// What a program can write: vectors, circles and the library. Wrong names are in
/// test_script_names.cpp, what it shows in test_script_showing.cpp.
class TestScriptLanguage : public QObject
{
    Q_OBJECT
private slots:
    void expressionHasItsValue_data();
    void expressionHasItsValue();
    void wrongUseIsExplained_data();
    void wrongUseIsExplained();
    void decimalCommaIsToldThePoint_data();
    void decimalCommaIsToldThePoint();
    void twoValuesAreNoDecimalComma_data();
    void twoValuesAreNoDecimalComma();
    void changedVectorIsToldWhatToWrite_data();
    void changedVectorIsToldWhatToWrite();
    void numberThatIsNotFiniteStopsAtItsLine_data();
    void numberThatIsNotFiniteStopsAtItsLine();
    void fieldsOfCirclesAreAssignable();
    void listOfCirclesIsWalked();
    void pairsKeepTheirOrder();
};

void TestScriptLanguage::expressionHasItsValue_data()
{
    QTest::addColumn<QString>("value");
    const auto row = [](const char *expression, const char *value) {
        QTest::newRow(expression) << lua(value);
    };
    row("vec(1, 2)", "(1, 2)");
    row("vec(1.5, -2).x, vec(1.5, -2).y", "1.5\t-2.0");
    row("vec(1, 2) + vec(3, 5)", "(4, 7)");
    row("vec(1, 2) - vec(3, 5)", "(-2, -3)");
    row("2 * vec(1, 2)", "(2, 4)");
    row("vec(1, 2) * 2", "(2, 4)");
    row("vec(1, 2) / 2", "(0.5, 1)");
    row("-vec(1, -2)", "(-1, 2)");
    row("vec(1, 2) == vec(1, 2)", "true");
    row("vec(1, 2) == vec(2, 1)", "false");
    row("vec(1, 2) ~= vec(1, 2)", "false");
    row("vec(1, 2) == 1", "false");
    row("vec(1, 2) == circle1", "false");
    row("circle1 == circles[1], circle1 == circle2", "true\tfalse");
    row("vec(3, 4):length()", "5.0");
    row("vec(3, 4):length_squared()", "25.0");
    row("vec(3, 4):normalized()", "(0.6, 0.8)");
    row("vec(1e200, 0):normalized()", "(1, 0)");
    row("vec(1, 2):dot(vec(3, 4))", "11.0");
    row("dot(vec(1, 2), vec(3, 4))", "11.0");
    row("vec(1, 2):perpendicular()", "(-2, 1)");
    row("vec(1, 2):perpendicular():dot(vec(1, 2))", "0.0");
    row("'v = ' .. vec(1, 2)", "v = (1, 2)");
    row("vec(1, 2) .. '!'", "(1, 2)!");
    row("vec(1, 2) / 0 == vec(math.huge, math.huge)", "true");
    row("type(vec(1, 2)), type(circle1), type(circles)", "vector\tcircle\tuserdata");
    row("type(1), type('a'), type(nil), type({}), type(print)",
        "number\tstring\tnil\ttable\tfunction");
    row("circle1, circles, square", "circle1\tcircles\tsquare");
    row("circle1.position, circle1.velocity, circle1.radius, circle1.density",
        "(-2, 2)\t(2, 0)\t0.2\t7.8");
    row("circle2.index, circles[1].index, #circles", "2\t1\t2");
    row("circles[3], circles[0], circles[1.5], circles[1e9]", "nil\tnil\tnil\tnil");
    row("square.half_width, square.left, square.right, square.bottom, square.top",
        "4.0\t-4.0\t4.0\t-4.0\t4.0");
    row("time, step", "0.0\t0");
    row("0.1 + 0.2, 1/3, 1e100, 7 // 2, 7 % 4, 2 ^ 10",
        "0.3\t0.33333333333333\t1e+100\t3\t3\t1024.0");
    row("math.sqrt(16), math.abs(-2), math.max(1, 3), math.min(1, 3), math.floor(2.7)",
        "4.0\t2\t3\t1\t2");
    row("math.pi, math.huge, math.sin(0), math.cos(0)", "3.1415926535898\tinf\t0.0\t1.0");
    row("math.random() < 1, math.random(5) <= 5, math.type(1)", "true\ttrue\tinteger");
    row("string.format('%.2f %5d %s', 1.005, 42, vec(1, 2))", "1.00    42 (1, 2)");
    row("('abc'):upper(), ('ABC'):lower(), ('abc'):len(), ('abc'):sub(2, 3), #'abc'",
        "ABC\tabc\t3\tbc\t3");
    row("string.upper('a'), string.lower('A'), string.len('a'), string.sub('abc', 1, 1)",
        "A\ta\t1\ta");
    row("table.concat({1, 2, 3}, '+'), table.unpack({4, 5})", "1+2+3\t4\t5");
    row("(function() local t = {3, 1, 2} table.sort(t) return table.concat(t) end)()", "123");
    row("(function() local t = {3, 1} table.sort(t, function(a, b) return a > b end) "
        "return table.concat(t) end)()",
        "31");
    row("(function() local t = {1} table.insert(t, 2) table.insert(t, 1, 0) table.remove(t) "
        "return table.concat(t) end)()",
        "01");
    row("'10' + 1, '6' * '7', -'3', 2 ^ '3'", "11\t42\t-3\t8.0");
    row("(function() string = 5 return ('a'):upper(), string end)()", "A\t5");
    row("(function() function string.twice(s) return s .. s end return ('a'):twice() end)()", "aa");
    row("(function() math = {pi = 3} table = 4 return math.pi, table end)()", "3\t4");
    row("(function() local m = math math = nil return m.pi > 3, pcall(function() return math "
        "end) end)()",
        "true\tfalse\t`math` is not known: nothing of that name was given a value before");
    row("pcall(math.sqrt)",
        "false\tbad argument #1 to 'math.sqrt' (number expected, got no value)");
    row("select('#', 1, nil), select(2, 'a', 'b')", "2\tb");
    row("tostring(12), tonumber('0x10'), tonumber('z'), tonumber('11', 2)", "12\t16\tnil\t3");
    row("pcall(error, 'no')", "false\tno");
    row("pcall(function(a) return a, 2 end, 1)", "true\t1\t2");
    row("(pcall(function() return vec(1, 2) + 1 end))", "false");
    row("assert(1, 2)", "1\t2");
}

void TestScriptLanguage::expressionHasItsValue()
{
    QFETCH(QString, value);
    const ScriptRun run =
        runScript(lua("print(") + QString::fromUtf8(QTest::currentDataTag()) + lua(")"));
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text, value + lua("\n"));
}

void TestScriptLanguage::wrongUseIsExplained_data()
{
    QTest::addColumn<QString>("words");
    const auto row = [](const char *statement, const char *words) {
        QTest::newRow(statement) << lua(words);
    };
    row("return 1 + vec(1, 2)", "the number 1 + the vector (1, 2) has no meaning");
    row("return vec(1, 2) + 1", "the vector (1, 2) + the number 1 has no meaning");
    row("return vec(1, 2) - 1", "a vector is taken from a vector");
    row("return vec(1, 2) * vec(3, 4)", "for the dot product write a:dot(b)");
    row("return 1 / vec(1, 2)", "a vector is divided by a number");
    row("return vec(1, 2) / vec(1, 2)", "a vector is divided by a number");
    row("return '1' * vec(1, 2)", "the text \"1\" * the vector (1, 2)");
    row("return vec(1, 2) + nil", "+ nil has no meaning");
    row("return vec(1)", "vec(x, y) takes two numbers; y is nothing");
    row("return vec('a', 2)", "x is the text \"a\"");
    row("return vec('1', 2)", "x is the text \"1\"");
    row("return vec(vec(1, 2), 0)", "x is the vector (1, 2)");
    row("return vec(1, 2, 3)", "takes two numbers, not 3");
    row("return vec(1, 2) < vec(2, 3)", "v:length()");
    row("return vec(0, 0):normalized()", "has no direction");
    row("return vec(1, 2).length(3)", "write v:length(), with a colon");
    row("return vec(1, 2):dot(3)", "dot needs a vector, not the number 3");
    const char *colon =
        "dot got one vector and takes two: write a:dot(b) with a colon, or dot(a, b)";
    row("return dot(vec(1, 2))", colon);
    row("local v = vec(1, 2) return v.dot(v)", colon);
    row("return vec(1, 2):dot(nil)", "dot needs a vector, not nil");
    row("circle1.position = 3", "circle1.position must be a vector, not the number 3");
    row("circle1.velocity = nil",
        "circle1.velocity must be a vector, not nil: what it is to become has no value here");
    row("return vec(1, 2) * {}", "a vector is multiplied by a number");
    row("return circle1.restitution",
        "circle1 has no field `restitution`: it belongs to the whole world; write `restitution`");
    row("return circle2.time", "write `time` alone");
    row("circle1.radius = vec(1, 2)", "circle1.radius must be a number");
    row("circle1.radius = '1'", "circle1.radius must be a number, not the text \"1\"");
    row("circle1.radius = 0", "circle1.radius would be 0; it must be finite and above 0");
    row("circle1.density = -1", "circle1.density would be -1");
    row("circle1[1] = 2", "a field has a name");
    row("return circles['x']", "circles[i] takes a number from 1 to 2, not the text \"x\"");
    row("circles[9].radius = 1", "is nil, so it has no fields");
    row("return circle1 + vec(1, 2)", "circle1 + the vector (1, 2) has no meaning");
    row("return circle1 + 1", "`circle1` is circle, not a number");
    row("gravity = 9.81", "gravity must be a vector in m/s², not the number 9.81; write gravity = "
                          "vec(0, -9.81)");
    row("gravity = 0", "write gravity = vec(0, 0)");
    row("gravity = -1.62", "write gravity = vec(0, -1.62)");
    row("gravity = {0, 0}", "write gravity = vec(0, -9.81)");
    row("gravity = vec(0, 1e9)", "at most 10000");
    row("restitution = 1.5", "restitution must be a number from 0 to 1");
    row("restitution = vec(1, 2)", "restitution must be a number from 0 to 1");
    row("return ('x' .. nil)", "nil");
    row("return circle1.mass.x", "circle1 has no field `mass`");
    row("local a\na.b = 1", "`a` is nil, so it has no fields");
    row("table.sort(3)", "table expected");
    row("table.sort({3, 'a', 1})", "attempt to compare");
    row("for k in pairs(5) do end", "pairs goes through a table or circles, not the number 5");
    row("for k in pairs(circle1) do end", "not circle1");
    row("local function f() return f() + 1 end\nf()", "does one call itself without end?");
}

void TestScriptLanguage::wrongUseIsExplained()
{
    QFETCH(QString, words);
    const QString statement = QString::fromUtf8(QTest::currentDataTag());
    const ScriptRun run = runScript(lua("\nlocal function work()\n") + statement
                                    + lua("\nend\nlocal result = work()"));
    const bool second = statement.contains(lua("local a\n"));
    VERIFY_STOPS(run, second ? 4 : 3, words);
    QVERIFY2(!run.error->message.contains(lua("table.sort:")), run.say().constData());
    QVERIFY2(!run.error->message.contains(lua("userdata")), run.say().constData());
}

void TestScriptLanguage::decimalCommaIsToldThePoint_data()
{
    QTest::addColumn<QString>("words");
    const auto row = [](const char *statement, const char *words) {
        QTest::newRow(statement) << lua(words);
    };
    row("restitution = 0,5", "restitution would be 0 here: the comma ends a value; a number has a "
                             "point, 0.5");
    row("  circle2.density=7,85;", "circle2.density would be 7 here");
    row("local g = -9,81 -- m/s²", "a number has a point, -9.81");
    row("--[[ e ]]\nlocal e = 0,5", "e would be 0 here");
}

void TestScriptLanguage::decimalCommaIsToldThePoint()
{
    QFETCH(QString, words);
    const QString statement = QString::fromUtf8(QTest::currentDataTag());
    const int line = 2 + static_cast<int>(statement.count(QLatin1Char('\n')));
    const ScriptRun run = runScript(lua("local s = 'ä'\n") + statement + lua("\n"));
    VERIFY_STOPS(run, line, words);
    QCOMPARE(run.error->kind, ProgramError::Kind::Syntax);
    const auto error = findSyntaxError(lua("local s = 'ä'\n") + statement);
    QVERIFY(error);
    QCOMPARE(error->line, line);
}

void TestScriptLanguage::twoValuesAreNoDecimalComma_data()
{
    QTest::addColumn<QString>("source");
    const auto row = [](const char *name, const char *source) {
        QTest::newRow(name) << lua(source);
    };
    row("counts", "for i = 1,2 do end");
    row("two names", "local a, b = 0,5");
    row("two names in two lines", "local a,\nb = 0,5");
    row("arguments", "local v = vec(0,5)");
    row("parts of a table", "local t = {\nx = 0,5\n}");
    row("comment", "--[[\nrestitution = 0,5\n]]");
    row("text", "local t = [[\nrestitution = 0,5\n]]");
    row("space", "local a = 1, 2");
}

void TestScriptLanguage::twoValuesAreNoDecimalComma()
{
    QFETCH(QString, source);
    const ScriptRun run = runScript(source);
    VERIFY_RUNS(run);
    QVERIFY(!findSyntaxError(source));
}

void TestScriptLanguage::changedVectorIsToldWhatToWrite_data()
{
    QTest::addColumn<QString>("words");
    QTest::newRow("circle1.position.x = 3")
        << lua("build a new one: circle1.position = vec(3, circle1.position.y)");
    QTest::newRow("circle1.velocity.y = -circle1.velocity.y")
        << lua("circle1.velocity = vec(circle1.velocity.x, -circle1.velocity.y)");
    QTest::newRow("if circle1.radius > 0 then circles[2].position.x = 1 end")
        << lua("circles[2].position = vec(1, circles[2].position.y)");
    QTest::newRow("local v = vec(1, 2) v.y = 2 * v.x -- twice") << lua("v = vec(v.x, 2 * v.x)");
    QTest::newRow("local v = vec(1, 2) v['x'] = 5") << lua("a vector cannot be changed");
    QTest::newRow("local v = vec(1, 2) v.z = 5") << lua("a vector cannot be changed");
}

void TestScriptLanguage::changedVectorIsToldWhatToWrite()
{
    QFETCH(QString, words);
    const ScriptRun run = runScript(lua("\n\n\n") + QString::fromUtf8(QTest::currentDataTag()));
    VERIFY_STOPS(run, 4, words);
}

void TestScriptLanguage::numberThatIsNotFiniteStopsAtItsLine_data()
{
    QTest::addColumn<QString>("words");
    QTest::newRow("circle1.position = vec(1 / 0, 0)") << lua("circle1.position would be (inf, 0)");
    QTest::newRow("circle1.velocity = vec(0, 0 / 0)") << lua("circle1.velocity would be");
    QTest::newRow("circle1.velocity = vec(0, -math.huge)") << lua("(0, -inf)");
    QTest::newRow("circle2.radius = 1 / 0") << lua("circle2.radius would be inf");
    QTest::newRow("circle2.density = 0 / 0") << lua("circle2.density would be");
    QTest::newRow("gravity = vec(0, 1 / 0)") << lua("gravity would be (0, inf)");
    QTest::newRow("circle1.position = vec(1e308, 0) * 10") << lua("must be finite");
}

void TestScriptLanguage::numberThatIsNotFiniteStopsAtItsLine()
{
    QFETCH(QString, words);
    const QString statement = QString::fromUtf8(QTest::currentDataTag());
    for (const bool pinned : {false, true}) {
        const ScriptRun run = runScript(lua("local x = 1\n") + statement, 0, {.pinned = pinned});
        VERIFY_STOPS(run, 2, words);
    }
}

void TestScriptLanguage::fieldsOfCirclesAreAssignable()
{
    const ScriptRun run = runScript(lua(R"lua(
function on_update()
  circle1.position, circle1.velocity = vec(1, 2), vec(3, 4)
  circle2.radius, circle2.density = 0.5, 1
  circle2.mass, circle2.name, circle2.seen = 3, "b", {1}
  circle2.mass = nil
  circle2.seen[1] = circle2.name .. #circle2.seen
  print(circle2.name, circle2.seen[1], pcall(function() return circle2.mass end))
end)lua"),
                                    1);
    VERIFY_RUNS(run);
    QCOMPARE(run.circle(1).position, (Vec2{1.0, 2.0}));
    QCOMPARE(run.circle(1).velocity, (Vec2{3.0, 4.0}));
    QCOMPARE(run.circle(2).radius, 0.5);
    QCOMPARE(run.circle(2).density, 1.0);
    QVERIFY2(run.output.text.startsWith(lua("b\tb1\tfalse\tcircle2 has no field `mass`")),
             qPrintable(run.output.text));
}

void TestScriptLanguage::listOfCirclesIsWalked()
{
    const ScriptRun run = runScript(lua(R"lua(
for i, c in ipairs(circles) do print(i, c, c.index) end
for i, c in pairs(circles) do print(i, c == circles[i]) end
for i = 1, #circles do circles[i].mass = i end
print(circle1.mass + circle2.mass)
local walk, list = pairs(circles)
print(walk(list, math.maxinteger), walk(list, -5), walk(list, 2)))lua"));
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text,
             lua("1\tcircle1\t1\n2\tcircle2\t2\n1\ttrue\n2\ttrue\n3\nnil\tnil\tnil\n"));
}

void TestScriptLanguage::pairsKeepTheirOrder()
{
    const ScriptRun run = runScript(lua(R"lua(
local t = {b = 1, a = 2, [10] = 3, "x", "y", [-1] = 4, [0.5] = 5, [true] = 6, aa = 7}
local keys = ""
for k, v in pairs(t) do
  keys = keys .. tostring(k) .. " "
  t[k] = nil
end
print(keys .. "left " .. tostring(pairs(t)(t)))
for k in pairs({a = 1, b = 2, c = 3}) do if k == "b" then break end print(k) end
local u = {a = 1, b = 2, c = 3}
for k in pairs(u) do u.b = nil print(k) end
for k in pairs({}) do print(k) end)lua"));
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text, lua("-1 1 2 10 0.5 a aa b true left nil\na\na\nc\n"));
}

QTEST_GUILESS_MAIN(TestScriptLanguage)
#include "test_script_language.moc"
