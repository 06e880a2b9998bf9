// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/measured_pair.h"
#include "tasks/judging/measured_wall.h"

#include <optional>

namespace cradle {

/// The laws of one program, each measured when it is asked for.
class MeasuredLaws
{
public:
    /// \param program  null where the laws of the scene move the circles; outlives this
    MeasuredLaws(const QString *program, const Ground &ground)
        : m_program(program)
        , m_ground(ground)
    {
    }

    [[nodiscard]] const MeasuredFlight &flight() const
    {
        if (!m_flight)
            m_flight.emplace(m_program, m_ground);
        return *m_flight;
    }
    [[nodiscard]] const MeasuredWalls &walls() const
    {
        if (!m_walls)
            m_walls.emplace(m_program, m_ground, flight());
        return *m_walls;
    }
    [[nodiscard]] const MeasuredPair &pair() const
    {
        if (!m_pair)
            m_pair.emplace(m_program, m_ground, flight());
        return *m_pair;
    }
    /// Whether they were measured already.
    [[nodiscard]] bool knowsWalls() const { return m_walls.has_value(); }
    [[nodiscard]] bool knowsPair() const { return m_pair.has_value(); }

private:
    const QString *m_program;
    const Ground &m_ground;
    mutable std::optional<MeasuredFlight> m_flight{};
    mutable std::optional<MeasuredWalls> m_walls{};
    mutable std::optional<MeasuredPair> m_pair{};
};

} // namespace cradle
