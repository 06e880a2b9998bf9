// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/exact_curves.h"

#include "model/run/simulation.h"
#include "model/world/measurements.h"

#include <algorithm>

namespace cradle {

void ExactCurves::update(const Simulation &simulation, qint64 maxBytes)
{
    const Recording &recording = simulation.recording();
    if (!simulation.shadow() || recording.last() + 1 < m_nextFrame)
        reset();
    if (!simulation.shadow())
        return;
    const Preset &preset = simulation.preset();
    for (qint64 i = std::max(m_nextFrame, recording.first()); i <= recording.last(); ++i) {
        const auto exact = simulation.shadow()->circles(i);
        if (exact.empty())
            continue;
        const Deviation off =
            deviation(recording.circles(i), exact, preset.gravity, preset.halfWidth);
        m_distance.append(recording.time(i), off.greatest);
        m_energy.append(recording.time(i), off.energy);
    }
    m_nextFrame = recording.last() + 1;
    double oldest = recording.time(recording.first());
    if (m_distance.bytes() + m_energy.bytes() > maxBytes && !m_distance.isEmpty())
        oldest = std::max(oldest, 0.5 * (m_distance.firstTime() + m_distance.lastTime()));
    m_distance.dropBefore(oldest);
    m_energy.dropBefore(oldest);
}

} // namespace cradle
