// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/script/student_script.h"

using namespace cradle;
using namespace cradle::programs;

/// What people write who come from C#: told at the line where it stands, in the words of Lua.
class TestMeant : public QObject
{
    Q_OBJECT
private slots:
    void grammarOfAnotherLanguage_data();
    void grammarOfAnotherLanguage();
    void wayOfAnotherLanguage_data();
    void wayOfAnotherLanguage();
    void soundProgramsAreNotTaught_data();
    void soundProgramsAreNotTaught();
    void aMissingArgumentIsSoughtAtTheCall_data();
    void aMissingArgumentIsSoughtAtTheCall();
    void otherErrorsKeepTheirWords_data();
    void otherErrorsKeepTheirWords();
};

namespace {

void row(const char *name, const char *source, int line, const char *words)
{
    QTest::newRow(name) << lua(source) << line << lua(words);
}

void addColumns()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("words");
}

} // namespace

void TestMeant::grammarOfAnotherLanguage_data()
{
    addColumns();
    row("if with braces", "x = 1\nif (x > 0) {\n  x = 2\n}", 2, "if … then … else … end");
    row("if with braces in a line", "x = 1\nif (x > 0) { x = 2 }", 2, "if … then … else … end");
    row("brace of its own line", "x = 1\nif (x > 0)\n{\n  x = 2\n}", 3, "no braces around blocks");
    row("else with braces", "if x then\n  y = 1\n} else {\n  y = 2\n}", 3,
        "if … then … else … end");
    row("while with braces", "x = 1\nwhile (x < 5) {\n  x = x + 1\n}", 2, "while … do … end");
    row("function with braces", "function on_update(dt) {\n  x = 1\n}", 1,
        "function name(…) … end");
    row("for with braces", "for i = 1, 3 {\n  x = i\n}", 1, "for … do … end");
    row("for of C", "x = 1\nfor (int i = 0; i < 3; i++) {\n  x = i\n}", 2,
        "for i = first, last do … end");
    row("for of C without parentheses", "for i = 0; i < 3; i++ do\nend", 1,
        "for i = first, last do … end");
    row("assignment in a condition", "x = 1\nif x = 2 then\nend", 2, "to compare write ==");
    row("assignment behind a comparison", "x = 1\nif x > 0 and x = 2 then\nend", 2,
        "to compare write ==");
    row("condition without then", "x = 1\nif x > 0\n  x = 2\nend", 2, "here `then` is missing");
    row("minus of a text", "x = 1\ny = −x", 2, "− is not the minus of Lua");
    row("point between factors", "x = 1\ny = 2 · x", 2, "does not know the sign ·");
    row("quotes of a text", "x = 1\nprint(“hit”)", 2, "does not know the sign “");
    row("letter of another alphabet", "x = 1\nδ = 2", 2, "names have the letters a to z");
    row("foreach", "foreach (var c in circles) {\n  x = c\n}", 1,
        "for _, c in ipairs(circles) do … end");
    row("foreach of a field", "foreach (Circle ball in world.balls)\n{\n}", 1,
        "for _, ball in ipairs(world.balls) do … end");
    row("float", "x = 1\nfloat y = 1.5;\n", 2, "local y = …");
    row("float without value", "float y;\n", 1, "local y = …");
    row("var", "function on_update(dt)\n  var speed = 2\nend", 2, "local speed = …");
    row("int", "int i = 0", 1, "local i = …");
    row("double", "double d = 0.5;", 1, "local d = …");
    row("const float", "const float g = 9.81f;", 1, "local g = …");
    row("array", "float[] masses = {1, 2};", 1, "local masses = …");
    row("vector", "Vector2 v = new Vector2(1, 2);", 1, "local v = …");
    row("list", "List<float> masses = x;", 1, "local masses = …");
    row("own type", "Circle c = circles[1];", 1, "local c = …");
    row("void", "x = 1\nvoid on_update()\nend", 2, "function on_update(…) … end");
    row("public void", "public void on_load() {\n}", 1, "function on_load(…) … end");
    row("typed parameter", "function on_update(float timestep)\nend", 1,
        "of a parameter write only the name: timestep");
    row("using", "using System;", 1, "Lua has no `using`");
    row("class", "class Ball {\n}", 1, "Lua has no `class`");
    row("increment", "x = 1\nx++", 2, "write x = x + 1");
    row("increment of a field", "circle1.hits++;", 1, "write circle1.hits = circle1.hits + 1");
    row("increment before", "++x", 1, "write x = x + 1");
    row("decrement", "x = 1\nx--\ny = 2", 2, "write x = x - 1");
    row("decrement at the end of a block", "function f()\n  x--;\n\nend", 2, "write x = x - 1");
    row("compound", "x = 1\nx += 1", 2, "write x = x + 1");
    row("compound with a semicolon", "circle1.speed *= -1;", 1,
        "write circle1.speed = circle1.speed * -1 ");
    row("unequal", "if 1 != 2 then end", 1, "~= in Lua");
    row("and", "x = 1\nif x > 0 && x < 2 then end", 2, "`and`, `or`, `not`");
    row("or", "if x || y then end", 1, "`and`, `or`, `not`");
    row("not", "x = 1\nif !x then end", 2, "`not` in words");
    row("comment", "x = 1\n// the speed\ny = 2", 2, "a comment begins with --");
    row("comment behind a statement", "x = 1; // the speed\ny = 2", 1, "a comment begins with --");
    row("comment behind a number", "x = 1 // the speed of it\ny = 2", 1,
        "a comment begins with --");
    row("comment with an apostrophe", "x = 1\n// don't move\ny = 2", 2, "a comment begins with --");
    row("long comment", "/* move */\nx = 1", 1, "a comment begins with --");
    row("type before a comment", "float y = 1; // is it right?", 1, "local y = …");
    row("choice", "x = 1\ny = x > 0 ? 1 : 2", 2, "condition and a or b");
    row("choice of constants", "y = true ? 1 : 2", 1, "condition and a or b");
    row("lambda", "x = 1\nf = (a) => a + 1", 2, "function(x) return … end");
    row("continue", "for i = 1, 3 do\n  continue;\nend", 2, "Lua has no `continue`");
    row("continue without a semicolon", "for i = 1, 3 do\n  continue\nend", 2,
        "Lua has no `continue`");
    row("else if",
        "function f(x)\n  if x > 1 then\n    y = 1\n  else if x > 0 then\n    y = 2\n"
        "  end\nend\n",
        4, "elseif");
    row("missing then", "x = 1\nif x > 0\n  x = 2\nend", 2, "here `then` is missing");
    row("missing do", "x = 1\nwhile x > 0\n\n  x = 0\nend", 2, "here `do` is missing");
    row("code after return", "function f()\n  return 1\n  x = 2\nend", 3, "return ends its block");
    row("code after return in a line",
        "function f()\n  do return end x = 2\n  return x; x = 1\nend", 3, "return ends its block");
    row("code after an empty return", "function f()\n  return\n  x = 2\nend", 3,
        "return ends its block");
    row("assignment in a condition", "if x = 1 then end", 1, "to compare write ==");
}

