// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/runner.h"

#include "model/run/inferred_hits.h"
#include "tests/simulation_scenes.h"

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// Lets all circles fly, and turns them at x = 1 m; each step is work of ten instructions.
class Turner final : public Program
{
public:
    std::optional<ProgramError> begin(Preset &scene) override
    {
        work = 0;
        scene.restitution = 0.25;
        if (failsIn == 0)
            return ProgramError{.message = QStringLiteral("no")};
        return std::nullopt;
    }
    bool moves() const override { return movesThem; }
    std::optional<ProgramError> advance(World &world, double dt) override
    {
        work += 10;
        if (world.step + 1 == failsIn)
            return ProgramError{.message = QStringLiteral("stop"), .step = failsIn};
        for (Circle &circle : world.circles) {
            circle.position += dt * circle.velocity;
            if (circle.position.x > 1.0)
                circle.velocity.x = -std::abs(circle.velocity.x);
        }
        return std::nullopt;
    }
    qint64 instructions() const override { return work; }
    ProgramOutput takeOutput() override { return {}; }

    qint64 failsIn = -1;
    bool movesThem = true;
    qint64 work = 0;
};

/// A circle that a wall at x = 1 m turns.
Preset turned()
{
    Preset preset = scene({circle({0, 0}, {2, 0}, 0.2)}, {WallLaw::Reflect, CircleLaw::None, {}});
    preset.halfWidth = 1.2;
    return preset;
}

} // namespace

/// One way to run for all who run something.
class TestRunner : public QObject
{
    Q_OBJECT
private slots:
    void stepsAsTheStepperDoes();
    void partsOfAStepMakeTheSameStep();
    void timeAddsUpAfterAStepOfAnotherLength();
    void hitsOfAProgramAreInferred();
    void nobodyLooksAtHits();
    void lawsMoveWhereTheProgramDoesNot();
    void failingStepLeavesTheStateBefore();
    void programThatDoesNotBeginLeavesTheScene();
    void goesOnFromWhereItIsPlaced();
    void endsAtItsBounds_data();
    void endsAtItsBounds();
};

void TestRunner::stepsAsTheStepperDoes()
{
    const std::vector<World> expected = worldsOf(lively(), 300);
    Recording recording;
    Runner run(lively(), nullptr, {.recording = &recording});
    QVERIFY(!run.isProgrammed());
    std::size_t hits = 0;
    for (std::size_t k = 1; k <= 300; ++k) {
        QVERIFY(run.step());
        QVERIFY(run.world() == expected[k]);
        hits += run.hits().size();
    }
    QCOMPARE(recording.last(), qint64{300});
    for (qint64 k = 0; k <= 300; ++k)
        QVERIFY(recording.world(k) == expected[static_cast<std::size_t>(k)]);
    QVERIFY(hits > 0);
    QCOMPARE(recording.hits().size(), hits);
}

void TestRunner::partsOfAStepMakeTheSameStep()
{
    Runner whole(fallingHeap(60, 0.9));
    Runner parts(fallingHeap(60, 0.9));
    int begun = 0;
    for (int k = 0; k < 30; ++k) {
        QVERIFY(whole.step());
        Runner::Progress progress = Runner::Progress::Begun;
        while (progress == Runner::Progress::Begun) {
            const World before = parts.world();
            progress = parts.advance(dt, 1);
            if (progress == Runner::Progress::Begun) {
                ++begun;
                QVERIFY(parts.isUnfinished());
                QVERIFY(parts.world() == before);
                QVERIFY(parts.hits().empty());
            }
        }
        QVERIFY(!parts.isUnfinished());
        QVERIFY(parts.world() == whole.world());
        QVERIFY(parts.hits() == whole.hits());
    }
    QVERIFY(begun > 30);
}

void TestRunner::timeAddsUpAfterAStepOfAnotherLength()
{
    Runner run(lively());
    for (int k = 1; k <= 100; ++k) {
        QCOMPARE(run.endOf(dt), k * dt);
        QVERIFY(run.step());
        QVERIFY(run.world().time == k * dt);
    }
    QVERIFY(run.advance(0.005) == Runner::Progress::Done);
    QVERIFY(run.world().time == 100 * dt + 0.005);
    QVERIFY(run.step());
    QVERIFY(run.world().time == 100 * dt + 0.005 + dt);
    QCOMPARE(run.world().step, qint64{102});
}

void TestRunner::hitsOfAProgramAreInferred()
{
    Turner turner;
    Recording recording;
    Runner run(turned(), &turner, {.recording = &recording});
    QVERIFY(run.isProgrammed());
    QCOMPARE(run.scene().restitution, 0.25);
    int hits = 0;
    for (int k = 1; k <= 60; ++k) {
        const std::vector<Circle> before = run.world().circles;
        QVERIFY(run.step());
        std::vector<Hit> expected;
        inferHits(run.scene(), before, run.world().circles, dt, k, k * dt, expected);
        QVERIFY(run.hits() == expected);
        hits += static_cast<int>(expected.size());
    }
    QCOMPARE(hits, 1);
    QCOMPARE(recording.hits().size(), std::size_t{1});
    QVERIFY(recording.hits().front().kind == Hit::Kind::Wall);
}

