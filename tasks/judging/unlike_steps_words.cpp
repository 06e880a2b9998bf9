// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/likeness.h"

namespace cradle {

namespace {

/// Judges whether the steps of a run, from the second on, follow one law.
class UnlikeStepsJudge : FlightComparison
{
public:
    explicit UnlikeStepsJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> judge()
    {
        if (!flight(0).isKnown || !right().isKnown || hasPull())
            return std::nullopt;
        // Who waits until a time is over may do so with the shorter timesteps alone.
        for (m_at = 0; m_at < m_ground.timesteps.size(); ++m_at) {
            if (m_at > 0 && isAsAsked())
                continue;
            if (auto unlike = judgeSteps())
                return unlike;
        }
        return std::nullopt;
    }

private:
    static constexpr int looked = 6; ///< steps of a run
    static constexpr int shown = 4;  ///< of these

    [[nodiscard]] double timestep() const { return m_ground.timesteps[m_at]; }
    [[nodiscard]] const Flight &flown() const { return flight(m_at); }
    [[nodiscard]] const Flight &wantedFlight() const
    {
        return m_right.at(gravity(), timestep(), m_i);
    }

    /// Whether the second step is that of the reference.
    [[nodiscard]] bool isAsAsked() const
    {
        return isAlike(flown().acceleration, wantedFlight().acceleration)
               && isAlike(flown().growth, wantedFlight().growth)
               && isAlike(flown().way, wantedFlight().way)
               && isAlike(flown().drift, wantedFlight().drift, 1e-3 * timestep());
    }

    [[nodiscard]] std::optional<FlightSaid> judgeSteps()
    {
        if (!flown().isKnown || !wantedFlight().isKnown)
            return std::nullopt;
        m_steps = m_own.firstSteps(gravity(), timestep(), m_i, FirstSteps::Going, looked);
        if (m_steps.size() < shown
            || std::all_of(m_steps.begin() + 1, m_steps.end(),
                           [&](const Flight::Step &step) { return follows(step); })
            || !hangsOnKept())
            return std::nullopt;
        const std::vector<Vec2> turns = offs(false);
        if (areUnlike(turns))
            return told(turns, false);
        // What way is right hangs on the velocity: where that is wrong, it is told first.
        return length(turns.front()) > slack() ? std::nullopt
                                               : std::optional(told(offs(true), true));
    }

    /// Whether steps from one and the same start differ, from the second on.
    [[nodiscard]] bool hangsOnKept() const
    {
        const std::vector<Flight::Step> again =
            m_own.firstSteps(gravity(), timestep(), m_i, FirstSteps::Repeated, looked);
        return again.size() > 1
               && std::any_of(again.begin() + 2, again.end(), [&](const Flight::Step &step) {
                      return !isAlike(step.turn, again[1].turn)
                             || !isAlike(step.way, again[1].way, 1e-3 * timestep());
                  });
    }
    /// What \p flight makes of the velocity before \p step.
    [[nodiscard]] Motion by(const Flight &flight, const Flight::Step &step) const
    {
        return flight.after({.position = {}, .velocity = step.velocity}, timestep());
    }
    /// Whether the law that the second step tells is that of \p step, too.
    [[nodiscard]] bool follows(const Flight::Step &step) const
    {
        const Motion next = by(flown(), step);
        return isAlike(step.velocity + step.turn, next.velocity)
               && isAlike(step.way, next.position, 1e-3 * timestep());
    }

    /// The way, m, or the change of the velocity, m/s.
    static Vec2 seen(const Flight::Step &step, bool isWay) { return isWay ? step.way : step.turn; }
    /// What is right of that after the velocity before \p step.
    [[nodiscard]] Vec2 wanted(const Flight::Step &step, bool isWay) const
    {
        const Motion next = by(wantedFlight(), step);
        return isWay ? next.position : next.velocity - step.velocity;
    }
    /// By how much each step is wrong.
    [[nodiscard]] std::vector<Vec2> offs(bool isWay) const
    {
        std::vector<Vec2> all;
        for (const Flight::Step &step : m_steps)
            all.push_back(seen(step, isWay) - wanted(step, isWay));
        return all;
    }

