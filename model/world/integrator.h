// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <array>

namespace cradle {

/// How a position and a velocity are carried over a timestep.
enum class Integrator { Euler, SymplecticEuler, Verlet, RungeKutta4 };
inline constexpr std::array allIntegrators{Integrator::Euler, Integrator::SymplecticEuler,
                                           Integrator::Verlet, Integrator::RungeKutta4};

/// Position (m) and velocity (m/s) of one body.
struct Motion {
    Vec2 position{};
    Vec2 velocity{};

    friend constexpr bool operator==(const Motion &, const Motion &) = default;
};

/// The motion of \p m \p dt seconds later under the constant acceleration \p a (m/s²).
///
///     Euler             x' = x + v h             v' = v + a h
///     symplectic Euler  v' = v + a h             x' = x + v' h
///     velocity Verlet   x' = x + v h + ½ a h²    v' = v + a h
///     Runge–Kutta 4     the classical four stages; for constant a the same as Verlet to rounding
///
/// With uniform gravity one step changes the energy per mass by exactly +½ a² h² (Euler),
/// −½ a² h² (symplectic Euler), 0 (the others).
/// Derived in docs/physics.md, 2.
/// Source: Hairer, Lubich, Wanner: Geometric Numerical Integration, 2nd ed., I.1.
[[nodiscard]] constexpr Motion advance(Integrator integrator, Motion m, Vec2 a, double dt)
{
    switch (integrator) {
    case Integrator::Euler:
        return {m.position + dt * m.velocity, m.velocity + dt * a};
    case Integrator::SymplecticEuler: {
        const Vec2 v = m.velocity + dt * a;
        return {m.position + dt * v, v};
    }
    case Integrator::Verlet:
        return {m.position + dt * m.velocity + (0.5 * dt * dt) * a, m.velocity + dt * a};
    case Integrator::RungeKutta4: {
        // Slopes of the position; those of the velocity are all a, for a does not change.
        const Vec2 k1 = m.velocity;
        const Vec2 k2 = m.velocity + 0.5 * dt * a;
        const Vec2 k3 = k2;
        const Vec2 k4 = m.velocity + dt * a;
        return {m.position + (dt / 6.0) * (k1 + 2.0 * k2 + 2.0 * k3 + k4), m.velocity + dt * a};
    }
    }
    return m;
}

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
