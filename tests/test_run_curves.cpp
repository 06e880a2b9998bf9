// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/measurements.h"
#include "tests/gui/chart_scenes.h"
#include "views/charts/run_curves.h"

#include <QTest>

using namespace cradle;

class TestRunCurves final : public QObject
{
    Q_OBJECT
private slots:
    void curvesFollowTheRecording();
    void curvesBeginAnewWithTheRun();
    void energyIsKeptOrCountedAsDissipated();
    void manyCirclesHaveOnlyTheirSum();
    void curvesStayWithinTheirMemory();
};

void TestRunCurves::curvesFollowTheRecording()
{
    Simulation simulation(glancing());
    RunCurves curves(simulation);
    run(simulation, 200);
    const Recording &recording = simulation.recording();
    for (qint64 i = 0; i <= recording.last(); ++i) {
        const Totals sum = measure(recording.circles(i), {}, 4.0);
        QCOMPARE(curves.sum().momentum[0].valueAt(recording.time(i)), sum.momentum.x);
        const Circle &first = recording.circles(i)[0];
        QCOMPARE(curves.circle(0).kinetic.valueAt(recording.time(i)),
                 measure(first, {}, 4.0).kinetic);
    }
}

void TestRunCurves::curvesBeginAnewWithTheRun()
{
    Simulation simulation(glancing());
    RunCurves curves(simulation);
    run(simulation, 50);
    simulation.restart();
    QCOMPARE(curves.total().lastTime(), 0.0);
    simulation.setPreset(falling(3));
    QCOMPARE(curves.circleCount(), std::size_t{3});
    QCOMPARE(curves.dissipated().lastValue(), 0.0);
}

void TestRunCurves::energyIsKeptOrCountedAsDissipated()
{
    Simulation simulation(falling(2));
    RunCurves curves(simulation);
    run(simulation, 300);
    const double start = curves.total().valueAt(0.0);
    const double end = curves.total().lastValue() + curves.dissipated().lastValue();
    QVERIFY(curves.dissipated().lastValue() > 0.1 * start);
    QVERIFY2(std::abs(end - start) < 1e-6 * start, qPrintable(QString::number(end - start)));
}

void TestRunCurves::manyCirclesHaveOnlyTheirSum()
{
    Simulation simulation(falling(9));
    RunCurves curves(simulation);
    QCOMPARE(curves.circleCount(), std::size_t{0});
    run(simulation, 3);
    QCOMPARE(curves.sum().kinetic.lastTime(), simulation.time());
}

void TestRunCurves::curvesStayWithinTheirMemory()
{
    constexpr qint64 bound = 30'000;
    Simulation simulation(falling(2));
    RunCurves curves(simulation, nullptr, bound);
    run(simulation, 3000);
    QVERIFY(curves.bytes() <= bound);
    QCOMPARE(curves.total().lastTime(), simulation.time());
    QVERIFY(curves.total().firstTime() > 0.0);
}

QTEST_MAIN(TestRunCurves)

#include "test_run_curves.moc"
