// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/program_notes.h"
#include "model/run/simulation.h"
#include "tests/patience.h"

#include <QSignalSpy>
#include <QTest>

using namespace cradle;

namespace {

/// Moves every circle by 1 m a step, and fails in a step if told so.
class Walker final : public Program
{
public:
    std::optional<ProgramError> begin(Preset &scene) override
    {
        ++begun;
        if (failsToLoad)
            return ProgramError{.message = QStringLiteral("no"), .line = 3};
        scene.gravity = {0.0, -1.0};
        scene.circles[0].body.velocity = {1.0, 0.0};
        return std::nullopt;
    }
    bool moves() const override { return movesThem; }
    std::optional<ProgramError> advance(World &world, double) override
    {
        const Vec2 next = world.circles[0].position + Vec2{1.0, 0.0};
        output.text = QStringLiteral("step\n");
        output.points = {{QStringLiteral("x"), next.x}};
        output.drawings = {{.kind = Drawing::Kind::Point, .from = next}};
        if (world.step + 1 == failsIn)
            return ProgramError{.message = QStringLiteral("stop"), .line = 7, .step = failsIn};
        for (Circle &circle : world.circles)
            circle.position.x += 1.0;
        return std::nullopt;
    }
    ProgramOutput takeOutput() override { return std::exchange(output, {}); }

    int begun = 0;
    bool failsToLoad = false;
    bool movesThem = true;
    qint64 failsIn = -1;
    ProgramOutput output;
};

Preset oneCircle()
{
    Preset preset;
    preset.circles.resize(1);
    return preset;
}

} // namespace

/// A run that a program moves.
class TestProgramRun final : public QObject
{
    Q_OBJECT
private slots:
    void longCurvesKeepTheirTimes();
    void programMovesTheCircles();
    void sceneIsWhatTheProgramMadeOfIt();
    void lawsMoveWhereTheProgramDoesNot();
    void runRestsBeforeTheFailingStep();
    void programThatDoesNotLoadRunsNothing();
    void restartBeginsTheProgramAnew();
    void notesBelongToTheirSteps();
    void notesAreBounded();
    void drawingsOfTheLatestStepStay();
};

void TestProgramRun::programMovesTheCircles()
{
    Simulation simulation(oneCircle());
    Walker walker;
    simulation.setProgram(&walker);
    simulation.goTo(3);
    QCOMPARE(simulation.recording().circles(3)[0].position.x, 3.0);
    QCOMPARE(simulation.time(), 3.0 / 60.0);
    QVERIFY(simulation.isProgrammed());
    // The past is told, not run again.
    simulation.stepBack();
    simulation.stepForward();
    QCOMPARE(simulation.recording().last(), 3);
    simulation.setProgram(nullptr);
    QVERIFY(!simulation.isProgrammed());
    simulation.goTo(3);
    QCOMPARE(simulation.recording().circles(3)[0].position.x, 0.0);
}

void TestProgramRun::sceneIsWhatTheProgramMadeOfIt()
{
    Simulation simulation(oneCircle());
    Walker walker;
    simulation.setProgram(&walker);
    QCOMPARE(simulation.preset().gravity, (Vec2{0.0, -1.0}));
    QCOMPARE(simulation.basePreset().gravity, Vec2{});
    QCOMPARE(simulation.recording().circles(0)[0].velocity, (Vec2{1.0, 0.0}));
}

void TestProgramRun::lawsMoveWhereTheProgramDoesNot()
{
    Simulation simulation(oneCircle());
    Walker walker;
    walker.movesThem = false;
    simulation.setProgram(&walker);
    simulation.goTo(60);
    // With the velocity and the gravity that the program has set, by Euler.
    const Circle &c = simulation.recording().circles(60)[0];
    QVERIFY(std::abs(c.position.x - 1.0) < 1e-12);
    QVERIFY(std::abs(c.velocity.y + 1.0) < 1e-12);
}

void TestProgramRun::runRestsBeforeTheFailingStep()
{
    Simulation simulation(oneCircle());
    Walker walker;
    walker.failsIn = 5;
    QSignalSpy failed(&simulation, &Simulation::programFailed);
    simulation.setProgram(&walker);
    simulation.start();
    QTRY_COMPARE(failed.size(), 1);
    QVERIFY(!simulation.isRunning());
    QCOMPARE(simulation.current(), 4);
    QCOMPARE(simulation.recording().last(), 4);
    QCOMPARE(simulation.programError()->line, 7);
    // It says so again when asked to go on, and nothing runs.
    simulation.start();
    QCOMPARE(failed.size(), 2);
    QVERIFY(!simulation.isRunning());
    simulation.goTo(100);
    QCOMPARE(simulation.recording().last(), 4);
    // What has happened can still be seen.
    simulation.seek(1);
    QCOMPARE(simulation.current(), 1);
}

