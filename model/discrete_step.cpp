// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/discrete_step.h"

#include "model/collision_detection.h"
#include "model/collision_response.h"

namespace cradle {

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
    auto &circles = world.circles;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        for (std::size_t j = i + 1; j < circles.size(); ++j) {
            Circle &a = circles[i];
            Circle &b = circles[j];
            if (!overlap(a, b))
                continue;
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
                continue;
            a.position = m_old[i];
            b.position = m_old[j];
            hit.afterA = a.velocity;
            hit.afterB = b.velocity;
            hit.impulse = mass(b) * dot(hit.afterB - hit.beforeB, n);
            hit.loss -= kineticEnergy(a) + kineticEnergy(b);
            hits.push_back(hit);
        }
    }
}

} // namespace cradle
