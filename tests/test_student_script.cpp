// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/runs/observation.h"
#include "tasks/script/student_script.h"

#include <QProcess>
#include <QTemporaryDir>

#include <clocale>

using namespace cradle;
using namespace cradle::programs;

/// When a program is called and what it may change. What it can write is in
/// test_script_language.cpp, its errors in test_script_errors.cpp, its lines in
/// test_script_lines.cpp.
class TestStudentScript : public QObject
{
    Q_OBJECT
private slots:
    void fileThenLoadThenUpdates();
    void fileFindsThePresetInPlace();
    void lawsMoveWithoutAnUpdate();
    void updateAloneMovesTheCircles();
    void vectorsAreThoseOfTheMoment();
    void loadChangesTheScene();
    void pinnedSceneKeepsItsValues();
    void sceneOfTheWorldIsFixedWhileItRuns_data();
    void sceneOfTheWorldIsFixedWhileItRuns();
    void ownFieldsStayFromStepToStep();
    void tooManyOwnFieldsAreNotShown();
    void beginStartsAnew();
    void timeAndStepCount();
    void sameProgramGivesTheSameBits();
    void numbersAreTheSameInEveryLanguage();
    void outputIsTakenOnce();
};

void TestStudentScript::fileThenLoadThenUpdates()
{
    const ScriptRun run = runScript(lua(R"lua(
function on_update(timestep) print("update", step) end
print("file")
function on_load() print("load") end
print("end of file"))lua"),
                                    2);
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text, lua("file\nend of file\nload\nupdate\t0\nupdate\t1\n"));
}

void TestStudentScript::fileFindsThePresetInPlace()
{
    const ScriptRun run = runScript(
        lua("print(circle1.position, circle2.radius, gravity, restitution, square.top, #circles)"));
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text, lua("(-2, 2)\t0.25\t(0, -9.81)\t0.5\t4.0\t2\n"));
}

void TestStudentScript::lawsMoveWithoutAnUpdate()
{
    const QString program = lua("function on_load() circle1.velocity = vec(3, 0) end");
    QVERIFY(!runScript(program).moves);
    const Observation o = observe({QStringLiteral("preset"), scriptScene(), 0.1}, &program);
    QVERIFY(!o.error);
    QCOMPARE(o.steps(), 6);
    // Euler: x = 3 t, and gravity acts on circle 1 from the second step on.
    QCOMPARE(o.circle(0, 6).position.x, -2.0 + 0.3);
    QVERIFY(o.circle(0, 6).position.y < 2.0);
}

void TestStudentScript::updateAloneMovesTheCircles()
{
    const ScriptRun run = runScript(
        lua("function on_update(dt) circle2.position = circle2.position + vec(1, 0) * dt end"), 60);
    VERIFY_RUNS(run);
    QCOMPARE(run.circle(1), scriptScene().circles[0].body);
    QCOMPARE(run.circle(2).position.x, 3.0);
}

