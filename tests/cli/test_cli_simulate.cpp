// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/simulate_test.h"
#include "tests/patience.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <csignal>

using namespace cradle::programs;

/// cradle-cli simulate: its tables and its usage.
class TestCliSimulate : public QObject
{
    Q_OBJECT
private slots:
    void tablesHaveTheHeadersOfTheFormat();
    void everyCircleHasARowForEveryStep();
    void everyNthStepIsWritten();
    void timestepOfTheLineCounts();
    void timingOfTheLineCounts();
    void numbersAreShortest();
    void summaryIsPrintedWithoutTables();
    void summaryCanBeJson();
    void mergedContactsAreSaid();
    void stoppedRunWritesWhatItHas();
    void wrongUsageIsSaid_data();
    void wrongUsageIsSaid();
    void unreadableInputNamesItsPlace_data();
    void unreadableInputNamesItsPlace();

private:
    SimulateTest m_run;
};

namespace {

/// The fewest significant digits that read back to \p value, found by trying.
int fewestDigits(double value)
{
    int digits = 1;
    while (digits < 17 && QByteArray::number(value, 'e', digits - 1).toDouble() != value)
        ++digits;
    return digits;
}

int digitsOf(QString number)
{
    number = number.section(QLatin1Char('e'), 0, 0).remove(QLatin1Char('-'));
    const bool whole = !number.contains(QLatin1Char('.'));
    number.remove(QLatin1Char('.'));
    while (number.startsWith(QLatin1Char('0')) && number.size() > 1)
        number.remove(0, 1);
    while (whole && number.endsWith(QLatin1Char('0')) && number.size() > 1)
        number.chop(1);
    return static_cast<int>(number.size());
}

} // namespace

void TestCliSimulate::tablesHaveTheHeadersOfTheFormat()
{
    const Outcome outcome = m_run.simulate(
        m_run.preset("[]"), text("--duration 1 --states STATES --totals TOTALS --events EVENTS"));
    VERIFY_CODE(outcome, 0);
    QVERIFY(outcome.out.isEmpty() && outcome.error.isEmpty());
    QCOMPARE(m_run.table("STATES").header, text("step,time,circle,x,y,vx,vy"));
    QCOMPARE(m_run.table("TOTALS").header, text("step,time,px,py,kinetic,potential,total"));
    QCOMPARE(m_run.table("EVENTS").header, text("time,kind,a,b,nx,ny,impulse"));
    QVERIFY(m_run.table("STATES").rows.empty());
    QCOMPARE(m_run.table("TOTALS").rows.size(), std::size_t{61});
}

void TestCliSimulate::everyCircleHasARowForEveryStep()
{
    VERIFY_CODE(m_run.simulate(m_run.preset(glancing), text("--duration 0.1 --states STATES")), 0);
    const Table states = m_run.table("STATES");
    QVERIFY(states.complete);
    QCOMPARE(states.rows.size(), std::size_t{14}); // steps 0 to 6, two circles
    QCOMPARE(states.rows[0], text("0,0,1,-2,2.3,2,0").split(QLatin1Char(',')));
    QCOMPARE(states.rows[1], text("0,0,2,2,2,0,0").split(QLatin1Char(',')));
    for (std::size_t i = 0; i < states.rows.size(); ++i) {
        QCOMPARE(states.rows[i].size(), 7);
        QCOMPARE(states.rows[i][0].toInt(), static_cast<int>(i / 2));
        QCOMPARE(states.rows[i][2].toInt(), static_cast<int>(i % 2) + 1);
        QCOMPARE(states.number(i, 1), static_cast<double>(i / 2) * (1.0 / 60.0));
    }
}

void TestCliSimulate::everyNthStepIsWritten()
{
    VERIFY_CODE(m_run.simulate(m_run.preset(glancing),
                               text("--duration 1 --every 25 --states STATES --totals TOTALS")),
                0);
    QStringList steps;
    for (const QStringList &row : m_run.table("TOTALS").rows)
        steps.append(row[0]);
    QCOMPARE(steps, text("0,25,50").split(QLatin1Char(',')));
    QCOMPARE(m_run.table("STATES").rows.size(), std::size_t{6});
}