void TestRunner::nobodyLooksAtHits()
{
    for (Turner turner;
         Program * program : {static_cast<Program *>(nullptr), static_cast<Program *>(&turner)}) {
        Recording recording;
        Runner run(turned(), program, {.recording = &recording, .tellsHits = false});
        QVERIFY(run.run({.steps = 60}) == Runner::End::AllSteps);
        QCOMPARE(recording.last(), qint64{60});
        QVERIFY(recording.hits().empty());
    }
}

void TestRunner::lawsMoveWhereTheProgramDoesNot()
{
    Turner turner;
    turner.movesThem = false;
    Runner run(turned(), &turner);
    QVERIFY(!run.isProgrammed());
    Preset scene = turned();
    scene.restitution = 0.25;
    const std::vector<World> expected = worldsOf(scene, 60);
    QVERIFY(run.run({.steps = 60}) == Runner::End::AllSteps);
    QVERIFY(run.world() == expected.back());
    QCOMPARE(turner.work, qint64{0});
}

void TestRunner::failingStepLeavesTheStateBefore()
{
    Turner turner;
    turner.failsIn = 5;
    Recording recording;
    Runner run(turned(), &turner, {.recording = &recording});
    for (int k = 0; k < 4; ++k)
        QVERIFY(run.step());
    const World before = run.world();
    for (int again = 0; again < 2; ++again) {
        QVERIFY(!run.step());
        QVERIFY(run.world() == before);
        QCOMPARE(run.error()->step, qint64{5});
        QVERIFY(run.hits().empty());
    }
    QCOMPARE(recording.last(), qint64{4});
    QCOMPARE(turner.work, qint64{50}); // it is not asked again
}

void TestRunner::programThatDoesNotBeginLeavesTheScene()
{
    Turner turner;
    turner.failsIn = 0;
    Recording recording;
    Runner run(turned(), &turner, {.recording = &recording});
    QVERIFY(run.error());
    QVERIFY(run.scene() == turned());
    QVERIFY(run.world() == initialWorld(turned()));
    QCOMPARE(recording.last(), qint64{0});
    QVERIFY(run.run({.steps = 10}) == Runner::End::Failed);
    QCOMPARE(run.world().step, qint64{0});
}

void TestRunner::goesOnFromWhereItIsPlaced()
{
    const std::vector<World> expected = worldsOf(lively(), 100);
    Runner run(lively());
    run.place(expected[40]);
    QVERIFY(run.run({.steps = 100}) == Runner::End::AllSteps);
    QVERIFY(run.world() == expected[100]);
}

void TestRunner::endsAtItsBounds_data()
{
    QTest::addColumn<Runner::Bounds>("bounds");
    QTest::addColumn<qint64>("failsIn");
    QTest::addColumn<int>("end");
    QTest::addColumn<qint64>("steps");
    using End = Runner::End;
    const auto row = [](const char *name, Runner::Bounds bounds, qint64 failsIn, End end,
                        qint64 steps) {
        QTest::newRow(name) << bounds << failsIn << static_cast<int>(end) << steps;
    };
    row("all steps", {.steps = 20}, -1, End::AllSteps, 20);
    row("no step", {.steps = 0}, -1, End::AllSteps, 0);
    row("it fails", {.steps = 20}, 8, End::Failed, 7);
    // Ten a step: after the sixth there are more than 55.
    row("too much work", {.steps = 20, .instructions = 55}, -1, End::TooManyInstructions, 6);
    row("stopped at once", {.steps = 20, .stop = [] { return true; }}, -1, End::Stopped, 0);
    // It is asked before every step.
    const auto asked = std::make_shared<int>(0);
    row("stopped later", {.steps = 20, .stop = [asked] { return ++*asked == 4; }}, -1, End::Stopped,
        3);
}

void TestRunner::endsAtItsBounds()
{
    QFETCH(Runner::Bounds, bounds);
    QFETCH(qint64, failsIn);
    QFETCH(qint64, steps);
    Turner turner;
    turner.failsIn = failsIn;
    Runner run(turned(), &turner);
    qint64 done = 0;
    const Runner::End end = run.run(bounds, [&] {
        ++done;
        QCOMPARE(run.world().step, done);
    });
    QTEST(static_cast<int>(end), "end");
    QCOMPARE(done, steps);
    QCOMPARE(run.world().step, steps);
}

QTEST_APPLESS_MAIN(TestRunner)
#include "test_runner.moc"
