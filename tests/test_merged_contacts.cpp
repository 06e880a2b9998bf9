// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"
#include "model/world/measurements.h"
#include "tests/patience.h"
#include "tests/scenes.h"

#include <QSignalSpy>

using namespace cradle;
using namespace cradle::scenes;

using Action = void (*)(Simulation &);

/// Exact timing says when it cannot follow a heap any longer, and ends; its steps and the search
/// for a hit can be taken in parts.
class TestMergedContacts : public QObject
{
    Q_OBJECT
private slots:
    void aHeapIsMergedWhateverTheTimestep();
    void aHeapThatIsMergedComesToRest();
    void aThousandTakeBoundedWork();
    void whatCanBeFollowedStaysExact();
    void anotherWorldIsExactAgain();
    void partsOfAStepMakeTheStep();
    void simulationTellsOfTheMerging();
    void searchForAHitCanBeEnded_data();
    void searchForAHitCanBeEnded();
    void longSearchEndsByItself();
};

namespace {

constexpr int many = 200; // circles, of which exact timing cannot follow a heap

double energyOf(const World &world)
{
    return measure(world.circles, {0, -g}, 1.0).total();
}

/// So many at rest that no search for a hit ends at once.
Preset still(int count)
{
    Preset preset = fallingHeap(count, 1.0);
    preset.gravity = {};
    for (PresetCircle &c : preset.circles)
        c.body.velocity = {};
    return preset;
}

} // namespace

void TestMergedContacts::aHeapIsMergedWhateverTheTimestep()
{
    double merged[2] = {0.0, 1.0};
    for (const int parts : {1, 4}) {
        Preset preset = fallingHeap(many, 0.5);
        preset.timestep = dt / parts;
        Stepper stepper(preset);
        World world = initialWorld(preset);
        std::vector<Hit> hits;
        while (!stepper.mergedFrom() && world.time < 5.0)
            stepper.advance(world, hits);
        QVERIFY(stepper.mergedFrom().has_value());
        QVERIFY(*stepper.mergedFrom() <= world.time);
        QVERIFY(*stepper.mergedFrom() > world.time - preset.timestep);
        merged[parts == 1 ? 0 : 1] = *stepper.mergedFrom();
    }
    COMPARE_NEAR(merged[0], merged[1], 1e-12);
}

void TestMergedContacts::aHeapThatIsMergedComesToRest()
{
    const Preset preset = fallingHeap(many, 0.5);
    Stepper stepper(preset);
    World world = initialWorld(preset);
    std::vector<Hit> hits;
    const double start = energyOf(world);
    double least = start;
    while (world.time < 3.0) {
        stepper.advance(world, hits);
        QVERIFY(energyOf(world) <= least + 1e-3 * start);
        least = std::min(least, energyOf(world));
    }
    for (std::size_t i = 0; i < world.circles.size(); ++i) {
        const Circle &a = world.circles[i];
        QVERIFY(length(a.velocity) < 0.05);
        QVERIFY(std::max(std::abs(a.position.x), std::abs(a.position.y)) <= 1.0 - 0.99 * a.radius);
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(length(world.circles[j].position - a.position) >= 1.99 * a.radius);
    }
    for (std::size_t i = 1; i < hits.size(); ++i)
        QVERIFY(hits[i].time >= hits[i - 1].time);
}

/// 1,000 circles that lose little in hits: followed hit by hit their third second would not end.
void TestMergedContacts::aThousandTakeBoundedWork()
{
    constexpr std::size_t eventsAPart = 10'000;
    constexpr int mostParts = 20; // a step takes no more than some 0.2 s
    Preset preset = fallingHeap(1, 0.9);
    preset.halfWidth = 4.0;
    preset.fill->count = 1000;
    preset.fill->rmsSpeed = 1.0;
    preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    Stepper stepper(preset);
    World world = initialWorld(preset);
    std::vector<Hit> hits;
    std::optional<double> merged;
    const double start = measure(world.circles, preset.gravity, preset.halfWidth).total();
    for (int step = 1; step <= 180; ++step) {
        int parts = 1;
        while (!stepper.advanceWithin(eventsAPart, world, dt, step * dt, hits))
            ++parts;
        QVERIFY2(parts <= mostParts, QByteArray::number(parts).constData());
        if (merged)
            QVERIFY(stepper.mergedFrom() == merged);
        merged = stepper.mergedFrom();
    }
    QVERIFY(merged.has_value());
    // They lie three rows deep at the least, and the first has fallen for less than this.
    QVERIFY(*merged > 0.9 * std::sqrt(2.0 * preset.halfWidth / g));
    QVERIFY(*merged < 3.0);
    QVERIFY(measure(world.circles, preset.gravity, preset.halfWidth).total() < start);
}

