// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/measurements.h"
#include "tests/gui/chart_scenes.h"
#include "views/charts/run_curves.h"

#include <QTest>

using namespace cradle;

namespace {

/// The run of a simulation in a recording that forgets the oldest part.
struct ForgetfulRun {
    static constexpr qint64 maxBytes = 100'000;

    ForgetfulRun()
        : simulation(falling(2))
        , recording(maxBytes)
    {
        scarce.begin(2);
        scarce.setGroups({}, recording, simulation.preset(), 0);
        full.begin(2);
        const auto &hits = simulation.recording().hits();
        std::size_t hit = 0;
        for (int i = 0; i < 2000; ++i) {
            const World world = simulation.recording().world(i);
            const std::size_t first = hit;
            while (hit < hits.size() && hits[hit].step <= world.step)
                ++hit;
            const std::vector<Hit> shown(hits.begin() + static_cast<std::ptrdiff_t>(first),
                                         hits.begin() + static_cast<std::ptrdiff_t>(hit));
            recording.append(world, shown);
            for (CurveSet *set : {&scarce, &full}) {
                set->read(recording, simulation.preset(), i);
                set->dropBefore(recording.time(recording.first()));
            }
            simulation.stepForward();
        }
    }

    Simulation simulation;
    Recording recording;
    CurveSet scarce; ///< the total only
    CurveSet full;
};

/// Whether both have the same kinetic energies, and what was made to rounding.
void verifyAlike(const ForgetfulRun &run, const CurveSet &set)
{
    for (qint64 i = run.recording.first(); i <= run.recording.last(); ++i) {
        const double time = run.recording.time(i);
        QCOMPARE(set.circle(1).kinetic.valueAt(time), run.full.circle(1).kinetic.valueAt(time));
        QCOMPARE(set.sum().momentum[1].valueAt(time), run.full.sum().momentum[1].valueAt(time));
        const double off = set.made().valueAt(time) - run.full.made().valueAt(time);
        QVERIFY2(std::abs(off) < 1e-9 * run.full.energyScale(), qPrintable(QString::number(off)));
    }
}

} // namespace

class TestRunCurves final : public QObject
{
    Q_OBJECT
private slots:
    void curvesFollowTheRecording();
    void curvesBeginAnewWithTheRun();
    void energyIsKeptOrCountedAsDissipated();
    void manyCirclesHaveOnlyTheirSum();
    void curvesStayWithinTheirMemory();
    void onlyWhatIsWantedIsKept();
    void whatIsWantedLaterIsAsIfItHadBeenKept();
    void wholeRunHasAllCurves();
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

void TestRunCurves::onlyWhatIsWantedIsKept()
{
    Simulation simulation(falling(2));
    RunCurves curves(simulation);
    RunCurves all(simulation);
    run(simulation, 600);
    const QObject momentum;
    const QObject energy;
    curves.want(&momentum, CurveGroup::MomentumX);
    QVERIFY(!curves.sum().momentum[0].isEmpty());
    QVERIFY(curves.sum().momentum[1].isEmpty() && curves.circle(0).kinetic.isEmpty());
    QVERIFY(curves.bytes() < all.bytes() / 4);
    curves.want(&energy, CurveGroup::KineticOfEach);
    run(simulation, 100);
    curves.want(&momentum, CurveGroup::MomentumY); // and no longer x
    QVERIFY(curves.sum().momentum[0].isEmpty());
    run(simulation, 100);
    // What was read late and what has gone on are as in a set that always had them.
    const double end = simulation.time();
    const auto points = [end](const MinMaxPyramid &curve) {
        return curve.decimate(0.0, end, 2000);
    };
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(points(curves.circle(i).momentum[1]), points(all.circle(i).momentum[1]));
        QCOMPARE(points(curves.circle(i).kinetic), points(all.circle(i).kinetic));
    }
    QCOMPARE(points(curves.total()), points(all.total()));
    QCOMPARE(curves.energyScale(), all.energyScale());
    QCOMPARE(curves.momentumScale(), all.momentumScale());
    simulation.restart();
    run(simulation, 10);
    QVERIFY(curves.sum().momentum[0].isEmpty());
    QCOMPARE(curves.sum().momentum[1].lastTime(), simulation.time());
}

void TestRunCurves::whatIsWantedLaterIsAsIfItHadBeenKept()
{
    ForgetfulRun run;
    QVERIFY(run.recording.droppedHits() > 0 && run.recording.hasDropped());
    QVERIFY(run.scarce.made().isEmpty());
    run.scarce.setGroups(CurveGroup::All, run.recording, run.simulation.preset(), 2000);
    QCOMPARE(run.scarce.startTotal(), run.full.startTotal());
    verifyAlike(run, run.scarce);
}

void TestRunCurves::wholeRunHasAllCurves()
{
    const ForgetfulRun run;
    const CurveSet whole =
        run.scarce.whole(run.recording, run.simulation.preset(), 2000, 10'000'000);
    QCOMPARE(whole.startTotal(), run.full.startTotal());
    verifyAlike(run, whole);
    const CurveSet part = run.scarce.whole(run.recording, run.simulation.preset(), 2000, 60'000);
    QVERIFY(part.bytes() <= 60'000);
    QCOMPARE(part.circle(0).total.lastValue(), run.full.circle(0).total.lastValue());
}

QTEST_MAIN(TestRunCurves)

#include "test_run_curves.moc"
