// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/likeness.h"

namespace cradle {

namespace {

// Of MeasuredFlight::Own::unsteadiness().
constexpr double steadyFall = 0.02; ///< a fall, at most
constexpr double comesAgain = 0.5;  ///< what comes again, if less, at most

/// Judges whether heavy and light circles fall alike.
class HeavierJudge : FlightComparison
{
public:
    explicit HeavierJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    /// What the same circle does if it is heavier than the others.
    [[nodiscard]] std::optional<FlightSaid> heavier(Vec2 g) const
    {
        const Vec2 right = m_right.at(g, timestep(), m_i).acceleration;
        const Vec2 own = m_own.at(g, timestep(), m_i).acceleration;
        const auto heavier = m_own.heavierFall(g, timestep(), m_i);
        const auto wanted = m_right.heavierFall(g, timestep(), m_i);
        if (!heavier || !wanted || isAlike(*heavier, own, 0.01) || !isAlike(*wanted, right, 0.01))
            return std::nullopt;
        return FlightSaid{
            FlightText::tr("The fall of %who depends on radius or density"),
            FlightText::tr("Under gravity %1 m/s² circle %4 is accelerated by %2 m/s², and by %3 "
                           "m/s² when its radius is 1.25 times and its density 1.5 times as large. "
                           "Gravity is an acceleration already: all bodies fall alike, whatever "
                           "they weigh.")
                .arg(brief(g), brief(own), brief(*heavier))
                .arg(m_i + 1),
            moment(false, g)};
    }
};

/// Judges what a circle does in the student's own scene beside what it does in the others.
class OwnSceneJudge : FlightComparison
{
public:
    explicit OwnSceneJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    /// Its first step must go on from the start that the program sets, not from what the scene has
    /// before that.
    [[nodiscard]] std::optional<FlightSaid> older() const
    {
        const MeasuredFlight::Own &own = m_own.own();
        const auto i = static_cast<std::size_t>(m_i);
        if (i >= own.ways.size() || i >= m_ground.own.circles.size())
            return std::nullopt;
        const double h = own.scene.timestep;
        const Circle &start = own.scene.circles[i].body;
        const Circle &old = m_ground.own.circles[i].body;
        const Motion is{start.position + own.ways[i], start.velocity + h * own.accelerations[i]};
        const auto goesOnFrom = [&](Vec2 place, Vec2 velocity) {
            Circle from = start;
            from.position = place;
            from.velocity = velocity;
            const Motion next = m_right.at(own.scene.gravity, h, m_i).after(from, h);
            return isAlike(is.position, next.position) && isAlike(is.velocity, next.velocity);
        };
        if (goesOnFrom(start.position, start.velocity))
            return std::nullopt;
        const bool isPlace = goesOnFrom(old.position, start.velocity);
        const bool isVelocity = goesOnFrom(start.position, old.velocity);
        if (!isPlace && !isVelocity && !goesOnFrom(old.position, old.velocity))
            return std::nullopt;
        const QString text =
            isPlace ? FlightText::tr("Your program sets it at %1 m, and one step later it is at %2 "
                                     "m: that step goes on from %3 m, where the scene has it.")
                          .arg(brief(start.position), brief(is.position), brief(old.position))
            : isVelocity
                ? FlightText::tr("Your program starts it with %1 m/s, and one step later it has "
                                 "%2 m/s: that step goes on from %3 m/s, which the scene gives it.")
                      .arg(brief(start.velocity), brief(is.velocity), brief(old.velocity))
                : FlightText::tr("Your program sets it at %1 m with %2 m/s, and one step later it "
                                 "is at %3 m with %4 m/s: that step goes on from %5 m and %6 m/s, "
                                 "which the scene gives it.")
                      .arg(brief(start.position), brief(start.velocity), brief(is.position),
                           brief(is.velocity), brief(old.position), brief(old.velocity));
        return FlightSaid{
            FlightText::tr("The start of %who in your own scene is not taken over"),
            text + QLatin1Char(' ')
                + FlightText::tr("A copy keeps the value of the moment when it was made: is it "
                                 "made before the start is set?"),
            {{m_ground.own, false}, 1, {m_i}, !isVelocity},
            false,
            Suspect::Begun};
    }

    /// The own scene must fall as all others do: else a copy of gravity is older than gravity.
    [[nodiscard]] std::optional<FlightSaid> fall() const
    {
        const MeasuredFlight::Own &own = m_own.own();
        const auto i = static_cast<std::size_t>(m_i);
        if (i >= own.accelerations.size())
            return std::nullopt;
        const Vec2 right = own.scene.gravity;
        const Vec2 braked = flight(0).growth;
        const Vec2 v = own.scene.circles[i].body.velocity;
        const Vec2 fallen = own.accelerations[i] - Vec2{braked.x * v.x, braked.y * v.y};
        const bool isAsked = std::find(m_ground.gravities.begin(), m_ground.gravities.end(), right)
                             != m_ground.gravities.end();
        const double blur = 1e-6 + growthBlur(0);
        if (!isAsked || own.unsteadiness(i) > comesAgain
            || length(fallen - right) < blur * (1.0 + length(right))
            || length(m_right.at(right, timestep(), m_i).acceleration - right) > wrong)
            return std::nullopt;
        if (auto fault = heavierSaid(*this, right))
            return fault;
        const Moment moment{{m_ground.own, false}, 1, {m_i}, false};
        if (own.unsteadiness(i) <= steadyFall && isSameElsewhere(own, fallen))
            return FlightSaid{
                FlightText::tr("The fall of %who is not that of the gravity in the scene"),
                FlightText::tr("In your own scene gravity is %1 m/s², and the velocity changes "
                               "by %2 m/s in a second. A copy of gravity keeps the value of "
                               "the moment when it was made: before or after `on_load` has "
                               "set it?")
                    .arg(brief(right), brief(own.accelerations[i])),
                moment, false, Suspect::Copy};
        return FlightSaid{
            FlightText::tr("The fall of %who is not that of the gravity in the scene"),
            FlightText::tr("In your own scene gravity is %1 m/s²; the velocity changes by %2 "
                           "m/s in the first step and by %3 m/s in the second. Look at what "
                           "else changes the velocity, away from any hit.")
                .arg(brief(right), brief(own.scene.timestep * own.accelerations[i]),
                     brief(own.scene.timestep * own.later[i])),
            moment};
    }

