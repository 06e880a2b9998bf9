// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"

#include "model/run/inferred_hits.h"

#include <algorithm>

namespace cradle {

namespace {

/// A step of exact timing goes on in the next frame after so many events: about 20 ms.
constexpr std::size_t eventsAtOnce = 16'384;

} // namespace

Simulation::Simulation(const Preset &preset, QObject *parent)
    : QObject(parent)
    , m_preset(preset)
    , m_scene(preset)
    , m_stepper(preset)
    , m_clock(preset.timestep)
{
    connect(&m_clock, &SimulationClock::stepDue, this, &Simulation::advance);
    connect(&m_clock, &SimulationClock::frameReady, this, &Simulation::frameReady);
    m_searchTimer.setInterval(0);
    connect(&m_searchTimer, &QTimer::timeout, this, &Simulation::searchOn);
    begin();
}

void Simulation::setPreset(const Preset &preset)
{
    setRun(preset, m_program);
}

void Simulation::setProgram(Program *program)
{
    setRun(m_preset, program);
}

void Simulation::setRun(const Preset &preset, Program *program)
{
    Q_ASSERT(!findFault(preset));
    m_preset = preset;
    m_program = program;
    m_clock.setStep(preset.timestep);
    begin();
    emit presetChanged();
    emit restarted();
    emit frameReady();
    if (m_error)
        fail(*m_error);
}

void Simulation::begin()
{
    endSearch();
    m_unfinished.reset();
    m_scene = m_preset;
    m_error.reset();
    m_notes.clear();
    if (m_program) {
        m_error = m_program->begin(m_scene);
        m_notes.add(0, 0.0, m_program->takeOutput());
        // What a program did before it stopped is no scene to show.
        if (m_error)
            m_scene = m_preset;
    }
    m_stepper = Stepper(m_scene);
    m_world = initialWorld(m_scene);
    m_recording.clear();
    m_recording.append(m_world);
    m_current = 0;
    if (m_shadow)
        beginShadow();
}

void Simulation::beginShadow()
{
    m_shadow.emplace(m_scene, isProgrammed() ? m_programLaws.value_or(m_scene.laws) : m_scene.laws);
    m_shadow->follow(m_recording);
}

/// The state before the step that could not be made is the newest; there the run rests.
void Simulation::fail(const ProgramError &error)
{
    stopClock();
    emit programFailed(error);
}

void Simulation::start()
{
    if (isRunning())
        return;
    if (m_error && m_current == m_recording.last()) {
        emit programFailed(*m_error);
        return;
    }
    pause();
    m_clock.start();
    followPace();
    emit runningChanged(true);
}

void Simulation::pause()
{
    if (m_search)
        endSearchAt(m_search->begin);
    stopClock();
}

void Simulation::stopClock()
{
    if (!isRunning())
        return;
    m_clock.pause();
    followPace();
    emit runningChanged(false);
}

void Simulation::setRunning(bool running)
{
    if (running)
        start();
    else
        pause();
}

void Simulation::restart()
{
    pause();
    begin();
    if (m_program) // it may set other values this time
        emit presetChanged();
    emit restarted();
    emit frameReady();
    if (m_error)
        fail(*m_error);
}

void Simulation::stepForward()
{
    pause();
    advanceWholly();
    emit frameReady();
}

/// However many parts it takes.
void Simulation::advanceWholly()
{
    do {
        advance(m_preset.timestep);
    } while (m_unfinished);
}

void Simulation::stepBack()
{
    seek(m_current - 1);
}

void Simulation::seek(qint64 index)
{
    pause();
    m_current = std::clamp(index, m_recording.first(), m_recording.last());
    emit frameReady();
}

void Simulation::goTo(qint64 step)
{
    const qint64 ahead = step - m_recording.step(m_recording.last());
    if (ahead <= 0) {
        seek(m_recording.last() + ahead);
        return;
    }
    pause();
    m_current = m_recording.last();
    for (qint64 k = 0; k < ahead && !m_error; ++k)
        advanceWholly();
    emit frameReady();
}

void Simulation::setPausesAtHits(bool on)
{
    m_pausesAtHits = on;
}

void Simulation::setSpeed(double speed)
{
    m_speed = std::clamp(speed, slowest, fastest);
    followPace();
}

void Simulation::setSlowsAtHits(bool on)
{
    m_slowsAtHits = on;
    followPace();
}

/// Only while it runs: a run that stands has no slow motion to speak of.
void Simulation::followPace()
{
    const bool slow = m_slowsAtHits && isRunning() && !m_frameTime && isNearHit();
    const double pace = slow ? std::min(m_speed, slowMotion) : m_speed;
    if (pace == m_clock.speed())
        return;
    m_clock.setSpeed(pace);
    emit paceChanged();
}

void Simulation::setFrameTime(bool on)
{
    m_frameTime = on;
    m_clock.setFrameTime(on);
    followPace();
}

void Simulation::setShadowed(bool on)
{
    if (on == m_shadow.has_value())
        return;
    if (on)
        beginShadow();
    else
        m_shadow.reset();
    emit shadowChanged();
    emit frameReady();
}

void Simulation::advance(double dt)
{
    // In the past, go along the recording: what has happened happens again.
    if (m_current == m_recording.last() && !appendStep(dt))
        return;
    if (m_shadow)
        m_shadow->follow(m_recording);
    m_current = std::max(m_current + 1, m_recording.first());
    if (m_pausesAtHits && isRunning() && showsHit())
        pause();
    if (m_slowsAtHits)
        followPace();
}

/// After frames of any length the time goes on from where it is, never back to a multiple.
bool Simulation::isOnGrid(double dt) const
{
    return dt == m_preset.timestep
           && m_world.time == static_cast<double>(m_world.step) * m_preset.timestep;
}

/// \return false if the program cannot go on, or the step goes on in the next call
bool Simulation::appendStep(double dt)
{
    m_hits.clear();
    if (m_error) {
        fail(*m_error);
        return false;
    }
    if (m_program && m_program->moves())
        return appendProgramStep(dt);
    dt = m_unfinished.value_or(dt);
    const double end = isOnGrid(dt) ? static_cast<double>(m_world.step + 1) * m_preset.timestep
                                    : m_world.time + dt;
    const bool done = m_stepper.advanceWithin(eventsAtOnce, m_world, dt, end, m_hits);
    m_unfinished = done ? std::nullopt : std::optional(dt);
    if (!done)
        return false;
    m_recording.append(m_world, m_hits);
    return true;
}

bool Simulation::appendProgramStep(double dt)
{
    World next = m_world;
    m_error = m_program->advance(next, dt);
    ++next.step;
    next.time =
        isOnGrid(dt) ? static_cast<double>(next.step) * m_preset.timestep : m_world.time + dt;
    m_notes.add(next.step, next.time, m_program->takeOutput());
    if (m_error) {
        fail(*m_error);
        return false;
    }
    inferHits(m_scene, m_world.circles, next.circles, dt, next.step, next.time, m_hits);
    m_world = std::move(next);
    m_recording.append(m_world, m_hits);
    return true;
}

} // namespace cradle
