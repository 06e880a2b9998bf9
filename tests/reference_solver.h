// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/world.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace cradle::reference {

/// 64 bits of mantissa on x86: what it rounds is small beside what a solver in double rounds.
using Real = long double;

/// A circle as the reference knows it; SI units.
struct Body {
    Real x = 0, y = 0, vx = 0, vy = 0;
    Real radius = 0, mass = 0;
};

/// A hit, and the state of its bodies after it.
struct Impact {
    Real time = 0;     ///< s
    bool wall = false; ///< b is the Wall as an int
    int a = 0;         ///< the first circle
    int b = 0;         ///< the second one, a < b, or the wall
    Real nx = 0;       ///< unit vector from a to b
    Real ny = 0;
};

/// The first time ≥ 0 at which gap = u t + ½ a t² is crossed outwards, for gap ≥ 0 up to rounding:
/// the root of ½ a t² + u t − gap = 0 with u + a t > 0.
inline std::optional<Real> timeToWall(Real gap, Real u, Real a)
{
    if (gap < 0)
        gap = 0;
    const Real square = u * u + 2 * a * gap; // of the speed there
    if (square < 0 || (u <= 0 && a <= 0))
        return std::nullopt;
    const Real speed = std::sqrt(square);
    if (u > 0)
        return 2 * gap / (u + speed); // without cancellation
    return (speed - u) / a;
}

/// The first time ≥ 0 at which two discs meet that move at constant velocity against each other
/// (gravity moves both alike): the smaller root of |d + v t|² = R², if they approach.
inline std::optional<Real> timeToMeet(const Body &a, const Body &b)
{
    const Real dx = b.x - a.x, dy = b.y - a.y;
    const Real vx = b.vx - a.vx, vy = b.vy - a.vy;
    const Real distance = a.radius + b.radius;
    const Real approach = -(dx * vx + dy * vy);
    if (approach <= 0)
        return std::nullopt;
    const Real speedSquared = vx * vx + vy * vy;
    // R² − (impact parameter)², times v²: no difference of large squares in a near miss.
    const Real parameter = dx * vy - dy * vx;
    const Real inside = distance * distance * speedSquared - parameter * parameter;
    if (inside < 0)
        return std::nullopt;
    const Real length = std::sqrt(dx * dx + dy * dy);
    const Real gap = (length - distance) * (length + distance);
    return gap <= 0 ? 0 : gap / (approach + std::sqrt(inside));
}

/// The plainest solver there is, to compare with: tries all pairs and walls for the earliest hit,
/// moves everything there, answers that one hit, and begins anew. No cells, no queue, no memory of
/// earlier times; O(N²) a hit. Reflecting walls or none; impulse law. Knows nothing of rest: not
/// for bouncing that dies away.
class Solver
{
public:
    explicit Solver(const Preset &preset)
        : m_half(preset.halfWidth)
        , m_gx(preset.gravity.x)
        , m_gy(preset.gravity.y)
        , m_restitution(preset.restitution)
        , m_walls(preset.laws.walls == WallLaw::Reflect)
    {
        for (const PresetCircle &c : preset.circles) {
            const Circle &body = c.body;
            const Real r = body.radius;
            const Real volume = Real{4} / 3 * std::numbers::pi_v<Real> * r * r * r;
            m_bodies.push_back({.x = body.position.x,
                                .y = body.position.y,
                                .vx = body.velocity.x,
                                .vy = body.velocity.y,
                                .radius = r,
                                .mass = 1000 * Real{body.density} * volume});
        }
    }

    [[nodiscard]] Real time() const { return m_time; }                            ///< s
    [[nodiscard]] const Body &operator[](int i) const { return m_bodies[at(i)]; } ///< now

    /// The next hit if it comes before \p end (s); it is not yet answered.
    [[nodiscard]] std::optional<Impact> next(Real end) const
    {
        std::optional<Impact> first;
        const auto offer = [&](std::optional<Real> wait, bool wall, int a, int b) {
            if (wait && m_time + *wait < (first ? first->time : end))
                first = Impact{.time = m_time + *wait, .wall = wall, .a = a, .b = b};
        };
        const int count = static_cast<int>(m_bodies.size());
        for (int i = 0; i < count; ++i) {
            const Body &c = m_bodies[at(i)];
            for (const Wall wall : allWalls) {
                const Vec2 n = outwardNormal(wall);
                const Real gap = m_half - c.radius - (c.x * n.x + c.y * n.y);
                if (m_walls)
                    offer(timeToWall(gap, c.vx * n.x + c.vy * n.y, m_gx * n.x + m_gy * n.y), true,
                          i, static_cast<int>(wall));
            }
            for (int j = i + 1; j < count; ++j)
                offer(timeToMeet(c, m_bodies[at(j)]), false, i, j);
        }
        return first;
    }

    /// Moves every body on its parabola to \p time.
    void moveTo(Real time)
    {
        const Real t = time - m_time;
        for (Body &c : m_bodies) {
            c.x += t * (c.vx + t * m_gx / 2);
            c.y += t * (c.vy + t * m_gy / 2);
            c.vx += t * m_gx;
            c.vy += t * m_gy;
        }
        m_time = time;
    }

    /// Moves to the hit and answers it: J = (1 + e) μ u along the normal, μ = m_a for a wall.
    void take(Impact &hit)
    {
        moveTo(hit.time);
        Body &a = m_bodies[at(hit.a)];
        if (hit.wall) {
            const Vec2 n = outwardNormal(static_cast<Wall>(hit.b));
            hit.nx = n.x;
            hit.ny = n.y;
            push(a, hit, -(1 + m_restitution) * (a.vx * hit.nx + a.vy * hit.ny));
            return;
        }
        Body &b = m_bodies[at(hit.b)];
        const Real length = std::hypot(b.x - a.x, b.y - a.y);
        hit.nx = (b.x - a.x) / length;
        hit.ny = (b.y - a.y) / length;
        const Real closing = (a.vx - b.vx) * hit.nx + (a.vy - b.vy) * hit.ny;
        const Real impulse = (1 + m_restitution) * closing * a.mass * b.mass / (a.mass + b.mass);
        push(a, hit, -impulse / a.mass);
        push(b, hit, impulse / b.mass);
    }

private:
    static std::size_t at(int index) { return static_cast<std::size_t>(index); }
    static void push(Body &body, const Impact &hit, Real change)
    {
        body.vx += change * hit.nx;
        body.vy += change * hit.ny;
    }

    Real m_half, m_gx, m_gy, m_restitution;
    bool m_walls;
    Real m_time = 0;
    std::vector<Body> m_bodies{};
};

} // namespace cradle::reference
