// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/flight_scenes.h"
#include "tasks/judging/measured_flight.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>

namespace cradle {

struct FlightText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// What is said of one circle; the same of several is said once, with their names in place of %who.
struct FlightSaid {
    QString headline;
    QString body;
    Moment moment{};
    bool isMethod = false; ///< it is about the integrator
    Suspect suspect = Suspect::Answer;
    bool hidesHits = false;  ///< hits are not seen through it
    bool hidesWalls = false; ///< what is shot at walls is not seen through it
    bool isOfOne = false;    ///< its numbers are of that circle alone, though others fly like it
    bool isOfWall = false;   ///< a wall does it, see strayWallSaid()
    Topic topic = Topic::Other;
};

/// The flight of one circle beside that of the reference.
class FlightComparison
{
public:
    /// Relative: what is more is another law, not another rounding.
    static constexpr double wrong = 1e-4;
    /// Who goes so far in a step, m, comes to a wall within the flights: a small part of the
    /// square.
    static constexpr double farInAStep = 0.5;
    /// Then gravity and velocities of so much are tried in place of the usual ones.
    static constexpr double weak = 1e-3;

    FlightComparison(const MeasuredFlight &own, const MeasuredFlight &right, const Ground &ground,
                     int circle)
        : m_own(own)
        , m_right(right)
        , m_ground(ground)
        , m_i(circle)
    {
    }

protected:
    using Part = std::function<double(const Flight &)>;

    [[nodiscard]] Vec2 gravity() const { return m_ground.gravities.front(); }
    [[nodiscard]] double timestep() const { return m_ground.timesteps.front(); }
    [[nodiscard]] const Flight &flight(std::size_t h) const
    {
        return m_own.at(gravity(), m_ground.timesteps[h], m_i);
    }
    /// Of the reference, under the same conditions as flight(0).
    [[nodiscard]] const Flight &right() const { return m_right.at(gravity(), timestep(), m_i); }
    /// Where a place pulls, its flights are not alike for that reason alone.
    [[nodiscard]] bool hasPull() const
    {
        return flight(0).pull != Vec2{} || right().pull != Vec2{};
    }
    /// How far a growth of the velocity that nobody asked for shows in a step, relative.
    [[nodiscard]] double growthBlur(std::size_t h) const
    {
        const Vec2 off =
            flight(h).growth - m_right.at(gravity(), m_ground.timesteps[h], m_i).growth;
        return 1.1 * std::max(std::abs(off.x), std::abs(off.y)) * m_ground.timesteps[h];
    }
    [[nodiscard]] Moment moment(bool isPosition, Vec2 g) const
    {
        return {flightStage(m_ground, g, timestep()), 2, {m_i}, isPosition};
    }
    [[nodiscard]] FlightSaid said(const QString &headline, const QString &body,
                                  bool isPosition) const
    {
        return {headline, body, moment(isPosition, gravity())};
    }

    /// \p part divided by that of the reference, for every timestep.
    [[nodiscard]] TimestepPattern pattern(Vec2 g, const Part &part) const
    {
        std::vector<std::pair<double, double>> factors;
        for (const double h : m_ground.timesteps)
            factors.emplace_back(h, part(m_own.at(g, h, m_i)) / part(m_right.at(g, h, m_i)));
        return patternOf(factors);
    }

    /// Where a number stands for the timestep, one that is another number shows it; where \p part
    /// is right with some timesteps, the one with which it is most wrong does.
    [[nodiscard]] std::size_t shownTimestep(const TimestepPattern &p, const Part &part = {}) const
    {
        const bool fixed = p.kind == TimestepPattern::Kind::Fixed;
        if (!fixed && (p.kind != TimestepPattern::Kind::Other || !part))
            return 0;
        const auto &all = m_ground.timesteps;
        const auto off = [&](double h) {
            if (fixed)
                return std::abs(std::log(h / p.value));
            return std::abs(part(m_own.at(gravity(), h, m_i)) / part(m_right.at(gravity(), h, m_i))
                            - 1.0);
        };
        const auto most = std::max_element(all.begin(), all.end(),
                                           [&](double a, double b) { return off(a) < off(b); });
        return static_cast<std::size_t>(most - all.begin());
    }

    [[nodiscard]] static bool isRight(const TimestepPattern &p)
    {
        return p.kind == TimestepPattern::Kind::Constant && std::abs(p.value - 1.0) < wrong;
    }

    /// What brakes or drives the velocity shows in \p part of the same step as well.
    [[nodiscard]] bool isBlurred(Vec2 g, const Part &part) const
    {
        for (std::size_t h = 0; h < m_ground.timesteps.size(); ++h) {
            const double step = m_ground.timesteps[h];
            const double factor = part(m_own.at(g, step, m_i)) / part(m_right.at(g, step, m_i));
            if (!(std::abs(factor - 1.0) <= growthBlur(h)))
                return false;
        }
        return growthBlur(0) > 0.0;
    }

