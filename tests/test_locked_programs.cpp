// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/judging/judgement.h"
#include "tasks/proof/lab_verifier.h"
#include "tasks/reading/lab_reader.h"

#include <QTest>

#include <algorithm>

using namespace cradle;
using namespace cradle::programs;

/// A program may not change what its step fixes: it stops at that line, with the reason.
class TestLockedPrograms : public QObject
{
    Q_OBJECT
private slots:
    void changeStopsTheProgram_data();
    void changeStopsTheProgram();
    void otherProgramsRun_data();
    void otherProgramsRun();
    void massLeavesTheRestFree();
    void sceneOfACheckKeepsItsValues();
    void checkTellsTheLine();
    void verifyTellsTheLine();

private:
    /// A lab of one step whose program sets the gravity that the step fixes, in line 5.
    [[nodiscard]] static Lab lockedLab();
};

void TestLockedPrograms::changeStopsTheProgram_data()
{
    QTest::addColumn<QString>("locked");
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("line");
    const auto row = [](const char *what, const char *locked, const char *program, const char *name,
                        int line) {
        QTest::newRow(what) << lua(locked) << lua(program) << lua(name) << line;
    };
    row("in on_load", "gravity", "function on_load()\n  gravity = vec(0, -1.6)\nend", "gravity", 2);
    row("before on_load", "gravity", "gravity = vec(0, 0)", "gravity", 1);
    row("restitution", "restitution", "function on_load()\n\n  restitution = 1\nend", "restitution",
        3);
    row("place", "circles/1/position", "circle1.position = vec(0, 0)", "position of circle 1", 1);
    row("velocity", "circles/2/velocity", "circles[2].velocity = vec(1, 0)", "velocity of circle 2",
        1);
    row("radius", "circles/2/radius", "circle2.radius = 0.2", "radius of circle 2", 1);
    row("density", "circles/1/density", "circle1.density = 1", "density of circle 1", 1);
    row("mass by density", "circles/1/mass", "circle1.density = 1", "mass of circle 1", 1);
    row("mass by radius", "circles/1/mass", "circle1.radius = 0.1", "mass of circle 1", 1);
    row("in on_update", "circles/1/radius", "function on_update()\n  circle1.radius = 0.1\nend",
        "radius of circle 1", 2);
}

void TestLockedPrograms::changeStopsTheProgram()
{
    QFETCH(QString, locked);
    QFETCH(QString, program);
    QFETCH(QString, name);
    QFETCH(int, line);
    const ScriptRun run =
        runScript(program, 1, {.pinned = false, .quiet = true, .locked = {locked}});
    QVERIFY(run.error);
    QCOMPARE(run.error->line, line);
    QVERIFY2(run.error->message.contains(QStringLiteral("fixed this: ") + name), run.say());
    QCOMPARE(run.scene, scriptScene());
    const ScriptRun free = runScript(program);
    QVERIFY2(!free.error, free.say());
}

void TestLockedPrograms::otherProgramsRun_data()
{
    QTest::addColumn<QString>("program");
    QTest::newRow("the same value") << lua("gravity = vec(0, -9.81) circle1.radius = 0.2");
    QTest::newRow("another circle") << lua("circle2.velocity = vec(1, 0) circle2.radius = 0.3");
    QTest::newRow("what fixes no mass") << lua("circle2.density = 3 circle2.position = vec(1, 1)");
    QTest::newRow("moved in the update") << lua("function on_update(dt) circle1.position = "
                                                "circle1.position + circle1.velocity * dt end");
    QTest::newRow("a field of its own") << lua("circle1.mass = 5");
}

void TestLockedPrograms::otherProgramsRun()
{
    QFETCH(QString, program);
    const ScriptRun run = runScript(
        program, 3,
        {.pinned = false,
         .quiet = true,
         .locked = {QStringLiteral("gravity"), QStringLiteral("circles/1/position"),
                    QStringLiteral("circles/1/velocity"), QStringLiteral("circles/1/mass")}});
    QVERIFY2(!run.error, run.say());
}

/// A mass is changed by radius and density alone.
void TestLockedPrograms::massLeavesTheRestFree()
{
    const ScriptRun run =
        runScript(lua("circle1.position = vec(1, 1) circle1.velocity = vec(1, 0)"), 3,
                  {.locked = {QStringLiteral("circles/1/mass")}});
    QVERIFY2(!run.error, run.say());
}

void TestLockedPrograms::sceneOfACheckKeepsItsValues()
{
    const ScriptRun run =
        runScript(lua("gravity = vec(0, 0) circle1.velocity = vec(0, 0) circle1.radius = 0.1"), 0,
                  {.pinned = true,
                   .quiet = true,
                   .locked = {QStringLiteral("gravity"), QStringLiteral("circles/1/velocity"),
                              QStringLiteral("circles/1/radius")}});
    QVERIFY2(!run.error, run.say());
    QCOMPARE(run.scene, scriptScene());
}

Lab TestLockedPrograms::lockedLab()
{
    const LabFiles files = newLab(QStringLiteral("lab"), QStringLiteral("Lab"), {});
    const QString step = stepsOf(files).front();
    Result<TaskForm> form = taskForm(files, step);
    form->locked = {QStringLiteral("gravity")};
    return *readLab(*withTask(files, step, *form), QStringLiteral("/lab"));
}

void TestLockedPrograms::checkTellsTheLine()
{
    const Lab lab = lockedLab();
    const Task &task = lab.tasks.front();
    QCOMPARE(task.preset.gravity, Vec2{});
    QCOMPARE(task.solution.split(QLatin1Char('\n')).at(4),
             QStringLiteral("  gravity = vec(0, -9.81)"));
    const auto report = judgeTask(lab, task, Submission(task.preset, task.solution), 1);
    QVERIFY(!report->passed);
    QVERIFY(report->error);
    QCOMPARE(report->error->line, 5);
    QVERIFY(report->error->message.contains(QStringLiteral("fixed this: gravity")));
}

void TestLockedPrograms::verifyTellsTheLine()
{
    const std::vector<VerifiedTask> tasks = verifyLab(lockedLab());
    const std::vector<LabFinding> &findings = tasks.front().findings;
    const auto found = std::find_if(findings.begin(), findings.end(), [](const LabFinding &each) {
        return each.program == QLatin1String("solution");
    });
    QVERIFY(found != findings.end());
    QCOMPARE(found->kind, LabFinding::Kind::ProgramErrs);
    QVERIFY2(found->message.contains(QStringLiteral("line 5: the author of this step")),
             qPrintable(found->message));
}

QTEST_GUILESS_MAIN(TestLockedPrograms)
#include "test_locked_programs.moc"
