// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/flight_reading.h"
#include "tasks/judging/occasions.h"
#include "tasks/judging/stray_wall.h"

#include <algorithm>
#include <functional>
#include <memory>

namespace cradle {

/// A step of free flight in a long run; whether it is right is not known.
struct FlightOccasion {
    int circle = 0;
    Circle before{};
    Circle after{};
    Occasion when{};
};

/// Steps of all circles here and there, early and late, in one run of \p program under the gravity
/// of the own scene; none where laws move the circles, or the program does not go on from where
/// they are set.
[[nodiscard]] std::vector<FlightOccasion> measureFlightAgain(const QString *program,
                                                             const Ground &ground);

/// All that is known of the free motion of a program.
class MeasuredFlight
{
public:
    MeasuredFlight(const QString *program, const Ground &ground);

    /// Measured where it is asked for, once.
    [[nodiscard]] const std::vector<Flight> &at(Vec2 gravity, double h) const;
    [[nodiscard]] const Flight &at(Vec2 gravity, double h, int circle) const
    {
        return at(gravity, h)[static_cast<std::size_t>(circle)];
    }

    /// The student's own scene as he starts it, and how its circles then fall in its first step.
    struct Own {
        Preset scene{};
        std::vector<Vec2> accelerations{}; ///< m/s²; none where the program stops
        std::vector<Vec2> later{};         ///< the same of the second step, m/s²
        std::vector<Vec2> ways{};          ///< of the first step, m

        /// How much the second step differs from the first: 0 of a fall, about 1 of a hit or a
        /// stop, which happen once, between them where something brakes.
        [[nodiscard]] double unsteadiness(std::size_t i) const
        {
            return length(later[i] - accelerations[i]) / std::max(length(accelerations[i]), 1e-9);
        }
    };
    [[nodiscard]] const Own &own() const { return m_own; }
    /// The acceleration of circle \p i where it is set at rest somewhere else in that scene, m/s².
    [[nodiscard]] std::optional<Vec2> ownFallElsewhere(int i) const;

    /// The acceleration of circle \p i in the first step of that scene where all others are set
    /// somewhere else, m/s².
    [[nodiscard]] std::optional<Vec2> ownFallApart(int i) const;

    /// The acceleration of a circle \p i at rest that is wider and denser than those of at(), m/s².
    [[nodiscard]] std::optional<Vec2> heavierFall(Vec2 gravity, double h, int i) const;

    /// The second step of a circle \p i that starts as in the first flight of at(), while all
    /// others rest elsewhere; nothing where there are none.
    [[nodiscard]] std::optional<Flight::Step> whileOthersRest(Vec2 gravity, double h, int i) const;

    /// The second step of a circle \p i that starts as in the first flight of at(), with that
    /// restitution; nothing where the program stops.
    [[nodiscard]] std::optional<Flight::Step> withRestitution(Vec2 gravity, double h, int i,
                                                              double restitution) const;

    /// The first step of a circle \p i without gravity that is \p slower times as fast as in the
    /// first flight of at(), and its velocity at the start; nothing where the program stops.
    [[nodiscard]] std::optional<Flight::Step> slowStart(double slower, double h, int i) const;

    /// The first \p count steps of a circle \p i that starts as in the first flight of at(); fewer
    /// where the program stops or it comes to a wall.
    [[nodiscard]] std::vector<Flight::Step> firstSteps(Vec2 gravity, double h, int i,
                                                       FirstSteps which, int count) const
    {
        return measureFirstSteps(m_program, m_ground, gravity, h, static_cast<std::size_t>(i),
                                 which, count);
    }

    /// See measureStrayWall().
    [[nodiscard]] std::optional<StrayWall> strayWall(Vec2 gravity, double h, int i,
                                                     const Flight &right) const
    {
        return measureStrayWall(m_program, m_ground, right, gravity, h, i);
    }

    /// Whether another program flies in the same way.
    [[nodiscard]] bool isLike(const MeasuredFlight &other) const;

private:
    /// Whether the first steps of a run are made alike, which the second alone does not tell.
    [[nodiscard]] bool beginsLike(const MeasuredFlight &other) const;
    /// The own scene, in which \p set has changed every circle at hand of a place apart from all
    /// others, m; nothing where the program does not run.
    [[nodiscard]] std::unique_ptr<Probe>
    ownWith(const std::function<void(Circle &, int circle, Vec2 place)> &set) const;
    /// The acceleration of circle \p i in the next step of \p probe of the own scene, m/s².
    [[nodiscard]] std::optional<Vec2> nextFall(Probe &probe, int i) const;

    struct Measured {
        Vec2 gravity;
        double timestep;
        std::vector<Flight> flights;
    };

    const QString *m_program;
    const Ground &m_ground;
    mutable std::vector<std::unique_ptr<const Measured>> m_measured{};
    Own m_own{};
};

} // namespace cradle
