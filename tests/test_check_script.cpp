// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"
#include "tasks/checks/check_script.h"

#include <QTest>

using namespace cradle;

/// Checks in Lua: what they see of a run, what they answer, and that they cannot do harm.
class TestCheckScript : public QObject
{
    Q_OBJECT
private slots:
    void whatTheRunOffers_data();
    void whatTheRunOffers();
    void everyHitIsOffered();
    void verdictIsTaken();
    void mistakeOfTheCheckIsNamed_data();
    void mistakeOfTheCheckIsNamed();
    void textIsJudgedWithoutARun_data();
    void textIsJudgedWithoutARun();
    void hostileCheckDoesNoHarm_data();
    void hostileCheckDoesNoHarm();
    void judgeTellsTheStep();
    void judgeNamesFileAndLine();
};

namespace {

/// A circle that drifts to the right with 2 m/s and bounces off the wall at 4 m, radius 0.5 m, and
/// one that rests.
Observation drift()
{
    Preset preset;
    preset.timestep = 0.125;
    preset.laws = {WallLaw::Reflect, CircleLaw::None, Timing::Discrete};
    preset.circles.resize(2);
    preset.circles[0].body = {.position = {0, 1}, .velocity = {2, 0}, .radius = 0.5, .density = 2};
    preset.circles[1].body = {.position = {-2, -2}, .radius = 0.25};
    return observe({QStringLiteral("preset"), preset, 4.0});
}

QString checkOf(const QString &body)
{
    return QStringLiteral("function check(run)\n%1\nend").arg(body);
}

} // namespace

void TestCheckScript::whatTheRunOffers_data()
{
    QTest::addColumn<QString>("holds");
    for (const char *holds :
         {"run.duration == 4", "run.timestep == 0.125", "run.step_count == 32",
          "run.circle_count == 2", "run.language == 'en'", "run.restitution == 1",
          "run.gravity == vec(0, 0)",
          "run.square.half_width == 4 and run.square.left == -4 and run.square.top == 4",
          "run:at(0).circles[1].position == vec(0, 1)", "run:at(0.5).time == 0.5",
          "run:at(0.5).step == 4", "run:at(0.5).circles[1].position == vec(1, 1)",
          "run:at(0.1875).circles[1].position == vec(0.375, 1)",
          "run:at(1).circles[1].radius == 0.5 and run:at(1).circles[1].density == 2",
          "#run:at(1).circles == 2", "run:at(4).step == 32",
          "run:circle(1):at(1).position == vec(2, 1)", "run:circle(2):at(3).index == 2",
          "run:circle(1):at(1).velocity:length() == 2", "run:step(8).time == 1",
          "run:step(8).circles[1].position.x == 2",
          "(function() local n = 0 for s in run:steps() do n = n + 1 end return n end)() == 33",
          "(function() local last for s in run:steps() do last = s end return last.time end)() == "
          "4",
          "run:at(4 + 5e-10).time == 4 and run:at(-5e-10).time == 0",
          "run:step(0).step == 0 and run:step(32).step == 32 and run:step(32).time == 4",
          "run:circle(1).index == 1 and run:circle(2):at(0).position == vec(-2, -2)",
          "(function() for s in run:steps() do return s.step end end)() == 0",
          "run.square.right == 4 and run.square.bottom == -4", "#run:hits() + #run:hits() == 2",
          "run:hits()[1].kind == 'wall' and run:hits()[1].b == 'right'",
          "run:hits()[1].a == 1 and run:hits()[1].normal == vec(1, 0)",
          "run:hits()[1].time > 1.5 and run:hits()[1].time <= 1.875",
          "run:hits()[1].step == run:hits()[1].time / run.timestep",
          // 2 m/s turned round of 2000 kg/m³ · 4/3 π 0.5³ m³; the impulse is that on the wall.
          "math.abs(run:hits()[1].impulse - 4 * 2000 * 4 / 3 * math.pi * 0.125) < 1e-6"})
        QTest::newRow(holds) << QString::fromUtf8(holds);
}

void TestCheckScript::whatTheRunOffers()
{
    QFETCH(QString, holds);
    const ScriptVerdict verdict =
        runCheckScript(checkOf(QStringLiteral("return %1, 'no'").arg(holds)), drift());
    QVERIFY2(!verdict.error, verdict.error ? qPrintable(verdict.error->message) : "");
    QVERIFY(verdict.passed);
}

