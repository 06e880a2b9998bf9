// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/program_run.h"
#include "tests/scenes.h"

#include <array>

using namespace cradle::programs;
namespace scenes = cradle::scenes;

/// cradle-cli simulate: its tables, and its numbers against formulas.
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
    void integratorFollowsItsRecurrence_data();
    void integratorFollowsItsRecurrence();
    void glancingHitIsThatOfTheFormula_data();
    void glancingHitIsThatOfTheFormula();
    void momentumIsKept_data();
    void momentumIsKept();
    void wallHitIsNamed_data();
    void wallHitIsNamed();
    void summaryIsPrintedWithoutTables();
    void wrongUsageIsSaid_data();
    void wrongUsageIsSaid();
    void unreadableInputNamesItsPlace_data();
    void unreadableInputNamesItsPlace();

private:
    [[nodiscard]] QString preset(const QByteArray &circles, const QByteArray &laws = "{}",
                                 const QByteArray &more = {}) const;
    [[nodiscard]] Outcome simulate(const QString &preset, const QString &options) const;
    [[nodiscard]] Table table(const char *name) const;

    QTemporaryDir m_folder;
};

namespace {

const QByteArray glancing = R"([{"position": [-2, 2.3], "velocity": [2, 0], "radius": 0.2},
                                {"position": [2, 2], "radius": 0.2}])";

QString text(const char *latin)
{
    return QString::fromLatin1(latin);
}

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

QString TestCliSimulate::preset(const QByteArray &circles, const QByteArray &laws,
                                const QByteArray &more) const
{
    return written(m_folder, "preset.json",
                   R"({"format": 1, "laws": )" + laws + more + R"(, "circles": )" + circles + "}");
}

/// \p options  may name tables as STATES, TOTALS and EVENTS
Outcome TestCliSimulate::simulate(const QString &preset, const QString &options) const
{
    QStringList arguments{text("simulate"), preset};
    for (QString word : options.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        for (const char *name : {"STATES", "TOTALS", "EVENTS"}) {
            if (word == QLatin1String(name))
                word = m_folder.filePath(word);
        }
        arguments.append(word);
    }
    return runCli(arguments);
}

Table TestCliSimulate::table(const char *name) const
{
    return readTable(m_folder.filePath(text(name)));
}

void TestCliSimulate::tablesHaveTheHeadersOfTheFormat()
{
    const Outcome outcome = simulate(
        preset("[]"), text("--duration 1 --states STATES --totals TOTALS --events EVENTS"));
    VERIFY_CODE(outcome, 0);
    QVERIFY(outcome.out.isEmpty() && outcome.error.isEmpty());
    QCOMPARE(table("STATES").header, text("step,time,circle,x,y,vx,vy"));
    QCOMPARE(table("TOTALS").header, text("step,time,px,py,kinetic,potential,total"));
    QCOMPARE(table("EVENTS").header, text("time,kind,a,b,nx,ny,impulse"));
    QVERIFY(table("STATES").rows.empty());
    QCOMPARE(table("TOTALS").rows.size(), std::size_t{61});
}

void TestCliSimulate::everyCircleHasARowForEveryStep()
{
    VERIFY_CODE(simulate(preset(glancing), text("--duration 0.1 --states STATES")), 0);
    const Table states = table("STATES");
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
    VERIFY_CODE(
        simulate(preset(glancing), text("--duration 1 --every 25 --states STATES --totals TOTALS")),
        0);
    QStringList steps;
    for (const QStringList &row : table("TOTALS").rows)
        steps.append(row[0]);
    QCOMPARE(steps, text("0,25,50").split(QLatin1Char(',')));
    QCOMPARE(table("STATES").rows.size(), std::size_t{6});
}

void TestCliSimulate::timestepOfTheLineCounts()
{
    VERIFY_CODE(simulate(preset(glancing), text("--duration 1 --timestep 0.01 --states STATES")),
                0);
    const Table states = table("STATES");
    QCOMPARE(states.rows.size(), std::size_t{202});
    QCOMPARE(states.number(201, 1), 1.0);
    COMPARE_NEAR(states.number(200, 3), 0.0, 1e-12);
}

void TestCliSimulate::timingOfTheLineCounts()
{
    // Discrete timing answers at a step; exact timing between two steps.
    const QString scene = preset(glancing, R"({"circles": "impulse", "timing": "discrete"})");
    const auto phase = [&](const char *timing) {
        const Outcome outcome =
            simulate(scene, text("--duration 4 --events EVENTS --timing ") + text(timing));
        const double steps = outcome.code == 0 ? table("EVENTS").number(0, 0) * 60.0 : 0.0;
        return std::abs(steps - std::round(steps));
    };
    QVERIFY(phase("discrete") < 1e-9);
    QVERIFY(phase("exact") > 1e-3);
}

