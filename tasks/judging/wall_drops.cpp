// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_range.h"

#include "tasks/judging/likeness.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr int stepsOfDrop = 70;
constexpr int stepsOfLob = 8;

} // namespace

bool WallRange::canDrop(int circle) const
{
    // Of a fall that is wrong nothing lies on the floor as it should.
    if (fall() == Vec2{} || m_gravity != m_ground.walls.gravity)
        return false;
    const Flight &f = m_flight.at(fall(), m_usual, circle);
    return f.isKnown && isAlike(f.way.x, 1.0, 0.1) && isAlike(f.way.y, 1.0, 0.1);
}

Drop WallRange::lob(int circle, double e, double speed) const
{
    Drop lob{.circle = circle, .wall = Wall::Top, .restitution = e};
    Preset preset = m_ground.stage();
    preset.gravity = fall();
    preset.restitution = e;
    preset.timestep = *std::max_element(m_ground.timesteps.begin(), m_ground.timesteps.end());
    const double h = preset.timestep;
    const double g = length(preset.gravity);
    Circle &c = preset.circles[static_cast<std::size_t>(circle)].body;
    // It has this share of g h of its speed left when its rim is at the ceiling.
    const double last = speed * g * h;
    c.position = {circle % 2 == 0 ? -1.83 : 1.61, preset.halfWidth - c.radius - last * h};
    c.velocity = {0.41, last + g * h};
    lob.stage = {preset, true};
    const Flight &flight = m_flight.at(preset.gravity, h, circle);
    Probe probe(m_program, lob.stage);
    for (int k = 1; k <= stepsOfLob; ++k) {
        const World was = probe.world();
        const Circle &before = was.circles[static_cast<std::size_t>(circle)];
        if (!probe.step())
            break;
        const double free = flight.after(before, h).velocity.y;
        const bool isHigh = before.position.y > preset.halfWidth - 2.0 * before.radius;
        if (isHigh && before.velocity.y < 0.0 && free < 0.0
            && probe.circle(circle).velocity.y > wallKick * (1.0 - free)) {
            if (lob.again == 0)
                lob.isAgainAnew = turnsAnew(lob.stage, was, circle, lob.wall);
            ++lob.again;
            lob.step = lob.step == 0 ? k : lob.step;
        }
    }
    if (lob.step == 0)
        lob.step = stepsOfLob;
    return lob;
}

Drop WallRange::drop(int circle, double e, double height) const
{
    Drop drop{.circle = circle, .restitution = e};
    Preset preset = m_ground.stage();
    preset.gravity = fall();
    preset.restitution = e;
    preset.timestep = m_usual;
    Circle &c = preset.circles[static_cast<std::size_t>(circle)].body;
    c.position = {circle % 2 == 0 ? -1.83 : 1.61, -preset.halfWidth + c.radius + height};
    c.velocity = {0.41, 0.0};
    drop.stage = {preset, true};
    const Flight &flight = m_flight.at(preset.gravity, m_usual, circle);
    const auto depth = [&](const Circle &now) {
        return -preset.halfWidth + now.radius - now.position.y;
    };
    Probe probe(m_program, drop.stage);
    double halfway = 0.0;
    for (int k = 1; k <= stepsOfDrop; ++k) {
        const World was = probe.world();
        const Circle &before = was.circles[static_cast<std::size_t>(circle)];
        if (!probe.step())
            break;
        const Circle &after = probe.circle(circle);
        const double free = flight.after(before, m_usual).velocity.y;
        const bool isLow = before.position.y < -preset.halfWidth + 2.0 * before.radius;
        if (isLow && before.velocity.y > 0.0 && free > 0.0
            && after.velocity.y < -wallKick * (1.0 + free)) {
            if (drop.again == 0)
                drop.isAgainAnew = turnsAnew(drop.stage, was, circle, drop.wall);
            ++drop.again;
            drop.step = drop.step == 0 ? k : drop.step;
        }
        if (k == stepsOfDrop / 2)
            halfway = depth(after);
    }
    drop.depth = depth(probe.circle(circle));
    drop.sinks = drop.depth > halfway + 1e-3;
    if (drop.step == 0)
        drop.step = stepsOfDrop;
    return drop;
}

Vec2 WallRange::fall() const
{
    Vec2 strongest{};
    for (const Vec2 g : m_ground.gravities)
        strongest = g.x == 0.0 && g.y < strongest.y ? g : strongest;
    return strongest;
}

} // namespace cradle