/// Two that meet, come back from their walls and meet again; one goes up and down beside them.
void TestCheckScript::everyHitIsOffered()
{
    Preset preset;
    preset.gravity = {};
    preset.restitution = 1.0;
    preset.timestep = 0.125;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact};
    preset.circles.resize(3);
    preset.circles[0].body = {.position = {-2, 0}, .velocity = {1, 0}, .radius = 0.5};
    preset.circles[1].body = {.position = {2, 0}, .velocity = {-1, 0}, .radius = 0.5};
    preset.circles[2].body = {.position = {0, 2.5}, .velocity = {0, 1}, .radius = 0.5};
    const ScriptVerdict verdict = runCheckScript(
        checkOf(QStringLiteral("local all = {}\n"
                               "for i, h in ipairs(run:hits()) do\n"
                               "  all[i] = h.a .. ' ' .. h.kind .. ' ' .. h.b .. ' ' .. "
                               "tostring(h.normal) .. string.format(' at %.3f', h.time)\n"
                               "end\n"
                               "return false, table.concat(all, '; ')")),
        observe({QStringLiteral("preset"), preset, 9.0}));
    QVERIFY2(!verdict.error, verdict.error ? qPrintable(verdict.error->message) : "");
    QCOMPARE(verdict.message,
             QStringLiteral("3 wall top (0, 1) at 1.000; 1 circle 2 (1, 0) at 1.500; "
                            "1 wall left (-1, 0) at 4.500; 2 wall right (1, 0) at 4.500; "
                            "1 circle 2 (1, 0) at 7.500; 3 wall bottom (0, -1) at 8.000"));
}

void TestCheckScript::verdictIsTaken()
{
    const ScriptVerdict german = runCheckScript(
        checkOf(QStringLiteral("return false, run.language")), drift(), QStringLiteral("de"));
    QCOMPARE(german.message, QStringLiteral("de"));
    const ScriptVerdict full = runCheckScript(
        checkOf(QStringLiteral("return false, 'too\\nlow', {time = 1.5, expected = 2, observed = "
                               "1, unit = 'm'}")),
        drift());
    QVERIFY(!full.error && !full.passed);
    QCOMPARE(full.message, QStringLiteral("too low"));
    QCOMPARE(full.time, 1.5);
    QCOMPARE(full.expected, 2.0);
    QCOMPARE(full.observed, 1.0);
    QCOMPARE(full.unit, QStringLiteral("m"));

    const ScriptVerdict odd = runCheckScript(
        checkOf(QStringLiteral("return false, 'x', {time = 99, expected = 0/0, unit = 7}")),
        drift());
    QVERIFY(!odd.error && !odd.passed);
    QCOMPARE(odd.time, 4.0);
    for (const auto &[given, kept] : {std::pair("-2", 0.0), std::pair("0.5", 0.5)}) {
        const QString check = QStringLiteral("return false, 'x', {time = %1}");
        QCOMPARE(runCheckScript(checkOf(check.arg(QLatin1String(given))), drift()).time, kept);
    }
    QVERIFY(!odd.expected && !odd.observed);
    QVERIFY(odd.unit.isEmpty());

    const QString endless = QString(50'000, QLatin1Char('x'));
    const ScriptVerdict wordy =
        runCheckScript(checkOf(QStringLiteral("return false, '%1'").arg(endless)), drift());
    QCOMPARE(wordy.message.size(), 1000);
}

void TestCheckScript::mistakeOfTheCheckIsNamed_data()
{
    QTest::addColumn<QString>("body");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("message");
    const auto row = [](const QByteArray &body, int line, const QByteArray &message) {
        QTest::newRow(body.constData())
            << QString::fromUtf8(body) << line << QString::fromUtf8(message);
    };
    row("", 0, "check(run) returned nil; true, or false and a message, is right");
    row("return 1", 0, "check(run) returned the number 1");
    row("return false", 0, "without a message for the student");
    row("return false, 3", 0, "without a message for the student");
    row("local x = 1\nreturn run.timestp > x", 3, "did you mean `timestep`?");
    row("return run." + QByteArray(70, 'x'), 2,
        "there is no field `" + QByteArray(64, 'x') + "` here");
    row("return run:at(1).circles[1].centre", 2, "there is no field `centre` here; there are");
    row("return run:at(5)", 2, "a number of seconds from 0 to 4, not the number 5");
    row("return run:at(-1)", 2, "a number of seconds from 0 to 4");
    row("return run:at(0/0)", 2, "a number of seconds from 0 to 4");
    row("return run:at('1')", 2, "a number of seconds from 0 to 4");
    row("return run.at(1)", 2, "write run:at(t), with a colon");
    row("return run.hits()", 2, "write run:hits(), with a colon");
    row("return run.step(1)", 2, "write run:step(k), with a colon");
    row("return run.steps()", 2, "write run:steps(), with a colon");
    row("return run.circle(1)", 2, "write run:circle(i), with a colon");
    row("return run:circle(1).at(1)", 2, "write run:circle(i):at(t), with a colon");
    row("return run:at(4 + 5e-9)", 2, "a number of seconds from 0 to 4");
    row("return run:at(-5e-9)", 2, "a number of seconds from 0 to 4");
    row("return run:step('1')", 2, "a whole number from 0 to 32, not the text \"1\"");
    row("return run:step(-1)", 2, "a whole number from 0 to 32, not the number -1");
    row("return run:circle(0)", 2, "a whole number from 1 to 2, not the number 0");
    row("return run:step(1).tim", 2, "there is no field `tim` here");
    row("return run:hits()[1].when", 2, "there is no field `when` here");
    row("return run:circle(1).centre", 2, "there is no field `centre` here");
    row("return run.square.width", 2, "there is no field `width` here");
    row("return run:circle(3)", 2, "a whole number from 1 to 2, not the number 3");
    row("return run:step(33)", 2, "a whole number from 0 to 32");
    row("return run:step(0.5)", 2, "a whole number from 0 to 32");
    row("return run:at(1).circles[3].position", 2, "so it has no fields");
    row("error('no')", 2, "no");
    row("return os.time()", 2, "os");
}

void TestCheckScript::mistakeOfTheCheckIsNamed()
{
    QFETCH(QString, body);
    QFETCH(int, line);
    QFETCH(QString, message);
    const ScriptVerdict verdict = runCheckScript(checkOf(body), drift());
    QVERIFY(verdict.error);
    QVERIFY2(verdict.error->message.contains(message), qPrintable(verdict.error->message));
    QCOMPARE(verdict.error->line, line);
    QVERIFY(!verdict.passed);
}

void TestCheckScript::textIsJudgedWithoutARun_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("message");
    QTest::newRow("sound") << checkOf(QStringLiteral("return true")) << QString();
    QTest::newRow("empty") << QString() << QStringLiteral("there is no function check(run)");
    QTest::newRow("another name") << QStringLiteral("function chek(run) end")
                                  << QStringLiteral("there is no function check(run)");
    QTest::newRow("local") << QStringLiteral("local function check(run) end")
                           << QStringLiteral("there is no function check(run)");
    QTest::newRow("no function") << QStringLiteral("check = 1")
                                 << QStringLiteral("there is no function check(run)");
    QTest::newRow("grammar") << QStringLiteral("function check(run\nend")
                             << QStringLiteral("')' expected");
    QTest::newRow("stops at load") << QStringLiteral("error('here')") << QStringLiteral("here");
}

