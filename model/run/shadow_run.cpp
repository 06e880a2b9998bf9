// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/shadow_run.h"

namespace cradle {

namespace {

/// \p scene under \p laws with exact timing, if it can be run so.
std::optional<Preset> exactScene(const Preset &scene, const Laws &laws)
{
    if (scene.circles.size() > ShadowRun::mostCircles)
        return std::nullopt;
    Preset exact = scene;
    exact.laws = laws;
    exact.laws.timing = Timing::Exact;
    return findFault(exact) ? std::nullopt : std::optional(exact);
}

} // namespace

ShadowRun::ShadowRun(const Preset &scene, const Laws &laws)
    : m_timestep(scene.timestep)
    , m_world(initialWorld(scene))
{
    if (const auto exact = exactScene(scene, laws))
        m_stepper.emplace(*exact);
}

void ShadowRun::follow(const Recording &run)
{
    if (!m_stepper)
        return;
    if (m_recording.isEmpty()) {
        m_offset = run.first();
    } else if (run.last() - m_offset < m_recording.last()) {
        m_recording.truncateAfter(run.last() - m_offset);
        m_world = m_recording.world(m_recording.last());
    }
    for (qint64 index = m_offset + m_recording.last() + 1; index <= run.last(); ++index) {
        moveTo(run.time(index));
        // Without hits it takes no more memory than the run, so it drops no frame before the run
        // does.
        m_recording.append(m_world);
    }
}

/// In steps no longer than the scene's: the work of one step is bounded.
void ShadowRun::moveTo(double time)
{
    while (m_world.time < time) {
        const double left = time - m_world.time;
        m_hits.clear();
        m_stepper->advanceBy(m_world, left < 1.5 * m_timestep ? left : m_timestep, m_hits);
    }
}

std::span<const Circle> ShadowRun::circles(qint64 index) const
{
    const qint64 own = index - m_offset;
    if (m_recording.isEmpty() || own < m_recording.first() || own > m_recording.last())
        return {};
    return m_recording.circles(own);
}

} // namespace cradle
