// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_neighbours.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// So many are looked at all together.
constexpr std::size_t fewCircles = 8;
constexpr double rounding = 1e-9;

} // namespace

void ContinuousNeighbours::find(std::span<const Circle> circles, double gravity, double dt)
{
    m_dt = dt;
    m_gain = gravity * dt;
    m_places.clear();
    m_radii.clear();
    double fastest = 0.0;
    for (const Circle &c : circles) {
        m_places.push_back(c.position);
        m_radii.push_back(c.radius);
        fastest = std::max(fastest, lengthSquared(c.velocity));
    }
    look(std::sqrt(fastest));
}

bool ContinuousNeighbours::foresee(double speed)
{
    if (m_places.size() <= fewCircles || speed + m_gain <= m_foreseen)
        return false;
    look(speed + m_gain);
    return true;
}

void ContinuousNeighbours::look(double fastest)
{
    m_foreseen = 2.0 * (fastest + m_gain);
    const double travel = m_dt * (m_foreseen + m_gain);
    const std::size_t count = m_places.size();
    const bool few = count <= fewCircles;
    m_first.assign(1, 0);
    m_neighbours.clear();
    double widest = 0.0;
    for (const double radius : m_radii)
        widest = std::max(widest, radius);
    if (!few)
        m_grid.build(count, [this](std::size_t i) { return m_places[i]; });
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto consider = [&](std::uint32_t j) {
            const double near = m_radii[i] + m_radii[j] + 2.0 * travel;
            if (j != i && (few || lengthSquared(m_places[j] - m_places[i]) <= near * near))
                m_neighbours.push_back(j);
        };
        if (few) {
            for (std::uint32_t j = 0; j < count; ++j)
                consider(j);
        } else {
            m_grid.visitRuns(m_places[i], (m_radii[i] + widest + 2.0 * travel) * (1.0 + rounding),
                             [&](std::uint32_t begin, std::uint32_t end) {
                                 for (std::uint32_t slot = begin; slot < end; ++slot)
                                     consider(m_grid.sorted()[slot]);
                             });
        }
        m_first.push_back(static_cast<std::uint32_t>(m_neighbours.size()));
    }
}

} // namespace cradle
