// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/program_run.h"
#include "tests/hostile_programs.h"
#include "tests/sanitized.h"
#include "tests/script_run.h"

#include "tasks/judging/checker.h"
#include "tasks/reading/lab_reader.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <ctime>

using namespace cradle;
using namespace cradle::programs;

/// Every one of these programs must end, soon, with the right kind of error and its line, and
/// leave the rest of us unharmed.
class TestHostileScripts : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void programEnds_data();
    void programEnds();
    void judgementEnds_data();
    void judgementEnds();
    void commandEnds_data();
    void commandEnds();
    void nothingIsLeftAfterwards();
    void reserveIsLeftBetweenSteps();
    void manyAtOnceDoNotDisturbEachOther();

private:
    /// Sanitizers are shown one of three, from \p first on.
    static void addRows(int first = 0);

    Lab m_lab;
};

namespace {

#if defined(CRADLE_SANITIZED)
constexpr qint64 soon = 10'000; ///< ms
#else
constexpr qint64 soon = 3'000;
#endif

/// Of the processor, which others may keep busy, ms.
qint64 usedTime()
{
    return static_cast<qint64>(std::clock()) * 1000 / CLOCKS_PER_SEC;
}

/// Steps in which even what comes slowly shows.
constexpr int enoughSteps = 120;

QByteArray nameOf(const std::optional<ProgramError> &error)
{
    if (!error)
        return noKind;
    switch (error->kind) {
    case ProgramError::Kind::Syntax:
        return syntaxKind;
    case ProgramError::Kind::Runtime:
        return runtimeKind;
    case ProgramError::Kind::Time:
        return timeKind;
    case ProgramError::Kind::Memory:
        return memoryKind;
    case ProgramError::Kind::Machine:
        break;
    }
    return "machine";
}

/// Programs that would do what they do for ever, but are stopped by more than one limit: whichever
/// comes first on this machine.
bool mayBeTimeOrMemory(const QByteArray &name)
{
    return name.startsWith("very many globals") || name.startsWith("very many fields")
           || name.startsWith("garbage beside") || name.startsWith("sort of long texts");
}

} // namespace

void TestHostileScripts::initTestCase()
{
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab.ok());
    m_lab = *lab;
}

void TestHostileScripts::addRows(int first)
{
    QTest::addColumn<HostileProgram>("program");
    int count = first;
    for (const auto &programs :
         {endlessPrograms(), greedyPrograms(), overflowingPrograms(), strangePrograms()}) {
        for (const HostileProgram &program : programs) {
            if (count++ % oneOf(3) == 0)
                QTest::newRow(program.name) << program;
        }
    }
}

void TestHostileScripts::programEnds_data()
{
    addRows();
}

void TestHostileScripts::programEnds()
{
    QFETCH(HostileProgram, program);
    const qint64 start = usedTime();
    const ScriptRun run = runScript(program.source, enoughSteps);
    const qint64 elapsed = usedTime() - start;
    const QByteArray kind = nameOf(run.error);
    if (mayBeTimeOrMemory(program.name))
        QVERIFY2(kind == timeKind || kind == memoryKind, run.say().constData());
    else
        QVERIFY2(kind == program.kind, kind + ": " + run.say());
    if (kind == timeKind || (kind == memoryKind && program.source.size() < 1'000'000))
        QVERIFY2(run.error->line > 0, run.say().constData());
    if (run.error) {
        QVERIFY(!run.error->message.isEmpty());
        QVERIFY2(run.error->message.size() < 3000, "a message that nobody reads");
    }
    QVERIFY2(elapsed < soon, QByteArray::number(elapsed) + " ms");
}

void TestHostileScripts::judgementEnds_data()
{
    addRows(1);
}

