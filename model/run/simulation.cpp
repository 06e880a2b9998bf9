// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr int searchFrame = 16; ///< ms, after which what a search has found shows

} // namespace

Simulation::Simulation(const Preset &preset, QObject *parent)
    : QObject(parent)
    , m_preset(preset)
    , m_run(preset)
    , m_clock(preset.timestep)
{
    connect(&m_clock, &SimulationClock::stepDue, this, &Simulation::advance);
    connect(&m_clock, &SimulationClock::frameReady, this, &Simulation::frameReady);
    m_searchTimer.setInterval(searchFrame);
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
    m_recording.clear();
    m_notes.clear();
    m_run = Runner(m_preset, m_program, {.recording = &m_recording});
    m_error = m_run.error();
    m_mergedFrom.reset();
    if (m_program)
        m_notes.add(0, 0.0, m_program->takeOutput());
    m_current = 0;
    if (m_shadow)
        beginShadow();
}

void Simulation::beginShadow()
{
    const Laws &own = preset().laws;
    m_shadow.emplace(preset(), isProgrammed() ? m_programLaws.value_or(own) : own);
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
    } while (m_run.isUnfinished());
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

/// \return false if the program cannot go on, or the step goes on in the next call
bool Simulation::appendStep(double dt)
{
    const qint64 step = m_run.world().step + 1;
    const double end = m_run.endOf(dt);
    const Runner::Progress progress = m_run.advance(dt, Runner::eventsAtOnce);
    if (isProgrammed())
        m_notes.add(step, end, m_program->takeOutput());
    m_mergedFrom = m_run.mergedFrom();
    if (progress == Runner::Progress::Failed) {
        m_error = m_run.error();
        fail(*m_error);
    }
    return progress == Runner::Progress::Done;
}

} // namespace cradle