    /// The first step of the own scene must not change what nothing is near to.
    [[nodiscard]] std::optional<FlightSaid> start() const
    {
        const MeasuredFlight::Own &own = m_own.own();
        const auto i = static_cast<std::size_t>(m_i);
        if (i >= own.accelerations.size() || own.unsteadiness(i) <= comesAgain
            || !isOffWalls(own.scene, i))
            return std::nullopt;
        const bool isAlone = !isBeside(own.scene, i);
        if (!isAlone && m_ground.pair.asked)
            return std::nullopt;
        const double h = own.scene.timestep;
        const Vec2 v = own.scene.circles[i].body.velocity;
        const Vec2 turn = h * own.accelerations[i];
        const Vec2 fall = h * m_right.at(own.scene.gravity, h, m_i).acceleration;
        if (length(turn - fall) < 0.2 * length(v) + 2.0 * length(fall))
            return std::nullopt;
        // What it does in any step is said already.
        const Vec2 usual = m_own.at(own.scene.gravity, h, m_i).after({.velocity = v}, h).velocity;
        if (length(v + turn - usual) < 1e-6)
            return std::nullopt;
        if (!isAlone)
            return besideAnother(v, v + turn, fall);
        return FlightSaid{
            FlightText::tr("In your own scene the first step changes the velocity of %who"),
            FlightText::tr("It starts with %1 m/s, and has %2 m/s one step later; nothing that it "
                           "could hit is near. Look at which lines change its velocity there, and "
                           "at what is asked before them.")
                .arg(brief(v), brief(v + turn)),
            {{m_ground.own, false}, 1, {m_i}, false}};
    }

    /// Whether it falls alike when it is set to another place of the same run: then it is no place
    /// that counts, but what the program keeps from its start.
    [[nodiscard]] bool isSameElsewhere(const MeasuredFlight::Own &own, Vec2 fallen) const
    {
        const auto elsewhere = m_own.ownFallElsewhere(m_i);
        return elsewhere && length(*elsewhere - fallen) < 1e-3 * (1.0 + length(own.scene.gravity));
    }

    /// That another circle, which is near, changes it, where none should: with the others elsewhere
    /// it goes on rightly.
    [[nodiscard]] std::optional<FlightSaid> besideAnother(Vec2 from, Vec2 to, Vec2 fall) const
    {
        const double h = m_own.own().scene.timestep;
        const auto apart = m_own.ownFallApart(m_i);
        if (!apart || length(h * *apart - fall) > 1e-6 * (1.0 + length(from)))
            return std::nullopt;
        return FlightSaid{
            FlightText::tr("Another circle that is near changes the velocity of %who"),
            FlightText::tr("In your own scene it starts with %1 m/s and has %2 m/s one step later; "
                           "with every other circle set elsewhere it has %3 m/s then. In this step "
                           "of the lab circles go through each other: look at what compares "
                           "their places.")
                .arg(brief(from), brief(to), brief(from + h * *apart)),
            {{m_ground.own, false}, 1, {m_i}, false}};
    }

    /// How far circle \p c may come from its place in the first two steps, with its rim, m.
    static double reach(const Preset &scene, const Circle &c)
    {
        return c.radius + 4.0 * length(c.velocity) * scene.timestep;
    }

    /// Whether circle \p i comes near no wall in the first two steps.
    static bool isOffWalls(const Preset &scene, std::size_t i)
    {
        const Circle &c = scene.circles[i].body;
        return std::max(std::abs(c.position.x), std::abs(c.position.y))
               <= scene.halfWidth - reach(scene, c);
    }

    /// Whether it comes near another circle.
    static bool isBeside(const Preset &scene, std::size_t i)
    {
        const Circle &c = scene.circles[i].body;
        for (std::size_t k = 0; k < scene.circles.size(); ++k) {
            const Circle &other = scene.circles[k].body;
            if (k != i
                && length(other.position - c.position) < reach(scene, c) + reach(scene, other))
                return true;
        }
        return false;
    }
};

} // namespace

std::optional<FlightSaid> heavierSaid(const FlightComparison &comparison, Vec2 gravity)
{
    return HeavierJudge(comparison).heavier(gravity);
}

std::optional<FlightSaid> ownSceneSaid(const FlightComparison &comparison)
{
    const OwnSceneJudge judge(comparison);
    for (const auto law : {&OwnSceneJudge::older, &OwnSceneJudge::fall, &OwnSceneJudge::start}) {
        if (auto fault = (judge.*law)())
            return fault;
    }
    return std::nullopt;
}

} // namespace cradle
