// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/frame_throttle.h"

#include <QEvent>

namespace cradle {

namespace {

constexpr int runningInterval = 32; ///< ms: every second frame
constexpr int pausedInterval = 16;  ///< ms: a drag may send more moments than the screen has frames

constexpr int earliness = 4; ///< ms: timers are not exact

} // namespace

FrameThrottle::FrameThrottle(const Simulation &simulation, QWidget *view)
    : QObject(view)
    , m_simulation(simulation)
    , m_view(view)
{
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &FrameThrottle::fire);
    connect(&simulation, &Simulation::frameReady, this, &FrameThrottle::request);
    connect(&simulation, &Simulation::runningChanged, this, &FrameThrottle::request);
    view->installEventFilter(this);
}

void FrameThrottle::request()
{
    m_dirty = true;
    if (!m_view->isVisible() || m_timer.isActive())
        return;
    const int interval = m_simulation.isRunning() ? runningInterval : pausedInterval;
    const qint64 elapsed = m_sinceLast.isValid() ? m_sinceLast.elapsed() : interval;
    if (elapsed < interval - earliness)
        m_timer.start(interval - static_cast<int>(elapsed));
    else
        fire();
}

void FrameThrottle::fire()
{
    m_timer.stop();
    if (!m_dirty || !m_view->isVisible())
        return;
    m_dirty = false;
    m_sinceLast.start();
    emit due();
}

bool FrameThrottle::eventFilter(QObject *watched, QEvent *event)
{
    // The widget counts as visible only after its show event.
    if (watched == m_view && event->type() == QEvent::Show && m_dirty)
        m_timer.start(0);
    return QObject::eventFilter(watched, event);
}

} // namespace cradle
