// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation_clock.h"

#include <algorithm>
#include <chrono>

namespace cradle {

namespace {

using namespace std::chrono_literals;

/// Between frames: a little under 1/60 s, so that no frame of the screen goes without.
constexpr auto frameInterval = 16ms;
/// Wall time that one frame makes up for at most, s: after a stall the run goes on, not ahead.
constexpr double longestFrame = 0.1;
/// Steps that take longer than this in one frame are put off, and what is late is dropped, s.
constexpr double workPerFrame = 0.05;

} // namespace

SimulationClock::SimulationClock(double stepSeconds, QObject *parent)
    : QObject(parent)
    , m_step(stepSeconds)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(frameInterval);
    connect(&m_timer, &QTimer::timeout, this, &SimulationClock::onTimeout);
}

void SimulationClock::setStep(double stepSeconds)
{
    m_step = stepSeconds;
    m_backlog = 0.0;
}

void SimulationClock::setSpeed(double speed)
{
    // What is late is no longer made up for at the old speed.
    if (speed < m_speed)
        m_backlog = std::min(m_backlog, 0.5 * m_step);
    m_speed = speed;
}

void SimulationClock::setFrameTime(bool on)
{
    m_frameTime = on;
    m_backlog = 0.0;
}

void SimulationClock::start()
{
    m_backlog = 0.0;
    m_wall.start();
    m_timer.start();
}

void SimulationClock::pause()
{
    m_timer.stop();
    // A step that pauses is the last one of its frame.
    m_backlog = std::min(m_backlog, 0.5 * m_step);
}

void SimulationClock::onTimeout()
{
    tick(static_cast<double>(m_wall.nsecsElapsed()) * 1e-9);
}

void SimulationClock::tick(double wallSeconds)
{
    m_wall.start();
    const double due = std::min(wallSeconds, longestFrame) * m_speed;
    if (m_frameTime) {
        emit stepDue(due);
        emit frameReady();
        return;
    }
    m_backlog += due;
    bool stepped = false;
    while (m_backlog >= m_step) {
        m_backlog -= m_step;
        stepped = true;
        emit stepDue(m_step);
        if (static_cast<double>(m_wall.nsecsElapsed()) * 1e-9 > workPerFrame)
            m_backlog = std::min(m_backlog, 0.5 * m_step);
    }
    if (stepped)
        emit frameReady();
}

} // namespace cradle
