// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/sort_skin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cradle {

void SortSkin::start(double dt, double gravity, double width, double fastest)
{
    m_dt = dt;
    m_gravity = gravity;
    m_steps = mostSteps;
    m_driftStep = 0;
    m_drifted = 0.0;
    m_fastest = -1.0;
    m_width = std::max(width, travel(dt, fastest));
    note(fastest, 0);
    m_steps = std::max<std::size_t>(m_steps, 1);
}

double SortSkin::driftAfter(std::size_t steps) const
{
    const double since = static_cast<double>(steps - m_driftStep) * m_dt;
    return std::min(m_width, m_drifted + travel(since, m_fastest));
}

void SortSkin::note(double speed, std::size_t index)
{
    const double since = static_cast<double>(index - m_driftStep) * m_dt;
    if (speed <= m_fastest + m_gravity * since)
        return;
    // The latest step may have been flown at the new speed already.
    m_drifted += travel(since, std::max(m_fastest, 0.0)) + (index > 0 ? travel(m_dt, speed) : 0.0);
    m_driftStep = index;
    m_fastest = speed;
    const double left = std::max(0.0, m_width - m_drifted);
    const double push = speed + m_gravity * m_dt;
    const double reach = push + std::sqrt(push * push + 2.0 * m_gravity * left);
    const double steps =
        reach > 0.0 ? 2.0 * left / (reach * m_dt) : std::numeric_limits<double>::infinity();
    if (steps < static_cast<double>(m_steps - index))
        m_steps = index + static_cast<std::size_t>(steps);
}

} // namespace cradle
