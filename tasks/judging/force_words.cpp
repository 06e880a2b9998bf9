// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/likeness.h"
#include "tasks/judging/measured_wall.h"

namespace cradle {

namespace {

/// Judges what the velocity and the place of a circle do to its velocity.
class ForceJudge : FlightComparison
{
public:
    explicit ForceJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    /// What the place does.
    [[nodiscard]] std::optional<FlightSaid> pull() const
    {
        const Flight &f = flight(0);
        const Flight &r = right();
        if (isAlike(f.pull, r.pull, wrong))
            return std::nullopt;
        // What was measured in the second step is no acceleration of a circle at rest then.
        const double h = timestep();
        if (length(f.fromRest.velocity - h * f.acceleration)
            > 2.0 * h * (length(f.acceleration) + length(r.acceleration)))
            return letGoSaid(f.fromRest.velocity, h * r.acceleration);
        const auto here = [](const Flight &each) { return brief(each.acceleration); };
        const auto there = [](const Flight &each) {
            const Vec2 far = flights::shift;
            return brief(each.acceleration + Vec2{each.pull.x * far.x, each.pull.y * far.y});
        };
        return said(
            r.pull == Vec2{}
                ? FlightText::tr("The acceleration of %who depends on the place")
                : FlightText::tr("The place of %who acts on its velocity otherwise than asked"),
            FlightText::tr("At rest under gravity %1 m/s² it is accelerated by %2 m/s² at %3 m and "
                           "by %4 m/s² at %5 m; %6 and %7 m/s² are right.")
                .arg(brief(gravity()), here(f), brief(f.restedAt), there(f),
                     brief(f.restedAt + flights::shift), here(r), there(r)),
            false);
    }

    /// What e does to it, though it hits nothing.
    [[nodiscard]] std::optional<FlightSaid> loss() const
    {
        std::vector<double> all = m_ground.walls.restitutions;
        all.insert(all.end(), m_ground.pair.restitutions.begin(), m_ground.pair.restitutions.end());
        const double e = middleOf(all);
        const auto seen = e == 1.0 || !flight(0).isKnown
                              ? std::nullopt
                              : m_own.withRestitution(gravity(), timestep(), m_i, e);
        const Flight::Step &usual = flight(0).seen[0];
        if (!seen || isAlike(seen->velocity + seen->turn, usual.velocity + usual.turn, wrong))
            return std::nullopt;
        FlightSaid fault =
            said(FlightText::tr("e changes the velocity of %who away from any hit"),
                 FlightText::tr(
                     "Started with %1 m/s, it has %2 m/s two steps of %3 s later with e = %4, "
                     "and %5 m/s with e = 1; nothing is near. e belongs to hits alone: look "
                     "at what is asked before the line that takes it.")
                     .arg(brief(flight(0).startedWith),
                          briefBeside(seen->velocity + seen->turn, usual.velocity + usual.turn),
                          briefTimestep(timestep()), brief(e),
                          briefBeside(usual.velocity + usual.turn, seen->velocity + seen->turn)),
                 false);
        fault.moment.stage.preset.restitution = e;
        fault.hidesHits = true;
        return fault;
    }

    /// Whether parts of its velocity have the other sign one step later.
    [[nodiscard]] std::optional<FlightSaid> turnsRound() const
    {
        const bool inX = hasTurned(flight(0).growth.x) && !hasTurned(right().growth.x);
        const bool inY = hasTurned(flight(0).growth.y) && !hasTurned(right().growth.y);
        return inX || inY ? std::optional(turnedRound(inX, inY)) : std::nullopt;
    }

    /// What its own velocity does else.
    [[nodiscard]] std::optional<FlightSaid> growth() const
    {
        const Vec2 is = flight(0).growth;
        const Vec2 asked = right().growth;
        if (isAlike(is, asked, wrong))
            return std::nullopt;
        const bool inX = !isAlike(is.x, asked.x, wrong);
        const bool inY = !isAlike(is.y, asked.y, wrong);
        const bool isOne =
            inX && inY && isAlike(is.x, is.y, wrong) && isAlike(asked.x, asked.y, wrong);
        QString headline =
            inX && inY && !isOne && growthHeadline(is.x, asked.x) != growthHeadline(is.y, asked.y)
                ? FlightText::tr("The velocity of %who changes by itself "
                                 "otherwise than asked")
                : growthHeadline(inX ? is.x : is.y, inX ? asked.x : asked.y);
        headline += partOf(inX, inY);
        return said(headline, law(isOne, inX, inY) + atOtherTimesteps(inX), false);
    }

private:
    [[nodiscard]] FlightSaid letGoSaid(Vec2 got, Vec2 wanted) const
    {
        FlightSaid fault = said(
            FlightText::tr("The velocity of %who changes far from everything"),
            FlightText::tr("Let go at rest, it has %1 m/s one step of %2 s later, far from every "
                           "wall and every other circle; gravity gives it %3 m/s in a step. Look "
                           "at which lines change its velocity there, and at what is asked before "
                           "them.")
                .arg(brief(got), briefTimestep(timestep()), brief(wanted)),
            false);
        for (PresetCircle &each : fault.moment.stage.preset.circles)
            each.body.velocity = {};
        fault.moment.step = 1;
        return fault;
    }

