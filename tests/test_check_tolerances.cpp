// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/programs.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::programs;

namespace {

constexpr Vec2 down{0.0, -scenes::g};
constexpr double h = scenes::dt;
const Circle thrown{.position = {-1.0, 0.5}, .velocity = {1.5, 2.0}};

/// Two circles thrown alike, x' = x + v h + c g h²; in the tenth step circle 1 goes wrong.
Observation flight(double c, const std::function<void(Circle &)> &wrong)
{
    const auto program = [c, wrong, step = 0](Circles &circles, double dt) mutable {
        for (Circle &each : circles) {
            each.position += dt * each.velocity + c * dt * dt * down;
            each.velocity += dt * down;
        }
        if (++step == 10)
            wrong(circles.front());
    };
    return observed(scene({thrown, thrown}, down), 0.8, program);
}

Observation misplaced(double error)
{
    return flight(0.0, [error](Circle &c) { c.position.x += error; });
}

Observation misplacedOnParabola(double error)
{
    return flight(0.5, [error](Circle &c) { c.position.x += error; });
}

/// By two steps of Euler in one, through the middle of the square as the tenth step begins.
Observation misplacedInHalves(double error)
{
    constexpr double t = 9.0 * h;
    const Vec2 speed{1.5, 2.0};
    const Vec2 fallen = 0.5 * t * (t - 0.5 * h) * down;
    const Circle circle{.position = -t * speed - fallen, .velocity = speed};
    return observed(scene({circle}, down), 0.8, [error, step = 0](Circles &c, double dt) mutable {
        for (int half = 0; half < 2; ++half) {
            c[0].position += 0.5 * dt * c[0].velocity;
            c[0].velocity += 0.5 * dt * down;
        }
        if (++step == 10)
            c[0].position.x += error;
    });
}

Observation hastened(double error)
{
    return flight(0.0, [error](Circle &c) { c.velocity.x += error; });
}

/// Circle 1 runs at 2 m/s into circle 2, which rests; they swap velocities when their rims are
/// \p early apart, with \p errorA and \p errorB.
Observation headOn(double early, double errorA, double errorB)
{
    const Circle one{.position = {-0.4 - 20.0 * h - early, 0.0}, .velocity = {2.0, 0.0}};
    const Circle two{};
    return observed(scene({one, two}), 0.5, [=](Circles &c, double dt) {
        for (Circle &each : c)
            each.position += dt * each.velocity;
        const bool touch = c[1].position.x - c[0].position.x <= 0.4 + early + 1e-12;
        if (touch && c[0].velocity.x > 1.0) {
            c[0].velocity.x = errorA;
            c[1].velocity.x = 2.0 + errorB;
        }
    });
}

Observation tooEarly(double error)
{
    return headOn(error, 0.0, 0.0);
}

Observation leavesTooFast(double error)
{
    return headOn(0.0, 0.0, error);
}

Observation staysTooFast(double error)
{
    return headOn(0.0, error, 0.0);
}

Observation losesEnergy(double error)
{
    return headOn(0.0, error, -error);
}

/// They come with 2 and −1 m/s and swap velocities, but for \p error.
Observation bothMove(double error)
{
    const Circle one{.position = {-0.6, 0.0}, .velocity = {2.0, 0.0}};
    const Circle two{.velocity = {-1.0, 0.0}};
    return observed(scene({one, two}), 0.5, [=](Circles &c, double dt) {
        for (Circle &each : c)
            each.position += dt * each.velocity;
        if (c[1].position.x - c[0].position.x < 0.4 && c[0].velocity.x > 1.0) {
            c[0].velocity.x = -1.0;
            c[1].velocity.x = 2.0 + error;
        }
    });
}

Observation startsTooWide(double error)
{
    Circle wide = thrown;
    wide.radius += error;
    return observed(scene({wide}), 0.1, [](Circles &, double) {});
}

} // namespace

using Wrong = Observation (*)(double);

/// Every check bears what roundings do and nothing more: a fifth less than its tolerance is right,
/// a fifth more is wrong.
class TestCheckTolerances : public QObject
{
    Q_OBJECT
private slots:
    void toleranceHasTwoSides_data();
    void toleranceHasTwoSides();
};

void TestCheckTolerances::toleranceHasTwoSides_data()
{
    QTest::addColumn<CheckSpec>("spec");
    QTest::addColumn<Wrong>("program");
    QTest::addColumn<double>("borne");
    const auto row = [](const char *name, const CheckSpec &spec, Wrong program, double borne) {
        QTest::newRow(name) << spec << program << borne;
        CheckSpec stated = spec; // the same with a tolerance of its own
        stated.parameters.insert(QStringLiteral("tolerance"), 1e-5);
        QTest::addRow("%s, stated", name) << stated << program << borne * 1e4;
    };
    // Of numbers near 0 it is absolute, of others a share: 1e-9 (1 + |v|).
    const QJsonObject euler{{QStringLiteral("integrators"), QJsonArray{QStringLiteral("euler")}}};
    const double t = 9.0 * h; // s: where the tenth step begins
    const Vec2 speed = thrown.velocity + t * down;
    const Vec2 place = thrown.position + t * thrown.velocity + 0.5 * t * (t - h) * down;
    row("integrates, place", check("integrates", {0}, euler), misplaced,
        1e-9 * (1.0 + std::hypot(place.x, place.y)));
    row("integrates, velocity", check("integrates", {0}, euler), hastened,
        1e-9 * (1.0 + std::hypot(speed.x, speed.y)));
    row("integrates, any method in parts of a step", check("integrates"), misplacedInHalves, 1e-9);
    row("closed form", check("closed_form", {0}), misplacedOnParabola, 1e-9);
    row("together, place", check("together", {0, 1}), misplaced, 1e-9);
    row("collides", check("collides", {0, 1}), staysTooFast, 1e-9);
    row("collides, the other", check("collides", {0, 1}), leavesTooFast, 3e-9);
    row("rebounds", check("rebounds", {0, 1}), leavesTooFast, 3e-9);
    row("touches", check("touches", {0, 1}), tooEarly, 1e-9);
    // Of m 2 m/s, and of ½ m (2 m/s)², which changes by 2 m/s times m and the error.
    row("conserves momentum", check("conserves", {0, 1}), leavesTooFast, 2e-9);
    row("conserves momentum, both move", check("conserves", {0, 1}), bothMove, 3e-9);
    // The change of the energy is 2 m/s m times the error, of ½ m (2² + 1²) (m/s)².
    row("conserves energy, both move",
        check("conserves", {0, 1}, {{QStringLiteral("energy"), true}}), bothMove, 1.25e-9);
    row("start", check("start", {0}, {{QStringLiteral("radius"), thrown.radius}}), startsTooWide,
        1e-9 * (1.0 + thrown.radius));
    row("conserves energy", check("conserves", {0, 1}, {{QStringLiteral("energy"), true}}),
        losesEnergy, 1e-9);
}

void TestCheckTolerances::toleranceHasTwoSides()
{
    QFETCH(CheckSpec, spec);
    QFETCH(Wrong, program);
    QFETCH(double, borne);
    VERIFY_ACCEPTED(judge(spec, program(0.0)));
    VERIFY_ACCEPTED(judge(spec, program(0.8 * borne)));
    QVERIFY(judge(spec, program(1.2 * borne)).has_value());
}

QTEST_APPLESS_MAIN(TestCheckTolerances)
#include "test_check_tolerances.moc"
