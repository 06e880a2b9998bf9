// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/code_run.h"

#include <utility>

namespace cradle {

CodeRun::CodeRun(Simulation &simulation)
    : m_simulation(simulation)
{
    // Whatever moves the run on ends the walk through its lines.
    connect(&m_simulation, &Simulation::restarted, this, &CodeRun::endStepping);
    connect(&m_simulation, &Simulation::frameReady, this, &CodeRun::endStepping);
}

CodeRun::~CodeRun()
{
    setActive(false);
}

void CodeRun::open(const QString &text, const QStringList &locked, bool active, const Start &start)
{
    m_pinned = false;
    m_locked = locked;
    m_fault = findSyntaxError(text);
    m_text = m_fault ? QString() : text;
    m_active = active;
    // The old program lives until the simulation has let go of it.
    const auto before = std::exchange(m_script, makeScript());
    start(program());
}

void CodeRun::close()
{
    m_fault.reset();
    setActive(false);
    m_text.clear();
    m_script.reset();
}

void CodeRun::apply(const QString &text)
{
    m_fault = findSyntaxError(text);
    if (m_fault || !m_script || text == m_script->source())
        return;
    m_text = text;
    // The old program lives until the simulation has let go of it.
    auto script = makeScript();
    if (m_active)
        m_simulation.setProgram(script.get());
    m_script = std::move(script);
}

void CodeRun::setActive(bool active)
{
    active = active && m_script;
    if (active == m_active)
        return;
    m_active = active;
    m_simulation.setProgram(program());
}

void CodeRun::setPinned(bool pinned)
{
    m_pinned = pinned;
    if (m_script)
        m_script->setPinned(pinned);
}

std::unique_ptr<StudentScript> CodeRun::makeScript() const
{
    return std::make_unique<StudentScript>(
        m_text, StudentScript::Options{.pinned = m_pinned, .timed = true, .locked = m_locked});
}

void CodeRun::stepLine()
{
    if (!program() || !m_script->moves() || m_simulation.programError())
        return;
    m_simulation.pause();
    const Recording &recording = m_simulation.recording();
    // The past is told, not run: lines are those of the step that comes next.
    if (m_simulation.current() != recording.last())
        m_simulation.seek(recording.last());
    const StudentScript::Pause pause = m_stepping
                                           ? m_script->nextLine()
                                           : m_script->beginLines(recording.world(recording.last()),
                                                                  m_simulation.preset().timestep);
    m_stepping = pause.line > 0 && !pause.error;
    if (m_stepping)
        emit paused(pause);
    else
        finishStep();
}

void CodeRun::finishStep()
{
    if (!program())
        return;
    m_stepping = false;
    emit steppingEnded();
    m_simulation.stepForward();
}

void CodeRun::endStepping()
{
    if (!std::exchange(m_stepping, false))
        return;
    m_script->dropLines();
    emit steppingEnded();
}

} // namespace cradle
