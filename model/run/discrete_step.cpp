// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/discrete_step.h"

#include "model/contacts/collision_detection.h"
#include "model/contacts/collision_response.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// So many circles are looked at all together, without a grid.
constexpr std::size_t fewCircles = 16;

} // namespace

void DiscreteStep::run(const Rules &rules, World &world, double dt, std::vector<Hit> &hits)
{
    m_old.resize(world.circles.size());
    for (std::size_t i = 0; i < world.circles.size(); ++i) {
        Circle &c = world.circles[i];
        m_old[i] = c.position;
        const Motion m = advance(rules.integrators[i], {c.position, c.velocity}, rules.gravity, dt);
        c.position = m.position;
        c.velocity = m.velocity;
    }
    if (rules.laws.walls == WallLaw::Reflect)
        hitWalls(rules, world, hits);
    if (rules.laws.circles != CircleLaw::None)
        hitCircles(rules, world, hits);
}

void DiscreteStep::hitWalls(const Rules &rules, World &world, std::vector<Hit> &hits)
{
    for (std::size_t i = 0; i < world.circles.size(); ++i) {
        Circle &c = world.circles[i];
        const Vec2 moved = c.position;
        // Most are at no wall.
        if (std::abs(moved.x) + c.radius <= rules.halfWidth
            && std::abs(moved.y) + c.radius <= rules.halfWidth)
            continue;
        for (const Wall wall : allWalls) {
            const Vec2 n = outwardNormal(wall);
            if (dot(moved, n) + c.radius <= rules.halfWidth)
                continue;
            const Circle before = c;
            if (!reflect(c.velocity, n, rules.restitution))
                continue;
            c.position = m_old[i];
            hits.push_back({.time = world.time,
                            .step = world.step,
                            .kind = Hit::Kind::Wall,
                            .a = static_cast<int>(i),
                            .b = static_cast<int>(wall),
                            .normal = n,
                            .impulse = mass(c) * dot(before.velocity - c.velocity, n),
                            .beforeA = before.velocity,
                            .afterA = c.velocity,
                            .loss = kineticEnergy(before) - kineticEnergy(c)});
        }
    }
}

void DiscreteStep::hitCircles(const Rules &rules, World &world, std::vector<Hit> &hits)
{
    const auto &circles = world.circles;
    if (circles.size() <= fewCircles) {
        for (std::size_t i = 0; i < circles.size(); ++i) {
            for (std::size_t j = i + 1; j < circles.size(); ++j)
                hitPair(rules, world, i, j, hits);
        }
        return;
    }
    // A hit puts two back to their old places, so others may be met where they were.
    double widest = 0.0;
    double farthest = 0.0;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        widest = std::max(widest, circles[i].radius);
        farthest = std::max(farthest, lengthSquared(circles[i].position - m_old[i]));
    }
    const double reach = widest + 2.0 * std::sqrt(farthest);
    m_grid.build(circles.size(), [&](std::size_t i) { return circles[i].position; });
    for (std::size_t i = 0; i < circles.size(); ++i) {
        findNear(world, i, reach);
        for (const std::size_t j : m_near)
            hitPair(rules, world, i, j, hits);
    }
}

/// Finds the circles after the \p i-th that may reach into it, in the order of the list: each hit
/// changes what the next one sees.
void DiscreteStep::findNear(const World &world, std::size_t i, double reach)
{
    m_near.clear();
    const Circle &c = world.circles[i];
    m_grid.visitRuns(c.position, reach + c.radius, [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t slot = begin; slot < end; ++slot) {
            const std::uint32_t j = m_grid.sorted()[slot];
            if (j > i)
                m_near.push_back(j);
        }
    });
    std::sort(m_near.begin(), m_near.end());
}

void DiscreteStep::hitPair(const Rules &rules, World &world, std::size_t i, std::size_t j,
                           std::vector<Hit> &hits)
{
    Circle &a = world.circles[i];
    Circle &b = world.circles[j];
    if (!overlap(a, b))
        return;
    // The normal where they go back to: there they cannot have passed each other.
    const Vec2 n = normalized(m_old[j] - m_old[i]);
    Hit hit{.time = world.time,
            .step = world.step,
            .kind = Hit::Kind::Circle,
            .a = static_cast<int>(i),
            .b = static_cast<int>(j),
            .normal = n,
            .beforeA = a.velocity,
            .beforeB = b.velocity,
            .loss = kineticEnergy(a) + kineticEnergy(b)};
    if (!respond(rules.laws.circles, a, b, n, rules.restitution))
        return;
    a.position = m_old[i];
    b.position = m_old[j];
    hit.afterA = a.velocity;
    hit.afterB = b.velocity;
    hit.impulse = mass(b) * dot(hit.afterB - hit.beforeB, n);
    hit.loss -= kineticEnergy(a) + kineticEnergy(b);
    hits.push_back(hit);
}

} // namespace cradle
