// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/simulate_test.h"

#include <array>

using namespace cradle::programs;
namespace scenes = cradle::scenes;

/// cradle-cli simulate: its numbers against formulas worked out apart from the engine.
class TestCliSimulateValues : public QObject
{
    Q_OBJECT
private slots:
    void integratorFollowsItsRecurrence_data();
    void integratorFollowsItsRecurrence();
    void glancingHitIsThatOfTheFormula_data();
    void glancingHitIsThatOfTheFormula();
    void momentumIsKept_data();
    void momentumIsKept();
    void wallHitIsNamed_data();
    void wallHitIsNamed();

private:
    SimulateTest m_run;
};

void TestCliSimulateValues::integratorFollowsItsRecurrence_data()
{
    QTest::addColumn<double>("late"); ///< the part of g h² that the position gets in the same step
    QTest::newRow("euler") << 0.0;
    QTest::newRow("symplectic_euler") << 1.0;
    QTest::newRow("verlet") << 0.5;
    QTest::newRow("rk4") << 0.5;
}

void TestCliSimulateValues::integratorFollowsItsRecurrence()
{
    QFETCH(double, late);
    const QByteArray name = QTest::currentDataTag();
    const QByteArray circle =
        R"([{"position": [-2, 2], "velocity": [2, 1], "integrator": ")" + name + R"("}])";
    VERIFY_CODE(m_run.simulate(
                    m_run.preset(circle, "{}", R"(, "gravity": [0.25, -9.81], "timestep": 0.01)"),
                    text("--duration 2 --states STATES")),
                0);
    const Table states = m_run.table("STATES");
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

void TestCliSimulateValues::glancingHitIsThatOfTheFormula_data()
{
    QTest::addColumn<QByteArray>("laws");
    QTest::newRow("swap, continuous")
        << QByteArray(R"({"circles": "swap_normal", "timing": "continuous"})");
    QTest::newRow("impulse, continuous")
        << QByteArray(R"({"circles": "impulse", "timing": "continuous"})");
    QTest::newRow("impulse, exact") << QByteArray(R"({"circles": "impulse", "timing": "exact"})");
}

/// d = 0.3 m off centre and r₁ + r₂ = 0.4 m: contact at x = 2 − √0.07.
void TestCliSimulateValues::glancingHitIsThatOfTheFormula()
{
    QFETCH(QByteArray, laws);
    VERIFY_CODE(m_run.simulate(m_run.preset(glancing, laws),
                               text("--duration 3 --states STATES --events EVENTS")),
                0);
    const Table events = m_run.table("EVENTS");
    QCOMPARE(events.rows.size(), std::size_t{1});
    QCOMPARE(events.rows[0].mid(1, 3), text("circle,1,2").split(QLatin1Char(',')));
    const double mass = 7800.0 * 4.0 / 3.0 * scenes::pi * 0.008;
    COMPARE_NEAR(events.number(0, 0), (4.0 - std::sqrt(0.07)) / 2.0, 1e-9);
    COMPARE_NEAR(events.number(0, 4), std::sqrt(7.0) / 4.0, 1e-9);
    COMPARE_NEAR(events.number(0, 5), -0.75, 1e-9);
    COMPARE_NEAR(events.number(0, 6) / (mass * std::sqrt(7.0) / 2.0), 1.0, 1e-9);
    const Table states = m_run.table("STATES");
    const std::size_t last = states.rows.size() - 2;
    COMPARE_NEAR(states.number(last, 5), 1.125, 1e-9);
    COMPARE_NEAR(states.number(last, 6), 0.9921567416492215, 1e-9);
    COMPARE_NEAR(states.number(last + 1, 5), 0.875, 1e-9);
    COMPARE_NEAR(states.number(last + 1, 6), -0.9921567416492215, 1e-9);
    // And what is left of the time after the hit is spent.
    const double rest = 3.0 - (4.0 - std::sqrt(0.07)) / 2.0;
    COMPARE_NEAR(states.number(last + 1, 3), 2.0 + 0.875 * rest, 1e-9);
}

void TestCliSimulateValues::momentumIsKept_data()
{
    QTest::addColumn<QByteArray>("timing");
    for (const char *timing : {"discrete", "continuous", "exact"})
        QTest::newRow(timing) << QByteArray(timing);
}

void TestCliSimulateValues::momentumIsKept()
{
    QFETCH(QByteArray, timing);
    const QByteArray circles = R"([
        {"position": [-2, 0], "velocity": [3, 0.1], "radius": 0.3, "density": 2},
        {"position": [0, 0.2], "velocity": [0.2, -0.3], "radius": 0.2, "density": 5},
        {"position": [2, -0.1], "velocity": [-1, 0.4], "radius": 0.4, "density": 1}])";
    VERIFY_CODE(m_run.simulate(
                    m_run.preset(circles, R"({"circles": "impulse", "timing": ")" + timing + "\"}",
                                 R"(, "restitution": 0.6)"),
                    text("--duration 5 --totals TOTALS --events EVENTS")),
                0);
    QVERIFY(m_run.table("EVENTS").rows.size() >= 2);
    const Table totals = m_run.table("TOTALS");
    for (std::size_t i = 1; i < totals.rows.size(); ++i) {
        for (const int column : {2, 3}) {
            const double before = totals.number(0, column);
            COMPARE_NEAR(totals.number(i, column), before, 1e-12 * std::abs(totals.number(0, 2)));
        }
        QVERIFY(totals.number(i, 4) <= totals.number(i - 1, 4) * (1.0 + 1e-12));
        COMPARE_NEAR(totals.number(i, 4) + totals.number(i, 5), totals.number(i, 6), 1e-9);
    }
}

void TestCliSimulateValues::wallHitIsNamed_data()
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

void TestCliSimulateValues::wallHitIsNamed()
{
    QFETCH(QByteArray, velocity);
    QFETCH(QStringList, row);
    const QByteArray circle = R"([{"position": [0, 0], "velocity": )" + velocity + "}]";
    VERIFY_CODE(
        m_run.simulate(m_run.preset(circle, R"({"walls": "reflect", "timing": "continuous"})",
                                    R"(, "restitution": 0.5)"),
                       text("--duration 2 --events EVENTS")),
        0);
    const Table events = m_run.table("EVENTS");
    QCOMPARE(events.rows.size(), std::size_t{1});
    QCOMPARE(events.rows[0].mid(1, 5), row);
    COMPARE_NEAR(events.number(0, 0), 1.9, 1e-9);
    // The wall takes m v (1 + e) along the outward normal.
    const double mass = 7800.0 * 4.0 / 3.0 * scenes::pi * 0.008;
    COMPARE_NEAR(events.number(0, 6) / (mass * 3.0), 1.0, 1e-9);
}

QTEST_GUILESS_MAIN(TestCliSimulateValues)
#include "test_cli_simulate_values.moc"
