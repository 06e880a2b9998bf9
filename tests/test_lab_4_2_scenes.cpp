// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lab_test.h"

#include "tasks/reading/lab_reader.h"

#include <algorithm>

using namespace cradle;

/// Wrong scenes for the steps of the shipped lab fail, each by the check that should see it; other
/// good ones pass.
class TestLab42Scenes : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void wrongSceneFailsByTheCheckThatSeesIt_data();
    void wrongSceneFailsByTheCheckThatSeesIt();
    void everyStepHasThreeWrongScenes();
    void everyCheckIsFailedBySomething();
    void otherGoodScenesPass_data();
    void otherGoodScenesPass();
};

namespace {

using Change = void (*)(Preset &);

struct WrongScene {
    const char *step;
    const char *what;
    const char *check; ///< that must fail
    Change change;     ///< makes the solution wrong
};

Circle &body(Preset &p, std::size_t i)
{
    return p.circles[i].body;
}

// clang-format off
const WrongScene wrongScenes[] = {
    {"L42T1", "at rest", "start-velocity", [](Preset &p) { body(p, 0).velocity = {}; }},
    {"L42T1", "wrong axis", "start-velocity", [](Preset &p) { body(p, 0).velocity = {0, 2}; }},
    {"L42T1", "wrong sign", "start-velocity", [](Preset &p) { body(p, 0).velocity = {-2, 0}; }},
    {"L42T1", "too fast", "start-velocity", [](Preset &p) { body(p, 0).velocity = {4, 0}; }},
    {"L42T1", "gravity", "drifts", [](Preset &p) { p.gravity = {0, -9.81}; }},
    {"L42T2", "no walls", "walls", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T2", "walls that take speed", "walls", [](Preset &p) { p.restitution = 0.5; }},
    {"L42T2", "gravity", "drifts", [](Preset &p) { p.gravity = {0, -9.81}; }},
    {"L42T2", "no walls, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T2", "no walls, seen in corners", "corners", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T2", "at rest", "start-velocity", [](Preset &p) { body(p, 0).velocity = {}; }},
    {"L42T3", "symplectic Euler", "euler", [](Preset &p) { p.circles[0].integrator = Integrator::SymplecticEuler; }},
    {"L42T3", "Verlet", "euler-anywhere", [](Preset &p) { p.circles[0].integrator = Integrator::Verlet; }},
    {"L42T3", "Verlet on the Moon", "moon", [](Preset &p) { p.circles[0].integrator = Integrator::Verlet; }},
    {"L42T3", "gravity upward", "euler", [](Preset &p) { p.gravity = {0, 9.81}; }},
    {"L42T3", "gravity twice", "euler", [](Preset &p) { p.gravity = {0, -19.62}; }},
    {"L42T3", "gravity sideways", "euler", [](Preset &p) { p.gravity = {-9.81, 0}; }},
    {"L42T3", "walls lost", "walls", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T3", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T4", "second left where it was", "start-2", [](Preset &p) { body(p, 1).position = {2, 2}; body(p, 1).velocity = {}; }},
    {"L42T4", "other place", "together", [](Preset &p) { body(p, 1).position.x += 0.1; }},
    {"L42T4", "other velocity", "together", [](Preset &p) { body(p, 1).velocity.x = 2.001; }},
    {"L42T4", "second symplectic", "euler", [](Preset &p) { p.circles[1].integrator = Integrator::SymplecticEuler; }},
    {"L42T4", "no walls", "walls", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T4", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T5", "both symplectic", "circle1-euler", [](Preset &p) { p.circles[0].integrator = Integrator::SymplecticEuler; }},
    {"L42T5", "both Euler", "circle2-symplectic", [](Preset &p) { p.circles[1].integrator = Integrator::Euler; }},
    {"L42T5", "exchanged", "circle2-symplectic", [](Preset &p) { std::swap(p.circles[0].integrator, p.circles[1].integrator); }},
    {"L42T5", "second Verlet", "circle2-symplectic", [](Preset &p) { p.circles[1].integrator = Integrator::Verlet; }},
    {"L42T5", "no walls", "walls", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T5", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42X6", "second symplectic", "circle2-exact", [](Preset &p) { p.circles[1].integrator = Integrator::SymplecticEuler; }},
    {"L42X6", "second Euler", "circle2-steps", [](Preset &p) { p.circles[1].integrator = Integrator::Euler; }},
    {"L42X6", "first Verlet, too", "circle1-euler", [](Preset &p) { p.circles[0].integrator = Integrator::Verlet; }},
    {"L42X6", "half gravity", "circle2-exact", [](Preset &p) { p.gravity = {0, -4.905}; }},
    {"L42X6", "no walls", "walls", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42X6", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T7", "different", "same-integrator", [](Preset &p) { p.circles[0].integrator = Integrator::Euler; }},
    {"L42T7", "Verlet beside symplectic", "same-integrator", [](Preset &p) { p.circles[1].integrator = Integrator::Verlet; }},
    {"L42T7", "gravity lost", "gravity", [](Preset &p) { p.gravity = {}; }},
    {"L42T7", "walls lost", "walls", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T7", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T8", "gravity left on", "no-gravity", [](Preset &p) { p.gravity = {0, -9.81}; }},
    {"L42T8", "second moves", "start-2", [](Preset &p) { body(p, 1).velocity = {-2, 0}; }},
    {"L42T8", "wrong place", "start-1", [](Preset &p) { body(p, 0).position = {-2, 1}; }},
    {"L42T8", "they collide", "passes-through", [](Preset &p) { p.laws.circles = CircleLaw::SwapNormal; }},
    {"L42T8", "walls lost", "walls", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T8", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T9", "pass through", "stops", [](Preset &p) { p.laws.circles = CircleLaw::None; }},
    {"L42T9", "swap", "stops-anywhere", [](Preset &p) { p.laws.circles = CircleLaw::SwapVelocities; }},
    {"L42T9", "impulse", "stops", [](Preset &p) { p.laws.circles = CircleLaw::Impulse; }},
    {"L42T9", "walls lost", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T9", "not set back", "start-1", [](Preset &p) { body(p, 0).position = {-2, 2.3}; }},
    {"L42T9", "second moves", "start-2", [](Preset &p) { body(p, 1).velocity = {-1, 0}; }},
    {"L42T10", "still stop", "transfer", [](Preset &p) { p.laws.circles = CircleLaw::Stop; }},
    {"L42T10", "pass through", "transfer-anywhere", [](Preset &p) { p.laws.circles = CircleLaw::None; }},
    {"L42T10", "half the rebound", "transfer", [](Preset &p) { p.laws.circles = CircleLaw::Impulse; p.restitution = 0.5; }},
    {"L42T10", "walls lost", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T10", "wrong start", "start-1", [](Preset &p) { body(p, 0).velocity = {3, 0}; }},
    {"L42T10", "second moves", "start-2", [](Preset &p) { body(p, 1).velocity = {-1, 0}; }},
    {"L42T11", "whole velocity swapped", "glancing", [](Preset &p) { p.laws.circles = CircleLaw::SwapVelocities; }},
    {"L42T11", "whole velocity swapped, anywhere", "glancing-anywhere", [](Preset &p) { p.laws.circles = CircleLaw::SwapVelocities; }},
    {"L42T11", "stop", "kept", [](Preset &p) { p.laws.circles = CircleLaw::Stop; }},
    {"L42T11", "head-on", "start-1", [](Preset &p) { body(p, 0).position = {-2, 2}; }},
    {"L42T11", "second moves", "start-2", [](Preset &p) { body(p, 1).velocity = {-1, 0}; }},
    {"L42T11", "gravity", "goes-on", [](Preset &p) { p.gravity = {0, -9.81}; }},
    {"L42T11", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T12", "whole velocity swapped", "exchange-anywhere", [](Preset &p) { p.laws.circles = CircleLaw::SwapVelocities; }},
    {"L42T12", "stop", "exchange", [](Preset &p) { p.laws.circles = CircleLaw::Stop; }},
    {"L42T12", "pass through", "kept", [](Preset &p) { p.laws.circles = CircleLaw::None; }},
    {"L42T12", "second at rest", "start-2", [](Preset &p) { body(p, 1).velocity = {}; }},
    {"L42T12", "first elsewhere", "start-1", [](Preset &p) { body(p, 0).position = {-2, 2.3}; }},
    {"L42T12", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T13", "radius unchanged", "radii", [](Preset &p) { body(p, 1).radius = 0.2; }},
    {"L42T13", "first doubled, too", "radius-1", [](Preset &p) { body(p, 0).radius = 0.4; }},
    {"L42T13", "pass through", "contact", [](Preset &p) { p.laws.circles = CircleLaw::None; }},
    {"L42T13", "stop", "contact-anywhere", [](Preset &p) { p.laws.circles = CircleLaw::Stop; }},
    {"L42T13", "walls lost", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T14", "masses left out", "known-values", [](Preset &p) { p.laws.circles = CircleLaw::SwapNormal; }},
    {"L42T14", "masses left out, anywhere", "masses", [](Preset &p) { p.laws.circles = CircleLaw::SwapNormal; }},
    {"L42T14", "whole velocity swapped", "kept", [](Preset &p) { p.laws.circles = CircleLaw::SwapVelocities; }},
    {"L42T14", "radius 0.25", "start-2", [](Preset &p) { body(p, 1).radius = 0.25; }},
    {"L42T14", "too fast", "start-1", [](Preset &p) { body(p, 0).velocity = {2, 0}; }},
    {"L42T14", "not elastic", "known-values", [](Preset &p) { p.restitution = 0.9; }},
    {"L42T14", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T15", "density unchanged", "density-1", [](Preset &p) { body(p, 0).density = 2; }},
    {"L42T15", "densities exchanged", "same-result", [](Preset &p) { std::swap(body(p, 0).density, body(p, 1).density); }},
    {"L42T15", "density unchanged, second", "density-2", [](Preset &p) { body(p, 1).density = 1; }},
    {"L42T15", "masses left out", "densities", [](Preset &p) { p.laws.circles = CircleLaw::SwapNormal; }},
    {"L42T15", "radius still 0.252", "start-2", [](Preset &p) { body(p, 1).radius = 0.252; }},
    {"L42T15", "wrong place", "start-1", [](Preset &p) { body(p, 0).position = {-2, 2}; }},
    {"L42T13", "walls lost, own scene", "own-walls", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T14", "walls lost, own scene", "own-walls", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T15", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T16", "elastic", "loses-energy", [](Preset &p) { p.restitution = 1; }},
    {"L42T16", "no rebound at all", "own-restitution", [](Preset &p) { p.restitution = 0; }},
    {"L42T16", "left as in step 14", "start-1", [](Preset &p) { body(p, 0).density = 7.8; }},
    {"L42T16", "density 100", "start-2", [](Preset &p) { body(p, 1).density = 100; }},
    {"L42T16", "masses and e left out", "restitution", [](Preset &p) { p.laws.circles = CircleLaw::SwapNormal; }},
    {"L42T16", "stop", "momentum", [](Preset &p) { p.laws.circles = CircleLaw::Stop; }},
    {"L42T16", "pass through", "own-collision", [](Preset &p) { p.laws.circles = CircleLaw::None; }},
    {"L42T16", "walls lost, seen from everywhere", "walls-anywhere", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T17", "densities exchanged", "start-1", [](Preset &p) { std::swap(body(p, 0).density, body(p, 1).density); }},
    {"L42T17", "circle 2 at rest", "start-2", [](Preset &p) { body(p, 1).velocity = {}; }},
    {"L42T17", "gravity off", "gravity", [](Preset &p) { p.gravity = {}; }},
    {"L42T17", "walls lost", "wall-restitution", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T17", "walls lost, floor", "floor-restitution", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T17", "walls lost, inside", "stays-inside", [](Preset &p) { p.laws.walls = WallLaw::None; }},
    {"L42T17", "masses left out", "collisions", [](Preset &p) { p.laws.circles = CircleLaw::SwapNormal; }},
    {"L42T17", "pass through", "collisions", [](Preset &p) { p.laws.circles = CircleLaw::None; }},
    {"L42T17", "another restitution", "own-walls", [](Preset &p) { p.restitution = 0.8; }},
    {"L42T17", "another restitution, hit", "own-collision", [](Preset &p) { p.restitution = 0.8; }},
};

struct GoodScene {
    const char *step;
    const char *what;
    Change change;
};

const GoodScene goodScenes[] = {
    {"L42T1", "continuous timing", [](Preset &p) { p.laws.timing = Timing::Continuous; }},
    {"L42T2", "continuous timing", [](Preset &p) { p.laws.timing = Timing::Continuous; }},
    {"L42T2", "finer timestep", [](Preset &p) { p.timestep = 1.0 / 240.0; }},
    {"L42T2", "another integrator, for there is no gravity", [](Preset &p) { p.circles[0].integrator = Integrator::RungeKutta4; }},
    {"L42T3", "continuous timing", [](Preset &p) { p.laws.timing = Timing::Continuous; }},
    {"L42X6", "Runge-Kutta 4", [](Preset &p) { p.circles[1].integrator = Integrator::RungeKutta4; }},
    {"L42T7", "both Euler", [](Preset &p) { p.circles[0].integrator = p.circles[1].integrator = Integrator::Euler; }},
    {"L42T7", "both Verlet", [](Preset &p) { p.circles[0].integrator = p.circles[1].integrator = Integrator::Verlet; }},
    {"L42T7", "both Runge-Kutta 4", [](Preset &p) { p.circles[0].integrator = p.circles[1].integrator = Integrator::RungeKutta4; }},
    {"L42T9", "continuous timing", [](Preset &p) { p.laws.timing = Timing::Continuous; }},
    {"L42T10", "normal parts swapped", [](Preset &p) { p.laws.circles = CircleLaw::SwapNormal; }},
    {"L42T10", "impulse", [](Preset &p) { p.laws.circles = CircleLaw::Impulse; }},
    {"L42T10", "continuous timing", [](Preset &p) { p.laws.timing = Timing::Continuous; }},
    {"L42T11", "impulse", [](Preset &p) { p.laws.circles = CircleLaw::Impulse; }},
    {"L42T11", "continuous timing", [](Preset &p) { p.laws.timing = Timing::Continuous; }},
    {"L42T12", "impulse", [](Preset &p) { p.laws.circles = CircleLaw::Impulse; }},
    {"L42T12", "continuous timing", [](Preset &p) { p.laws.timing = Timing::Continuous; }},
    {"L42T13", "impulse", [](Preset &p) { p.laws.circles = CircleLaw::Impulse; }},
    {"L42T13", "exact timing", [](Preset &p) { p.laws.timing = Timing::Exact; }},
    {"L42T14", "continuous timing", [](Preset &p) { p.laws.timing = Timing::Continuous; }},
    {"L42T16", "continuous timing", [](Preset &p) { p.laws.timing = Timing::Continuous; }},
    {"L42T17", "Euler", [](Preset &p) { for (auto &c : p.circles) c.integrator = Integrator::Euler; }},
    {"L42T17", "Verlet, continuous", [](Preset &p) { for (auto &c : p.circles) c.integrator = Integrator::Verlet; p.laws.timing = Timing::Continuous; }},
    {"L42T17", "Runge-Kutta 4", [](Preset &p) { for (auto &c : p.circles) c.integrator = Integrator::RungeKutta4; }},
};
// clang-format on

} // namespace

void TestLab42Scenes::wrongSceneFailsByTheCheckThatSeesIt_data()
{
    QTest::addColumn<int>("index");
    int index = 0;
    for (const WrongScene &wrong : wrongScenes)
        QTest::addRow("%s %s", wrong.step, wrong.what) << index++;
}

void TestLab42Scenes::wrongSceneFailsByTheCheckThatSeesIt()
{
    QFETCH(int, index);
    const WrongScene &wrong = wrongScenes[index];
    Preset preset = solution(QLatin1String(wrong.step));
    wrong.change(preset);
    QVERIFY(!findFault(preset));
    const CheckReport report = judged(QLatin1String(wrong.step), preset);
    QVERIFY(!report.passed);
    const auto check = std::find_if(report.checks.begin(), report.checks.end(), [&](const auto &c) {
        return c.id == QLatin1String(wrong.check);
    });
    QVERIFY2(check != report.checks.end(), "no such check");
    QVERIFY2(!check->passed, qPrintable(failedChecks(report)));
    QVERIFY(!check->message.isEmpty());
}

void TestLab42Scenes::everyStepHasThreeWrongScenes()
{
    for (const Task &task : m_lab.tasks) {
        const auto count = std::count_if(
            std::begin(wrongScenes), std::end(wrongScenes),
            [&](const WrongScene &wrong) { return task.id == QLatin1String(wrong.step); });
        QVERIFY2(count >= 3, qPrintable(task.id));
    }
}

void TestLab42Scenes::everyCheckIsFailedBySomething()
{
    for (const Task &task : m_lab.tasks) {
        for (const CheckSpec &check : task.checks) {
            const bool seen = std::any_of(std::begin(wrongScenes), std::end(wrongScenes),
                                          [&](const WrongScene &wrong) {
                                              return task.id == QLatin1String(wrong.step)
                                                     && check.id == QLatin1String(wrong.check);
                                          });
            // What only code can get wrong is failed by the mistakes in code.
            const bool needsCode =
                check.id == QLatin1String("settles") || check.id == QLatin1String("parting")
                || check.id == QLatin1String("moves-anywhere")
                || check.id == QLatin1String("undisturbed") || check.id == QLatin1String("goes-on")
                || check.id == QLatin1String("walls-close")
                || check.id == QLatin1String("slow-hits");
            QVERIFY2(seen || needsCode, qPrintable(task.id + QLatin1Char(' ') + check.id));
        }
    }
}

void TestLab42Scenes::otherGoodScenesPass_data()
{
    QTest::addColumn<int>("index");
    int index = 0;
    for (const GoodScene &good : goodScenes)
        QTest::addRow("%s %s", good.step, good.what) << index++;
}

void TestLab42Scenes::otherGoodScenesPass()
{
    QFETCH(int, index);
    const GoodScene &good = goodScenes[index];
    Preset preset = solution(QLatin1String(good.step));
    good.change(preset);
    for (qint64 seed = 1; seed <= 3; ++seed) {
        const CheckReport report = judged(QLatin1String(good.step), preset, seed);
        QVERIFY2(report.passed, qPrintable(failedChecks(report)));
    }
}

QTEST_GUILESS_MAIN(TestLab42Scenes)
#include "test_lab_4_2_scenes.moc"
