// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/code_session.h"

#include <chrono>
#include <utility>

namespace cradle {

namespace {

using namespace std::chrono_literals;

constexpr auto saveDelay = 200ms;  ///< after the first key that is not saved
constexpr auto applyDelay = 400ms; ///< after the last key: a word is seldom a program
constexpr auto keepDelay = 10min;  ///< of changed text, for a version of it
constexpr auto lookDelay = 300ms;  ///< other programs write a file in several steps

} // namespace

CodeSession::CodeSession(Simulation &simulation, QObject *parent)
    : QObject(parent)
    , m_simulation(simulation)
{
    m_saveSoon.setSingleShot(true);
    m_saveSoon.setInterval(saveDelay);
    m_applySoon.setSingleShot(true);
    m_applySoon.setInterval(applyDelay);
    m_keepSoon.setSingleShot(true);
    m_keepSoon.setInterval(keepDelay);
    m_lookSoon.setSingleShot(true);
    m_lookSoon.setInterval(lookDelay);
    connect(&m_saveSoon, &QTimer::timeout, this, &CodeSession::save);
    connect(&m_keepSoon, &QTimer::timeout, this,
            [this] { keepVersion(m_text, {.reason = VersionReason::Typed}); });
    connect(&m_lookSoon, &QTimer::timeout, this, &CodeSession::lookOutside);
    connect(&m_applySoon, &QTimer::timeout, this, &CodeSession::apply);
    // Whatever moves the run on ends the walk through its lines.
    connect(&m_simulation, &Simulation::restarted, this, &CodeSession::endStepping);
    connect(&m_simulation, &Simulation::frameReady, this, &CodeSession::endStepping);
}

CodeSession::~CodeSession()
{
    save();
    keepTyped();
    if (m_active)
        m_simulation.setProgram(nullptr);
}

void CodeSession::open(const Lab &lab, int index)
{
    open(lab, index, m_active, [this](Program *program) {
        if (m_active)
            m_simulation.setProgram(program);
    });
}

void CodeSession::open(const Lab &lab, int index, bool active,
                       const std::function<void(Program *program)> &start)
{
    save();
    keepTyped();
    m_applySoon.stop();
    m_pinned = false;
    m_taskId = lab.tasks[static_cast<std::size_t>(index)].id;
    m_locked = lab.tasks[static_cast<std::size_t>(index)].locked;
    const Result<QString> text = m_workspace.textOf(lab, index);
    m_foreign = text ? std::nullopt : std::optional(text.error());
    m_text = text ? *text : QString();
    m_unsaved = false;
    watch();
    m_fault = findSyntaxError(m_text);
    m_running = m_fault ? QString() : m_text;
    m_active = active;
    // The old program lives until the simulation has let go of it.
    const auto before = std::exchange(m_script, makeScript());
    emit opened(m_text);
    start(program());
    emit versionsChanged();
    emit stateChanged();
}

void CodeSession::close()
{
    save();
    keepTyped();
    m_applySoon.stop();
    m_watcher.reset();
    m_taskId.clear();
    m_text.clear();
    m_foreign.reset();
    m_unsaved = false;
    m_fault.reset();
    setActive(false);
    emit opened({});
    emit versionsChanged();
    emit stateChanged();
}

bool CodeSession::isEditable() const
{
    return isOpen() && !m_foreign && m_workspace.mayWrite();
}

void CodeSession::setActive(bool active)
{
    active = active && isOpen();
    if (active == m_active)
        return;
    m_active = active;
    m_simulation.setProgram(program());
}

void CodeSession::setPinned(bool pinned)
{
    m_pinned = pinned;
    if (m_script)
        m_script->setPinned(pinned);
}

void CodeSession::setAppliesAtOnce(bool atOnce)
{
    m_atOnce = atOnce;
    if (atOnce)
        apply();
    else
        m_applySoon.stop();
}

void CodeSession::edit(const QString &text)
{
    if (!isEditable() || text == m_text)
        return;
    m_text = text;
    m_unsaved = true;
    // Never started again by the next key: who types without a pause is saved, too.
    if (!m_saveSoon.isActive())
        m_saveSoon.start(saveDelay);
    if (!m_keepSoon.isActive())
        m_keepSoon.start();
    if (m_atOnce)
        m_applySoon.start();
    emit edited();
    emit stateChanged();
}

void CodeSession::replace(const QString &text)
{
    if (!isEditable())
        return;
    keepVersion(m_text, {.reason = VersionReason::Before});
    edit(text);
    emit textReplaced(m_text);
    apply();
}

void CodeSession::apply()
{
    m_applySoon.stop();
    if (!isOpen())
        return;
    m_fault = findSyntaxError(m_text);
    if (!m_fault && m_text != m_script->source()) {
        m_running = m_text;
        run();
    }
    emit stateChanged();
}

std::unique_ptr<StudentScript> CodeSession::makeScript() const
{
    return std::make_unique<StudentScript>(
        m_running, StudentScript::Options{.pinned = m_pinned, .timed = true, .locked = m_locked});
}

/// The old program lives until the simulation has let go of it.
void CodeSession::run()
{
    auto script = makeScript();
    if (m_active)
        m_simulation.setProgram(script.get());
    m_script = std::move(script);
}

void CodeSession::stepLine()
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

void CodeSession::finishStep()
{
    if (!program())
        return;
    m_stepping = false;
    emit steppingEnded();
    m_simulation.stepForward();
}

void CodeSession::endStepping()
{
    if (!std::exchange(m_stepping, false))
        return;
    m_script->dropLines();
    emit steppingEnded();
}

} // namespace cradle
