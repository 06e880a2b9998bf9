// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/scenes.h"

#include <rapidcheck.h>

namespace cradle::scenes {

/// The same cases every time, unless others are asked for. Not shrunk: a smaller scene need not be
/// a simpler one, and a run takes its time. For initTestCase().
inline void useFixedCases()
{
    if (!qEnvironmentVariableIsSet("RC_PARAMS"))
        qputenv("RC_PARAMS", "seed=20260101 noshrink=1");
}

/// A number from low to high in a million steps, 0 and the ends among them.
inline double numberIn(double low, double high)
{
    constexpr int parts = 1'000'000;
    // At the full size from the first case on, or the first ones would all be near low.
    const int part = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, parts + 1));
    return low + (high - low) * part / parts;
}

inline Vec2 vectorIn(double bound)
{
    const double x = numberIn(-bound, bound);
    return {x, numberIn(-bound, bound)};
}

inline bool close(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance;
}

inline bool close(Vec2 a, Vec2 b, double tolerance)
{
    return close(a.x, b.x, tolerance) && close(a.y, b.y, tolerance);
}

/// \p least to \p most (9 fill the lattice) circles of mixed radii and densities on a lattice, none
/// in touch, all moving.
inline Preset someCircles(Laws laws, int least = 2, int most = 9)
{
    Preset preset = scene({}, laws);
    const int count = *rc::gen::inRange(least, most + 1);
    for (int i = 0; i < count; ++i) {
        const Vec2 site{-2.4 + 2.4 * (i % 3), -2.4 + 2.4 * (i / 3)};
        preset.circles.push_back(circle(site + vectorIn(0.4), vectorIn(5.0), numberIn(0.2, 0.7),
                                        Integrator::Verlet, numberIn(0.5, 10.0)));
    }
    RC_ASSERT(!findFault(preset).has_value());
    return preset;
}

/// No gravity, the lab's, or any.
inline Vec2 anyGravity()
{
    switch (*rc::gen::inRange(0, 3)) {
    case 0:
        return {};
    case 1:
        return {0, -g};
    default:
        return vectorIn(10.0);
    }
}

inline Integrator anyIntegrator()
{
    return *rc::gen::element(Integrator::Euler, Integrator::SymplecticEuler, Integrator::Verlet,
                             Integrator::RungeKutta4);
}

} // namespace cradle::scenes
