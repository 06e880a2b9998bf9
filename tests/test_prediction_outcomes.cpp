// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab/prediction.h"

#include "model/files/preset_json.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/runs/observation.h"

#include <QTest>

#include <cmath>

using namespace cradle;

namespace {

/// A run of a step's scene that passes, \p seconds long.
Observation run(const char *step, double seconds, std::optional<double> restitution = {})
{
    const Lab lab = *readLab(QLatin1String(shippedLab));
    const Task &task = lab.tasks[static_cast<std::size_t>(lab.indexOf(QLatin1String(step)))];
    Preset preset = *readPreset(task.folder + QStringLiteral("/solution-preset.json"));
    preset.restitution = restitution.value_or(preset.restitution);
    return observe({.name = QStringLiteral("own"), .preset = preset, .duration = seconds});
}

struct Moment {
    std::vector<Circle> circles;

    [[nodiscard]] Vec2 momentum() const
    {
        Vec2 sum{};
        for (const Circle &circle : circles)
            sum = sum + circle.velocity * mass(circle);
        return sum;
    }
};

Moment after(const char *step, double seconds, std::optional<double> restitution = {})
{
    const Observation seen = run(step, seconds, restitution);
    Moment moment;
    for (int c = 0; c < seen.circleCount(); ++c)
        moment.circles.push_back(seen.circle(c, seen.steps()));
    return moment;
}

/// The highest y of circle 1 between the first time at the floor and the next.
double firstRise(const char *step)
{
    const Observation seen = run(step, 4.0);
    qint64 k = 1;
    while (seen.circle(0, k).velocity.y <= 0.0)
        ++k;
    for (; seen.circle(0, k).velocity.y > 0.0; ++k) {
    }
    return seen.circle(0, k).position.y;
}

/// Of circle 1 in the scene of step 7, J.
double energyAfterAMinute(Integrator integrator)
{
    const Lab lab = *readLab(QLatin1String(shippedLab));
    Preset preset =
        *readPreset(lab.tasks[static_cast<std::size_t>(lab.indexOf(QStringLiteral("L42T7")))].folder
                    + QStringLiteral("/solution-preset.json"));
    preset.circles[0].integrator = integrator;
    const Observation seen =
        observe({.name = QStringLiteral("own"), .preset = preset, .duration = 60.0});
    const Circle &c = seen.circle(0, seen.steps());
    const double height = c.position.y + preset.halfWidth;
    return mass(c) * (0.5 * lengthSquared(c.velocity) - preset.gravity.y * height);
}

struct Outcome {
    const char *step;
    const char *answer;  ///< that comes true
    bool (*comesTrue)(); ///< in a run
};

bool near(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance;
}

// clang-format off
const Outcome outcomes[] = {
    {"L42T1", "at x = 0", [] { return near(after("L42T1", 1.0).circles[0].position.x, 0.0, 1e-9); }},
    {"L42T2", "the momentum turns round, the energy stays", [] {
        return near(after("L42T2", 3.0).circles[0].velocity.x, -2.0, 1e-9); }},
    {"L42T3", "a little higher", [] { return near(firstRise("L42T3"), 2.36, 0.01); }},
    {"L42T4", "exactly where circle 1 is", [] {
        const Moment m = after("L42T4", 30.0);
        return m.circles[0].position == m.circles[1].position && m.circles[0].velocity == m.circles[1].velocity; }},
    {"L42T5", "lower than circle 1", [] {
        const Moment m = after("L42T5", 1.0);
        return near(m.circles[0].position.y - m.circles[1].position.y, 0.1635, 1e-9); }},
    {"L42X6", "Verlet and Runge-Kutta 4", [] {
        return near(after("L42X6", 1.0).circles[1].position.y, -2.905, 1e-9); }},
    {"L42T7", "symplectic Euler", [] {
        return near(energyAfterAMinute(Integrator::SymplecticEuler), 15907.6, 640.0)
               && near(energyAfterAMinute(Integrator::Euler), 41700.0, 50.0)
               && near(energyAfterAMinute(Integrator::Verlet), 29100.0, 50.0)
               && near(energyAfterAMinute(Integrator::RungeKutta4), 29100.0, 50.0); }},
    {"L42T8", "nothing: circle 1 keeps all of it", [] {
        const Moment m = after("L42T8", 2.0);
        return near(m.circles[0].velocity.x, 2.0, 1e-9) && near(m.circles[1].velocity.x, 0.0, 1e-9); }},
    {"L42T9", "take all the momentum", [] {
        return near(after("L42T9", 1.0).momentum().x, 522.8, 0.1) && after("L42T9", 2.0).momentum() == Vec2{}; }},
    {"L42T10", "circle 1 stops, circle 2 goes on with 2 m/s", [] {
        const Moment m = after("L42T10", 2.0);
        return near(m.circles[0].velocity.x, 0.0, 1e-9) && near(m.circles[1].velocity.x, 2.0, 1e-9); }},
    {"L42T11", "down to the right, along the line of centres", [] {
        const Vec2 v = after("L42T11", 2.0).circles[1].velocity;
        return near(v.x, 0.875, 0.01) && near(v.y, -0.992, 0.01); }},
    {"L42T12", "circle 1 goes up, circle 2 to the right", [] {
        const Moment m = after("L42T12", 2.0);
        return near(m.circles[0].velocity.y, 2.0, 1e-9) && near(m.circles[1].velocity.x, 2.0, 1e-9); }},
    {"L42T13", "8 times", [] {
        const Moment m = after("L42T13", 2.0);
        return near(mass(m.circles[1]) / mass(m.circles[0]), 8.0, 1e-9) && near(m.momentum().x, 4182.1, 0.1); }},
    {"L42T14", "circle 1, the light one", [] {
        const Moment m = after("L42T14", 2.0);
        return near(m.circles[0].velocity.x, -1.667, 0.001) && near(m.circles[1].velocity.x, 0.333, 0.001); }},
    {"L42T15", "next to nothing", [] {
        const Moment then = after("L42T14", 2.0);
        const Moment now = after("L42T15", 2.0);
        return near(now.circles[0].velocity.x, then.circles[0].velocity.x, 2e-4)
               && near(now.circles[1].velocity.x, then.circles[1].velocity.x, 2e-4)
               && near(then.momentum().x / now.momentum().x, 7.8, 0.01); }},
    {"L42T16", "no, they go on together", [] {
        const Moment m = after("L42T16", 2.0, 0.0);
        return near(m.circles[0].velocity.x, -1.0 / 3.0, 1e-9) && near(m.circles[1].velocity.x, -1.0 / 3.0, 1e-9); }},
    {"L42T17", "about 3.3 m, 0.75² of that", [] { return near(firstRise("L42T17") + 3.8, 3.3, 0.15); }},
};
// clang-format on

} // namespace

/// What the steps of Lab 4.2 say that happens is what happens.
class TestPredictionOutcomes : public QObject
{
    Q_OBJECT
private slots:
    void outcomesOfTheLabComeTrue_data();
    void outcomesOfTheLabComeTrue();
};

void TestPredictionOutcomes::outcomesOfTheLabComeTrue_data()
{
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Outcome &outcome : outcomes)
        QTest::newRow(outcome.step) << index++;
}

/// The answer that the lab calls right is what the engine does.
void TestPredictionOutcomes::outcomesOfTheLabComeTrue()
{
    QFETCH(int, index);
    const Outcome &outcome = outcomes[index];
    const Lab lab = *readLab(QLatin1String(shippedLab));
    const auto &prediction =
        lab.tasks[static_cast<std::size_t>(lab.indexOf(QLatin1String(outcome.step)))].prediction;
    QVERIFY(prediction);
    QCOMPARE(prediction->answers[prediction->right], QString::fromUtf8(outcome.answer));
    QVERIFY(outcome.comesTrue());
}

QTEST_GUILESS_MAIN(TestPredictionOutcomes)
#include "test_prediction_outcomes.moc"
