// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/vec2.h"

namespace cradle {

/// How a position and a velocity are carried over a timestep.
enum class Integrator { Euler, SymplecticEuler, Verlet, RungeKutta4 };

/// Position (m) and velocity (m/s) of one body.
struct Motion {
    Vec2 position{};
    Vec2 velocity{};

    friend constexpr bool operator==(const Motion &, const Motion &) = default;
};

/// The motion \p dt seconds later under the constant acceleration \p a (m/s²).
///
///     Euler             x' = x + v h             v' = v + a h
///     symplectic Euler  v' = v + a h             x' = x + v' h
///     velocity Verlet   x' = x + v h + ½ a h²    v' = v + a h
///     Runge–Kutta 4     the classical four stages; for constant a the same as Verlet to rounding
///
/// With uniform gravity one step changes the energy per mass by exactly +½ a² h² (Euler),
/// −½ a² h² (symplectic Euler), 0 (the others).
/// Source: Hairer, Lubich, Wanner: Geometric Numerical Integration, 2nd ed., I.1.
[[nodiscard]] Motion advance(Integrator integrator, Motion motion, Vec2 a, double dt);

/// c in x(τ) = x + v τ + c a τ², the path that advance() follows as its step τ grows:
/// 0 Euler, 1 symplectic Euler, ½ the others.
[[nodiscard]] constexpr double pathCurvature(Integrator integrator)
{
    switch (integrator) {
    case Integrator::Euler:
        return 0.0;
    case Integrator::SymplecticEuler:
        return 1.0;
    case Integrator::Verlet:
    case Integrator::RungeKutta4:
        break;
    }
    return 0.5;
}

} // namespace cradle
