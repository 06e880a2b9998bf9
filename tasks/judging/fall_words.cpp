// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/likeness.h"

namespace cradle {

namespace {

using Kind = TimestepPattern::Kind;

class FallJudge : FlightComparison
{
public:
    explicit FallJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> fall() const
    {
        for (const Vec2 g : m_ground.gravities) {
            if (auto fault = fallUnder(g))
                return fault;
        }
        return heavierSaid(*this, gravity());
    }

    /// A fall so strong that it ends at a wall within the flights: measured under weaker gravity.
    [[nodiscard]] std::optional<FlightSaid> strongFall() const
    {
        const double h = *std::max_element(m_ground.timesteps.begin(), m_ground.timesteps.end());
        for (const Vec2 g : m_ground.gravities) {
            const Flight &f = m_own.at(g, h, m_i);
            // In the second step it goes as far as it got faster in the first, and a little more.
            if (h * length(f.turnedInto - f.startedWith) < farInAStep)
                continue;
            const Vec2 weaker = weak * g;
            if (m_own.at(weaker, h, m_i).isKnown)
                return fallUnder(weaker);
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] Vec2 own(Vec2 g) const { return m_own.at(g, timestep(), m_i).acceleration; }
    [[nodiscard]] Vec2 wanted(Vec2 g) const { return m_right.at(g, timestep(), m_i).acceleration; }

    [[nodiscard]] std::optional<FlightSaid> fallUnder(Vec2 g) const
    {
        const Vec2 right = wanted(g);
        if (length(right) < wrong)
            return length(own(g)) < wrong ? std::nullopt : std::optional(besides(g));
        const Vec2 down = normalized(right);
        const auto pull = [&](const Flight &f) { return dot(f.acceleration, down); };
        const auto p = pattern(g, pull);
        const bool isSideways = length(own(g) - dot(own(g), down) * down) > wrong * length(right);
        if (!isSideways && (isRight(p) || isBlurred(g, pull)))
            return std::nullopt;
        if (auto fault = byVelocity(g))
            return fault;
        if (!isProportional(g))
            return besides(g);
        if (isSideways)
            return FlightSaid{FlightText::tr("Gravity pulls %who in a wrong direction"),
                              turnUnder(g, timestep()), moment(false, g)};
        if (isOnPosition(g))
            return FlightSaid{
                FlightText::tr("Gravity moves %who at once and changes no velocity"),
                FlightText::tr("Under gravity %1 m/s² a circle at rest is %2 m away after "
                               "a step of %3 s, and its velocity is still 0. Gravity is an "
                               "acceleration: it changes the velocity, and that moves the "
                               "circle.")
                    .arg(brief(g), brief(m_own.at(g, timestep(), m_i).drift),
                         briefTimestep(timestep())),
                moment(true, g)};
        if (auto fault = heavierSaid(*this, g))
            return fault;
        const auto [headline, where] = fallWords(p, g, pull);
        const double shown =
            p.kind == Kind::Other ? mostWrong(g, pull) : m_ground.timesteps[shownTimestep(p)];
        FlightSaid fault{headline, turnUnder(g, shown) + QLatin1Char(' ') + where,
                         moment(false, g)};
        if (p.kind == TimestepPattern::Kind::Constant && std::abs(p.value) < wrong)
            fault.suspect = Suspect::Omission;
        return fault;
    }

    [[nodiscard]] QString turnUnder(Vec2 g, double h) const
    {
        const Vec2 is = h * m_own.at(g, h, m_i).acceleration;
        const Vec2 asked = h * m_right.at(g, h, m_i).acceleration;
        return FlightText::tr("Under gravity %1 m/s² the velocity changes by %2 m/s in a step of "
                              "%3 s; it should change by %4 m/s.")
            .arg(brief(g), briefBeside(is, asked), briefTimestep(h), briefBeside(asked, is));
    }

    /// Another gravity of the same direction: one of the step's, if there is one.
    [[nodiscard]] Vec2 otherGravity(Vec2 g) const
    {
        if (g == Vec2{})
            return {0.0, -2.0};
        const auto &all = m_ground.gravities;
        // Beside a weaker one that was tried for that the step's own are too strong.
        if (std::find(all.begin(), all.end(), g) == all.end())
            return 0.5 * g;
        const auto other = std::find_if(all.begin(), all.end(), [&](Vec2 each) {
            return each != g && each != Vec2{} && std::abs(cross(each, g)) < 1e-9;
        });
        return other == all.end() ? 0.5 * g : *other;
    }

    /// A fall that hangs on the velocity: with some timestep, or under another gravity.
    [[nodiscard]] std::optional<FlightSaid> byVelocity(Vec2 g) const
    {
        for (const double h : m_ground.timesteps) {
            if (auto fault = byVelocity(g, h))
                return fault;
        }
        return byVelocity(otherGravity(g), timestep());
    }

    /// One step that gravity changes rightly beside one that it does not.
    [[nodiscard]] std::optional<FlightSaid> byVelocity(Vec2 g, double h) const
    {
        const Flight &f = m_own.at(g, h, m_i);
        const auto asked = [&](const Flight::Step &step) {
            const Flight &r = m_right.at(g, h, m_i);
            return r.after({.position = {}, .velocity = step.velocity}, h).velocity - step.velocity;
        };
        const Flight::Step *good = nullptr;
        const Flight::Step *bad = nullptr;
        for (const Flight::Step *step : {&f.seen[0], &f.seen[1], &f.fromRest})
            (brief(step->turn) == brief(asked(*step)) ? good : bad) = step;
        if (f.isTurnLinear || !good || !bad)
            return std::nullopt;
        FlightSaid fault{
            FlightText::tr("The acceleration of %who depends wrongly on the velocity"),
            FlightText::tr("Under gravity %1 m/s² and with the velocity %2 m/s it changes by %3 "
                           "m/s in a step of %4 s, with %5 m/s by %6 m/s; %7 and %8 m/s are "
                           "right. Look at what the lines that change the velocity take, and at "
                           "what is asked before them.")
                .arg(brief(g), brief(good->velocity), brief(good->turn), briefTimestep(h),
                     brief(bad->velocity), brief(bad->turn), brief(asked(*good)),
                     brief(asked(*bad))),
            moment(false, g)};
        fault.suspect = Suspect::Question;
        return fault;
    }

    /// Whether what it makes of gravity \p g is the same share of another one.
    [[nodiscard]] bool isProportional(Vec2 g) const
    {
        const Vec2 other = otherGravity(g);
        return isAlike(own(g) / length(wanted(g)), own(other) / length(wanted(other)), 10 * wrong);
    }

    /// Of what is the same whatever gravity is. In a step without it nobody need have heard of it.
    [[nodiscard]] std::pair<QString, QString> fixedWords() const
    {
        const auto &all = m_ground.gravities;
        if (std::all_of(all.begin(), all.end(), [](Vec2 g) { return g == Vec2{}; }))
            return {FlightText::tr("The velocity of %who changes although no force acts"),
                    FlightText::tr("Without a force a velocity stays as it is: look for the line "
                                   "that changes it in free flight.")};
        return {FlightText::tr("A number stands for gravity in the motion of %who"),
                FlightText::tr("The name `gravity` holds the value of the scene; look where your "
                               "program has one of its own.")};
    }

    /// What is no share of gravity.
    [[nodiscard]] FlightSaid besides(Vec2 g) const
    {
        const Vec2 other = otherGravity(g);
        const QString seen =
            FlightText::tr(
                "Under gravity %1 m/s² the acceleration is %2 m/s², and %3 m/s² under %4 m/s².")
                .arg(brief(g), brief(own(g)), brief(own(other)), brief(other));
        if (isAlike(own(g), own(other), wrong)) {
            const auto [headline, where] = fixedWords();
            return {headline,
                    FlightText::tr("The acceleration is %1 m/s², under gravity %2 and under %3 "
                                   "m/s² alike.")
                            .arg(brief(own(g)), brief(g), brief(other))
                        + QLatin1Char(' ') + where,
                    moment(false, g)};
        }
        const Vec2 more = own(g) - wanted(g);
        if (isAlike(more, own(other) - wanted(other), wrong))
            return {FlightText::tr("Something besides gravity accelerates %who"),
                    seen + QLatin1Char(' ')
                        + FlightText::tr("Each time that is %1 m/s² more than gravity gives.")
                              .arg(brief(more)),
                    moment(false, g)};
        return {FlightText::tr("The acceleration of %who is not that of gravity"), seen,
                moment(false, g)};
    }

    /// Whether gravity changes the place at once, and the velocity not at all.
    [[nodiscard]] bool isOnPosition(Vec2 g) const
    {
        const Flight &f = m_own.at(g, timestep(), m_i);
        return length(f.acceleration) < wrong && dot(f.drift, g) > 1e-9 * lengthSquared(g);
    }

    /// What a step makes of gravity, divided by what is right.
    [[nodiscard]] double factorOf(Vec2 g, const Part &pull, double h) const
    {
        return pull(m_own.at(g, h, m_i)) / pull(m_right.at(g, h, m_i));
    }
    /// The timestep at which that is farthest from 1.
    [[nodiscard]] double mostWrong(Vec2 g, const Part &pull) const
    {
        return *std::max_element(
            m_ground.timesteps.begin(), m_ground.timesteps.end(), [&](double a, double b) {
                return std::abs(factorOf(g, pull, a) - 1.0) < std::abs(factorOf(g, pull, b) - 1.0);
            });
    }

    /// What depends on the timestep as no other law does, told at another one.
    [[nodiscard]] QString atAnotherTimestep(Vec2 g, const Part &pull) const
    {
        const auto &all = m_ground.timesteps;
        const auto right = std::find_if(all.begin(), all.end(), [&](double h) {
            return isAlike(factorOf(g, pull, h), 1.0, wrong);
        });
        if (right != all.end())
            return FlightText::tr("In one of %1 s it changes as it should. Look at which Δt the "
                                  "line that changes the velocity takes.")
                .arg(briefTimestep(*right));
        const double shown = factorOf(g, pull, mostWrong(g, pull));
        const auto other = std::find_if(all.begin(), all.end(), [&](double h) {
            return !isAlike(factorOf(g, pull, h), shown, wrong);
        });
        return FlightText::tr("In one of %1 s it changes by %2 m/s, and should by %3 m/s.")
            .arg(briefTimestep(*other), brief(*other * m_own.at(g, *other, m_i).acceleration),
                 brief(*other * m_right.at(g, *other, m_i).acceleration));
    }

    [[nodiscard]] std::pair<QString, QString> fallWords(const TimestepPattern &p, Vec2 g,
                                                        const Part &pull) const
    {
        switch (p.kind) {
        case Kind::Forgotten:
            return {FlightText::tr("Gravity acts on %who for a whole second in every step"),
                    FlightText::tr("An acceleration says what a second changes; a step lasts only "
                                   "Δt. Compare the units on both sides.")};
        case Kind::Squared:
            return {FlightText::tr("Gravity on %who is multiplied by the timestep twice"),
                    FlightText::tr("Count how often the timestep stands in the line that changes "
                                   "the velocity.")};
        case Kind::Divided:
            return {FlightText::tr("Gravity on %who is divided by the timestep"),
                    FlightText::tr("An acceleration times a time is a velocity. Look at what "
                                   "stands before the timestep in the line that changes the "
                                   "velocity.")};
        case Kind::Fixed:
            return {FlightText::tr("A fixed number stands for the timestep in the fall of %who"),
                    FlightText::tr(
                        "At every timestep tried gravity acts for %1 s. Take the parameter of "
                        "`on_update`.")
                        .arg(briefTimestep(p.value))};
        case Kind::Other:
            return {FlightText::tr("How gravity acts on %who depends on the timestep"),
                    atAnotherTimestep(g, pull)};
        case Kind::Constant:
            break;
        }
        if (std::abs(p.value) < wrong)
            return {FlightText::tr("In free flight gravity leaves %who alone"),
                    FlightText::tr("In every step gravity must change its velocity: look for the "
                                   "line that does it, and at what is asked before it.")};
        if (std::abs(p.value + 1.0) < wrong)
            return {FlightText::tr("The acceleration of %who is opposite to gravity"),
                    FlightText::tr("Look at the signs.")};
        if (std::abs(p.value - 2.0) < wrong)
            return {FlightText::tr("Gravity acts on %who twice as strongly"),
                    FlightText::tr("Count the lines of a step that change the velocity, and look "
                                   "at their factors.")};
        if (std::abs(p.value - 0.5) < wrong)
            return {FlightText::tr("The velocity of %who gets only half of gravity"),
                    FlightText::tr("Look for a factor ½, or for a second half that is missing.")};
        return {FlightText::tr("The velocity of %who gets %1 times what gravity gives")
                    .arg(briefBeside(p.value, 1.0)),
                FlightText::tr("Look at the factors in the line that changes the velocity.")};
    }
};

} // namespace

std::optional<FlightSaid> fallSaid(const FlightComparison &comparison)
{
    return FallJudge(comparison).fall();
}

std::optional<FlightSaid> strongFallSaid(const FlightComparison &comparison)
{
    return FallJudge(comparison).strongFall();
}

} // namespace cradle
