// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/likeness.h"

namespace cradle {

namespace {

using Kind = TimestepPattern::Kind;

/// Judges how far a circle goes in a step.
class WayJudge : FlightComparison
{
public:
    explicit WayJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> way() const
    {
        if (!hasPull() && right().isWayLinear) {
            if (isVelocityOdd() || isEveryWayRight())
                return std::nullopt;
            if (!flight(0).isWayLinear)
                return oddWaySaid(*this);
        }
        const auto partX = [](const Flight &f) { return f.way.x; };
        const auto partY = [](const Flight &f) { return f.way.y; };
        const auto x = pattern(gravity(), partX);
        const auto y = pattern(gravity(), partY);
        if ((isRight(x) && isRight(y))
            || (isBlurred(gravity(), partX) && isBlurred(gravity(), partY)))
            return std::nullopt;
        const std::size_t at = isRight(x) ? shownTimestep(y, partY) : shownTimestep(x, partX);
        const Flight &f = flight(at);
        const bool isX = x.kind == Kind::Constant && x.value == 0.0;
        const bool isY = y.kind == Kind::Constant && y.value == 0.0;
        // A part that nobody asks for may stay; what is wrong with the other is said first.
        const TimestepPattern &other = isX ? y : isY || !isRight(x) ? x : y;
        const QString went = seen(at, other.value);
        if (isX != isY && isRight(other))
            return said(withoutVelocity(isX, isX ? f.wayMade.x : f.wayMade.y),
                        went
                            + FlightText::tr(" Both parts of the position must change, each by "
                                             "its own part of the velocity."),
                        true);
        // What is wrong with one part is not said of the other.
        const bool isOne = isRight(x) || isRight(y) || isX != isY
                           || (x.kind == y.kind && std::abs(x.value - y.value) < wrong);
        if (x.kind == Kind::Other || y.kind == Kind::Other) {
            const auto rightAt = rightTimestep();
            if (rightAt) {
                FlightSaid fault = said(
                    FlightText::tr("With some timesteps the way of %who is not v Δt"),
                    went + QLatin1Char(' ')
                        + FlightText::tr("With Δt = %1 s it goes v Δt. Look at which Δt the line "
                                         "that changes the position takes.")
                              .arg(briefTimestep(*rightAt)),
                    true);
                fault.topic = Topic::Timestep;
                return fault;
            }
        }
        if (isOne && other.kind == Kind::Constant && other.value == 0.0 && f.wayMade == Vec2{}) {
            if (const auto alone = onlyInOwnScene(went))
                return *alone;
        }
        auto [headline, where] =
            wayWords(isOne ? other : TimestepPattern{Kind::Other, 0.0}, length(f.wayMade) > 1e-9);
        if (isRight(x) != isRight(y) || isX != isY)
            headline +=
                &other == &y ? FlightText::tr(" (only in y)") : FlightText::tr(" (only in x)");
        FlightSaid fault = said(headline, went + QLatin1Char(' ') + where, true);
        if (other.kind == Kind::Constant && other.value == 0.0)
            fault.suspect = Suspect::Omission;
        if (other.kind == Kind::Fixed)
            fault.topic = Topic::Timestep;
        return fault;
    }

    /// A way so far that walls turn it round in every step: of one that is slower.
    [[nodiscard]] std::optional<FlightSaid> strongWay() const
    {
        std::vector<std::pair<double, double>> factors;
        for (const double h : m_ground.timesteps) {
            const auto step = m_own.slowStart(weak, h, m_i);
            if (!step || length(step->way) < far * h * length(step->velocity)
                || std::abs(cross(step->way, step->velocity))
                       > wrong * length(step->way) * length(step->velocity))
                return std::nullopt;
            factors.emplace_back(h, dot(step->way, step->velocity)
                                        / (h * lengthSquared(step->velocity)));
        }
        const auto [headline, where] = wayWords(patternOf(factors), true);
        const auto step = m_own.slowStart(weak, timestep(), m_i);
        return said(headline,
                    seen(step->velocity, timestep(), step->way) + QLatin1Char(' ') + where, true);
    }

private:
    /// Whether with some timestep the way is no share of the velocity before the step, but that of
    /// the one after it, which is odd.
    [[nodiscard]] bool isVelocityOdd() const
    {
        for (std::size_t at = 0; at < m_ground.timesteps.size(); ++at) {
            if (!flight(at).isWayLinear && flight(at).isWayOfNew)
                return true;
        }
        return false;
    }

