// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/simulation.h"

#include <algorithm>

namespace cradle {

namespace {

/// How far seekNextHit() looks ahead, s of the scene.
constexpr double longestSearch = 60.0;

} // namespace

Simulation::Simulation(const Preset &preset, QObject *parent)
    : QObject(parent)
    , m_preset(preset)
    , m_stepper(preset)
    , m_clock(preset.timestep)
{
    connect(&m_clock, &SimulationClock::stepDue, this, &Simulation::advance);
    connect(&m_clock, &SimulationClock::frameReady, this, &Simulation::frameReady);
    begin();
}

void Simulation::setPreset(const Preset &preset)
{
    Q_ASSERT(!findFault(preset));
    m_preset = preset;
    m_stepper = Stepper(preset);
    m_clock.setStep(preset.timestep);
    begin();
    emit presetChanged();
    emit restarted();
    emit frameReady();
}

void Simulation::begin()
{
    m_world = initialWorld(m_preset);
    m_recording.clear();
    m_recording.append(m_world);
    m_current = 0;
}

void Simulation::start()
{
    if (isRunning())
        return;
    m_clock.start();
    emit runningChanged(true);
}

void Simulation::pause()
{
    if (!isRunning())
        return;
    m_clock.pause();
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
    emit restarted();
    emit frameReady();
}

void Simulation::stepForward()
{
    pause();
    advance(m_preset.timestep);
    emit frameReady();
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
    for (qint64 k = 0; k < ahead; ++k)
        advance(m_preset.timestep);
    emit frameReady();
}

void Simulation::seekNextHit()
{
    pause();
    const auto hitShown = [this] {
        const auto &hits = m_recording.hits();
        const qint64 step = m_recording.step(m_current);
        return std::any_of(hits.rbegin(), hits.rend(),
                           [step](const Hit &hit) { return hit.step == step; });
    };
    const qint64 begin = m_current;
    const double end = time() + longestSearch;
    do {
        advance(m_preset.timestep);
    } while (!hitShown() && time() < end);
    if (!hitShown()) {
        m_current = std::max(begin, m_recording.first());
        emit noHitFound();
    }
    emit frameReady();
}

void Simulation::setSpeed(double speed)
{
    m_clock.setSpeed(std::clamp(speed, slowest, fastest));
}

void Simulation::setFrameTime(bool on)
{
    m_frameTime = on;
    m_clock.setFrameTime(on);
}

void Simulation::advance(double dt)
{
    // In the past, go along the recording: what has happened happens again.
    if (m_current == m_recording.last())
        appendStep(dt);
    m_current = std::max(m_current + 1, m_recording.first());
}

void Simulation::appendStep(double dt)
{
    m_hits.clear();
    if (dt == m_preset.timestep && !m_frameTime)
        m_stepper.advance(m_world, m_hits);
    else
        m_stepper.advanceBy(m_world, dt, m_hits);
    m_recording.append(m_world, m_hits);
}

} // namespace cradle
