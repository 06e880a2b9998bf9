// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/preset_json.h"
#include "tests/scenes.h"
#include "tests/test_paths.h"
#include "views/charts/run_curves.h"

#include <QTest>

using namespace cradle;

namespace {

/// A ball that bounces lower and lower on the floor, and then rests there.
Preset settling(Integrator integrator)
{
    Preset preset;
    preset.gravity = {0.0, -9.81};
    preset.restitution = 0.5;
    preset.laws.walls = WallLaw::Reflect;
    preset.circles = {scenes::circle({0.0, 0.0}, {}, 0.2, integrator)};
    return preset;
}

/// Start = total + what hits took − what was made, at every moment.
void verifyBalance(const RunCurves &curves, double time)
{
    const double start = curves.set().startTotal();
    const double sum = curves.total().valueAt(time) + curves.dissipated().valueAt(time)
                       - curves.made().valueAt(time);
    QVERIFY2(std::abs(sum - start) <= 1e-9 * std::abs(start), qPrintable(QString::number(sum)));
}

} // namespace

/// Hits that follow each other at once are one contact with a beginning and an end; the energy that
/// they take grows no more when all rests.
class TestEncounters final : public QObject
{
    Q_OBJECT
private slots:
    void aRestingCircleIsOneEncounter();
    void fastHitsOfOneWallAreManyEncounters();
    void truncatedAndDroppedLikeTheHits();
    void nextHitPassesARest();
    void restTakesNoEnergy_data();
    void restTakesNoEnergy();
    void hitsAreChargedWithWhatTheyMake_data();
    void hitsAreChargedWithWhatTheyMake();
    void stepSeventeenComesToRest();
};

void TestEncounters::aRestingCircleIsOneEncounter()
{
    Simulation simulation(settling(Integrator::SymplecticEuler));
    simulation.goTo(1200); // 20 s
    const Recording &recording = simulation.recording();
    QVERIFY(recording.hits().size() > 600); // most steps of the rest
    QVERIFY(recording.encounters().size() < 15);
    const Encounter &rest = recording.encounters().back();
    QVERIFY(rest.lasts());
    QVERIFY(rest.endStep >= 1197);
    QVERIFY(rest.time < 5.0);
    QCOMPARE(recording.hitOf(rest).step, rest.step);
    for (std::size_t i = 0; i < 2; ++i)
        QVERIFY(!recording.encounters()[i].lasts());
}

/// From wall to wall and back in two steps: it leaves in between.
void TestEncounters::fastHitsOfOneWallAreManyEncounters()
{
    Preset preset;
    preset.halfWidth = 1.0;
    preset.laws = {WallLaw::Reflect, CircleLaw::None, Timing::Continuous};
    preset.circles = {scenes::circle({0.0, 0.0}, {90.0, 0.0})};
    Simulation simulation(preset);
    simulation.goTo(60);
    const Recording &recording = simulation.recording();
    QVERIFY(recording.hits().size() > 50);
    QCOMPARE(recording.encounters().size(), recording.hits().size());
}

void TestEncounters::truncatedAndDroppedLikeTheHits()
{
    Recording recording(40'000);
    World world = initialWorld(settling(Integrator::Verlet));
    Hit hit{.kind = Hit::Kind::Wall, .a = 0, .b = 2, .normal = {0.0, -1.0}};
    for (qint64 i = 0; i < 1000; ++i) {
        world.step = hit.step = i;
        world.time = hit.time = static_cast<double>(i) / 60.0;
        const bool hits = i % 100 < 10; // ten steps of contact, ninety without
        recording.append(world, hits ? std::span(&hit, 1) : std::span<const Hit>());
    }
    QVERIFY(recording.droppedEncounters() > 0);
    QCOMPARE(recording.droppedEncounters() + qint64(recording.encounters().size()), qint64{10});
    recording.truncateAfter(905);
    QCOMPARE(recording.encounters().back().step, qint64{900});
    QCOMPARE(recording.encounters().back().endStep, qint64{905});
    recording.truncateAfter(899);
    QCOMPARE(recording.encounters().back().step, qint64{800});
    QCOMPARE(recording.encounters().back().endStep, qint64{809});
    QCOMPARE(recording.droppedEncounters() + qint64(recording.encounters().size()), qint64{9});
}

void TestEncounters::nextHitPassesARest()
{
    Simulation simulation(settling(Integrator::SymplecticEuler));
    simulation.goTo(1200);
    bool found = true;
    connect(&simulation, &Simulation::noHitFound, this, [&found] { found = false; });
    simulation.seekNextHit();
    QVERIFY(!found);
    simulation.seekPreviousHit();
    QVERIFY(simulation.time() < 5.0); // where the rest began
}

void TestEncounters::restTakesNoEnergy_data()
{
    QTest::addColumn<Integrator>("integrator");
    // Euler's never rests: it hops, makes energy in each flight and gives it away in each hit.
    for (const Integrator integrator :
         {Integrator::SymplecticEuler, Integrator::Verlet, Integrator::RungeKutta4})
        QTest::newRow(scenes::shortName(integrator)) << integrator;
}

void TestEncounters::restTakesNoEnergy()
{
    QFETCH(Integrator, integrator);
    Simulation simulation(settling(integrator));
    RunCurves curves(simulation);
    simulation.goTo(1200);
    curves.update();
    const double start = curves.set().startTotal();
    const double at10 = curves.dissipated().valueAt(10.0);
    const double at20 = curves.dissipated().valueAt(20.0);
    QVERIFY2(std::abs(at20 - at10) < 1e-3 * start, qPrintable(QString::number(at20 - at10)));
    for (const double time : {0.5, 1.0, 2.0, 5.0, 20.0})
        verifyBalance(curves, time);
}

void TestEncounters::hitsAreChargedWithWhatTheyMake_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::newRow("Verlet") << Integrator::Verlet;
    QTest::newRow("RK4") << Integrator::RungeKutta4;
}

/// Both follow a parabola exactly, so that all the rest is the hits' doing.
void TestEncounters::hitsAreChargedWithWhatTheyMake()
{
    QFETCH(Integrator, integrator);
    Preset preset = settling(integrator);
    preset.restitution = 1.0;
    Simulation simulation(preset);
    RunCurves curves(simulation);
    simulation.goTo(1200);
    curves.update();
    const double start = curves.set().startTotal();
    QVERIFY(std::abs(curves.dissipated().lastValue()) > 1e-3 * start); // to the old place and back
    QVERIFY(std::abs(curves.made().lastValue()) < 1e-9 * start);
    verifyBalance(curves, 20.0);
}

void TestEncounters::stepSeventeenComesToRest()
{
    const auto preset = readPreset(sourcePath("tasks/labs/lab-4.2/L42T17/preset.json"));
    QVERIFY(preset);
    Preset scene = *preset;
    scene.gravity = {0.0, -9.81}; // as the step asks to try
    scene.laws.timing = Timing::Discrete;
    Simulation simulation(scene);
    RunCurves curves(simulation);
    simulation.goTo(3600); // 60 s
    curves.update();
    const double start = curves.set().startTotal();
    QVERIFY2(curves.dissipated().maximum() <= start * 1.001,
             qPrintable(QString::number(curves.dissipated().maximum())));
    QVERIFY2(simulation.recording().encounters().size() < 300,
             qPrintable(QString::number(simulation.recording().encounters().size())));
    verifyBalance(curves, 60.0);
}

QTEST_GUILESS_MAIN(TestEncounters)

#include "test_encounters.moc"
