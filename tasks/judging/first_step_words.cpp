// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/flight_scenes.h"
#include "tasks/judging/likeness.h"

namespace cradle {

namespace {

/// Judges the first step of a run by the law that the next ones follow.
class FirstStepJudge : FlightComparison
{
public:
    explicit FirstStepJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> judge() const
    {
        const Flight &f = flight(0);
        if (!f.isKnown || !right().isKnown || isOdd(right()))
            return std::nullopt;
        const Motion next = expected(f);
        if (isOddTurn(f))
            return firstSaid(
                FlightText::tr("Started with %1 m/s, it has %2 m/s after the first step of %3 s; "
                               "made as the second is, that step gives it %4 m/s.")
                    .arg(brief(f.startedWith), briefBeside(f.turnedInto, next.velocity),
                         briefTimestep(timestep()), briefBeside(next.velocity, f.turnedInto)),
                false);
        if (isOddWay(f))
            return firstSaid(
                FlightText::tr("Started with %1 m/s, it goes %2 m in the first step of %3 s; made "
                               "as the second is, that step goes %4 m.")
                    .arg(brief(f.startedWith), briefBeside(f.firstWay, next.position),
                         briefTimestep(timestep()), briefBeside(next.position, f.firstWay)),
                true);
        return std::nullopt;
    }

private:
    /// The way of the first step, m, and the velocity after it, m/s, by that law.
    [[nodiscard]] Motion expected(const Flight &f) const
    {
        return f.after({.position = {}, .velocity = f.startedWith}, timestep());
    }
    [[nodiscard]] bool isOddTurn(const Flight &f) const
    {
        return !isAlike(f.turnedInto, expected(f).velocity);
    }
    [[nodiscard]] bool isOddWay(const Flight &f) const
    {
        return !isAlike(f.firstWay, expected(f).position, 1e-3 * timestep());
    }
    [[nodiscard]] bool isOdd(const Flight &f) const { return isOddTurn(f) || isOddWay(f); }

    [[nodiscard]] FlightSaid firstSaid(const QString &seen, bool isPosition) const
    {
        FlightSaid fault = said(FlightText::tr("The first step of %who is made in another way"),
                                seen + QLatin1Char(' ')
                                    + FlightText::tr("Look at what your program keeps from one "
                                                     "step to the next, and at what it has of that "
                                                     "before the first."),
                                isPosition);
        fault.moment.step = 1;
        fault.suspect = Suspect::Kept;
        return fault;
    }
};

} // namespace

std::optional<FlightSaid> firstStepSaid(const FlightComparison &comparison)
{
    return FirstStepJudge(comparison).judge();
}

} // namespace cradle