    /// Whether with every timestep each way that was seen is the one asked for of the velocity
    /// before that step, and what becomes of the velocity, which is odd, hides its share.
    [[nodiscard]] bool isEveryWayRight() const
    {
        bool isHidden = false;
        for (std::size_t at = 0; at < m_ground.timesteps.size(); ++at) {
            const double h = m_ground.timesteps[at];
            const Flight &f = flight(at);
            const Flight &asked = m_right.at(gravity(), h, m_i);
            const auto isRightWay = [&](const Flight::Step &step) {
                const Motion next = asked.after({.position = {}, .velocity = step.velocity}, h);
                return length(step.way - next.position) < 1e-8;
            };
            if (!isRightWay(f.fromRest) || !std::all_of(f.seen.begin(), f.seen.end(), isRightWay))
                return false;
            isHidden |= !f.isTurnLinear || f.resetsX || f.resetsY;
        }
        return isHidden;
    }

    /// Of a part of the position of which the velocity has no share, where it goes so far, m.
    static QString withoutVelocity(bool isX, double way)
    {
        if (std::abs(way) > 1e-9)
            return isX ? FlightText::tr("The x of %who changes without its velocity")
                       : FlightText::tr("The y of %who changes without its velocity");
        return isX ? FlightText::tr("The x of %who does not change")
                   : FlightText::tr("The y of %who does not change");
    }

    /// What takes it so many times as far as v Δt takes it to a wall.
    static constexpr double far = 20.0;

    /// What is seen with a timestep of which the way by its velocity is so many times v Δt.
    /// \param at  which timestep
    [[nodiscard]] QString seen(std::size_t at, double factor) const
    {
        const double h = m_ground.timesteps[at];
        const Flight &f = flight(at);
        const Flight &asked = m_right.at(gravity(), h, m_i);
        const Vec2 v = f.turnedInto;
        const Vec2 way = f.wayMade;
        if (brief(way) == brief(way - f.drift))
            return seen(v, h, way);
        const QString text =
            FlightText::tr("With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m");
        const Vec2 right = asked.after({.position = {}, .velocity = v}, h).position;
        if (shares().size() == 1 && isAlike(f.drift / factor, asked.drift))
            return text.arg(brief(v), briefTimestep(h), briefBeside(way, right))
                   + FlightText::tr("; %1 m is right.").arg(briefBeside(right, way));
        return text.arg(brief(v), briefTimestep(h), brief(way))
               + FlightText::tr(", of which %1 m are not of the velocity; v Δt is %2 m.")
                     .arg(brief(f.drift), brief(h * v));
    }

    /// That it goes nowhere but in the first step of the own scene.
    [[nodiscard]] std::optional<FlightSaid> onlyInOwnScene(const QString &went) const
    {
        const MeasuredFlight::Own &own = m_own.own();
        const auto i = static_cast<std::size_t>(m_i);
        if (i >= own.ways.size())
            return std::nullopt;
        const double h = own.scene.timestep;
        const Vec2 v = own.scene.circles[i].body.velocity;
        if (v == Vec2{} || length(own.ways[i] - h * v) > 1e-6 + h * h * length(own.scene.gravity))
            return std::nullopt;
        FlightSaid fault = said(
            FlightText::tr("Only in your own scene a step moves %who"),
            went + QLatin1Char(' ')
                + FlightText::tr("In the first step of your own scene it goes %1 m, as its "
                                 "velocity there makes it. So it should from every start: look at "
                                 "what is asked before the line that moves it.")
                      .arg(brief(own.ways[i])),
            true);
        fault.suspect = Suspect::Question;
        return fault;
    }

