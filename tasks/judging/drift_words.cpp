// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/likeness.h"

namespace cradle {

namespace {

/// Judges what a step adds to the place besides v Δt, where that is no share of g Δt².
class DriftJudge : FlightComparison
{
public:
    explicit DriftJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
        , m_h{timestep(), m_ground.timesteps.size() > 1 ? m_ground.timesteps[1] : 0.5 * timestep()}
    {
    }

    [[nodiscard]] std::optional<FlightSaid> drift() const
    {
        for (const Vec2 g : m_ground.gravities) {
            if (auto fault = driftUnder(g))
                return fault;
        }
        return std::nullopt;
    }

    /// Of one that gravity takes from rest so far that a wall holds it: under weaker gravity.
    [[nodiscard]] std::optional<FlightSaid> strongDrift() const
    {
        const auto start = m_ground.stage().circles[static_cast<std::size_t>(m_i)].body.position;
        for (const Vec2 g : m_ground.gravities) {
            if (length(at(g, 0).restedAt - start) < farInAStep)
                continue;
            const Vec2 weaker = weak * g;
            if (at(weaker, 0).isKnown && at(weaker, 1).isKnown)
                return driftUnder(weaker);
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<FlightSaid> byVelocity() const { return byVelocity(gravity()); }

private:
    [[nodiscard]] std::optional<FlightSaid> driftUnder(Vec2 g) const
    {
        // Where a way is not linear in the velocity, nothing is added to each alike.
        if (!at(g, 0).isWayLinear)
            return byVelocity(g);
        if (isShare(g))
            return std::nullopt;
        for (const int power : {0, 1, 2}) {
            if (const auto besides = goesWith(power, g))
                return told(power, g, *besides);
        }
        return odd(g);
    }

    /// Each of the steps seen is one of a method, and they are not of the same.
    [[nodiscard]] std::optional<FlightSaid> byVelocity(Vec2 g) const
    {
        const Flight &f = at(g, 0);
        const Vec2 fall = m_h[0] * m_h[0] * m_right.at(g, m_h[0], m_i).acceleration;
        if (lengthSquared(fall) == 0.0)
            return std::nullopt;
        const auto share = [&](const Flight::Step &step) {
            return dot(step.way - m_h[0] * step.velocity, fall) / lengthSquared(fall);
        };
        const Flight::Step &a = f.seen[0];
        const Flight::Step &b =
            std::abs(share(a) - share(f.seen[1])) < 0.01 ? f.fromRest : f.seen[1];
        const auto isOfMethod = [&](const Flight::Step &step) {
            const Vec2 rest = step.way - m_h[0] * step.velocity - share(step) * fall;
            return length(rest) < 1e-8
                   && std::abs(2.0 * share(step) - std::round(2.0 * share(step))) < 1e-3
                   && std::abs(share(step) - 0.5) < 0.6;
        };
        if (!isOfMethod(a) || !isOfMethod(b) || std::abs(share(a) - share(b)) < 0.01)
            return std::nullopt;
        return FlightSaid{
            FlightText::tr("The method that moves %who depends on the velocity"),
            FlightText::tr("The way of a step is %1 with the velocity %2 m/s, and %3 with %4 m/s. "
                           "Euler adds nothing to v Δt, symplectic Euler g Δt², the exact methods "
                           "½ g Δt². Look at what is asked before the lines that change the "
                           "position.")
                .arg(wayBy(share(a)), brief(a.velocity), wayBy(share(b)), brief(b.velocity)),
            moment(true, g)};
    }

    /// What is nothing but rounding, m.
    static constexpr double noWay = 1e-9;
    static constexpr std::array shares{0.0, 0.5, 1.0};

    [[nodiscard]] const Flight &at(Vec2 g, std::size_t k) const { return m_own.at(g, m_h[k], m_i); }

    /// What is left if a method with that share made the rest.
    [[nodiscard]] Vec2 left(Vec2 g, std::size_t k, double share) const
    {
        const Flight &f = at(g, k);
        return f.drift - share * m_h[k] * m_h[k] * f.acceleration;
    }

    /// Whether it is the same share of a Δt² with either timestep, and nothing else.
    [[nodiscard]] bool isShare(Vec2 g) const
    {
        const auto one = at(g, 0).share(m_h[0]);
        const auto two = at(g, 1).share(m_h[1]);
        if (!one || !two)
            return length(at(g, 0).drift) < noWay && length(at(g, 1).drift) < noWay;
        const double slack = noWay + 1e-3 * m_h[0] * m_h[0] * length(at(g, 0).acceleration);
        return std::abs(*one - *two) < 1e-3 && length(left(g, 0, *one)) < slack;
    }

    /// What is left of the way, divided by that power of Δt, if that is the same with either
    /// timestep for one of the methods.
    [[nodiscard]] std::optional<Vec2> goesWith(int power, Vec2 g) const
    {
        for (const double share : shares) {
            const Vec2 one = left(g, 0, share) / std::pow(m_h[0], power);
            const Vec2 two = left(g, 1, share) / std::pow(m_h[1], power);
            if (length(one - two) < 1e-4 * length(one) && isLeftBy(share))
                return one;
        }
        return std::nullopt;
    }

    /// Whether what a method with that share leaves is looked at: one that would be right, or all
    /// that is besides v Δt.
    [[nodiscard]] bool isLeftBy(double share) const { return share == 0.0 || isWanted(share); }

    /// Whether a method with that share would be right.
    [[nodiscard]] bool isWanted(double share) const
    {
        const auto &asked = m_ground.flights[static_cast<std::size_t>(m_i)].shares;
        return std::any_of(asked.begin(), asked.end(),
                           [&](double s) { return isOneMethod(s, share); });
    }

    /// Whether what is left with that power of Δt is another under half the gravity.
    [[nodiscard]] bool isOfGravity(int power, Vec2 g, Vec2 besides) const
    {
        const Flight &f = m_own.at(0.5 * g, m_h[0], m_i);
        return std::none_of(shares.begin(), shares.end(), [&](double share) {
            const Vec2 same =
                (f.drift - share * m_h[0] * m_h[0] * f.acceleration) / std::pow(m_h[0], power);
            return isLeftBy(share) && length(same - besides) < 1e-3 * length(besides);
        });
    }

    [[nodiscard]] FlightSaid told(int power, Vec2 g, Vec2 besides) const
    {
        if (isOfGravity(power, g, besides)) {
            if (power > 1)
                return odd(g);
            return {power == 1 ? FlightText::tr("What gravity adds to the way of %who goes with "
                                                "Δt, not with Δt²")
                               : FlightText::tr("What gravity adds to the way of %who does not "
                                                "depend on Δt"),
                    seen(g) + QLatin1Char(' ')
                        + FlightText::tr("A way is a length, as g Δt² is; g Δt is a velocity and "
                                         "g an acceleration."),
                    moment(true, g)};
        }
        if (power == 0)
            return {
                FlightText::tr("Every step moves %who by a fixed way besides v Δt"),
                FlightText::tr("At every timestep, gravity and velocity tried it goes on by %1 m "
                               "besides. Look at what is added to the position.")
                    .arg(brief(besides)),
                moment(true, g)};
        if (power == 1)
            return {FlightText::tr("Something besides its own velocity moves %who"),
                    FlightText::tr("At every gravity and velocity tried it goes on by %1 m/s "
                                   "times Δt besides. Look at what is added to the position.")
                        .arg(brief(besides)),
                    moment(true, g)};
        return odd(g);
    }

    [[nodiscard]] FlightSaid odd(Vec2 g) const
    {
        return {FlightText::tr("What a step adds to the way of %who besides v Δt is no method's"),
                seen(g), moment(true, g)};
    }

    [[nodiscard]] QString seen(Vec2 g) const
    {
        return FlightText::tr("Besides v Δt it goes %1 m in a step of %2 s under gravity %3 m/s², "
                              "and %4 m in one of %5 s. Euler adds nothing to v Δt, symplectic "
                              "Euler g Δt², the exact methods ½ g Δt².")
            .arg(brief(at(g, 0).drift), briefTimestep(m_h[0]), brief(g), brief(at(g, 1).drift),
                 briefTimestep(m_h[1]));
    }

    std::array<double, 2> m_h; ///< timesteps, s
};

} // namespace

std::optional<FlightSaid> driftSaid(const FlightComparison &comparison)
{
    return DriftJudge(comparison).drift();
}

std::optional<FlightSaid> methodByVelocity(const FlightComparison &comparison)
{
    return DriftJudge(comparison).byVelocity();
}

std::optional<FlightSaid> strongDriftSaid(const FlightComparison &comparison)
{
    return DriftJudge(comparison).strongDrift();
}

} // namespace cradle
