// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/simulate_test.h"

using namespace cradle::programs;
using cradle::scenes::dt;

/// cradle-cli simulate --script: a student's program in place of the laws.
class TestCliSimulateScript : public QObject
{
    Q_OBJECT
private slots:
    void programMovesTheCircles();
    void lawsMoveWhereTheProgramDoesNot();
    void programSetsTheScene();
    void timestepOfTheLineReachesTheProgram();
    void hitsAreInferred();
    void printedTextGoesToStandardError();
    void plotsAndDrawingsAreDropped();
    void tablesReachUpToTheFailingStep();
    void summaryReachesUpToTheFailingStep();
    void programThatDoesNotLoadLeavesTheStart_data();
    void programThatDoesNotLoadLeavesTheStart();
    void unreadableProgramIsRefused_data();
    void unreadableProgramIsRefused();

private:
    [[nodiscard]] QString program(const QByteArray &text) const
    {
        return written(m_run.folder(), "lab.lua", text);
    }
    [[nodiscard]] Outcome run(const QByteArray &source, const char *options,
                              const QByteArray &more = {}) const
    {
        return m_run.simulate(m_run.preset(glancing, "{}", more),
                              text(options) + text(" --script ") + program(source));
    }

    SimulateTest m_run;
};

namespace {

const QByteArray drift = "function on_update(dt)\n"
                         "  for _, c in ipairs(circles) do\n"
                         "    c.position = c.position + c.velocity * dt\n"
                         "  end\n"
                         "end\n";

/// Drifts for ten steps.
const QByteArray stopping = "function on_update(dt)\n"
                            "  circle1.position = circle1.position + vec(1, 0)\n"
                            "  if step == 10 then\n"
                            "    error('enough')\n"
                            "  end\n"
                            "end\n";

} // namespace

void TestCliSimulateScript::programMovesTheCircles()
{
    const Outcome outcome =
        run("function on_update(dt)\n  circle2.position = circle2.position + vec(0, -dt)\nend\n",
            "--duration 1 --states STATES");
    VERIFY_CODE(outcome, 0);
    QVERIFY(outcome.out.isEmpty() && outcome.error.isEmpty());
    const Table states = m_run.table("STATES");
    QCOMPARE(states.rows.size(), std::size_t{122});
    QCOMPARE(states.number(120, 0), 60.0);
    QCOMPARE(states.number(120, 1), 1.0);
    QCOMPARE(states.number(120, 3), -2.0); // circle 1 has a velocity, but nothing moves it
    QCOMPARE(states.number(120, 5), 2.0);
    COMPARE_NEAR(states.number(121, 4), 1.0, 1e-12);
}

void TestCliSimulateScript::lawsMoveWhereTheProgramDoesNot()
{
    const Outcome outcome =
        run("function on_load()\n  circle1.velocity = vec(3, 0)\n  circle2.position = vec(0, -3)\n"
            "end\n",
            "--duration 1 --states STATES");
    VERIFY_CODE(outcome, 0);
    COMPARE_NEAR(m_run.table("STATES").number(120, 3), 1.0, 1e-12);
}

void TestCliSimulateScript::programSetsTheScene()
{
    // Potential energy is that of the gravity which the program sets: m g times the height.
    VERIFY_CODE(run("function on_load()\n  gravity = vec(0, -2)\n  circle1.density = 1\n"
                    "  circle2.position = vec(0, -4)\nend\n"
                        + drift,
                    "--duration 0.1 --totals TOTALS"),
                0);
    const Table totals = m_run.table("TOTALS");
    const double mass = 1000.0 * 4.0 / 3.0 * cradle::scenes::pi * 0.2 * 0.2 * 0.2;
    COMPARE_NEAR(totals.number(0, 5), mass * 2.0 * 6.3, 1e-9);
}

void TestCliSimulateScript::timestepOfTheLineReachesTheProgram()
{
    VERIFY_CODE(run("function on_update(dt)\n  circle1.position = vec(dt, time)\nend\n",
                    "--duration 1 --timestep 0.01 --states STATES"),
                0);
    const Table states = m_run.table("STATES");
    QCOMPARE(states.rows.size(), std::size_t{202});
    QCOMPARE(states.number(200, 3), 0.01);
    COMPARE_NEAR(states.number(200, 4), 0.99, 1e-12); // at the start of the step
}