void TestCliSimulate::timestepOfTheLineCounts()
{
    VERIFY_CODE(m_run.simulate(m_run.preset(glancing),
                               text("--duration 1 --timestep 0.01 --states STATES")),
                0);
    const Table states = m_run.table("STATES");
    QCOMPARE(states.rows.size(), std::size_t{202});
    QCOMPARE(states.number(201, 1), 1.0);
    COMPARE_NEAR(states.number(200, 3), 0.0, 1e-12);
}

void TestCliSimulate::timingOfTheLineCounts()
{
    // Discrete timing answers at a step; exact timing between two steps.
    const QString scene = m_run.preset(glancing, R"({"circles": "impulse", "timing": "discrete"})");
    const auto phase = [&](const char *timing) {
        const Outcome outcome =
            m_run.simulate(scene, text("--duration 4 --events EVENTS --timing ") + text(timing));
        const double steps = outcome.code == 0 ? m_run.table("EVENTS").number(0, 0) * 60.0 : 0.0;
        return std::abs(steps - std::round(steps));
    };
    QVERIFY(phase("discrete") < 1e-9);
    QVERIFY(phase("exact") > 1e-3);
}

void TestCliSimulate::numbersAreShortest()
{
    VERIFY_CODE(
        m_run.simulate(m_run.preset(glancing, R"({"walls": "reflect", "circles": "impulse"})",
                                    R"(, "gravity": [0.3, -9.81], "restitution": 0.7)"),
                       text("--duration 5 --states STATES --totals TOTALS --events EVENTS")),
        0);
    for (const char *name : {"STATES", "TOTALS", "EVENTS"}) {
        for (const QStringList &row : m_run.table(name).rows) {
            for (const QString &cell : row) {
                bool isNumber = false;
                const double value = cell.toDouble(&isNumber);
                if (isNumber)
                    QVERIFY2(digitsOf(cell) == fewestDigits(value), qPrintable(cell));
            }
        }
    }
}

void TestCliSimulate::summaryIsPrintedWithoutTables()
{
    const Outcome outcome = m_run.simulate(m_run.preset(glancing), text("--duration 1"));
    VERIFY_CODE(outcome, 0);
    QVERIFY(outcome.out.contains(text("2 circles")) && outcome.out.contains(text("60 steps")));
}

void TestCliSimulate::summaryCanBeJson()
{
    // Beside a table, too; the first circle is of steel and moves at 2 m/s.
    const Outcome outcome = m_run.simulate(m_run.preset(glancing, R"({"circles": "none"})"),
                                           text("--duration 1 --format json --totals TOTALS"));
    VERIFY_CODE(outcome, 0);
    const QJsonObject json = QJsonDocument::fromJson(outcome.out.toUtf8()).object();
    const double mass = 7800.0 * 4.0 / 3.0 * cradle::scenes::pi * 0.2 * 0.2 * 0.2; // kg
    QCOMPARE(json.value(text("circles")).toInt(), 2);
    QCOMPARE(json.value(text("steps")).toInt(), 60);
    QCOMPARE(json.value(text("time")).toDouble(), 1.0);
    QCOMPARE(json.value(text("hits")).toInt(-1), 0);
    COMPARE_NEAR(json.value(text("momentum"))[0].toDouble(), 2.0 * mass, 1e-9);
    COMPARE_NEAR(json.value(text("kinetic")).toDouble(), 2.0 * mass, 1e-9);
    QVERIFY(json.value(text("merged_from")).isNull());
    QVERIFY(json.value(text("complete")).toBool());
    QCOMPARE(m_run.table("TOTALS").rows.size(), std::size_t{61});
}

void TestCliSimulate::mergedContactsAreSaid()
{
    const QString heap =
        m_run.preset(R"({"fill": {"count": 250, "radius": 0.05, "rms_speed": 0.5, "seed": 1}})",
                     R"({"walls": "reflect", "circles": "impulse", "timing": "exact"})",
                     R"(, "gravity": [0, -9.81], "restitution": 0.5, "square": {"half_width": 1})");
    const auto run = [&](const char *options) { return m_run.simulate(heap, text(options)); };
    const QString said = text("contacts merged from ");

    QVERIFY(!run("--duration 0.1").out.contains(said));
    const Outcome summary = run("--duration 2");
    VERIFY_CODE(summary, 0);
    const double from = summary.out.section(said, 1).section(QLatin1Char(' '), 0, 0).toDouble();
    QVERIFY2(from > 0.1 && from < 2.0, qPrintable(summary.out));
    const Outcome json = run("--duration 2 --format json");
    QCOMPARE(QJsonDocument::fromJson(json.out.toUtf8())[text("merged_from")].toDouble(), from);
    const Outcome tables = run("--duration 2 --totals TOTALS");
    VERIFY_CODE(tables, 0);
    QVERIFY2(tables.error.startsWith(said), qPrintable(tables.error));
}

