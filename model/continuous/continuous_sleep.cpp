// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_solver.h"

#include <algorithm>
#include <cmath>

namespace cradle {

// What has been at rest for a while is left alone until something may meet it.

namespace {

/// Of the speed that gravity gives in a step: what is slower in a pile lies, for its pushes are not
/// found more exactly. A circle on its way down gets faster than that long before it may sleep.
constexpr double lying = 0.05;
/// s for which it does so before it sleeps.
constexpr double untilSleep = 0.5;
constexpr double mostStill = 250.0; ///< steps

} // namespace

/// Groups of this step all of whose members have been at rest for long enough sleep from now on.
void ContinuousSolver::layToSleep()
{
    const double slow = lying * m_gravity * m_dt;
    const double steps = std::clamp(untilSleep / m_dt, 1.0, mostStill);
    for (std::uint32_t i = 0; i < m_members.size(); ++i) {
        const std::uint32_t group = groupOf(i);
        const double speed = length(m_members[i].after.velocity);
        const bool still = isPile(m_members[group].size) ? speed <= slow : speed == 0.0;
        std::uint8_t &stillFor = m_stillFor[m_ids[m_members[i].slot]];
        stillFor = still ? static_cast<std::uint8_t>(std::min(stillFor + 1, 255)) : 0;
        m_members[group].restless = m_members[group].restless || stillFor < steps;
    }
    std::vector<std::uint32_t> islands(m_members.size(), awake);
    bool any = false;
    for (std::uint32_t i = 0; i < m_members.size(); ++i) {
        const std::uint32_t group = groupOf(i);
        if (m_members[group].restless)
            continue;
        if (islands[group] == awake) {
            islands[group] = static_cast<std::uint32_t>(m_islands.size());
            m_islands.emplace_back();
        }
        const Slot slot = m_members[i].slot;
        const std::uint32_t id = m_ids[slot];
        m_motions[slot].velocity = Vec2{};
        m_islandOf[id] = islands[group];
        m_islands[islands[group]].push_back(id);
        m_slotOf[id] = slot;
        ++m_sleepers;
        any = true;
    }
    if (any)
        std::erase_if(m_resting, [this](const Candidates &pair) { return sleeps(pair.a); });
}

/// Wakes all that sleep with a circle; they are one group in this step.
void ContinuousSolver::wake(Slot slot)
{
    const std::uint32_t island = m_islandOf[m_ids[slot]];
    const std::vector<std::uint32_t> ids = std::move(m_islands[island]);
    m_islands[island].clear();
    for (const std::uint32_t id : ids) {
        m_islandOf[id] = awake;
        m_stillFor[id] = 0;
    }
    m_sleepers -= ids.size();
    for (const std::uint32_t id : ids)
        join(slot, m_slotOf[id]);
    if (m_sleepers == 0)
        m_islands.clear();
}

/// Puts two down of which one sleeps: the other comes no faster than its speed and gravity allow.
void ContinuousSolver::scheduleSleeper(Slot a, Slot b)
{
    if (sleeps(a) && sleeps(b))
        return;
    const double gap =
        length(m_motions[b].position - m_motions[a].position) - m_radii[a] - m_radii[b];
    if (gap <= 0.0) {
        putDown(0.0, a, b);
        return;
    }
    const double speed = length(m_motions[b].velocity - m_motions[a].velocity) + m_gravity * m_dt;
    putDown(2.0 * gap / (speed + std::sqrt(speed * speed + 2.0 * m_gravity * gap)), a, b);
}

} // namespace cradle
