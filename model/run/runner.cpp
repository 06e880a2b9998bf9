// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/runner.h"

#include "model/run/inferred_hits.h"

#include <utility>

namespace cradle {

Runner::Runner(const Preset &scene, Program *program)
    : Runner(scene, program, Use{})
{
}

Runner::Runner(const Preset &scene, Program *program, const Use &use)
    : m_scene(scene)
    , m_program(program)
    , m_use(use)
{
    if (m_program)
        m_error = m_program->begin(m_scene);
    // What a program did before it stopped is no scene.
    if (m_error)
        m_scene = scene;
    if (!m_program || !m_program->moves())
        m_laws.emplace(m_scene);
    m_world = initialWorld(m_scene);
    record();
}

double Runner::endOf(double dt) const
{
    const double timestep = m_scene.timestep;
    const bool isOnGrid =
        dt == timestep && m_world.time == static_cast<double>(m_world.step) * timestep;
    return isOnGrid ? static_cast<double>(m_world.step + 1) * timestep : m_world.time + dt;
}

void Runner::place(const World &world)
{
    m_world = world;
    m_begun.reset();
}

Runner::Progress Runner::advance(double dt, std::size_t events)
{
    m_hits.clear();
    if (m_error)
        return Progress::Failed;
    const bool done = m_laws ? moveByLaws(m_begun.value_or(dt), events) : moveByProgram(dt);
    if (!done)
        return m_error ? Progress::Failed : Progress::Begun;
    record();
    return Progress::Done;
}

bool Runner::moveByLaws(double dt, std::size_t events)
{
    const bool done = m_laws->advanceWithin(events, m_world, dt, endOf(dt), m_hits);
    m_begun = done ? std::nullopt : std::optional(dt);
    return done;
}

bool Runner::moveByProgram(double dt)
{
    if (m_use.tellsHits)
        m_before = m_world.circles;
    if (auto error = m_program->advance(m_world, dt)) {
        m_error = std::move(error);
        return false;
    }
    m_world.time = endOf(dt);
    ++m_world.step;
    if (m_use.tellsHits)
        inferHits(m_scene, m_before, m_world.circles, dt, m_world.step, m_world.time, m_hits);
    return true;
}

void Runner::record()
{
    if (!m_use.recording)
        return;
    if (m_use.tellsHits)
        m_use.recording->append(m_world, m_hits);
    else
        m_use.recording->append(m_world);
}

bool Runner::step()
{
    Progress progress = Progress::Begun;
    while (progress == Progress::Begun)
        progress = advance(m_scene.timestep);
    return progress == Progress::Done;
}

Runner::End Runner::run(const Bounds &bounds, const std::function<void()> &done)
{
    while (!m_error && m_world.step < bounds.steps) {
        if (bounds.stop && bounds.stop())
            return End::Stopped;
        if (instructions() > bounds.instructions)
            return End::TooManyInstructions;
        if (advance(m_scene.timestep, eventsAtOnce) == Progress::Done && done)
            done();
    }
    return m_error ? End::Failed : End::AllSteps;
}

} // namespace cradle
