// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/chart_scenes.h"
#include "tests/gui/settled.h"
#include "tests/patience.h"
#include "views/charts/energy_chart.h"

#include "model/world/measurements.h"

#include <QTest>

using namespace cradle;

namespace {

const ChartCurve *curveOf(const EnergyChart &chart, const QString &label)
{
    for (const ChartCurve &curve : chart.plot().curves()) {
        if (curve.label == label)
            return &curve;
    }
    return nullptr;
}

} // namespace

class TestEnergyChart final : public QObject
{
    Q_OBJECT
private slots:
    void areasLieOnTopOfEachOther();
    void errorToTheExactMotionIsACurve();
};

void TestEnergyChart::areasLieOnTopOfEachOther()
{
    Simulation simulation(falling(2));
    RunCurves curves(simulation);
    EnergyChart chart(simulation, curves);
    chart.setShown(EnergyChart::KineticOfEach, true);
    chart.setShown(EnergyChart::Stacked, true);
    chart.resize(420, 260);
    chart.show();
    run(simulation, 300);
    QTRY_VERIFY(curveOf(chart, QStringLiteral("+ dissipated")));
    const auto topAt = [&](const char *label, double time) {
        const ChartCurve *curve = curveOf(chart, QString::fromUtf8(label));
        return curve->samples->valueAt(time) + curve->lift;
    };
    const double start = curves.total().valueAt(0.0);
    for (const qint64 index : {10, 150, 300}) {
        const double time = simulation.recording().time(index);
        const auto circles = simulation.recording().circles(index);
        const double first = measure(circles[0], {0.0, -9.81}, 4.0).kinetic;
        const Totals all = measure(circles, {0.0, -9.81}, 4.0);
        QCOMPARE(topAt("kinetic 1", time), first);
        QCOMPARE(topAt("kinetic 2", time), all.kinetic);
        QCOMPARE(topAt("+ potential", time), all.total());
        // Verlet makes no energy: what hits took and what is left are what there was.
        QVERIFY(std::abs(topAt("+ dissipated", time) - start) < 1e-6 * start);
    }
    for (const ChartCurve &curve : chart.plot().curves())
        QVERIFY(curve.isFilled);
    chart.setShown(EnergyChart::Stacked, false);
    QTRY_VERIFY(curveOf(chart, QStringLiteral("total")));
}

void TestEnergyChart::errorToTheExactMotionIsACurve()
{
    Simulation simulation(euleredFall());
    RunCurves curves(simulation);
    EnergyChart chart(simulation, curves);
    chart.resize(420, 260);
    chart.show();
    run(simulation, 30);
    settle();
    QVERIFY(!curveOf(chart, QStringLiteral("more than exact")));
    simulation.setShadowed(true);
    run(simulation, 30);
    QTRY_VERIFY(curveOf(chart, QStringLiteral("more than exact")));
    // Up to the floor Euler gains ½ m g² h² a step, and symplectic Euler loses as much; both are
    // ½ g h t from the parabola.
    const double h = 1.0 / 60.0;
    for (const qint64 index : {15, 45}) {
        const double time = simulation.recording().time(index);
        QVERIFY(std::abs(curves.exact().energy().valueAt(time)) < 1e-6 * curves.total().valueAt(0));
        QVERIFY(std::abs(curves.exact().distance().valueAt(time) - 0.5 * 9.81 * h * time) < 1e-9);
    }
    simulation.setShadowed(false);
    QTRY_VERIFY(!curveOf(chart, QStringLiteral("more than exact")));
    QVERIFY(curves.exact().energy().isEmpty());
}

QTEST_MAIN(TestEnergyChart)

#include "test_energy_chart.moc"