/// Also where a circle was set from outside between two updates; 0 and -0 are told apart.
void TestStudentScript::vectorsAreThoseOfTheMoment()
{
    StudentScript program(lua(R"lua(
function on_update(dt)
  local old = circle1.position
  print(old, circle1.position, 1 / circle1.velocity.x)
  circle1.position = old + vec(1, 1)
  print(old, circle1.position)
end)lua"));
    Preset scene = scriptScene();
    QVERIFY(!program.begin(scene));
    World world = initialWorld(scene);
    QString text;
    for (const double zero : {0.0, -0.0}) {
        world.circles[0].velocity = {zero, 1.0};
        QVERIFY(!program.advance(world, 0.1));
        text += program.takeOutput().text;
        world.circles[0].position = {-3.0, 0.5};
    }
    QCOMPARE(text, lua("(-2, 2)\t(-2, 2)\tinf\n(-2, 2)\t(-1, 3)\n"
                       "(-3, 0.5)\t(-3, 0.5)\t-inf\n(-3, 0.5)\t(-2, 1.5)\n"));
}

void TestStudentScript::loadChangesTheScene()
{
    const ScriptRun run = runScript(lua(R"lua(
restitution = 0.25
function on_load()
  gravity = vec(1, 2)
  circle1.position, circle1.velocity = vec(1, 1), vec(0, 3)
  circle2.radius, circle2.density = 0.5, 3
  print(gravity, restitution, circle2.radius)
end)lua"));
    VERIFY_RUNS(run);
    QCOMPARE(run.scene.gravity, (Vec2{1.0, 2.0}));
    QCOMPARE(run.scene.restitution, 0.25);
    QCOMPARE(run.circle(1).position, (Vec2{1.0, 1.0}));
    QCOMPARE(run.circle(1).velocity, (Vec2{0.0, 3.0}));
    QCOMPARE(run.circle(2).radius, 0.5);
    QCOMPARE(run.circle(2).density, 3.0);
    QCOMPARE(run.output.text, lua("(1, 2)\t0.25\t0.5\n"));
}

void TestStudentScript::pinnedSceneKeepsItsValues()
{
    const QString program = lua(R"lua(
restitution = 0.25
function on_load()
  gravity = vec(1, 2)
  circle1.position, circle1.velocity = vec(1, 1), vec(0, 3)
  circle2.radius, circle2.density = 0.5, 3
  circle2.mass = circle2.density * circle2.radius
  print(gravity, restitution, circle1.position, circle1.velocity, circle2.radius, circle2.density)
end
function on_update(dt)
  circle1.radius = 1
  circle1.velocity = vec(0, 1)
  print(circle1.radius, circle2.mass, gravity, restitution)
end)lua");
    const ScriptRun run = runScript(program, 1, {.pinned = true});
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text, lua("(0, -9.81)\t0.5\t(-2, 2)\t(2, 0)\t0.25\t2.0\n"
                                  "0.2\t0.5\t(0, -9.81)\t0.5\n"));
    QCOMPARE(run.scene, scriptScene());
    QCOMPARE(run.circle(1).velocity, (Vec2{0.0, 1.0}));
}

void TestStudentScript::sceneOfTheWorldIsFixedWhileItRuns_data()
{
    QTest::addColumn<QString>("statement");
    QTest::addColumn<QString>("words");
    QTest::newRow("gravity") << lua("gravity = vec(0, 0)") << lua("`gravity` is set once");
    QTest::newRow("restitution") << lua("restitution = 1") << lua("`restitution` is set once");
    QTest::newRow("time") << lua("time = 1") << lua("`time` can only be read");
    QTest::newRow("step") << lua("step = 1") << lua("`step` can only be read");
    for (const char *given : {"circle1", "circle2", "circles", "square", "vec"})
        QTest::addRow("%s", given)
            << lua("%1 = 1").arg(lua(given)) << lua("`%1` is given by the lab").arg(lua(given));
    QTest::newRow("wall") << lua("square.left = 1") << lua("the square can only be read");
    QTest::newRow("index") << lua("circle1.index = 2") << lua("circle1.index is given");
    QTest::newRow("list") << lua("circles[3] = circle1") << lua("circles cannot be added");
}

void TestStudentScript::sceneOfTheWorldIsFixedWhileItRuns()
{
    QFETCH(QString, statement);
    QFETCH(QString, words);
    const ScriptRun run = runScript(lua("function on_update()\n") + statement + lua("\nend"), 1);
    VERIFY_STOPS(run, 2, words);
}

void TestStudentScript::ownFieldsStayFromStepToStep()
{
    const QString source = lua(R"lua(
function on_load() circle1.count, circle1.label, circle2.mass = 0, "a", 2.5 end
function on_update() circle1.count = circle1.count + 1 end)lua");
    StudentScript program(source);
    Preset scene = scriptScene();
    QVERIFY(program.ownFields().empty());
    QVERIFY(!program.begin(scene));
    World world = initialWorld(scene);
    for (int i = 0; i < 3; ++i)
        QVERIFY(!program.advance(world, 0.1));
    const std::vector<CircleField> fields{{0, lua("count"), 3.0}, {1, lua("mass"), 2.5}};
    QCOMPARE(program.ownFields(), fields);
}

/// Of more than a hundred none is, and those of the other circles are.
void TestStudentScript::tooManyOwnFieldsAreNotShown()
{
    for (const auto &[first, second] :
         {std::pair(100, 100), std::pair(101, 100), std::pair(100, 101), std::pair(3, 200)}) {
        const QString source = lua("function on_load() for i = 1, %1 do circle1['a' .. i] = i end "
                                   "for i = 1, %2 do circle2['b' .. i] = i end end")
                                   .arg(first)
                                   .arg(second);
        StudentScript program(source);
        Preset scene = scriptScene();
        QVERIFY(!program.begin(scene));
        const std::vector<CircleField> fields = program.ownFields();
        const auto of = [&](int circle) {
            return std::count_if(fields.begin(), fields.end(),
                                 [&](const CircleField &field) { return field.circle == circle; });
        };
        QCOMPARE(of(0), first > 100 ? 0 : first);
        QCOMPARE(of(1), second > 100 ? 0 : second);
    }
}

void TestStudentScript::beginStartsAnew()
{
    StudentScript program(lua("n = 0\nfunction on_update() n = n + 1 print(n) end"));
    for (int run = 0; run < 2; ++run) {
        Preset scene = scriptScene();
        QVERIFY(!program.begin(scene));
        World world = initialWorld(scene);
        QVERIFY(!program.advance(world, 0.1));
        QCOMPARE(program.takeOutput().text, lua("1\n"));
    }
}

void TestStudentScript::timeAndStepCount()
{
    const ScriptRun run =
        runScript(lua("function on_update(dt) print(step, time == step * dt, dt == 1/60) end"), 3);
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text, lua("0\ttrue\ttrue\n1\ttrue\ttrue\n2\ttrue\ttrue\n"));
}

