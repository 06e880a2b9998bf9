// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/stepper.h"

namespace cradle {

World initialWorld(const Preset &preset)
{
    World world;
    world.circles.reserve(preset.circles.size());
    for (const PresetCircle &circle : preset.circles)
        world.circles.push_back(circle.body);
    return world;
}

Rules rulesOf(const Preset &preset)
{
    Rules rules{.halfWidth = preset.halfWidth,
                .gravity = preset.gravity,
                .restitution = preset.restitution,
                .laws = preset.laws};
    rules.integrators.reserve(preset.circles.size());
    const bool exact = preset.laws.timing == Timing::Exact;
    for (const PresetCircle &circle : preset.circles)
        rules.integrators.push_back(exact ? Integrator::Verlet : circle.integrator);
    return rules;
}

Stepper::Stepper(const Preset &preset)
    : m_rules(rulesOf(preset))
    , m_timestep(preset.timestep)
{
}

void Stepper::advance(World &world, std::vector<Hit> &hits)
{
    ++world.step;
    world.time = static_cast<double>(world.step) * m_timestep;
    move(world, m_timestep, hits);
}

void Stepper::advanceBy(World &world, double dt, std::vector<Hit> &hits)
{
    ++world.step;
    world.time += dt;
    move(world, dt, hits);
}

void Stepper::move(World &world, double dt, std::vector<Hit> &hits)
{
    if (m_rules.laws.timing == Timing::Discrete)
        m_discrete.run(m_rules, world, dt, hits);
    else
        m_continuous.run(m_rules, world, dt, hits);
}

} // namespace cradle
