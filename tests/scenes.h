// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/stepper.h"
#include "model/world/preset.h"
#include "model/world/world.h"

#include <QTest>

#include <cmath>
#include <initializer_list>
#include <limits>

namespace cradle::scenes {

inline constexpr double g = 9.81;        ///< m/s²
inline constexpr double dt = 1.0 / 60.0; ///< s
inline constexpr double halfWidth = 4.0; ///< m
inline constexpr double pi = 3.14159265358979323846;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// A row name for an integrator, apart from the names of the file format.
inline const char *shortName(Integrator integrator)
{
    switch (integrator) {
    case Integrator::Euler:
        return "Euler";
    case Integrator::SymplecticEuler:
        return "symplectic";
    case Integrator::Verlet:
        return "Verlet";
    case Integrator::RungeKutta4:
        break;
    }
    return "RK4";
}

inline const char *shortName(Timing timing)
{
    switch (timing) {
    case Timing::Discrete:
        return "discrete";
    case Timing::Continuous:
        return "continuous";
    case Timing::Exact:
        break;
    }
    return "exact";
}

inline PresetCircle circle(Vec2 position, Vec2 velocity = {}, double radius = 0.2,
                           Integrator integrator = Integrator::Verlet, double density = 7.8)
{
    PresetCircle c;
    c.name = QStringLiteral("circle");
    c.body = {position, velocity, radius, density};
    c.integrator = integrator;
    return c;
}

/// A scene in the lab's square without gravity, elastic, 1/60 s.
inline Preset scene(std::initializer_list<PresetCircle> circles, Laws laws)
{
    Preset preset;
    preset.name = QStringLiteral("scene");
    preset.laws = laws;
    preset.circles = circles;
    return preset;
}

/// So many circles of 0.05 m, in exact timing, that fall into a heap in a square of 2 m. 200 with
/// e = 0.5 get closer than exact timing can follow within a second.
inline Preset fallingHeap(int count, double restitution)
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact});
    preset.gravity = {0, -g};
    preset.restitution = restitution;
    preset.halfWidth = 1.0;
    preset.fill = CircleFill{.count = count, .radius = 0.05, .rmsSpeed = 0.5};
    preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    return preset;
}

/// A run under way: the state after the latest step, and all hits so far.
struct Run {
    explicit Run(const Preset &preset)
        : stepper(preset)
        , world(initialWorld(preset))
    {
    }
    void steps(int count)
    {
        for (int i = 0; i < count; ++i)
            stepper.advance(world, hits);
    }
    [[nodiscard]] const Circle &operator[](std::size_t i) const { return world.circles[i]; }

    Stepper stepper;
    World world;
    std::vector<Hit> hits{};
};

inline bool near(double actual, double expected, double tolerance)
{
    return std::abs(actual - expected) <= tolerance;
}

inline QByteArray nearMessage(double actual, double expected, double tolerance)
{
    return "observed " + QByteArray::number(actual, 'g', 17) + ", expected "
           + QByteArray::number(expected, 'g', 17) + ", off by "
           + QByteArray::number(actual - expected, 'g', 3) + ", allowed "
           + QByteArray::number(tolerance, 'g', 3);
}

} // namespace cradle::scenes

/// Fails the test unless |actual − expected| ≤ tolerance.
#define COMPARE_NEAR(actual, expected, tolerance)                                                  \
    do {                                                                                           \
        const double observed_ = static_cast<double>(actual);                                      \
        const double wanted_ = static_cast<double>(expected);                                      \
        QVERIFY2(cradle::scenes::near(observed_, wanted_, tolerance),                              \
                 cradle::scenes::nearMessage(observed_, wanted_, tolerance).constData());          \
    } while (false)