    /// Whether those differ by more than rounding makes.
    [[nodiscard]] bool areUnlike(const std::vector<Vec2> &offs) const
    {
        return std::any_of(offs.begin(), offs.end(),
                           [&](Vec2 off) { return length(off - offs.front()) > slack(); });
    }
    /// What the steps are wrong by grows by the same in each.
    [[nodiscard]] bool areGrowing(const std::vector<Vec2> &offs) const
    {
        const Vec2 more = offs[1] - offs[0];
        for (std::size_t k = 1; k < offs.size(); ++k) {
            if (length(offs[k] - offs[k - 1] - more) > slack())
                return false;
        }
        return length(more) > slack();
    }
    [[nodiscard]] double slack() const { return 1e-5 * timestep(); }

    /// The first of them, one after the other, as \p text says it.
    [[nodiscard]] QString inARow(const QString &text, const std::vector<Vec2> &values) const
    {
        return text.arg(brief(m_steps.front().velocity), briefTimestep(timestep()),
                        brief(values[0]), brief(values[1]), brief(values[2]), brief(values[3]));
    }

    /// Whether the same is right in each of those that are told.
    [[nodiscard]] bool areWantedAlike(bool isWay) const
    {
        const Vec2 asked = wanted(m_steps.front(), isWay);
        return std::all_of(m_steps.begin(), m_steps.begin() + shown, [&](const Flight::Step &step) {
            return length(wanted(step, isWay) - asked) < slack();
        });
    }
    [[nodiscard]] QString seenSteps(const std::vector<Vec2> &offs, bool isWay) const
    {
        if (!areWantedAlike(isWay))
            return inARow(isWay ? FlightText::tr("Started with %1 m/s, in the first four steps of "
                                                 "%2 s it goes %3, %4, %5 and %6 m more than is "
                                                 "right of the velocity before each.")
                                : FlightText::tr("Started with %1 m/s, in the first four steps of "
                                                 "%2 s its velocity changes by %3, %4, %5 and %6 "
                                                 "m/s more than is right."),
                          offs);
        std::vector<Vec2> changes;
        for (const Flight::Step &step : m_steps)
            changes.push_back(seen(step, isWay));
        return inARow(isWay ? FlightText::tr("Started with %1 m/s, in the first four steps of %2 s "
                                             "it goes %3, %4, %5 and %6 m; %7 m is right in each.")
                            : FlightText::tr("Started with %1 m/s, in the first four steps of %2 s "
                                             "its velocity changes by %3, %4, %5 and %6 m/s; %7 "
                                             "m/s is right in each."),
                      changes)
            .arg(brief(wanted(m_steps.front(), isWay)));
    }

    [[nodiscard]] FlightSaid told(const std::vector<Vec2> &offs, bool isWay) const
    {
        const QString look =
            areGrowing(offs)
                ? FlightText::tr("From step to step that grows by the same: look at what your "
                                 "program adds up, or counts, since the start.")
                : FlightText::tr("Look at what your program counts, or keeps from one step to the "
                                 "next, and at what is asked before these lines.");
        FlightSaid fault = said(FlightText::tr("Not every step of %who is made alike"),
                                seenSteps(offs, isWay) + QLatin1Char(' ') + look, isWay);
        fault.moment.stage = flightStage(m_ground, gravity(), timestep());
        fault.moment.step = 1;
        const auto off = std::find_if(offs.begin(), offs.end(),
                                      [&](Vec2 each) { return length(each) > slack(); });
        if (off != offs.end())
            fault.moment.step = off - offs.begin() + 1;
        fault.hidesWalls = true;
        fault.isOfOne = !areWantedAlike(isWay);
        return fault;
    }

    std::size_t m_at = 0; ///< the timestep, of those of the checks
    std::vector<Flight::Step> m_steps{};
};

} // namespace

std::optional<FlightSaid> unlikeStepsSaid(const FlightComparison &comparison)
{
    return UnlikeStepsJudge(comparison).judge();
}

} // namespace cradle