    [[nodiscard]] static QString seen(Vec2 velocity, double h, Vec2 way)
    {
        return FlightText::
            tr("With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m; v Δt is %4 m.")
                .arg(brief(velocity), briefTimestep(h), briefBeside(way, h * velocity),
                     briefBeside(h * velocity, way));
    }

    /// One with which both parts of the way are right.
    [[nodiscard]] std::optional<double> rightTimestep() const
    {
        const auto &all = m_ground.timesteps;
        const auto at = std::find_if(all.begin(), all.end(), [&](double h) {
            const Flight &own = m_own.at(gravity(), h, m_i);
            return isAlike(own.way, m_right.at(gravity(), h, m_i).way, wrong);
        });
        return at == all.end() ? std::nullopt : std::optional(*at);
    }

    [[nodiscard]] const std::vector<double> &shares() const
    {
        return m_ground.flights[static_cast<std::size_t>(m_i)].shares;
    }

    /// \param moves  whether it goes anywhere
    static std::pair<QString, QString> wayWords(const TimestepPattern &p, bool moves)
    {
        switch (p.kind) {
        case Kind::Forgotten:
            return {FlightText::tr("The way of %who is not multiplied by the timestep"),
                    FlightText::tr("A velocity says how far it gets in a whole second; a step "
                                   "lasts only Δt.")};
        case Kind::Squared:
            return {FlightText::tr("The way of %who is multiplied by the timestep twice"),
                    FlightText::tr("Count how often the timestep stands in the line that moves "
                                   "it.")};
        case Kind::Divided:
            return {FlightText::tr("The way of %who is divided by the timestep"),
                    FlightText::tr("A velocity times a time is a length. Look at what stands "
                                   "before the timestep in the line that moves it.")};
        case Kind::Fixed:
            return {FlightText::tr("A fixed number stands for the timestep in the way of %who"),
                    FlightText::tr(
                        "At every timestep tried it goes as far as in %1 s. Take the parameter "
                        "of `on_update`.")
                        .arg(briefTimestep(p.value))};
        case Kind::Constant:
            break;
        case Kind::Other:
            return {FlightText::tr("The way of %who in a step is not v Δt"),
                    FlightText::tr("Look at the line that changes the position.")};
        }
        if (p.value == 0.0 && moves)
            return {FlightText::tr("The velocity has no part in the way of %who"),
                    FlightText::tr(
                        "Every step must add v Δt to the position. Look at what the line that "
                        "changes the position takes in its place.")};
        if (p.value == 0.0)
            return {FlightText::tr("In free flight a step moves %who nowhere"),
                    FlightText::tr("Every step must add v Δt to the position.")};
        if (std::abs(p.value + 1.0) < wrong)
            return {FlightText::tr("The way of %who is subtracted instead of added"),
                    FlightText::tr("Look at the sign in the line that moves it.")};
        if (std::abs(p.value - 2.0) < wrong)
            return {FlightText::tr("Every step moves %who twice as far"),
                    FlightText::tr("Count the lines that change the position in a step without a "
                                   "hit, and look at their factors.")};
        return {FlightText::tr("The way of %who in a step is %1 times v Δt")
                    .arg(briefBeside(p.value, 1.0)),
                FlightText::tr("Look at the factors in the line that moves it.")};
    }
};

} // namespace

std::optional<FlightSaid> waySaid(const FlightComparison &comparison)
{
    auto fault = WayJudge(comparison).way();
    // What is measured from the second step on says nothing of who sticks where the first one has
    // put it.
    return fault ? leapingWaySaid(comparison).value_or(*fault) : fault;
}

std::optional<FlightSaid> strongWaySaid(const FlightComparison &comparison)
{
    return WayJudge(comparison).strongWay();
}

} // namespace cradle