void TestHostileScripts::judgementEnds()
{
    QFETCH(HostileProgram, program);
    const Task &task = m_lab.tasks.front();
    const qint64 start = usedTime();
    const auto report = judgeTask(m_lab, task, Submission(task.preset, program.source), 1);
    const qint64 elapsed = usedTime() - start;
    QVERIFY(report);
    QVERIFY(!report->passed);
    // What does nothing but harm is an error, what does none is judged by what it moves.
    if (program.kind != QByteArray(noKind))
        QVERIFY2(report->error, "no error");
    QVERIFY2(elapsed < soon, QByteArray::number(elapsed) + " ms");
}

void TestHostileScripts::commandEnds_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("kind");
    QTest::newRow("time") << inUpdate("pcall(function() while true do end end)") << lua("time");
    QTest::newRow("memory") << inUpdate("local s = 'x' while true do s = s .. s end")
                            << lua("memory");
    QTest::newRow("runtime") << inUpdate("local function f() return 1 + f() end f()")
                             << lua("runtime");
    QTest::newRow("syntax") << repeated("x = ", "(", 5000, "1") << lua("syntax");
    QTest::newRow("bytecode") << QStringLiteral("\x1bLua\x54") << lua("syntax");
}

void TestHostileScripts::commandEnds()
{
    QFETCH(QString, source);
    QFETCH(QString, kind);
    const QTemporaryDir folder;
    const QString file = written(folder, "lab.lua", source.toUtf8());
    const Outcome outcome =
        runCli({lua("check"), lua("L42T1"), file, lua("--format"), lua("json")});
    VERIFY_CODE(outcome, 1);
    const QJsonObject report = QJsonDocument::fromJson(outcome.out.toUtf8()).object();
    QCOMPARE(report.value(lua("error")).toObject().value(lua("kind")).toString(), kind);
}

void TestHostileScripts::nothingIsLeftAfterwards()
{
    // A sound program behaves as ever after all of these.
    const QString sound = lua("function on_update(dt) circle1.position = vec(step, dt) end");
    const World before = runScript(sound, 10).world;
    for (const HostileProgram &program : strangePrograms())
        (void)runScript(program.source, 1);
    QCOMPARE(runScript(sound, 10).world, before);
}

/// Between steps we call into the state of a program that has filled its memory to the brim.
void TestHostileScripts::reserveIsLeftBetweenSteps()
{
    StudentScript program(lua(R"lua(
function on_update(dt)
  on_update = nil
  kept = {}
  local function fill(size)
    while filled + size < 62.5 * 2^20 do
      kept[#kept + 1] = string.format("%d", #kept) .. block:sub(1, size)
      filled = filled + size
    end
  end
  fill(2^16)
end
filled = 4 * 2^20
block = "x"
for i = 1, 17 do block = block .. block end)lua"));
    Preset scene = scriptScene();
    QVERIFY(!program.begin(scene));
    World world = initialWorld(scene);
    (void)program.advance(world, 0.1);
    for (int i = 0; i < 3; ++i) {
        QVERIFY(program.beginLines(world, 0.1).error);
        QVERIFY(program.advance(world, 0.1));
        (void)program.ownFields();
        (void)program.trace(world, 0.1);
    }
}

void TestHostileScripts::manyAtOnceDoNotDisturbEachOther()
{
    std::vector<std::unique_ptr<StudentScript>> programs;
    std::vector<World> worlds;
    for (int i = 0; i < 50; ++i) {
        programs.push_back(std::make_unique<StudentScript>(
            lua("n = 0 function on_update() n = n + 1 circle1.position = vec(n, %1) end").arg(i)));
        Preset scene = scriptScene();
        QVERIFY(!programs.back()->begin(scene));
        worlds.push_back(initialWorld(scene));
    }
    for (int step = 1; step <= 3; ++step) {
        for (std::size_t i = 0; i < programs.size(); ++i) {
            QVERIFY(!programs[i]->advance(worlds[i], 0.1));
            QCOMPARE(worlds[i].circles[0].position,
                     (Vec2{static_cast<double>(step), static_cast<double>(i)}));
        }
    }
}

QTEST_GUILESS_MAIN(TestHostileScripts)
#include "test_hostile_scripts.moc"
