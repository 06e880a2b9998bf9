// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/script/student_script.h"

#include <QRegularExpression>

using namespace cradle;
using namespace cradle::programs;

/// Names that a program gets wrong, and names that it must not have.
class TestScriptNames : public QObject
{
    Q_OBJECT
private slots:
    void forbiddenNameIsAbsent_data();
    void forbiddenNameIsAbsent();
    void misspeltNameIsToldTheRightOne_data();
    void misspeltNameIsToldTheRightOne();
    void oneCircleIsToldInTheSingular();
    void nameOfItsOwnIsWelcome_data();
    void nameOfItsOwnIsWelcome();
    void ownGlobalsAreSuggestedToo();
    void environmentIsNoWayOut_data();
    void environmentIsNoWayOut();
};

void TestScriptNames::forbiddenNameIsAbsent_data()
{
    QTest::addColumn<QString>("words");
    for (const char *name : {"os.exit()",
                             "io.open('x')",
                             "debug.getinfo(1)",
                             "require('os')",
                             "load('x = 1')",
                             "loadstring('x = 1')",
                             "loadfile('x')",
                             "dofile('x')",
                             "package.path",
                             "coroutine.wrap",
                             "setmetatable({}, {})",
                             "getmetatable('')",
                             "rawset({}, 1, 1)",
                             "rawget({}, 1)",
                             "rawequal(1, 1)",
                             "rawlen({})",
                             "utf8.char(65)",
                             "collectgarbage()",
                             "xpcall(print, print)",
                             "next({})",
                             "warn('x')",
                             "_G.os"}) {
        QTest::newRow(name) << QString::fromUtf8(name)
                                   .section(QRegularExpression(lua("\\W")), 0, 0)
                                   .prepend(lua("`"))
                                   .append(lua("` is not part of the lab's Lua"));
    }
    for (const char *name :
         {"string.rep", "string.find", "string.gsub", "string.match", "string.gmatch",
          "string.dump", "string.byte", "string.char", "table.move", "table.pack"})
        QTest::newRow(name) << lua("`%1` is not part of the lab's Lua").arg(lua(name));
    QTest::newRow("('x'):rep(1000)") << lua("`string.rep` is not part of the lab's Lua");
    QTest::newRow("('x'):gsub('x', 'y')") << lua("`string.gsub` is not part of the lab's Lua");
}

void TestScriptNames::forbiddenNameIsAbsent()
{
    QFETCH(QString, words);
    const QString name = QString::fromUtf8(QTest::currentDataTag());
    VERIFY_STOPS(runScript(lua("\nlocal x = ") + name), 2, words);
    VERIFY_STOPS(runScript(lua("function on_update()\n local x = ") + name + lua("\nend"), 1), 2,
                 words);
}

void TestScriptNames::misspeltNameIsToldTheRightOne_data()
{
    QTest::addColumn<QString>("words");
    const auto row = [](const char *statement, const char *words) {
        QTest::newRow(statement) << lua(words);
    };
    row("return gravty", "`gravty` is not known: did you mean `gravity`?");
    row("return Gravity", "did you mean `gravity`?");
    row("return circel1.position", "did you mean `circle1`?");
    row("return Circle1", "did you mean `circle1`?");
    row("return sqaure.left", "did you mean `square`?");
    row("return vector(1, 2)", "`vector` is not known");
    row("prnt(1)", "did you mean `print`?");
    row("return circle3", "there is no circle3: the scene has 2 circles");
    row("return circle1.positoin", "circle1 has no field `positoin`: did you mean `position`?");
    row("return circle1.pos", "did you mean `position`?");
    row("return circle1.speed", "circle1 has no field `speed`; it has position");
    row("circle1.velocty = vec(0, 0)", "circle1 has no field `velocty`: did you mean `velocity`?");
    row("circle1.raduis = 1", "did you mean `radius`?");
    row("return circle1.position.X", "did you mean `x`?");
    row("return circle1.velocity:lenght()", "a vector has no `lenght`: did you mean `length`?");
    row("return circle1.velocity:normalise()", "did you mean `normalized`?");
    row("return square.rigth", "square has no `rigth`: did you mean `right`?");
    row("return square.centre", "square has no `centre`; it has half_width");
    row("return math.squrt(2)", "math has no `squrt`: did you mean `math.sqrt`?");
    row("return math.clamp(2)", "math has no `clamp`");
    row("return string.fromat('')", "did you mean `string.format`?");
    row("table.instert({}, 1)", "did you mean `table.insert`?");
    row("restitutoin = 1", "did you mean `restitution`?");
    row("onUpdate = print", "did you mean `on_update`?");
    row("function on_laod() end", "did you mean `on_load`?");
    row("return something_else", "nothing of that name was given a value before");
}

