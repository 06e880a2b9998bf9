// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile_step.h"

#include <algorithm>
#include <cmath>

namespace cradle {

// Who may meet whom in a step of a pile.

/// Finds all pairs that can come together while no body leaves its way.
void PileStep::findNear()
{
    m_near.clear();
    double widest = 0.0;
    double farthest = 0.0;
    for (Body i = 0; i < m_circles.size(); ++i) {
        widest = std::max(widest, m_circles[i].radius);
        farthest = std::max(farthest, m_ways[i]);
    }
    const double g = length(m_rules->gravity);
    const Vec2 up = g > 0.0 ? m_rules->gravity / -g : Vec2{0.0, 1.0};
    for (Body i = 0; i < m_circles.size(); ++i) {
        const Circle &c = m_circles[i];
        const Vec2 place{cross(c.position, up), dot(c.position, up)};
        const double reach = c.radius + m_ways[i];
        m_grid.visitRunsAfter(i, place, reach + widest + farthest, [&](Body begin, Body end) {
            for (Body j = begin; j < end; ++j) {
                const double near = reach + m_circles[j].radius + m_ways[j];
                if (lengthSquared(m_circles[j].position - c.position) <= near * near)
                    addNear(i, j);
            }
        });
        if (m_rules->laws.walls != WallLaw::Reflect)
            continue;
        for (const Wall wall : allWalls) {
            if (dot(c.position, outwardNormal(wall)) + reach >= m_rules->halfWidth)
                addNear(i, static_cast<Body>(m_circles.size() + static_cast<Body>(wall)));
        }
    }
}

void PileStep::addNear(Body a, Body b)
{
    Near near{.a = a, .b = b};
    lookAt(near);
    m_near.push_back(near);
}

/// Finds when the two would meet if they flew straight on at what gravity makes of their speeds,
/// and along which normal. A plane across it that both keep to for the step keeps them apart.
void PileStep::lookAt(Near &near) const
{
    const Circle &a = m_circles[near.a];
    const Vec2 fall = m_dt * m_rules->gravity;
    if (isWall(near.b)) {
        near.normal = outwards(near.b);
        near.gap = m_rules->halfWidth - a.radius - dot(a.position, near.normal);
        const double closing = dot(a.velocity + fall, near.normal);
        near.met = near.gap <= m_apart ? 0.0 : closing > 0.0 ? near.gap / closing : -1.0;
        near.met = near.met <= m_dt ? near.met : -1.0;
        near.speed = dot(a.velocity, near.normal)
                     + std::max(near.met, 0.0) * dot(m_rules->gravity, near.normal);
        return;
    }
    const Circle &b = m_circles[near.b];
    const Vec2 d = b.position - a.position;
    const Vec2 v = b.velocity - a.velocity;
    const double distance = quickLength(d);
    const double sum = a.radius + b.radius;
    near.normal = d / distance;
    near.gap = distance - sum;
    near.met = near.gap <= m_apart ? 0.0 : -1.0;
    const double approach = -dot(d, v);
    const double rest = distance * distance - sum * sum;
    const double discriminant = approach * approach - lengthSquared(v) * rest;
    if (near.met < 0.0 && approach > 0.0 && discriminant > 0.0) {
        const double time = rest / (approach + std::sqrt(discriminant));
        if (time <= m_dt) {
            near.met = time;
            near.normal = normalized(d + time * v);
            near.gap = dot(d, near.normal) - sum;
        }
    }
    near.speed = -dot(v, near.normal);
}

/// Whether a body goes farther than whom it may meet was looked for; it will be now.
bool PileStep::haveComeFar()
{
    bool far = false;
    for (Body i = 0; i < m_circles.size(); ++i) {
        const double way = m_dt * quickLength(m_bodies.velocities[i]);
        far = far || way > m_ways[i];
        m_ways[i] = std::max(m_ways[i], way);
    }
    return far;
}

/// Whether the two are so near and so slow that any push may make them meet.
bool PileStep::isSlow(const Near &near) const
{
    const double speed = isWall(near.b)
                             ? quickLength(m_circles[near.a].velocity)
                             : quickLength(m_circles[near.a].velocity - m_circles[near.b].velocity);
    return speed <= 4.0 * m_gain && near.gap <= 2.0 * m_gain * m_dt;
}

double PileStep::gapOf(const Near &near, const std::vector<Vec2> &places) const
{
    const double radius = m_circles[near.a].radius;
    if (isWall(near.b))
        return m_rules->halfWidth - radius - dot(places[near.a], outwards(near.b));
    return quickLength(places[near.b] - places[near.a]) - radius - m_circles[near.b].radius;
}

std::uint64_t PileStep::keyOf(const Near &near) const
{
    const std::uint64_t a = m_ids[near.a];
    const std::uint64_t b =
        isWall(near.b) ? ~std::uint64_t{near.b - m_circles.size()} & 0xffffffffU : m_ids[near.b];
    return std::min(a, b) << 32U | std::max(a, b);
}

} // namespace cradle
