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
    /// The same again in long runs; at the same \p walls whenever it is asked for.
    [[nodiscard]] const std::vector<FlightOccasion> &flightAgain() const
    {
        if (!m_flightAgain)
            m_flightAgain = measureFlightAgain(m_program, m_ground);
        return *m_flightAgain;
    }
    [[nodiscard]] const std::vector<WallOccasion> &wallsAgain(const std::vector<Wall> &walls) const
    {
        if (!m_wallsAgain)
            m_wallsAgain = measureWallsAgain(m_program, m_ground, flight(), walls);
        return *m_wallsAgain;
    }
    [[nodiscard]] const std::vector<PairOccasion> &pairAgain() const
    {
        if (!m_pairAgain)
            m_pairAgain = measurePairAgain(m_program, m_ground, flight());
        return *m_pairAgain;
    }
    /// And of hits of all kinds.
    [[nodiscard]] const std::vector<PairHit> &pairAnswers() const
    {
        if (!m_pairAnswers)
            m_pairAnswers = measurePairAnswers(m_program, m_ground, flight());
        return *m_pairAnswers;
    }
    /// And of circles that fly along the line of centres.
    [[nodiscard]] const std::vector<PairHit> &pairChases() const
    {
        if (!m_pairChases)
            m_pairChases = measurePairChases(m_program, m_ground, flight());
        return *m_pairChases;
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
    mutable std::optional<std::vector<FlightOccasion>> m_flightAgain{};
    mutable std::optional<std::vector<WallOccasion>> m_wallsAgain{};
    mutable std::optional<std::vector<PairOccasion>> m_pairAgain{};
    mutable std::optional<std::vector<PairHit>> m_pairAnswers{};
    mutable std::optional<std::vector<PairHit>> m_pairChases{};
};

} // namespace cradle
