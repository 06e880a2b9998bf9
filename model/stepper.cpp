// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/stepper.h"

namespace cradle {

namespace {

/// So many circles are looked at all together, without a grid.
constexpr std::size_t fewCircles = 8;

} // namespace

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
    switch (m_rules.laws.timing) {
    case Timing::Discrete:
        m_discrete.run(m_rules, world, dt, hits);
        break;
    case Timing::Continuous:
        if (world.circles.size() <= fewCircles)
            m_continuous.run(m_rules, world, dt, hits);
        else
            carryOn(m_crowd, world, dt, hits);
        break;
    case Timing::Exact:
        carryOn(m_exact, world, dt, hits);
        break;
    }
}

template <class Solver>
void Stepper::carryOn(Solver &solver, World &world, double dt, std::vector<Hit> &hits)
{
    if (m_left.empty() || m_left != world.circles)
        solver.start(m_rules, world.circles);
    solver.advance(dt, world.time, world.step, hits);
    solver.read(world.circles);
    m_left = world.circles;
}

} // namespace cradle