void TestMergedContacts::whatCanBeFollowedStaysExact()
{
    // Elastic circles never collapse, however many; a heap of few can be followed.
    for (const Preset &preset : {fallingHeap(many, 1.0), fallingHeap(12, 0.5)}) {
        Stepper stepper(preset);
        World world = initialWorld(preset);
        std::vector<Hit> hits;
        while (world.time < 3.0)
            stepper.advance(world, hits);
        QVERIFY(!stepper.mergedFrom().has_value());
    }
}

void TestMergedContacts::anotherWorldIsExactAgain()
{
    const Preset preset = fallingHeap(many, 0.5);
    Stepper stepper(preset);
    World world = initialWorld(preset);
    std::vector<Hit> hits;
    while (!stepper.mergedFrom())
        stepper.advance(world, hits);
    world = initialWorld(preset);
    stepper.advance(world, hits);
    QVERIFY(!stepper.mergedFrom().has_value());
    World expected = initialWorld(preset);
    Stepper(preset).advance(expected, hits);
    QVERIFY(world == expected);
}

void TestMergedContacts::partsOfAStepMakeTheStep()
{
    const Preset preset = fallingHeap(60, 0.9);
    Stepper whole(preset);
    Stepper parted(preset);
    World expected = initialWorld(preset);
    World world = expected;
    std::vector<Hit> expectedHits;
    std::vector<Hit> hits;
    int parts = 0;
    for (int step = 1; step <= 60; ++step) {
        whole.advance(expected, expectedHits);
        const World before = world;
        while (!parted.advanceWithin(3, world, dt, step * dt, hits)) {
            QVERIFY(world == before);
            ++parts;
        }
        QVERIFY(world == expected);
        QVERIFY(hits == expectedHits);
    }
    QVERIFY(parts > 100);
}

void TestMergedContacts::simulationTellsOfTheMerging()
{
    Simulation simulation(fallingHeap(many, 0.5));
    QVERIFY(!simulation.mergedFrom().has_value());
    simulation.goTo(90); // 1.5 s
    QCOMPARE(simulation.recording().last(), qint64{90});
    QVERIFY(simulation.mergedFrom().has_value());
    simulation.restart();
    QVERIFY(!simulation.mergedFrom().has_value());
}

void TestMergedContacts::searchForAHitCanBeEnded_data()
{
    QTest::addColumn<Action>("action");
    QTest::addColumn<qint64>("current");
    QTest::newRow("pause") << Action([](Simulation &s) { s.pause(); }) << qint64{2};
    QTest::newRow("step") << Action([](Simulation &s) { s.stepForward(); }) << qint64{3};
    QTest::newRow("start") << Action([](Simulation &s) { s.start(); }) << qint64{2};
    QTest::newRow("restart") << Action([](Simulation &s) { s.restart(); }) << qint64{0};
}

void TestMergedContacts::searchForAHitCanBeEnded()
{
    QFETCH(Action, action);
    QFETCH(qint64, current);
    Simulation simulation(still(300));
    simulation.goTo(2);
    QSignalSpy searching(&simulation, &Simulation::searchingChanged);
    QSignalSpy noHit(&simulation, &Simulation::noHitFound);
    simulation.seekNextHit();
    QVERIFY(simulation.isSearching());
    QVERIFY(simulation.current() > 2);
    action(simulation);
    QVERIFY(!simulation.isSearching());
    QCOMPARE(simulation.current(), current);
    QCOMPARE(searching.size(), 2);
    QVERIFY(searching[0][0].toBool() && !searching[1][0].toBool());
    QCOMPARE(noHit.size(), 0);
}

void TestMergedContacts::longSearchEndsByItself()
{
    Simulation simulation(still(20));
    QSignalSpy noHit(&simulation, &Simulation::noHitFound);
    simulation.seekNextHit();
    QVERIFY(simulation.isSearching());
    QTRY_COMPARE(noHit.size(), 1);
    QVERIFY(!simulation.isSearching());
    QCOMPARE(simulation.current(), qint64{0});
}

QTEST_GUILESS_MAIN(TestMergedContacts)
#include "test_merged_contacts.moc"
