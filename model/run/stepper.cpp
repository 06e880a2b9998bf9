// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/stepper.h"

#include <limits>
#include <utility>

namespace cradle {

namespace {

/// So many circles are looked at all together, without a grid.
constexpr std::size_t fewBefriended = 8;
constexpr std::size_t allEvents = std::numeric_limits<std::size_t>::max();

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
    const double end = static_cast<double>(world.step + 1) * m_timestep;
    while (!advanceWithin(allEvents, world, m_timestep, end, hits)) {
    }
}

void Stepper::advanceBy(World &world, double dt, std::vector<Hit> &hits)
{
    const double end = world.time + dt;
    while (!advanceWithin(allEvents, world, dt, end, hits)) {
    }
}

bool Stepper::advanceWithin(std::size_t events, World &world, double dt, double end,
                            std::vector<Hit> &hits)
{
    const double begin = std::exchange(world.time, end);
    ++world.step;
    const bool done = move(events, world, dt, hits);
    if (!done) {
        world.time = begin;
        --world.step;
    }
    return done;
}

/// \p world already has the time and the step of the end.
bool Stepper::move(std::size_t events, World &world, double dt, std::vector<Hit> &hits)
{
    switch (m_rules.laws.timing) {
    case Timing::Discrete:
        m_discrete.run(m_rules, world, dt, hits);
        return true;
    case Timing::Continuous:
        moveContinuously(world, dt, hits);
        return true;
    case Timing::Exact:
        break;
    }
    return moveExactly(events, world, dt, hits);
}

bool Stepper::isLeft(const World &world) const
{
    return !m_left.empty() && m_left == world.circles;
}

void Stepper::moveContinuously(World &world, double dt, std::vector<Hit> &hits)
{
    if (world.circles.size() <= fewBefriended) {
        m_continuous.run(m_rules, world, dt, hits);
    } else {
        if (!isLeft(world))
            m_crowd.start(m_rules, world.circles);
        m_crowd.advance(dt, world.time, world.step, hits);
        m_crowd.read(world.circles);
        m_left = world.circles;
    }
}

bool Stepper::moveExactly(std::size_t events, World &world, double dt, std::vector<Hit> &hits)
{
    if (!isLeft(world)) {
        m_exact.start(m_rules, world.circles);
        m_mergedFrom.reset();
        m_isUnfinished = false;
        m_found.clear();
        m_left = world.circles;
    }
    if (m_mergedFrom) {
        moveContinuously(world, dt, hits);
        m_left = world.circles;
        return true;
    }
    if (!m_isUnfinished)
        m_exact.aim(dt, world.time, world.step);
    m_isUnfinished = !m_exact.run(events, m_found);
    if (m_isUnfinished)
        return false;
    hits.insert(hits.end(), m_found.begin(), m_found.end());
    m_found.clear();
    m_exact.read(world.circles);
    if (m_exact.hasCollapsed())
        merge(world, hits);
    m_left = world.circles;
    return true;
}

/// Exact timing has come as far as it can: continuous timing takes the rest of the step.
void Stepper::merge(World &world, std::vector<Hit> &hits)
{
    m_mergedFrom = world.time - m_exact.left();
    m_left.clear();
    moveContinuously(world, m_exact.left(), hits);
}

} // namespace cradle
