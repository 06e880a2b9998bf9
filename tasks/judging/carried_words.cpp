// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_comparison.h"

#include <cmath>

namespace cradle {

namespace {

/// Judges whether velocity and place follow from those before, and from the circle's own.
class CarriedJudge : FlightComparison
{
public:
    explicit CarriedJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> carriedOn() const
    {
        const Flight &f = flight(0);
        if (f.follows >= 0 && right().follows < 0)
            return besideAnother(
                FlightText::tr("Every step puts %who where circle %1 is").arg(f.follows + 1),
                FlightText::tr("From every start tried the two are at the same place one step "
                               "later. Each circle has a place and a velocity of its "
                               "own and goes on from those: look at what the lines for "
                               "one take from the other."));
        if (f.borrows >= 0 && right().borrows < 0
            && m_own.at(gravity(), timestep(), f.borrows).borrows == m_i)
            return said(
                FlightText::tr("Each circle goes on with the velocity of the other"),
                FlightText::tr("However they are started, what each has one step later comes from "
                               "the velocity of the other: started with %1 m/s, circle %2 has %3 "
                               "m/s. Each goes on from its own velocity: look at the names in the "
                               "lines that change it, and at what is asked before them.")
                    .arg(brief(f.startedWith), QString::number(m_i + 1), brief(f.turnedInto)),
                false);
        if (f.borrows >= 0 && right().borrows < 0)
            return said(
                FlightText::tr("The velocity of %who is taken from circle %1").arg(f.borrows + 1),
                FlightText::tr("However it is started, what it has one step later comes from "
                               "the velocity of circle %1: started with %2 m/s, it has %3 m/s. "
                               "Each circle goes on from its own velocity: look at the names in "
                               "the line that changes it.")
                    .arg(f.borrows + 1)
                    .arg(brief(f.startedWith), brief(f.turnedInto)),
                false);
        if (const auto fault = stoppedByAnother())
            return fault;
        if (f.onlySlow && !right().onlySlow)
            return said(FlightText::tr("Away from every wall a low speed of %who is taken away"),
                        FlightText::tr("Started with %1 m/s, it has %2 m/s one step later, far "
                                       "from every wall and every other circle; a faster one "
                                       "goes on. Look at the conditions in front of the "
                                       "lines that change the velocity.")
                            .arg(brief(f.startedWith), brief(f.turnedInto)),
                        false);
        if (isStopped() && !keepsOwnVelocity())
            return stopped();
        if (keepsOwnVelocity() && !right().resets && !right().resetsX && !right().resetsY)
            return startSaid(
                f.resets ? FlightText::tr("The velocity of %who at the start is not taken over")
                         : FlightText::tr("The velocity of %who at the start is not taken over "
                                          "whole"),
                (f.resets ? FlightText::tr("Started with %1 m/s, it has %2 m/s one step later, and "
                                           "so it has from every other start tried; later steps "
                                           "go on from that.")
                          : FlightText::tr("Started with %1 m/s, it has %2 m/s one step later; one "
                                           "part is the same from every other start tried, and "
                                           "later steps go on from that."))
                        .arg(brief(f.startedWith), brief(f.turnedInto))
                    + QLatin1Char(' ')
                    + FlightText::tr("A run begins with the velocity that the circle has then: "
                                     "look at which one your program begins with instead."),
                false);
        if (f.resets && !m_right.at(gravity(), timestep(), m_i).resets)
            return said(FlightText::tr("The velocity of %who is set anew in every step"),
                        FlightText::tr("Started with %1 m/s, it has %2 m/s one step later, and so "
                                       "it has from every other start tried. A step works the new "
                                       "velocity out from the one that the circle has, which a "
                                       "hit may have changed; a start is set once, in "
                                       "`on_load`.")
                            .arg(brief(f.startedWith), brief(f.turnedInto)),
                        false);
        if ((f.resetsX && !right().resetsX) || (f.resetsY && !right().resetsY))
            return said(
                partThatIsSet(f),
                FlightText::tr("Started with %1 m/s, it has %2 m/s one step later, and "
                               "that part is the same from every other start tried. A step works "
                               "each part out from the one that the circle has, and keeps "
                               "it for the next.")
                    .arg(brief(f.startedWith), brief(f.turnedInto)),
                false);
        if (f.isOfStart && !right().isOfStart)
            return said(FlightText::tr("Every step moves %who on from the place of the start"),
                        FlightText::tr("Started with %1 m/s, it is %2 m from its start after the "
                                       "first step of %3 s, and %4 m after the second. The way of "
                                       "a step is added to the place before that step: is the old "
                                       "place kept anew in every step?")
                            .arg(brief(f.startedWith), brief(f.firstWay), briefTimestep(timestep()),
                                 brief(f.firstWay + f.wayMade)),
                        true);
        if (f.leader >= 0 && f.isFromLeader && right().leader < 0)
            return besideAnother(
                FlightText::tr("Every step moves %who on from where circle %1 is")
                    .arg(f.leader + 1),
                FlightText::tr("From every start tried the two are near each other one step later. "
                               "Each circle goes on from its own place: look at "
                               "the names in the line that moves it."));
        if (f.leader >= 0 && m_right.at(gravity(), timestep(), m_i).leader < 0)
            return said(FlightText::tr("The velocity of circle %1 moves %who").arg(f.leader + 1),
                        FlightText::tr("In a scene in which circle %1 alone has a velocity, %who "
                                       "goes on by that times Δt. Each circle moves with its own "
                                       "velocity: look at the names in the line that moves it.")
                            .arg(f.leader + 1),
                        true);
        if (f.keepsOwnPlace && !right().jumps)
            return startSaid(
                FlightText::tr("The place of %who at the start is not taken over"),
                FlightText::tr("Started at rest at two places, it is at one and the same place two "
                               "steps later; the second step goes on from where the first one "
                               "ends. A run begins where the circle is then: look at which place "
                               "your program begins with instead."),
                true);
        if (f.jumps && !m_right.at(gravity(), timestep(), m_i).jumps)
            return said(FlightText::tr("The new place of %who does not depend on the old one"),
                        FlightText::tr("Started at rest at two places, it is at one and the same "
                                       "place two steps later. A step *adds* a way to the old "
                                       "position."),
                        true);
        if (std::abs(f.carried - 1.0) > 1e-6 && !hasPull()
            && std::abs(right().carried - 1.0) < 1e-6)
            return said(FlightText::tr("The old place of %who is multiplied, too"),
                        FlightText::tr("Two that start 1 m apart, at rest, are %1 m apart one step "
                                       "of %2 s later. The old position is kept as it is; the way "
                                       "v Δt is added to it: look at the brackets.")
                            .arg(brief(f.carried), briefTimestep(timestep())),
                        true);
        return std::nullopt;
    }