void TestCliSimulateScript::hitsAreInferred()
{
    const QByteArray walls = "function on_update(dt)\n"
                             "  local c, old = circle1, circle1.position\n"
                             "  c.position = c.position + c.velocity * dt\n"
                             "  if c.position.x + c.radius > square.right then\n"
                             "    c.position = old\n"
                             "    c.velocity = vec(-c.velocity.x, c.velocity.y)\n"
                             "  end\n"
                             "end\n";
    VERIFY_CODE(run("function on_load()\n  circle2.position = vec(0, -3)\nend\n" + walls,
                    "--duration 4 --events EVENTS"),
                0);
    const Table events = m_run.table("EVENTS");
    QCOMPARE(events.rows.size(), std::size_t{1});
    QCOMPARE(events.rows[0].mid(1, 5), text("wall,1,right,1,0").split(QLatin1Char(',')));
    // 5.8 m at 2 m/s are 174 steps; the next one would leave the square.
    COMPARE_NEAR(events.number(0, 0), 175.0 * dt, 1e-9);
    const double mass = 7800.0 * 4.0 / 3.0 * cradle::scenes::pi * 0.2 * 0.2 * 0.2;
    COMPARE_NEAR(events.number(0, 6), 4.0 * mass, 1e-9);
}

void TestCliSimulateScript::printedTextGoesToStandardError()
{
    const Outcome outcome = run("print('loading')\nfunction on_update(dt)\n  print(step)\nend\n",
                                "--duration 0.05 --totals -");
    VERIFY_CODE(outcome, 0);
    QCOMPARE(outcome.error, text("loading\n0\n1\n2\n"));
    QVERIFY(outcome.out.startsWith(text("step,time,")));
    QCOMPARE(outcome.out.count(QLatin1Char('\n')), 5);
}

void TestCliSimulateScript::plotsAndDrawingsAreDropped()
{
    const Outcome outcome = run("function on_update(dt)\n  plot('speed', step)\n"
                                "  draw.arrow(circle1.position, vec(1, 0), 'red', 'v')\nend\n",
                                "--duration 1");
    VERIFY_CODE(outcome, 0);
    QVERIFY(outcome.error.isEmpty());
    QVERIFY2(outcome.out.contains(text("60 steps")), outcome.toText().constData());
}

void TestCliSimulateScript::tablesReachUpToTheFailingStep()
{
    const Outcome outcome =
        run(stopping, "--duration 1 --states STATES --totals TOTALS --events EVENTS");
    VERIFY_CODE(outcome, 1);
    QCOMPARE(outcome.error, m_run.folder().filePath(text("lab.lua")) + text(":4: enough\n"));
    QVERIFY(outcome.out.isEmpty());
    // The eleventh step, which starts at step 10, could not be made.
    const Table states = m_run.table("STATES");
    QCOMPARE(states.rows.size(), std::size_t{22});
    QVERIFY(states.complete && m_run.table("EVENTS").complete);
    QCOMPARE(states.number(20, 0), 10.0);
    COMPARE_NEAR(states.number(20, 3), 8.0, 1e-12);
    QCOMPARE(m_run.table("TOTALS").rows.size(), std::size_t{11});
}

void TestCliSimulateScript::summaryReachesUpToTheFailingStep()
{
    const Outcome outcome = run(stopping, "--duration 1");
    VERIFY_CODE(outcome, 1);
    QVERIFY2(outcome.out.contains(text("10 steps")), outcome.toText().constData());
}

void TestCliSimulateScript::programThatDoesNotLoadLeavesTheStart_data()
{
    QTest::addColumn<QByteArray>("source");
    QTest::addColumn<QString>("place");
    QTest::newRow("syntax") << QByteArray("function on_load(\n  = 1\n") << text(":2: ");
    QTest::newRow("in on_load") << QByteArray(
        "function on_load()\n  circle1.position = vec(0, 0)\n  error('no')\nend\n")
                                << text(":3: ");
    QTest::newRow("scene that no law can run")
        << QByteArray("function on_load()\n  circle1.radius = -1\nend\n") << text(":2: ");
}

void TestCliSimulateScript::programThatDoesNotLoadLeavesTheStart()
{
    QFETCH(QByteArray, source);
    QFETCH(QString, place);
    const Outcome outcome = run(source, "--duration 1 --states STATES");
    VERIFY_CODE(outcome, 1);
    QVERIFY2(outcome.error.startsWith(m_run.folder().filePath(text("lab.lua")) + place),
             outcome.toText().constData());
    const Table states = m_run.table("STATES");
    QCOMPARE(states.rows.size(), std::size_t{2});
    QCOMPARE(states.number(0, 3), -2.0); // of the preset
}

void TestCliSimulateScript::unreadableProgramIsRefused_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("place");
    QTest::newRow("missing") << m_run.folder().filePath(text("nowhere.lua")) << text(": ");
    QTest::newRow("no text") << written(m_run.folder(), "binary.lua", "x = 1\n\xff\xfe")
                             << text(":2: ");
}

void TestCliSimulateScript::unreadableProgramIsRefused()
{
    QFETCH(QString, path);
    QFETCH(QString, place);
    const Outcome outcome =
        m_run.simulate(m_run.preset(glancing), text("--duration 1 --script ") + path);
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.startsWith(path + place), outcome.toText().constData());
    QVERIFY(outcome.out.isEmpty());
}

QTEST_GUILESS_MAIN(TestCliSimulateScript)
#include "test_cli_simulate_script.moc"