void TestMeant::grammarOfAnotherLanguage()
{
    QFETCH(QString, source);
    QFETCH(int, line);
    QFETCH(QString, words);
    const ScriptRun run = runScript(source);
    VERIFY_STOPS(run, line, words);
    QCOMPARE(run.error->kind, ProgramError::Kind::Syntax);
    const auto alone = findSyntaxError(source);
    QVERIFY(alone);
    QCOMPARE(alone->line, line);
    QCOMPARE(alone->message, run.error->message);
}

void TestMeant::wayOfAnotherLanguage_data()
{
    addColumns();
    row("circles from 0", "\ncircles[0].velocity = vec(1, 0)", 2,
        "There is no circles[0]: circles are counted from 1 to 2");
    row("loop from 0", "for i = 0, #circles do\n  circles[i].radius = 1\nend", 2,
        "There is no circles[0]: circles are counted from 1 to 2");
    row("loop beyond the last", "for i = 1, #circles + 1 do\n  circles[i].radius = 1\nend", 2,
        "There is no circles[3]");
    row("circle 0 in a local", "local c = circles[0]\nlocal n = 1\nprint(c.position)", 3,
        "There is no circles[0]");
    row("new", "local v = new Vector2(1, 2)", 1, "Lua has no `new`; a vector is made by vec(x, y)");
    row("Vector2", "\nlocal v = Vector2(1, 2)", 2, "a vector is made by vec(x, y)");
    row("Math.Sqrt", "local x = Math.Sqrt(2)", 1, "`Math.Sqrt` is math.sqrt in Lua");
    row("Math.Abs", "local x = 1 +\n Math.Abs(2)", 2, "`Math.Abs` is math.abs in Lua");
    row("Math.PI", "local x = 4 / 3 * Math.PI", 1, "`Math.PI` is math.pi in Lua");
    row("Math.Pow", "local x = Math.Pow(2, 3)", 1, "`Math.Pow` is a ^ b in Lua");
    row("Mathf", "local x = Mathf.Max(2, 3)", 1, "`Mathf.Max` is math.max in Lua");
    row("math.Sqrt", "local x = math.Sqrt(2)", 1, "did you mean `math.sqrt`?");
    row("Position", "local p = circle1.Position", 1, "did you mean `position`?");
    row("Position assigned", "\ncircle1.Position = vec(1, 1)", 2, "did you mean `position`?");
    row("null", "local c = circle1\nif c == null then end", 2, "nothing is written nil");
    row("this", "this.x = 1", 1, "there is no `this` here");
    row("Console", "Console.WriteLine(1)", 1, "print(…)");
    row("comment of one word", "local x = 1 // speed\n", 1, "a comment begins with --");
    row("text plus text", "local s = 'a' .. 'b'\ns = s + 'c'", 2, "Texts are joined by ..");
    row("text plus number", "local s = 'a' + 1", 1, "Texts are joined by ..");
    row("number plus text", "local n = 3\nlocal s = n + ' m'", 2, "Texts are joined by ..");
    row("Length of the circles", "for i = 1, circles.Length do end", 1, "#circles");
    row("Count of the circles", "local n = circles.Count", 1, "#circles");
    row("Length of a list", "local list = {1, 2}\nfor i = 1, list.Length do end", 2,
        "The length of a list is #list");
    row("Length in a sum", "local list = {1, 2}\nlocal n = list.Length + 1", 2,
        "The length of a list is #list");
    row("length without a call", "local s = circle1.velocity.length * 2", 1, "v:length()");
    row("function below",
        "function on_load()\n  bounce(circle1)\nend\n"
        "local function bounce(c) end",
        2, "`bounce` is not known yet: it is local and stands below, in line 4");
    row("function below as a value",
        "local x = 1\nfunction on_load()\n  bounce(x)\nend\n\n"
        "local bounce = function(c) end",
        3, "in line 6; move it up, or leave out `local`");
    row("local of another function",
        "function on_load()\n  local old = vec(0, 0)\n  go()\nend\n"
        "function go()\n  print(old)\nend",
        6, "`old` is not known here: it is local to another block, in line 2; a function gets");
    row("local of a block within",
        "function go()\n  if true then\n    local old = 1\n  end\n"
        "  print(old)\nend\ngo()",
        5, "`old` is not known here: it is local to the block of line 3; declare it before");
    row("local of a block", "if true then\n  local hit = 1\nend\nprint(hit)", 4,
        "`hit` is not known here: it is local to the block of line 2");
    row("misspelt local", "local old_position = 1\nprint(old_positon)", 2,
        "did you mean `old_position`?");
    row("misspelt parameter",
        "function on_load()\n  go(1)\nend\nfunction go(timestep)\n"
        "  print(timestpe)\nend",
        5, "did you mean `timestep`?");
    row("misspelt outer local",
        "local speed_limit = 3\nfunction on_load()\n"
        "  print(sped_limit)\nend",
        3, "did you mean `speed_limit`?");
    row("misspelt counter", "for index = 1, 2 do\n  print(indx)\nend", 2, "did you mean `index`?");
    row("misspelt local function", "local function bounce() end\nbuonce()", 2,
        "did you mean `bounce`?");
}