void TestCliSimulate::numbersAreShortest()
{
    VERIFY_CODE(simulate(preset(glancing, R"({"walls": "reflect", "circles": "impulse"})",
                                R"(, "gravity": [0.3, -9.81], "restitution": 0.7)"),
                         text("--duration 5 --states STATES --totals TOTALS --events EVENTS")),
                0);
    for (const char *name : {"STATES", "TOTALS", "EVENTS"}) {
        for (const QStringList &row : table(name).rows) {
            for (const QString &cell : row) {
                bool isNumber = false;
                const double value = cell.toDouble(&isNumber);
                if (isNumber)
                    QVERIFY2(digitsOf(cell) == fewestDigits(value), qPrintable(cell));
            }
        }
    }
}

void TestCliSimulate::integratorFollowsItsRecurrence_data()
{
    QTest::addColumn<double>("late"); ///< the part of g h² that the position gets in the same step
    QTest::newRow("euler") << 0.0;
    QTest::newRow("symplectic_euler") << 1.0;
    QTest::newRow("verlet") << 0.5;
    QTest::newRow("rk4") << 0.5;
}

void TestCliSimulate::integratorFollowsItsRecurrence()
{
    QFETCH(double, late);
    const QByteArray name = QTest::currentDataTag();
    const QByteArray circle =
        R"([{"position": [-2, 2], "velocity": [2, 1], "integrator": ")" + name + R"("}])";
    VERIFY_CODE(simulate(preset(circle, "{}", R"(, "gravity": [0.25, -9.81], "timestep": 0.01)"),
                         text("--duration 2 --states STATES")),
                0);
    const Table states = table("STATES");
    QCOMPARE(states.rows.size(), std::size_t{201});
    const long double h = 0.01L;
    const std::array<long double, 2> g{0.25L, -9.81L};
    std::array<long double, 2> x{-2.0L, 2.0L};
    std::array<long double, 2> v{2.0L, 1.0L};
    for (std::size_t n = 0; n < states.rows.size(); ++n) {
        for (std::size_t i = 0; i < 2; ++i) {
            COMPARE_NEAR(states.number(n, 3 + static_cast<int>(i)), x[i], 1e-12);
            COMPARE_NEAR(states.number(n, 5 + static_cast<int>(i)), v[i], 1e-12);
            x[i] += h * v[i] + static_cast<long double>(late) * g[i] * h * h;
            v[i] += h * g[i];
        }
    }
}

void TestCliSimulate::glancingHitIsThatOfTheFormula_data()
{
    QTest::addColumn<QByteArray>("laws");
    QTest::newRow("swap, continuous")
        << QByteArray(R"({"circles": "swap_normal", "timing": "continuous"})");
    QTest::newRow("impulse, continuous")
        << QByteArray(R"({"circles": "impulse", "timing": "continuous"})");
    QTest::newRow("impulse, exact") << QByteArray(R"({"circles": "impulse", "timing": "exact"})");
}

/// d = 0.3 m off centre and r₁ + r₂ = 0.4 m: contact at x = 2 − √0.07.
void TestCliSimulate::glancingHitIsThatOfTheFormula()
{
    QFETCH(QByteArray, laws);
    VERIFY_CODE(
        simulate(preset(glancing, laws), text("--duration 3 --states STATES --events EVENTS")), 0);
    const Table events = table("EVENTS");
    QCOMPARE(events.rows.size(), std::size_t{1});
    QCOMPARE(events.rows[0].mid(1, 3), text("circle,1,2").split(QLatin1Char(',')));
    const double mass = 7800.0 * 4.0 / 3.0 * scenes::pi * 0.008;
    COMPARE_NEAR(events.number(0, 0), (4.0 - std::sqrt(0.07)) / 2.0, 1e-9);
    COMPARE_NEAR(events.number(0, 4), std::sqrt(7.0) / 4.0, 1e-9);
    COMPARE_NEAR(events.number(0, 5), -0.75, 1e-9);
    COMPARE_NEAR(events.number(0, 6) / (mass * std::sqrt(7.0) / 2.0), 1.0, 1e-9);
    const Table states = table("STATES");
    const std::size_t last = states.rows.size() - 2;
    COMPARE_NEAR(states.number(last, 5), 1.125, 1e-9);
    COMPARE_NEAR(states.number(last, 6), 0.9921567416492215, 1e-9);
    COMPARE_NEAR(states.number(last + 1, 5), 0.875, 1e-9);
    COMPARE_NEAR(states.number(last + 1, 6), -0.9921567416492215, 1e-9);
    // And what is left of the time after the hit is spent.
    const double rest = 3.0 - (4.0 - std::sqrt(0.07)) / 2.0;
    COMPARE_NEAR(states.number(last + 1, 3), 2.0 + 0.875 * rest, 1e-9);
}

void TestCliSimulate::momentumIsKept_data()
{
    QTest::addColumn<QByteArray>("timing");
    for (const char *timing : {"discrete", "continuous", "exact"})
        QTest::newRow(timing) << QByteArray(timing);
}