void TestScriptNames::misspeltNameIsToldTheRightOne()
{
    QFETCH(QString, words);
    const QString statement = QString::fromUtf8(QTest::currentDataTag());
    const ScriptRun run =
        runScript(lua("local function work()\n") + statement + lua("\nend\nlocal r = work()"));
    VERIFY_STOPS(run, 2, words);
}

void TestScriptNames::oneCircleIsToldInTheSingular()
{
    Preset preset = scriptScene();
    preset.circles.pop_back();
    VERIFY_STOPS(runScript(lua("print(circle2)"), 0, {}, preset), 1,
                 lua("there is no circle2: the scene has 1 circle"));
    QVERIFY(
        !runScript(lua("print(circle2)"), 0, {}, preset).error->message.contains(lua("circles")));
}

void TestScriptNames::nameOfItsOwnIsWelcome_data()
{
    QTest::addColumn<QString>("source");
    for (const char *source :
         {"g = 9.81", "speed = 3", "gravity2 = vec(0, 0)", "old_position = vec(0, 0)",
          "circle1.mass = 1", "circle1.velocity2 = vec(0, 0)", "circle1.old_position = vec(0, 0)",
          "circle1.m = 1", "circle1.acc = vec(0, 0)", "circle_1 = circle1", "update = 5",
          "on_hit = print", "masses = {}", "local restitutoin = 1", "timer = 1", "steps = 2"})
        QTest::newRow(source) << lua(source);
}

void TestScriptNames::nameOfItsOwnIsWelcome()
{
    QFETCH(QString, source);
    VERIFY_RUNS(runScript(source));
}

void TestScriptNames::ownGlobalsAreSuggestedToo()
{
    VERIFY_STOPS(runScript(lua("old_position = vec(0, 0)\nprint(old_positon)")), 2,
                 lua("did you mean `old_position`?"));
    VERIFY_STOPS(runScript(lua("circle1.mass = 1\nprint(circle1.mas)")), 2,
                 lua("did you mean `mass`?"));
}

void TestScriptNames::environmentIsNoWayOut_data()
{
    QTest::addColumn<QString>("words");
    QTest::newRow("print(_ENV.os)") << lua("`os` is not part of the lab's Lua");
    QTest::newRow("local _ENV = {} x = 1 y = os.exit") << lua("is nil, so it has no fields");
    QTest::newRow("local e = _ENV _ENV = {} e.print(e.os)")
        << lua("`os` is not part of the lab's Lua");
    QTest::newRow("_ENV = nil x = 1") << lua("is nil, so it has no fields");
    QTest::newRow("print(_ENV[1])") << lua("is not known");
    QTest::newRow("print(_ENV[{}])") << lua("is not known");
}

void TestScriptNames::environmentIsNoWayOut()
{
    QFETCH(QString, words);
    VERIFY_STOPS(runScript(lua("\n") + QString::fromUtf8(QTest::currentDataTag())), 2, words);
}

QTEST_GUILESS_MAIN(TestScriptNames)
#include "test_script_names.moc"
