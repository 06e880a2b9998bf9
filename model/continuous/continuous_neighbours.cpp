// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_step.h"

#include <algorithm>

namespace cradle {

// Who can meet whom in a step, and who takes part in a moment.

namespace {

/// So many are looked at all together.
constexpr std::size_t fewBodies = 8;
constexpr double rounding = 1e-9;

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

} // namespace

/// Finds who can meet whom in this step, at speeds up to twice \p fastest (m/s). Where something
/// gets faster than that they are found again.
void ContinuousStep::findNeighbours(double fastest)
{
    m_foreseenSpeed = 2.0 * (fastest + length(m_rules->gravity) * m_dt);
    const double travel = m_dt * (m_foreseenSpeed + length(m_rules->gravity) * m_dt);
    const std::size_t count = m_bodies.size();
    m_firstNeighbour.assign(1, 0);
    m_neighbours.clear();
    double widest = 0.0;
    for (const Circle &c : m_world->circles)
        widest = std::max(widest, c.radius);
    const bool few = count <= fewBodies;
    if (!few)
        m_grid.build(count, [this](std::size_t i) { return m_places[i]; });
    for (std::uint32_t i = 0; i < count; ++i) {
        const double radius = m_world->circles[i].radius;
        const auto look = [&](std::uint32_t j) {
            const double near = radius + m_world->circles[j].radius + 2.0 * travel;
            if (j != i && (few || lengthSquared(m_places[j] - m_places[i]) <= near * near))
                m_neighbours.push_back(j);
        };
        if (few) {
            for (std::uint32_t j = 0; j < count; ++j)
                look(j);
        } else {
            m_grid.visitRuns(m_places[i], (radius + widest + 2.0 * travel) * (1.0 + rounding),
                             [&](std::uint32_t begin, std::uint32_t end) {
                                 for (std::uint32_t slot = begin; slot < end; ++slot)
                                     look(m_grid.sorted()[slot]);
                             });
        }
        m_firstNeighbour.push_back(static_cast<std::uint32_t>(m_neighbours.size()));
    }
}

/// Looks again for neighbours if a body has become faster than was foreseen.
void ContinuousStep::foreseeSpeeds()
{
    double fastest = 0.0;
    for (const std::size_t i : m_touched)
        fastest = std::max(fastest, lengthSquared(m_world->circles[i].velocity));
    fastest = std::sqrt(fastest) + length(m_rules->gravity) * m_dt;
    if (m_bodies.size() <= fewBodies || fastest <= m_foreseenSpeed)
        return;
    findNeighbours(fastest);
    for (std::size_t i = 0; i < m_bodies.size(); ++i)
        touch(i);
}

std::span<const std::uint32_t> ContinuousStep::neighboursOf(std::size_t body) const
{
    return std::span(m_neighbours)
        .subspan(m_firstNeighbour[body], m_firstNeighbour[body + 1] - m_firstNeighbour[body]);
}

/// What rests on a body that is hit is split at the hit, too: the forces between them change.
void ContinuousStep::touchRestingNeighbours()
{
    bool grown = true;
    while (grown) {
        grown = false;
        for (const auto &[a, b] : m_resting) {
            if (m_bodies[at(a)].touched != m_bodies[at(b)].touched) {
                touch(at(a));
                touch(at(b));
                grown = true;
            }
        }
    }
}

} // namespace cradle