    /// Whether later steps go on from the velocity after the first one, the same from every start;
    /// of a circle that stays at rest then, whether those of another do.
    [[nodiscard]] bool keepsOwnVelocity() const
    {
        if (!isStopped())
            return flight(0).keepsOwnVelocity;
        for (int i = 0; i < static_cast<int>(m_ground.flights.size()); ++i) {
            if (m_own.at(gravity(), timestep(), i).keepsOwnVelocity)
                return true;
        }
        return false;
    }

    /// The part of the velocity that does not go on from itself. What is 0 may be set in every
    /// step, or begin so and stay.
    [[nodiscard]] static QString partThatIsSet(const Flight &f)
    {
        const double part = f.resetsX ? f.turnedInto.x : f.turnedInto.y;
        if (std::abs(part) < 1e-9)
            return f.resetsX
                       ? FlightText::tr("The x of the velocity of %who is 0 after every step")
                       : FlightText::tr("The y of the velocity of %who is 0 after every step");
        return f.resetsX
                   ? FlightText::tr("The x of the velocity of %who is set anew in every step")
                   : FlightText::tr("The y of the velocity of %who is set anew in every step");
    }

    /// What a run begins with.
    [[nodiscard]] FlightSaid startSaid(const QString &headline, const QString &body,
                                       bool isPosition) const
    {
        FlightSaid fault = said(headline, body, isPosition);
        fault.suspect = Suspect::Begun;
        fault.moment.step = 1;
        return fault;
    }

    /// What puts it beside another circle: where hits are answered it is in one all the time.
    [[nodiscard]] FlightSaid besideAnother(const QString &headline, const QString &body) const
    {
        FlightSaid fault = said(headline, body, true);
        fault.hidesHits = m_ground.pair.asked;
        return fault;
    }

    /// Whether the two stop as if they touched, because of where the other is.
    [[nodiscard]] std::optional<FlightSaid> stoppedByAnother() const
    {
        if (!m_ground.pair.asked || !flight(0).freedBy || right().resets)
            return std::nullopt;
        const Flight &a = m_own.at(gravity(), timestep(), 0);
        const Flight &b = m_own.at(gravity(), timestep(), 1);
        if (!a.resets || !b.resets)
            return std::nullopt;
        // One that both are told with.
        const bool isFirst = a.freedBy.has_value();
        FlightSaid fault = said(
            FlightText::tr("The circles answer each other although they are far apart"),
            FlightText::tr("Started with %1 and %2 m/s, far from each other, they have %3 and %4 "
                           "m/s one step of %5 s later; where circle %6 starts at %7 m, circle "
                           "%8 keeps its velocity. Look at how your program tests "
                           "whether they touch.")
                .arg(brief(a.startedWith), brief(b.startedWith), brief(a.turnedInto),
                     brief(b.turnedInto), briefTimestep(timestep()),
                     QString::number(isFirst ? 2 : 1), brief(*(isFirst ? a : b).freedBy),
                     QString::number(isFirst ? 1 : 2)),
            false);
        fault.suspect = Suspect::Question;
        fault.moment.step = 1;
        return fault;
    }

