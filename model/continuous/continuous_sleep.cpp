// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_solver.h"

#include <algorithm>
#include <cmath>

namespace cradle {

// What has been at rest for a while is left alone until something may meet it.

namespace {

/// s for which a pile lies before it sleeps.
constexpr double untilSleep = 0.5;
constexpr double mostStill = 250.0; ///< steps
/// Of the speed that gravity gives in a step: what has come no farther meanwhile than at so much
/// lies. That is the error of its pushes, which, one upon the other, are off by as many times more
/// as there are more rows than in a pile of 1,000. It is the way that tells, for the errors of
/// thousands never all are small in one moment, but they go to and fro.
constexpr double lying = 0.05;
constexpr double fewRows = 32.0;
/// Of the same: the error shakes a circle to and fro at no more than this, what falls does not.
constexpr double shaking = 0.5;
/// Of the same: what a rounding leaves to one that lies without a pile.
constexpr double roundedSpeed = 1e-9;

} // namespace

/// Groups of this step all of whose members have been at rest for long enough sleep from now on.
void ContinuousSolver::layToSleep()
{
    const double gain = m_gravity * m_dt;
    const double steps = std::min(untilSleep / m_dt, mostStill);
    for (std::uint32_t i = 0; i < m_groups.size(); ++i) {
        Member &group = m_groups[m_groups.groupOf(i)];
        const Motion &after = m_groups[i].after;
        const bool pile = isPile(group.size);
        const double rows = pile ? std::sqrt(static_cast<double>(group.size)) : 0.0;
        const double reach = lying * gain * untilSleep * std::max(1.0, rows / fewRows);
        const bool slow = length(after.velocity) <= (pile ? shaking : roundedSpeed) * gain;
        if (m_sleep.countStill(m_ids[m_groups[i].slot], slow, after.position, reach) < steps)
            group.restless = true;
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> tired; // group, circle
    for (std::uint32_t i = 0; i < m_groups.size(); ++i) {
        const std::uint32_t group = m_groups.groupOf(i);
        if (m_groups[group].restless)
            continue;
        const Slot slot = m_groups[i].slot;
        m_motions[slot].velocity = Vec2{};
        m_slotOf[m_ids[slot]] = slot;
        tired.emplace_back(group, m_ids[slot]);
    }
    if (tired.empty())
        return;
    std::sort(tired.begin(), tired.end());
    std::vector<std::uint32_t> island;
    for (std::size_t k = 0; k < tired.size(); ++k) {
        island.push_back(tired[k].second);
        if (k + 1 == tired.size() || tired[k + 1].first != tired[k].first) {
            m_sleep.lay(island);
            island.clear();
        }
    }
    std::erase_if(m_resting, [this](const Candidates &pair) { return sleeps(pair.a); });
}

/// Wakes all that sleep with a circle; they are one group in this step.
void ContinuousSolver::wake(Slot slot)
{
    for (const std::uint32_t id : m_sleep.wake(m_ids[slot]))
        join(slot, m_slotOf[id]);
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