void TestMeant::wayOfAnotherLanguage()
{
    QFETCH(QString, source);
    QFETCH(int, line);
    QFETCH(QString, words);
    const ScriptRun run = runScript(source);
    VERIFY_STOPS(run, line, words);
    QCOMPARE(run.error->kind, ProgramError::Kind::Runtime);
}

void TestMeant::soundProgramsAreNotTaught_data()
{
    QTest::addColumn<QString>("source");
    QTest::newRow("semicolons") << lua("local x = 1; local y = 2;\nfunction f() return x; end");
    QTest::newRow("else with an if of its own")
        << lua("local x = 1\nif x > 2 then\nelse if x > 1 then\nend\nend");
    QTest::newRow("whole division") << lua("local x = 7 // 2");
    QTest::newRow("nothing before the first") << lua("local c = circles[0]\nassert(c == nil)");
    QTest::newRow("signs in a text") << lua("print('a != b ? c : d && e') -- x += 1");
}

void TestMeant::soundProgramsAreNotTaught()
{
    QFETCH(QString, source);
    VERIFY_RUNS(runScript(source));
}

void TestMeant::aMissingArgumentIsSoughtAtTheCall_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<int>("line"); // of the call that is named; 0 for none
    QTest::newRow("none given") << lua("local function f(a, c)\n  return c.radius\nend\n"
                                       "local r = f(circle1, circle1)\nr = f(circle1)")
                                << 5;
    QTest::newRow("number") << lua("local function f(c)\n  return c + 1\nend\nlocal r = f()") << 4;
    QTest::newRow("emptied here") << lua("local function f(c)\n  c = nil\n  return c.radius\nend\n"
                                         "local r = f(circle1)")
                                  << 0;
    QTest::newRow("another local") << lua("local function f()\n  local c\n  return c.radius\nend\n"
                                          "local r = f()")
                                   << 0;
    QTest::newRow("called by nobody") << lua("function on_load(c)\n  c.radius = 1\nend") << 0;
    QTest::newRow("call that is gone")
        << lua("local function f(c)\n  return c.radius\nend\n"
               "local function g()\n  return f()\nend\nlocal r = g()")
        << 0;
}