void TestStudentScript::sameProgramGivesTheSameBits()
{
    const QString program = lua(R"lua(
local weights = {}
for i = 1, 40 do weights["w" .. i] = 1 / i end
function on_load() circle1.velocity = vec(math.random(), math.random(1, 3)) end
function on_update(dt)
  local sum = 0
  for name, weight in pairs(weights) do sum = sum * 0.7 + weight * math.random() end
  circle1.velocity = circle1.velocity + gravity * dt * sum
  circle1.position = circle1.position + circle1.velocity * dt
  print(sum, math.random(1000))
end)lua");
    const ScriptRun first = runScript(program, 100);
    VERIFY_RUNS(first);
    for (int i = 0; i < 3; ++i) {
        const ScriptRun again = runScript(program, 100);
        QCOMPARE(again.world, first.world);
        QCOMPARE(again.output.text, first.output.text);
    }
}

void TestStudentScript::numbersAreTheSameInEveryLanguage()
{
    const QTemporaryDir folder;
    if (QProcess::execute(lua("localedef"), {lua("-i"), lua("de_DE"), lua("-f"), lua("UTF-8"),
                                             folder.filePath(lua("de_DE.UTF-8"))})
        != 0)
        QSKIP("no other locale can be made here");
    qputenv("LOCPATH", folder.path().toUtf8());
    QVERIFY(setlocale(LC_ALL, "de_DE.UTF-8"));
    const QString program = lua("print(1.5, string.format('%.2f', 0.25), tonumber('1,5'), "
                                "'a' < 'B', tonumber('1.5') == 1.5)");
    const ScriptRun run = runScript(program);
    const bool stillGerman = qstrcmp(localeconv()->decimal_point, ",") == 0;
    setlocale(LC_ALL, "C");
    VERIFY_RUNS(run);
    QCOMPARE(run.output.text, lua("1.5\t0.25\tnil\tfalse\ttrue\n"));
    QVERIFY2(stillGerman, "the rest of the application keeps its language");
}

void TestStudentScript::outputIsTakenOnce()
{
    StudentScript program(lua("print(1)\nplot('a', 2)\ndraw.point(vec(0, 0))"));
    QVERIFY(program.takeOutput().isEmpty());
    Preset scene = scriptScene();
    QVERIFY(!program.begin(scene));
    const ProgramOutput output = program.takeOutput();
    QCOMPARE(output.text, lua("1\n"));
    QCOMPARE(output.points.size(), std::size_t{1});
    QCOMPARE(output.drawings.size(), std::size_t{1});
    QVERIFY(program.takeOutput().isEmpty());
}

QTEST_GUILESS_MAIN(TestStudentScript)
#include "test_student_script.moc"
