// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/probe.h"

namespace cradle {

Probe::Probe(const QString *program, const Stage &stage, bool once)
    : m_scene(stage.preset)
{
    if (program) {
        m_program.emplace(
            *program,
            StudentScript::Options{
                .pinned = stage.pinned, .quiet = true, .silent = true, .once = once, .locked = {}});
        if (m_program->begin(m_scene))
            return;
        if (!m_program->moves())
            m_program.reset();
    }
    if (!m_program)
        m_laws.emplace(m_scene);
    m_world = initialWorld(m_scene);
    m_runs = true;
}

bool Probe::step()
{
    if (!m_runs)
        return false;
    if (m_program) {
        if (m_program->advance(m_world, m_scene.timestep))
            return m_runs = false;
        ++m_world.step;
        m_world.time = static_cast<double>(m_world.step) * m_scene.timestep;
    } else {
        std::vector<Hit> hits;
        m_laws->advance(m_world, hits);
    }
    return true;
}

qint64 Probe::instructions() const
{
    return m_program ? m_program->instructions() : 0;
}

std::vector<Assignment> Probe::trace()
{
    return m_runs && m_program ? m_program->trace(m_world, m_scene.timestep)
                               : std::vector<Assignment>{};
}

std::vector<int> Probe::lines()
{
    return m_runs && m_program ? m_program->linesOf(m_world, m_scene.timestep) : std::vector<int>{};
}

} // namespace cradle