    const MeasuredFlight &m_own;
    const MeasuredFlight &m_right;
    const Ground &m_ground;
    int m_i;
};

/// All that is wrong with the flight of one circle, worst first.
[[nodiscard]] std::vector<FlightSaid> flightSaid(const FlightComparison &comparison);

/// Whether velocity and place do not follow from those before, or not from the circle's own.
[[nodiscard]] std::optional<FlightSaid> carriedSaid(const FlightComparison &comparison);

/// Whether a part of the place after a step is that of the other part, or the same wherever the
/// circle started.
[[nodiscard]] std::optional<FlightSaid> placeSaid(const FlightComparison &comparison);

/// Whether it moves otherwise while the others are elsewhere.
[[nodiscard]] std::optional<FlightSaid> othersSaid(const FlightComparison &comparison);

/// Whether a step is made with another timestep, or not at all.
[[nodiscard]] std::optional<FlightSaid> stepSaid(const FlightComparison &comparison);

/// That the steps of a run, from the second on, are not made alike; the second tells their law
/// only if the others follow it.
[[nodiscard]] std::optional<FlightSaid> unlikeStepsSaid(const FlightComparison &comparison);
/// That the first step of a run is not made as the next ones are, which are alike.
[[nodiscard]] std::optional<FlightSaid> firstStepSaid(const FlightComparison &comparison);
/// That a wall turns it round far from where that is, which nothing of the flights explains.
[[nodiscard]] std::optional<FlightSaid> strayWallSaid(const FlightComparison &comparison);
/// What is wrong with the way of a circle in a step; the first that is found.
[[nodiscard]] std::optional<FlightSaid> waySaid(const FlightComparison &comparison);
/// The same of one that is no share of the velocity.
[[nodiscard]] FlightSaid oddWaySaid(const FlightComparison &comparison);
/// That the first step of a run takes a circle far away, and the next ones do not.
[[nodiscard]] std::optional<FlightSaid> leapingWaySaid(const FlightComparison &comparison);

/// What is wrong with the fall of a circle under gravity; the first that is found.
[[nodiscard]] std::optional<FlightSaid> fallSaid(const FlightComparison &comparison);
/// Whether a heavier circle falls otherwise.
[[nodiscard]] std::optional<FlightSaid> heavierSaid(const FlightComparison &comparison,
                                                    Vec2 gravity);
/// The same where it is so strong that nothing else can be told of the flights.
[[nodiscard]] std::optional<FlightSaid> strongFallSaid(const FlightComparison &comparison);
/// What gravity adds to the place, where that is so much that nothing else can be told.
[[nodiscard]] std::optional<FlightSaid> strongDriftSaid(const FlightComparison &comparison);
/// The same of the way by its velocity.
[[nodiscard]] std::optional<FlightSaid> strongWaySaid(const FlightComparison &comparison);
/// What is odd in the student's own scene alone.
[[nodiscard]] std::optional<FlightSaid> ownSceneSaid(const FlightComparison &comparison);

/// Whether e, which is of hits, changes its velocity.
[[nodiscard]] std::optional<FlightSaid> lossSaid(const FlightComparison &comparison);

/// Whether its place, or its velocity, changes its velocity otherwise than asked.
[[nodiscard]] std::optional<FlightSaid> pullSaid(const FlightComparison &comparison);
[[nodiscard]] std::optional<FlightSaid> turnsRoundSaid(const FlightComparison &comparison);
[[nodiscard]] std::optional<FlightSaid> growthSaid(const FlightComparison &comparison);
/// Whether a step adds something to the place that is no share of g Δt², which no method does.
[[nodiscard]] std::optional<FlightSaid> driftSaid(const FlightComparison &comparison);
/// Whether one velocity is moved by one method and another by another.
[[nodiscard]] std::optional<FlightSaid> methodByVelocity(const FlightComparison &comparison);
/// Whether the circle moves by another integrator than those that are asked for.
/// \param isFallRight  else only a method that is known and is none of those asked for
[[nodiscard]] std::optional<FlightSaid> methodSaid(const FlightComparison &comparison,
                                                   bool isFallRight);
/// Whether two shares of g Δt² that a step adds to v Δt are of the same method.
[[nodiscard]] bool isOneMethod(double share, double other);
/// The method that adds that share of g Δt² to v Δt; empty if none does.
[[nodiscard]] QString methodName(double share);
/// How far a step goes by the method that adds that share of g Δt²: "v Δt + ½ g Δt²".
[[nodiscard]] QString wayBy(double share);
/// What is wrong with the methods of all circles together.
[[nodiscard]] std::optional<LawDeviation> methodsTogether(const MeasuredFlight &own,
                                                          const Ground &ground);

} // namespace cradle
