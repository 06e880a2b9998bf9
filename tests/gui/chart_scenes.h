// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"

namespace cradle {

/// Circle 1 runs into circle 2 at rest; after 1.8 s they part.
inline Preset glancing()
{
    Preset preset;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous};
    preset.circles = {{QStringLiteral("circle 1"), {{-2.0, 2.3}, {2.0, 0.0}}},
                      {QStringLiteral("circle 2"), {{2.0, 2.0}, {0.0, 0.0}}}};
    return preset;
}

/// Two circles that fall alike, by Euler and by symplectic Euler.
inline Preset euleredFall()
{
    Preset preset;
    preset.gravity = {0.0, -9.81};
    preset.laws.walls = WallLaw::Reflect;
    const Circle body{.position = {-2.0, 2.0}, .velocity = {2.0, 0.0}};
    preset.circles = {
        {QStringLiteral("1"), body, QStringLiteral("#1e90ff"), Integrator::Euler},
        {QStringLiteral("2"), body, QStringLiteral("#e03131"), Integrator::SymplecticEuler}};
    return preset;
}

/// Balls that lose energy on the floor.
inline Preset falling(int count)
{
    Preset preset;
    preset.gravity = {0.0, -9.81};
    preset.restitution = 0.8;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous};
    for (int i = 0; i < count; ++i) {
        const Circle body{.position = {0.6 * i - 3.0, 0.1 * i}, .velocity = {0.3, 0.1 * i}};
        preset.circles.push_back(
            {QString::number(i + 1), body, QStringLiteral("#1e90ff"), Integrator::Verlet});
    }
    return preset;
}

inline void run(Simulation &simulation, int steps)
{
    for (int i = 0; i < steps; ++i)
        simulation.stepForward();
}

} // namespace cradle