    /// Whether a step takes its velocity away, from every start tried.
    [[nodiscard]] bool isStopped() const
    {
        return flight(0).resets && flight(0).turnedInto == Vec2{} && !right().resets;
    }

    [[nodiscard]] FlightSaid stopped() const
    {
        const bool isOfGravity = gravity() != Vec2{} && !m_own.at({}, timestep(), m_i).resets;
        const QString seen =
            isOfGravity
                ? FlightText::tr(
                      "Started with %1 m/s under gravity %2 m/s², away from every wall and every "
                      "other circle, its velocity is 0 one step later; without gravity it keeps "
                      "it.")
                      .arg(brief(flight(0).startedWith), brief(gravity()))
                : FlightText::tr("Started with %1 m/s, away from every wall and every other "
                                 "circle, its velocity is 0 one step later.")
                      .arg(brief(flight(0).startedWith));
        return said(isOfGravity
                        ? FlightText::tr("Under gravity a step took the velocity of %who away")
                        : FlightText::tr("In free flight a step took the velocity of %who away"),
                    seen + QLatin1Char(' ')
                        + FlightText::tr("Look at the lines that stop a circle, and at what is "
                                         "asked before they run: is it true although nothing "
                                         "touches?"),
                    false);
    }
};

/// Judges whether a circle minds where the others are.
class OthersJudge : FlightComparison
{
public:
    explicit OthersJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> others() const
    {
        const auto own = m_own.whileOthersRest(gravity(), timestep(), m_i);
        const auto wanted = m_right.whileOthersRest(gravity(), timestep(), m_i);
        const Flight::Step &seen = flight(0).seen[0];
        if (!own || !wanted || isSame(*own, seen) || !isSame(*wanted, right().seen[0]))
            return std::nullopt;
        const bool isTurn = brief(own->turn) != brief(seen.turn);
        if (!isTurn && brief(own->way) == brief(seen.way))
            return std::nullopt;
        if (auto fault = answer())
            return fault;
        const QString text =
            isTurn ? FlightText::tr("Started with %1 m/s, its velocity changes by %2 m/s in the "
                                    "second step of %3 s; with every other circle at rest and "
                                    "elsewhere by %4 m/s.")
                   : FlightText::tr("Started with %1 m/s, it goes %2 m in the second step of %3 s; "
                                    "with every other circle at rest and elsewhere %4 m.");
        return said(FlightText::tr("The flight of %who depends on another circle"),
                    text.arg(brief(flight(0).startedWith), brief(isTurn ? seen.turn : seen.way),
                             briefTimestep(timestep()), brief(isTurn ? own->turn : own->way))
                        + QLatin1Char(' ')
                        + FlightText::tr("They are far from each other. Look at what the lines "
                                         "that move one circle take from another, and at what is "
                                         "asked before them."),
                    !isTurn);
    }

private:
    /// What the first step of the flights does to the velocity of a circle and should not, m/s.
    [[nodiscard]] Vec2 pushOn(int i) const
    {
        const Flight &f = m_own.at(gravity(), timestep(), i);
        const Flight &asked = m_right.at(gravity(), timestep(), i);
        return f.turnedInto
               - asked.after({.position = {}, .velocity = f.startedWith}, timestep()).velocity;
    }

    /// Where both change at once and against each other, they answer as in a hit.
    [[nodiscard]] std::optional<FlightSaid> answer() const
    {
        if (!m_ground.pair.asked || m_ground.flights.size() != 2)
            return std::nullopt;
        const Vec2 first = pushOn(0);
        const Vec2 second = pushOn(1);
        const double size = length(first) * length(second);
        if (size < 1e-6 || dot(first, second) > (1e-3 - 1.0) * size)
            return std::nullopt;
        const Flight &a = m_own.at(gravity(), timestep(), 0);
        const Flight &b = m_own.at(gravity(), timestep(), 1);
        FlightSaid fault =
            said(FlightText::tr("The circles answer each other although they are far apart"),
                 FlightText::tr("Started with %1 and %2 m/s, far from each other, they have %3 and "
                                "%4 m/s one step of %5 s later: the velocities change against each "
                                "other, as in a hit. Look at how your program tests whether they "
                                "touch.")
                     .arg(brief(a.startedWith), brief(b.startedWith), brief(a.turnedInto),
                          brief(b.turnedInto), briefTimestep(timestep())),
                 false);
        fault.suspect = Suspect::Question;
        fault.moment.step = 1;
        return fault;
    }

    static bool isSame(const Flight::Step &a, const Flight::Step &b)
    {
        return length(a.velocity - b.velocity) + length(a.way - b.way) + length(a.turn - b.turn)
               < 1e-8;
    }
};

} // namespace

std::optional<FlightSaid> othersSaid(const FlightComparison &comparison)
{
    return OthersJudge(comparison).others();
}

std::optional<FlightSaid> carriedSaid(const FlightComparison &comparison)
{
    return CarriedJudge(comparison).carriedOn();
}

} // namespace cradle
