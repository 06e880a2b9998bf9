// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/integrator.h"

namespace cradle {

namespace {

Motion rungeKutta4(Motion m, Vec2 a, double h)
{
    // Slopes of the position; those of the velocity are all a, for a does not change.
    const Vec2 k1 = m.velocity;
    const Vec2 k2 = m.velocity + 0.5 * h * a;
    const Vec2 k3 = k2;
    const Vec2 k4 = m.velocity + h * a;
    return {m.position + (h / 6.0) * (k1 + 2.0 * k2 + 2.0 * k3 + k4), m.velocity + h * a};
}

} // namespace

Motion advance(Integrator integrator, Motion m, Vec2 a, double dt)
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
    case Integrator::RungeKutta4:
        return rungeKutta4(m, a, dt);
    }
    return m;
}

} // namespace cradle