    /// " (only in x)"; nothing of both parts.
    static QString partOf(bool inX, bool inY)
    {
        if (inX == inY)
            return {};
        return inX ? FlightText::tr(" (only in x)") : FlightText::tr(" (only in y)");
    }

    [[nodiscard]] bool hasTurned(double growth) const { return 1.0 + growth * timestep() < -0.01; }

    [[nodiscard]] FlightSaid turnedRound(bool inX, bool inY) const
    {
        const Flight::Step &seen = flight(0).seen[0];
        FlightSaid fault = said(
            FlightText::tr("Far from everything the velocity of %who turns round")
                + partOf(inX, inY),
            FlightText::tr("It had %1 m/s, and %2 m/s one step of %3 s later, with nothing near "
                           "that it could hit. Look at the lines that turn it, and at what is "
                           "asked before them: is it true although nothing touches?")
                .arg(brief(seen.velocity), brief(seen.velocity + seen.turn),
                     briefTimestep(timestep())),
            false);
        fault.suspect = Suspect::Question;
        return fault;
    }

    [[nodiscard]] QString law(bool isOne, bool inX, bool inY) const
    {
        const Vec2 is = flight(0).growth;
        const Vec2 asked = right().growth;
        const QString h = briefTimestep(timestep());
        if (isOne)
            return FlightText::tr("With Δt = %1 s it is accelerated by %2 m/s² for every m/s of "
                                  "its velocity; %3 is right.")
                .arg(h, brief(is.x), brief(asked.x));
        if (inX != inY)
            return (inX ? FlightText::tr("With Δt = %1 s it is accelerated in x by %2 m/s² for "
                                         "every m/s of its velocity in x; %3 is right.")
                        : FlightText::tr("With Δt = %1 s it is accelerated in y by %2 m/s² for "
                                         "every m/s of its velocity in y; %3 is right."))
                .arg(h, brief(inX ? is.x : is.y), brief(inX ? asked.x : asked.y));
        return FlightText::tr("With Δt = %1 s it is accelerated by %2 m/s² for every m/s of its "
                              "velocity in x, and by %3 m/s² for every m/s in y; %4 and %5 are "
                              "right.")
            .arg(h, brief(is.x), brief(is.y), brief(asked.x), brief(asked.y));
    }

    /// What a step takes away, however long it is, does so more often in shorter ones.
    [[nodiscard]] QString atOtherTimesteps(bool inX) const
    {
        const auto part = [&](const Flight &f) { return inX ? f.growth.x : f.growth.y; };
        const double kept = 1.0 + part(flight(0)) * timestep();
        for (std::size_t k = 1; k < m_ground.timesteps.size(); ++k) {
            const double h = m_ground.timesteps[k];
            const double other = part(flight(k));
            if (isAlike(other, part(flight(0)), wrong))
                continue;
            if (isAlike(1.0 + other * h, kept, wrong))
                return QLatin1Char(' ')
                       + FlightText::tr("In a step of %1 s it keeps as much of it, %2 times: so "
                                        "what happens in a second depends on Δt.")
                             .arg(briefTimestep(h), briefBeside(kept, 1.0));
            return QLatin1Char(' ')
                   + FlightText::tr("With Δt = %1 s it is %2 m/s².")
                         .arg(briefTimestep(h), brief(other));
        }
        return {};
    }

    static QString growthHeadline(double is, double asked)
    {
        if (std::abs(asked) < wrong)
            return is < 0.0 ? FlightText::tr("Something slows %who down on the way")
                            : FlightText::tr("Something makes %who faster on the way");
        if (std::abs(is) < wrong)
            return asked < 0.0 ? FlightText::tr("Nothing slows %who down on the way")
                               : FlightText::tr("Nothing makes %who faster on the way");
        if (is * asked < 0.0)
            return asked < 0.0 ? FlightText::tr("What should slow %who down makes it faster")
                               : FlightText::tr("What should make %who faster slows it down");
        return FlightText::tr("What acts on the velocity of %who is %1 times as strong as it "
                              "should be")
            .arg(brief(is / asked));
    }
};

} // namespace

std::optional<FlightSaid> pullSaid(const FlightComparison &comparison)
{
    return ForceJudge(comparison).pull();
}

std::optional<FlightSaid> lossSaid(const FlightComparison &comparison)
{
    return ForceJudge(comparison).loss();
}

std::optional<FlightSaid> turnsRoundSaid(const FlightComparison &comparison)
{
    return ForceJudge(comparison).turnsRound();
}

std::optional<FlightSaid> growthSaid(const FlightComparison &comparison)
{
    return ForceJudge(comparison).growth();
}

} // namespace cradle