void TestCheckScript::textIsJudgedWithoutARun()
{
    QFETCH(QString, source);
    QFETCH(QString, message);
    const auto error = findCheckScriptError(source);
    QCOMPARE(error.has_value(), !message.isEmpty());
    if (error)
        QVERIFY2(error->message.contains(message), qPrintable(error->message));
}

void TestCheckScript::hostileCheckDoesNoHarm_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<int>("kind");
    const auto row = [](const char *name, const QString &source, ProgramError::Kind kind) {
        QTest::newRow(name) << source << static_cast<int>(kind);
    };
    using Kind = ProgramError::Kind;
    row("loop", checkOf(QStringLiteral("while true do end")), Kind::Time);
    row("loop at load", QStringLiteral("while true do end"), Kind::Time);
    row("loop in pcall",
        checkOf(QStringLiteral("while true do pcall(function() while true do end end) end")),
        Kind::Time);
    row("states without end", checkOf(QStringLiteral("while true do run:at(1) end")), Kind::Time);
    row("hits without end", checkOf(QStringLiteral("while true do run:hits() end")), Kind::Time);
    row("steps without end",
        checkOf(QStringLiteral("while true do for s in run:steps() do end end")), Kind::Time);
    row("memory", checkOf(QStringLiteral("local t = {} while true do t[#t + 1] = run:at(1) end")),
        Kind::Memory);
    row("text", checkOf(QStringLiteral("local s = 'x' while true do s = s .. s end")),
        Kind::Memory);
    row("recursion", checkOf(QStringLiteral("return check(run) or check(run)")), Kind::Runtime);
    row("files", checkOf(QStringLiteral("return io.open('/etc/passwd')")), Kind::Runtime);
    row("code", checkOf(QStringLiteral("return load('x = 1')")), Kind::Runtime);
    row("metatables", checkOf(QStringLiteral("return setmetatable({}, {})")), Kind::Runtime);
}

void TestCheckScript::hostileCheckDoesNoHarm()
{
    QFETCH(QString, source);
    QFETCH(int, kind);
    const ScriptVerdict verdict = runCheckScript(source, drift());
    QVERIFY(verdict.error);
    QVERIFY(!verdict.passed);
    QCOMPARE(static_cast<int>(verdict.error->kind), kind);
}

void TestCheckScript::judgeTellsTheStep()
{
    const CheckSpec check{
        .id = QStringLiteral("own"),
        .title = {},
        .kind = QStringLiteral("script"),
        .circles = {0},
        .source = checkOf(QStringLiteral("return false, 'low', {time = 1, expected = 3}"))};
    const auto fault = judge(check, drift());
    QVERIFY(fault);
    QCOMPARE(fault->step, 8);
    QCOMPARE(fault->expected, 3.0);
    QCOMPARE(fault->message, QStringLiteral("low"));
}

void TestCheckScript::judgeNamesFileAndLine()
{
    const CheckSpec check{.id = QStringLiteral("own"),
                          .title = {},
                          .kind = QStringLiteral("script"),
                          .circles = {0},
                          .parameters = {{QStringLiteral("script"), QStringLiteral("heights.lua")}},
                          .source = checkOf(QStringLiteral("return nothing.here"))};
    const auto fault = judge(check, drift());
    QVERIFY(fault);
    QVERIFY2(fault->message.startsWith(QStringLiteral("checks/heights.lua:2: the check itself")),
             qPrintable(fault->message));
}

QTEST_GUILESS_MAIN(TestCheckScript)
#include "test_check_script.moc"
