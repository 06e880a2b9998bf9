// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/likeness.h"

namespace cradle {

namespace {

using Kind = TimestepPattern::Kind;

// Of MeasuredFlight::Own::unsteadiness().
constexpr double steady = 0.02; ///< a fall, at most
constexpr double once = 0.5;    ///< what comes again, if less, at most

class FallJudge : FlightComparison
{
public:
    explicit FallJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> fall() const
    {
        if (auto number = numberForGravity())
            return number;
        for (const Vec2 g : m_ground.gravities) {
            if (auto fault = fallUnder(g))
                return fault;
        }
        const auto copy = ownFall();
        return copy ? copy : ownStart();
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
    static constexpr double farInAStep = 0.5; ///< m, a small part of the square
    static constexpr double weak = 1e-3;

    /// The same acceleration, whatever gravity is.
    [[nodiscard]] std::optional<FlightSaid> numberForGravity() const
    {
        for (const Vec2 g : m_ground.gravities) {
            const Vec2 own = m_own.at(g, timestep(), m_i).acceleration;
            const Vec2 right = m_right.at(g, timestep(), m_i).acceleration;
            const bool same =
                std::all_of(m_ground.gravities.begin(), m_ground.gravities.end(), [&](Vec2 other) {
                    return isAlike(m_own.at(other, timestep(), m_i).acceleration, own, wrong);
                });
            if (!same || (m_ground.gravities.size() < 2 && g != Vec2{}) || length(own) < wrong
                || length(own - right) < wrong)
                continue;
            return FlightSaid{
                FlightText::tr("A number stands for gravity in the motion of %who"),
                FlightText::tr("In a scene with gravity %1 m/s² it is accelerated by %2 "
                               "m/s², as in every other. The name `gravity` holds the "
                               "value of the scene; look where your program has one of "
                               "its own.")
                    .arg(brief(g), brief(own)),
                moment(false, g)};
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<FlightSaid> fallUnder(Vec2 g) const
    {
        const Vec2 right = m_right.at(g, timestep(), m_i).acceleration;
        const Vec2 own = m_own.at(g, timestep(), m_i).acceleration;
        if (length(right) < wrong)
            return std::nullopt;
        const Vec2 down = normalized(right);
        const auto pull = [&](const Flight &f) { return dot(f.acceleration, down); };
        const auto p = pattern(g, pull);
        const Vec2 sideways = own - dot(own, down) * down;
        if (length(sideways) > wrong * length(right))
            return FlightSaid{
                FlightText::tr("Gravity pulls %who in a wrong direction"),
                FlightText::tr("Under gravity %1 m/s² the velocity changes by %2 m/s in a "
                               "step of %3 s; it should change by %4 m/s.")
                    .arg(brief(g), brief(timestep() * own), briefTimestep(timestep()),
                         brief(timestep() * right)),
                moment(false, g)};
        if (isRight(p) || isBlurred(g, pull))
            return std::nullopt;
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
        if (const auto fault = heavierFall(g))
            return fault;
        const auto [headline, where] = fallWords(p);
        const double h = m_ground.timesteps[shownTimestep(p)];
        FlightSaid fault{headline,
                         FlightText::tr("Under gravity %1 m/s² the velocity changes by %2 m/s in a "
                                        "step of %3 s; it should change by %4 m/s.")
                                 .arg(brief(g), brief(h * m_own.at(g, h, m_i).acceleration),
                                      briefTimestep(h),
                                      brief(h * m_right.at(g, h, m_i).acceleration))
                             + QLatin1Char(' ') + where,
                         moment(false, g)};
        if (p.kind == TimestepPattern::Kind::Constant && std::abs(p.value) < wrong)
            fault.suspect = Suspect::Omission;
        return fault;
    }

    /// The same circle, heavier than the others.
    [[nodiscard]] std::optional<FlightSaid> heavierFall(Vec2 g) const
    {
        const Vec2 own = m_own.at(g, timestep(), m_i).acceleration;
        const auto heavier = m_own.heavierFall(g, timestep(), m_i);
        if (!heavier || isAlike(*heavier, own, 0.01))
            return std::nullopt;
        return FlightSaid{
            FlightText::tr("Gravity does not act alike on light and heavy ones (%who)"),
            FlightText::tr("Under gravity %1 m/s² it is accelerated by %2 m/s², and by %3 m/s² "
                           "when its radius is 1.25 times and its density 1.5 times as large. "
                           "Gravity is an acceleration already: all bodies fall alike, whatever "
                           "they weigh.")
                .arg(brief(g), brief(own), brief(*heavier)),
            moment(false, g)};
    }

    /// Whether gravity changes the place at once, and the velocity not at all.
    [[nodiscard]] bool isOnPosition(Vec2 g) const
    {
        const Flight &f = m_own.at(g, timestep(), m_i);
        return length(f.acceleration) < wrong && dot(f.drift, g) > 1e-9 * lengthSquared(g);
    }

    static std::pair<QString, QString> fallWords(const TimestepPattern &p)
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
        case Kind::Fixed:
            return {FlightText::tr("A fixed number stands for the timestep in the fall of %who"),
                    FlightText::tr("Whatever Δt is, gravity acts for %1 s. Take the parameter of "
                                   "`on_update`.")
                        .arg(briefTimestep(p.value))};
        case Kind::Constant:
        case Kind::Other:
            break;
        }
        if (std::abs(p.value) < wrong)
            return {FlightText::tr("Gravity does not act on %who"),
                    FlightText::tr("In every step gravity must change its velocity: look for the "
                                   "line that does it, and at the conditions in front of it.")};
        if (std::abs(p.value + 1.0) < wrong)
            return {FlightText::tr("Gravity pushes %who against its own direction"),
                    FlightText::tr("Look at the signs.")};
        if (std::abs(p.value - 2.0) < wrong)
            return {FlightText::tr("Gravity acts on %who twice as strongly"),
                    FlightText::tr("Count the lines of a step that change the velocity, and look "
                                   "at their factors.")};
        if (std::abs(p.value - 0.5) < wrong)
            return {FlightText::tr("The velocity of %who gets only half of gravity"),
                    FlightText::tr("Look for a factor ½, or for a second half that is missing.")};
        return {FlightText::tr("Gravity on %who is %1 times as strong as it should be")
                    .arg(brief(p.value)),
                FlightText::tr("Look at the factors in the line that changes the velocity.")};
    }

    /// The own scene must fall as all others do: else a copy of gravity is older than gravity.
    [[nodiscard]] std::optional<FlightSaid> ownFall() const
    {
        const MeasuredFlight::Own &own = m_own.own();
        const auto i = static_cast<std::size_t>(m_i);
        if (!own.runs || i >= own.accelerations.size())
            return std::nullopt;
        const Vec2 right = own.scene.gravity;
        const Vec2 braked = flight(0).growth;
        const Vec2 v = own.scene.circles[i].body.velocity;
        const Vec2 fallen = own.accelerations[i] - Vec2{braked.x * v.x, braked.y * v.y};
        const bool isAsked = std::find(m_ground.gravities.begin(), m_ground.gravities.end(), right)
                             != m_ground.gravities.end();
        const double blur = 1e-6 + growthBlur(0);
        if (!isAsked || own.unsteadiness(i) > once
            || length(fallen - right) < blur * (1.0 + length(right))
            || length(m_right.at(right, timestep(), m_i).acceleration - right) > wrong)
            return std::nullopt;
        if (const auto fault = heavierFall(right))
            return fault;
        if (own.unsteadiness(i) > steady)
            return FlightSaid{
                FlightText::tr("The fall of %who is not that of the gravity in the scene"),
                FlightText::tr("In your own scene gravity is %1 m/s²; the velocity changes by %2 "
                               "m/s in the first step and by %3 m/s in the second. Look at what "
                               "else changes the velocity, away from any hit.")
                    .arg(brief(right), brief(own.scene.timestep * own.accelerations[i]),
                         brief(own.scene.timestep * own.later[i])),
                {{m_ground.own, false}, 1, {m_i}, false}};
        return FlightSaid{
            FlightText::tr("The fall of %who is not that of the gravity in the scene"),
            FlightText::tr("In your own scene gravity is %1 m/s², and the velocity changes "
                           "by %2 m/s in a second. A copy of gravity keeps the value of "
                           "the moment when it was made: before or after `on_load` has "
                           "set it?")
                .arg(brief(right), brief(own.accelerations[i])),
            {{m_ground.own, false}, 1, {m_i}, false},
            false,
            Suspect::Copy};
    }

    /// The first step of the own scene must not change what nothing is near to.
    [[nodiscard]] std::optional<FlightSaid> ownStart() const
    {
        const MeasuredFlight::Own &own = m_own.own();
        const auto i = static_cast<std::size_t>(m_i);
        if (!own.runs || i >= own.accelerations.size() || own.unsteadiness(i) <= once
            || !isAlone(own.scene, i))
            return std::nullopt;
        const double h = own.scene.timestep;
        const Vec2 v = own.scene.circles[i].body.velocity;
        const Vec2 turn = h * own.accelerations[i];
        const Vec2 fall = h * m_right.at(own.scene.gravity, h, m_i).acceleration;
        if (length(turn - fall) < 0.2 * length(v) + 2.0 * length(fall))
            return std::nullopt;
        return FlightSaid{
            FlightText::tr("In your own scene the first step changes the velocity of %who"),
            FlightText::tr("It starts with %1 m/s, and has %2 m/s one step later; nothing that it "
                           "could hit is near. Look at the values that the line takes: are they "
                           "those of this step, or older?")
                .arg(brief(v), brief(v + turn)),
            {{m_ground.own, false}, 1, {m_i}, false}};
    }

    /// Whether circle \p i comes near no wall and no other circle in the first two steps.
    static bool isAlone(const Preset &scene, std::size_t i)
    {
        const auto reach = [&](const Circle &c) {
            return c.radius + 4.0 * length(c.velocity) * scene.timestep;
        };
        const Circle &c = scene.circles[i].body;
        const double most = std::max(std::abs(c.position.x), std::abs(c.position.y));
        if (most > scene.halfWidth - reach(c))
            return false;
        for (std::size_t k = 0; k < scene.circles.size(); ++k) {
            const Circle &other = scene.circles[k].body;
            if (k != i && length(other.position - c.position) < reach(c) + reach(other))
                return false;
        }
        return true;
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
