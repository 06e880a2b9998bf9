// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/disc_grid.h"

namespace cradle {

/// Who can meet whom in a step, as long as nobody is faster than was foreseen.
class ContinuousNeighbours
{
public:
    /// Looks around \p circles at the start of a step of \p dt s, under \p gravity (its size,
    /// m/s²), for up to twice the fastest speed there is and what gravity gives.
    void find(std::span<const Circle> circles, double gravity, double dt);
    /// Looks around the same circles again if \p speed (m/s) is more than was foreseen; twice
    /// that, and what gravity gives, is from now on. \return whether it was
    bool foresee(double speed);

    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t circle) const
    {
        return std::span(m_neighbours)
            .subspan(m_first[circle], m_first[circle + 1] - m_first[circle]);
    }

private:
    void look(double fastest);

    double m_dt = 0.0;
    double m_gain = 0.0;                ///< that gravity gives in the step, m/s
    double m_foreseen = 0.0;            ///< m/s; for up to this the neighbours are all
    std::vector<Vec2> m_places;         ///< at the start of the step, m
    std::vector<double> m_radii;        ///< m
    DiscGrid m_grid;                    ///< of the places
    std::vector<std::uint32_t> m_first; ///< of each circle in m_neighbours, and the end
    std::vector<std::uint32_t> m_neighbours;
};

} // namespace cradle