void TestProgramRun::programThatDoesNotLoadRunsNothing()
{
    Simulation simulation(oneCircle());
    Walker walker;
    walker.failsToLoad = true;
    QSignalSpy failed(&simulation, &Simulation::programFailed);
    simulation.setProgram(&walker);
    QCOMPARE(failed.size(), 1);
    simulation.start();
    simulation.stepForward();
    QCOMPARE(simulation.recording().last(), 0);
    QCOMPARE(simulation.preset(), simulation.basePreset());
}

void TestProgramRun::restartBeginsTheProgramAnew()
{
    Simulation simulation(oneCircle());
    Walker walker;
    simulation.setProgram(&walker);
    simulation.goTo(2);
    simulation.restart();
    QCOMPARE(walker.begun, 2);
    QVERIFY(simulation.notes().lines().empty());
}

void TestProgramRun::notesBelongToTheirSteps()
{
    Simulation simulation(oneCircle());
    Walker walker;
    walker.output.text = QStringLiteral("loaded\n");
    simulation.setProgram(&walker);
    simulation.goTo(3);
    const ProgramNotes &notes = simulation.notes();
    QCOMPARE(notes.lines().size(), 4u);
    QCOMPARE(notes.lines()[0].step, 0);
    QCOMPARE(notes.lines()[2].step, 2);
    QCOMPARE(notes.lines()[2].text, QStringLiteral("step"));
    QCOMPARE(notes.curves().size(), 1u);
    QCOMPARE(notes.curves()[0].values, (std::vector<double>{1.0, 2.0, 3.0}));
    QCOMPARE(notes.drawings(2)[0].from.x, 2.0);
    QVERIFY(notes.drawings(9).empty());
}

/// Though they alone are as many as may be kept; of those before none stay.
void TestProgramRun::drawingsOfTheLatestStepStay()
{
    ProgramNotes notes;
    ProgramOutput output;
    output.drawings.resize(ProgramNotes::mostDrawings);
    notes.add(1, 0.1, output);
    QCOMPARE(notes.drawings(1).size(), ProgramNotes::mostDrawings);
    output.drawings.resize(1);
    notes.add(2, 0.2, output);
    QVERIFY(notes.drawings(1).empty());
    QCOMPARE(notes.drawings(2).size(), 1u);
    output.drawings.resize(ProgramNotes::mostDrawings + 1);
    notes.add(3, 0.3, output);
    QVERIFY(notes.drawings(2).empty());
    QCOMPARE(notes.drawings(3).size(), ProgramNotes::mostDrawings + 1);
}

void TestProgramRun::notesAreBounded()
{
    ProgramNotes notes;
    for (int step = 1; step <= 6000; ++step) {
        ProgramOutput output;
        output.text = QStringLiteral("a\n");
        for (int k = 0; k < 40; ++k)
            output.points.push_back({QStringLiteral("%1").arg(k), 1.0});
        output.drawings.resize(100);
        notes.add(step, step / 60.0, output);
    }
    QCOMPARE(notes.lines().size(), ProgramNotes::mostLines);
    QCOMPARE(notes.droppedLines(), 1000);
    QCOMPARE(notes.curves().size(), ProgramNotes::mostCurves);
    QVERIFY(notes.drawings(1).empty());
    QCOMPARE(notes.drawings(6000).size(), 100u);
}

/// Of a curve that has become too long every other point is left, its time with its value.
void TestProgramRun::longCurvesKeepTheirTimes()
{
    ProgramNotes notes;
    ProgramOutput output;
    constexpr int count = static_cast<int>(ProgramNotes::mostPoints) + 3;
    for (int i = 0; i < count; ++i) {
        output.points = {{QStringLiteral("x"), 2.0 * i}};
        notes.add(i, i, output);
    }
    QCOMPARE(notes.curves().size(), 1U);
    const ProgramNotes::Curve &curve = notes.curves().front();
    QCOMPARE(curve.times.size(), curve.values.size());
    QVERIFY(curve.times.size() > ProgramNotes::mostPoints / 2);
    QVERIFY(curve.times.size() < ProgramNotes::mostPoints / 2 + 5);
    for (std::size_t i = 0; i < curve.times.size(); ++i)
        QCOMPARE(curve.values[i], 2.0 * curve.times[i]);
}

QTEST_GUILESS_MAIN(TestProgramRun)
#include "test_program_run.moc"
