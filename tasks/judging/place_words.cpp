// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_comparison.h"

namespace cradle {

namespace {

using Follows = Flight::Follows;

/// Judges whether each part of the place goes on from itself.
class PlaceJudge : FlightComparison
{
public:
    explicit PlaceJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> place() const
    {
        const bool isOtherX = is(Follows::Other, &Flight::xFollows);
        const bool isOtherY = is(Follows::Other, &Flight::yFollows);
        if (isOtherX || isOtherY)
            return tell(isOtherX && isOtherY
                            ? FlightText::tr("A step exchanges x and y in the place of %who")
                        : isOtherX ? FlightText::tr("A step takes y for x in the place of %who")
                                   : FlightText::tr("A step takes x for y in the place of %who"),
                        FlightText::tr("Each part of the place goes on from itself: look at which "
                                       "part stands where."));
        const bool isSetX = is(Follows::Nothing, &Flight::xFollows);
        const bool isSetY = is(Follows::Nothing, &Flight::yFollows);
        if ((!isSetX && !isSetY) || flight(0).keepsOwnPlace)
            return std::nullopt;
        return tell(
            isSetX && isSetY ? FlightText::tr("Every step puts %who at the same place")
            : isSetX         ? FlightText::tr("Every step puts %who at the same x")
                             : FlightText::tr("Every step puts %who at the same y"),
            (isSetX && isSetY ? FlightText::tr("So it is from every start tried.")
             : isSetX         ? FlightText::tr("It has that x from every start tried.")
                              : FlightText::tr("It has that y from every start tried."))
                + QLatin1Char(' ')
                + FlightText::tr("A step *adds* a way to the old position: look at the lines that "
                                 "put it there, and at what is asked before them."));
    }

private:
    [[nodiscard]] bool is(Follows what, Follows Flight::*part) const
    {
        return flight(0).*part == what && right().*part != what;
    }

    [[nodiscard]] FlightSaid tell(const QString &headline, const QString &why) const
    {
        const Flight &f = flight(0);
        FlightSaid fault = said(
            headline,
            FlightText::tr("Started at %1 m with %2 m/s, it is at %3 m one step of %4 s later.")
                    .arg(brief(f.startedAt), brief(f.startedWith), brief(f.putAt),
                         briefTimestep(timestep()))
                + QLatin1Char(' ') + why,
            true);
        fault.moment.step = 1;
        return fault;
    }
};

} // namespace

std::optional<FlightSaid> placeSaid(const FlightComparison &comparison)
{
    return PlaceJudge(comparison).place();
}

} // namespace cradle
