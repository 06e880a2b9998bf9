// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/likeness.h"

#include <algorithm>

namespace cradle {

namespace {

/// Judges a way that is no share of the velocity.
class OddWayJudge : FlightComparison
{
public:
    explicit OddWayJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    /// A way that is no share of the own velocity.
    [[nodiscard]] FlightSaid judge() const
    {
        const Flight::Step &a = flight(0).seen[0];
        const Flight::Step &b = flight(0).seen[1];
        const double h = timestep();
        const auto two = [&](const QString &text, Vec2 one, Vec2 other) {
            return text.arg(brief(a.velocity), briefTimestep(h), briefBeside(a.way, one),
                            brief(b.velocity), briefBeside(b.way, other), briefBeside(one, a.way),
                            briefBeside(other, b.way));
        };
        const QString seen =
            two(FlightText::tr("With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m, "
                               "with %4 m/s %5 m; v Δt is %6 and %7 m."),
                h * a.velocity, h * b.velocity);
        const auto tell = [&](const QString &headline, const QString &why) {
            return said(headline, seen + QLatin1Char(' ') + why, true);
        };
        const QString own =
            FlightText::tr("Each part of the position changes by its own part of the velocity.");
        switch (flight(0).crossing) {
        case Flight::Crossing::XMovesY:
            return tell(FlightText::tr("The x part of the velocity moves %who in y"), own);
        case Flight::Crossing::YMovesX:
            return tell(FlightText::tr("The y part of the velocity moves %who in x"), own);
        case Flight::Crossing::Exchanged:
            if (isWrittenCrossed())
                return said(
                    FlightText::tr("x and y of the velocity of %who are exchanged"),
                    FlightText::tr("Started with %1 m/s, it goes %2 m in the first step of %3 s "
                                   "and has %4 m/s after it. Each part of the velocity goes on "
                                   "from itself: look at the line that writes it down.")
                        .arg(brief(flight(0).startedWith), brief(flight(0).firstWay),
                             briefTimestep(h), brief(flight(0).turnedInto)),
                    false);
            return tell(FlightText::tr("x and y of the velocity are exchanged in the way of %who"),
                        own);
        case Flight::Crossing::None:
            break;
        }
        if (const auto fault = methodByVelocity(*this))
            return *fault;
        const QString look = FlightText::tr("Look at what the line that changes the position "
                                            "takes, and at what is asked before it.");
        if (length(right().drift) < 1e-9
            || m_ground.flights[static_cast<std::size_t>(m_i)].shares.size() != 1)
            return tell(FlightText::tr("The way of %who in a step is not v Δt"), look);
        // Where a method is asked for, that is right, and not v Δt.
        const auto wanted = [&](const Flight::Step &step) {
            return right().after({.position = {}, .velocity = step.velocity}, h).position;
        };
        const Flight::Step &rest = flight(0).fromRest;
        QString told = two(FlightText::tr("With the velocity %1 m/s and Δt = %2 s the way of a "
                                          "step is %3 m, with %4 m/s %5 m; %6 and %7 m are right."),
                           wanted(a), wanted(b));
        if (isAlike(rest.way, wanted(rest)))
            told += QLatin1Char(' ') + FlightText::tr("Let go at rest, it goes as it should.");
        return said(FlightText::tr("The way of %who in a step is wrong"),
                    told + QLatin1Char(' ') + look, true);
    }

    /// Whether the first step takes it so much farther than by its velocity, and than the second
    /// one, that the two are made by different lines.
    [[nodiscard]] std::optional<FlightSaid> leap() const
    {
        constexpr double farther = 10.0;
        const Flight &f = flight(0);
        const double h = timestep();
        const double near =
            std::max({h * length(f.startedWith), h * length(f.turnedInto), length(f.seen[0].way),
                      length(f.seen[1].way), length(right().firstWay)});
        if (length(f.firstWay) <= farther * near)
            return std::nullopt;
        FlightSaid fault = said(
            FlightText::tr("A step takes %who much farther than its velocity does"),
            FlightText::tr("Started with %1 m/s, away from every wall and every other circle, it "
                           "goes %2 m in the first step of %3 s; v Δt is %4 m. Look at which lines "
                           "change the position, and at what is asked before them.")
                .arg(brief(f.startedWith), brief(f.firstWay), briefTimestep(h),
                     brief(h * f.startedWith)),
            true);
        fault.moment.step = 1;
        return fault;
    }

private:
    /// Whether the first step goes by the velocity of the start, and what that becomes has x and y
    /// exchanged.
    [[nodiscard]] bool isWrittenCrossed() const
    {
        const Flight &f = flight(0);
        const Vec2 way = timestep() * f.startedWith;
        const Vec2 crossed{f.startedWith.y, f.startedWith.x};
        const double blur = 0.2 * length(crossed - f.startedWith);
        return length(f.firstWay - way) < 0.2 * length(way)
               && length(f.turnedInto - crossed) < blur;
    }
};

} // namespace

FlightSaid oddWaySaid(const FlightComparison &comparison)
{
    return OddWayJudge(comparison).judge();
}

std::optional<FlightSaid> leapingWaySaid(const FlightComparison &comparison)
{
    return OddWayJudge(comparison).leap();
}

} // namespace cradle