void TestCliSimulate::stoppedRunWritesWhatItHas()
{
    const QString program =
        written(m_run.folder(), "endless.lua",
                "function on_update(timestep) if step == 3 then print('three') end end");
    const QString states = m_run.folder().filePath(text("stopped.csv"));
    QProcess process;
    process.setReadChannel(QProcess::StandardError);
    process.start(cradle::cliProgram(),
                  {text("simulate"), m_run.preset(glancing), text("--duration"), text("1e6"),
                   text("--every"), text("10000000"), text("--script"), program, text("--states"),
                   states});
    QByteArray said;
    while (!said.contains("three") && process.waitForReadyRead(patience))
        said += process.readAll();
    kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(patience));
    said += process.readAll();
    QCOMPARE(process.exitCode(), 130);
    QVERIFY2(said.contains("stopped at "), said.constData());
    QCOMPARE(readTable(states).rows.size(), std::size_t{2}); // of the start
}

void TestCliSimulate::wrongUsageIsSaid_data()
{
    QTest::addColumn<QString>("options");
    for (const char *options :
         {"", "--duration", "--duration 0", "--duration -1", "--duration nan", "--duration inf",
          "--duration soon", "--duration 1e9", "--duration 1 --timestep 0",
          "--duration 1 --timestep 1", "--duration 1 --timestep fast",
          "--duration 1 --timing later", "--duration 1 --every 0", "--duration 1 --every 1.5",
          "--duration 1 --every -3", "--duration 1 --format xml",
          "--duration 1 --format json --states -", "--duration 1 --colour",
          "--duration 1 second.json"})
        QTest::newRow(*options ? options : "no duration") << text(options);
}

void TestCliSimulate::wrongUsageIsSaid()
{
    QFETCH(QString, options);
    const Outcome outcome = m_run.simulate(m_run.preset(glancing), options);
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.startsWith(text("cradle-cli: ")), outcome.toText().constData());
    QVERIFY(outcome.out.isEmpty());
}

void TestCliSimulate::unreadableInputNamesItsPlace_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("place");
    const auto row = [](const char *name, const QByteArray &content, const char *place) {
        QTest::newRow(name) << content << text(place);
    };
    row("empty", "", ":1: ");
    row("binary", QByteArray("\x00\x01\xff{", 4), ":1: ");
    row("cut off", "{\n\"format\": 1,\n", ":3: ");
    row("deep", QByteArray(100'000, '['), ":1: ");
    row("number too large", "{\"format\": 1, \"circles\": [{\"position\": [1e999, 0]}]}", ":1: ");
    row("unknown law", R"({"format": 1, "laws": {"walls": "glue"}, "circles": []})",
        ": /laws/walls: ");
    row("crowd too dense", R"({"format": 1, "circles": {"fill": {"count": 100000, "radius": 1}}})",
        ": /circles/fill");
    row("too many", R"({"format": 1, "circles": {"fill": {"count": 1e300, "radius": 1}}})",
        ": /circles/fill/count: ");
    row("overlap", R"({"format": 1, "laws": {"circles": "stop"},
                       "circles": [{"position": [0, 0]}, {"position": [0, 0.1]}]})",
        ": /circles/1");
}

void TestCliSimulate::unreadableInputNamesItsPlace()
{
    QFETCH(QByteArray, content);
    QFETCH(QString, place);
    const QString path = written(m_run.folder(), "größe 1.json", content);
    const Outcome outcome = m_run.simulate(path, text("--duration 1"));
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.startsWith(path + place), outcome.toText().constData());
    QVERIFY(outcome.out.isEmpty());
    const QString nowhere = m_run.folder().filePath(text("no/folder.csv"));
    const Outcome unwritten =
        m_run.simulate(m_run.preset(glancing), text("--duration 1 --states ") + nowhere);
    VERIFY_CODE(unwritten, 3);
    QVERIFY(unwritten.error.startsWith(nowhere + text(": ")));
}

QTEST_GUILESS_MAIN(TestCliSimulate)
#include "test_cli_simulate.moc"
