// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/run_curves.h"

#include <algorithm>

namespace cradle {

RunCurves::RunCurves(const Simulation &simulation, QObject *parent, qint64 maxBytes)
    : QObject(parent)
    , m_simulation(simulation)
    , m_maxBytes(maxBytes)
{
    connect(&simulation, &Simulation::restarted, this, &RunCurves::reset);
    connect(&simulation, &Simulation::shadowChanged, this, [this] { m_exact.reset(); });
    connect(&simulation, &Simulation::frameReady, this, &RunCurves::update);
    reset();
}

void RunCurves::reset()
{
    m_set.begin(m_simulation.recording().circleCount());
    m_exact.reset();
    m_nextFrame = 0;
    update();
}

void RunCurves::update()
{
    const Recording &recording = m_simulation.recording();
    if (recording.isEmpty())
        return;
    if (recording.last() + 1 < m_nextFrame)
        return reset();
    for (qint64 i = std::max(m_nextFrame, recording.first()); i <= recording.last(); ++i)
        m_set.read(recording, m_simulation.preset(), i);
    m_nextFrame = recording.last() + 1;
    m_exact.update(m_simulation, m_maxBytes / 8);
    if (recording.hasDropped())
        m_set.dropBefore(recording.time(recording.first()));
    if (m_set.bytes() > m_maxBytes)
        m_set.dropOldest();
}

void RunCurves::want(const QObject *who, CurveGroups groups)
{
    m_wanted[who] = groups;
    CurveGroups all;
    for (const auto &[chart, wanted] : m_wanted)
        all |= wanted;
    if (all != m_set.groups())
        m_set.setGroups(all, m_simulation.recording(), m_simulation.preset(), m_nextFrame);
}

CurveSet RunCurves::whole(qint64 maxBytes) const
{
    return m_set.whole(m_simulation.recording(), m_simulation.preset(), m_nextFrame, maxBytes);
}

} // namespace cradle