void TestMeant::aMissingArgumentIsSoughtAtTheCall()
{
    QFETCH(QString, source);
    QFETCH(int, line);
    const ScriptRun run = runScript(source);
    QVERIFY(run.error);
    const QString hint = lua("Look at what the call in line %1 gives for it").arg(line);
    QCOMPARE(run.error->message.contains(lua("the call in line")), line > 0);
    QVERIFY2(line == 0 || run.error->message.endsWith(hint), qPrintable(run.error->message));
}

void TestMeant::otherErrorsKeepTheirWords_data()
{
    addColumns();
    row("signs in a text", "print('a != b' 'c')", 1, "')' expected near ''c''");
    row("table that is returned", "function f() return {\n  1 }\nend y = = 1", 3,
        "unexpected symbol near '='");
    row("missing end", "function f()\n  if x then\nend\n", 4,
        "'end' expected (to close 'function' at line 1)");
    row("another list", "local t = {}\nlocal c = circles[1]\nprint(t[0].x, c)", 3,
        "this value is nil, so it has no fields");
    row("circle that is there", "local t = {}\nprint(circles[1].radius + t[0].x)", 2,
        "this value is nil, so it has no fields");
    row("arithmetic on nothing", "local n = nil\nprint(1 + n)", 2,
        "`n` is nil, not a number to calculate with");
    row("unknown name", "local x = 1\nprint(quite_another)", 2, "nothing of that name was given");
}

void TestMeant::otherErrorsKeepTheirWords()
{
    QFETCH(QString, source);
    QFETCH(int, line);
    QFETCH(QString, words);
    const ScriptRun run = runScript(source);
    VERIFY_STOPS(run, line, words);
    QVERIFY2(run.error->message.startsWith(words) || words.startsWith(lua("nothing")),
             run.say().constData());
    QVERIFY2(!run.error->message.contains(lua("counted from")), run.say().constData());
}

QTEST_GUILESS_MAIN(TestMeant)
#include "test_meant.moc"