void TestCliSimulate::momentumIsKept()
{
    QFETCH(QByteArray, timing);
    const QByteArray circles = R"([
        {"position": [-2, 0], "velocity": [3, 0.1], "radius": 0.3, "density": 2},
        {"position": [0, 0.2], "velocity": [0.2, -0.3], "radius": 0.2, "density": 5},
        {"position": [2, -0.1], "velocity": [-1, 0.4], "radius": 0.4, "density": 1}])";
    VERIFY_CODE(simulate(preset(circles, R"({"circles": "impulse", "timing": ")" + timing + "\"}",
                                R"(, "restitution": 0.6)"),
                         text("--duration 5 --totals TOTALS --events EVENTS")),
                0);
    QVERIFY(table("EVENTS").rows.size() >= 2);
    const Table totals = table("TOTALS");
    for (std::size_t i = 1; i < totals.rows.size(); ++i) {
        for (const int column : {2, 3}) {
            const double before = totals.number(0, column);
            COMPARE_NEAR(totals.number(i, column), before, 1e-12 * std::abs(totals.number(0, 2)));
        }
        QVERIFY(totals.number(i, 4) <= totals.number(i - 1, 4) * (1.0 + 1e-12));
        COMPARE_NEAR(totals.number(i, 4) + totals.number(i, 5), totals.number(i, 6), 1e-9);
    }
}

void TestCliSimulate::wallHitIsNamed_data()
{
    QTest::addColumn<QByteArray>("velocity");
    QTest::addColumn<QStringList>("row"); ///< kind, a, b, nx, ny
    const auto row = [](const char *name, const char *velocity, const char *cells) {
        QTest::newRow(name) << QByteArray(velocity) << text(cells).split(QLatin1Char(','));
    };
    row("left", "[-2, 0]", "wall,1,left,-1,0");
    row("right", "[2, 0]", "wall,1,right,1,0");
    row("bottom", "[0, -2]", "wall,1,bottom,0,-1");
    row("top", "[0, 2]", "wall,1,top,0,1");
}

void TestCliSimulate::wallHitIsNamed()
{
    QFETCH(QByteArray, velocity);
    QFETCH(QStringList, row);
    const QByteArray circle = R"([{"position": [0, 0], "velocity": )" + velocity + "}]";
    VERIFY_CODE(simulate(preset(circle, R"({"walls": "reflect", "timing": "continuous"})",
                                R"(, "restitution": 0.5)"),
                         text("--duration 2 --events EVENTS")),
                0);
    const Table events = table("EVENTS");
    QCOMPARE(events.rows.size(), std::size_t{1});
    QCOMPARE(events.rows[0].mid(1, 5), row);
    COMPARE_NEAR(events.number(0, 0), 1.9, 1e-9);
    // The wall takes m v (1 + e) along the outward normal.
    const double mass = 7800.0 * 4.0 / 3.0 * scenes::pi * 0.008;
    COMPARE_NEAR(events.number(0, 6) / (mass * 3.0), 1.0, 1e-9);
}

void TestCliSimulate::summaryIsPrintedWithoutTables()
{
    const Outcome outcome = simulate(preset(glancing), text("--duration 1"));
    VERIFY_CODE(outcome, 0);
    QVERIFY(outcome.out.contains(text("2 circles")) && outcome.out.contains(text("60 steps")));
}

void TestCliSimulate::wrongUsageIsSaid_data()
{
    QTest::addColumn<QString>("options");
    for (const char *options :
         {"", "--duration", "--duration 0", "--duration -1", "--duration nan", "--duration inf",
          "--duration soon", "--duration 1e9", "--duration 1 --timestep 0",
          "--duration 1 --timestep 1", "--duration 1 --timestep fast",
          "--duration 1 --timing later", "--duration 1 --every 0", "--duration 1 --every 1.5",
          "--duration 1 --every -3", "--duration 1 --colour", "--duration 1 second.json"})
        QTest::newRow(*options ? options : "no duration") << text(options);
}

void TestCliSimulate::wrongUsageIsSaid()
{
    QFETCH(QString, options);
    const Outcome outcome = simulate(preset(glancing), options);
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
    const QString path = written(m_folder, "größe 1.json", content);
    const Outcome outcome = simulate(path, text("--duration 1"));
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.startsWith(path + place), outcome.toText().constData());
    QVERIFY(outcome.out.isEmpty());
    const QString nowhere = m_folder.filePath(text("no/folder.csv"));
    const Outcome unwritten = simulate(preset(glancing), text("--duration 1 --states ") + nowhere);
    VERIFY_CODE(unwritten, 2);
    QVERIFY(unwritten.error.startsWith(nowhere + text(": ")));
}

QTEST_GUILESS_MAIN(TestCliSimulate)
#include "test_cli_simulate.moc"
