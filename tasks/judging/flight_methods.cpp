// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"
#include "tasks/judging/flight_comparison.h"

namespace cradle {

namespace {

class MethodJudge : FlightComparison
{
public:
    explicit MethodJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> method(bool isFallRight) const
    {
        const auto shares = m_ground.flights[static_cast<std::size_t>(m_i)].shares;
        for (const Vec2 g : m_ground.gravities) {
            const auto share = m_own.at(g, timestep(), m_i).share(timestep());
            if (!share)
                continue;
            const auto is = [&](double s) { return isOneMethod(*share, s); };
            if (std::any_of(shares.begin(), shares.end(), is) || isSubstepped(*share)
                || (!isFallRight && !isOtherMethod(g, *share)))
                return std::nullopt;
            return FlightSaid{
                headlineOf(*share, shares),
                FlightText::tr(
                    "Under gravity %1 m/s² the way of a step is %2, with v from before it.")
                        .arg(brief(g), wayBy(*share))
                    + QLatin1Char(' ') + askedFor(shares),
                moment(true, g), true};
        }
        return std::nullopt;
    }

private:
    /// Whether that share is a method of its own, and not the right drift beside a wrong fall.
    [[nodiscard]] bool isOtherMethod(Vec2 g, double share) const
    {
        const Vec2 a = m_right.at(g, timestep(), m_i).acceleration;
        const Vec2 drift = m_own.at(g, timestep(), m_i).drift;
        const double asked = dot(drift, a) / (lengthSquared(a) * timestep() * timestep());
        const auto &shares = m_ground.flights[static_cast<std::size_t>(m_i)].shares;
        return lengthSquared(a) > 0.0 && (isOneMethod(share, 0.0) || isOneMethod(share, 1.0))
               && std::none_of(shares.begin(), shares.end(),
                               [&](double s) { return isOneMethod(asked, s); });
    }

    /// Whether it is one or the other Euler in n equal parts of a step: ½ ± 1/2n.
    [[nodiscard]] bool isSubstepped(double share) const
    {
        constexpr double most = 20.0; // more are not told from the exact methods
        const double parts = 0.5 / std::abs(share - 0.5);
        return m_ground.flights[static_cast<std::size_t>(m_i)].isAnyMethod
               && (parts > most || std::abs(parts - std::round(parts)) < 5e-3 * parts);
    }

    /// One or the other of the methods that are asked for, as \p told says each.
    static QString eachOf(const std::vector<double> &wanted, QString (*told)(double))
    {
        QStringList all;
        for (const double share : wanted)
            all.append(told(share));
        return all.join(FlightText::tr(" or "));
    }

    /// What would be right, in the words of the methods.
    static QString askedFor(const std::vector<double> &wanted)
    {
        const auto isOnly = [&](double s) {
            return wanted.size() == 1 && isOneMethod(wanted.front(), s);
        };
        if (wanted.size() > 2)
            return FlightText::tr(
                "Euler adds nothing to v Δt, symplectic Euler g Δt², the exact "
                "methods (Verlet, Runge-Kutta 4) ½ g Δt²; one of these is asked for.");
        if (isOnly(0.0))
            return FlightText::tr("Euler moves by the velocity from before the step alone.");
        if (isOnly(1.0))
            return FlightText::tr("Symplectic Euler changes the velocity first and moves by the "
                                  "new one, which is v Δt + g Δt².");
        return FlightText::tr("%1 is asked for.").arg(eachOf(wanted, wayBy));
    }

    static QString headlineOf(double share, const std::vector<double> &wanted)
    {
        if (isOneMethod(share, -0.5) && std::any_of(wanted.begin(), wanted.end(), [](double s) {
                return isOneMethod(s, 0.5);
            }))
            return FlightText::tr("The sign of ½ g Δt² is wrong in the motion of %who");
        const QString asked = eachOf(wanted, methodName);
        if (const QString name = methodName(share); !name.isEmpty())
            return FlightText::tr("The motion of %who is %1, not %2").arg(name, asked);
        return wanted.size() > 1
                   ? FlightText::tr("The motion of %who is no known method")
                   : FlightText::tr("The motion of %who is no known method; %1 is asked for")
                         .arg(asked);
    }
};

} // namespace

bool isOneMethod(double share, double other)
{
    return std::abs(share - other) < 1e-3;
}

QString methodName(double share)
{
    if (isOneMethod(share, 0.0))
        return motion::integratorName(Integrator::Euler);
    if (isOneMethod(share, 1.0))
        return motion::integratorName(Integrator::SymplecticEuler);
    return isOneMethod(share, 0.5) ? FlightText::tr("the exact parabola") : QString();
}

QString wayBy(double share)
{
    if (isOneMethod(share, 0.0))
        return QStringLiteral("v Δt");
    const QString sign = share < 0.0 ? QStringLiteral(" − ") : QStringLiteral(" + ");
    const double size = std::abs(share);
    const QString factor = isOneMethod(size, 1.0)   ? QString()
                           : isOneMethod(size, 0.5) ? QStringLiteral("½ ")
                                                    : brief(size) + QLatin1Char(' ');
    return QStringLiteral("v Δt") + sign + factor + QStringLiteral("g Δt²");
}

std::optional<FlightSaid> methodSaid(const FlightComparison &comparison, bool isFallRight)
{
    return MethodJudge(comparison).method(isFallRight);
}

std::optional<LawDeviation> methodsTogether(const MeasuredFlight &own, const Ground &ground)
{
    const double h = ground.timesteps.front();
    std::vector<double> shares;
    std::vector<int> circles;
    for (std::size_t i = 0; i < ground.flights.size(); ++i) {
        const int circle = static_cast<int>(i);
        for (const Vec2 g : ground.gravities) {
            if (const auto share = own.at(g, h, circle).share(h)) {
                shares.push_back(*share);
                circles.push_back(circle);
                break;
            }
        }
    }
    if (shares.size() != ground.flights.size() || shares.size() < 2)
        return std::nullopt;
    const auto asks = [&](std::size_t i, double share) {
        const auto &all = ground.flights[i].shares;
        return std::any_of(all.begin(), all.end(), [&](double s) { return isOneMethod(s, share); });
    };
    LawDeviation deviation{
        .moment = {flightStage(ground, ground.gravities.front(), h), 2, circles, true},
        .isMethod = true};
    const bool exchanged =
        asks(0, shares[1]) && asks(1, shares[0]) && !asks(0, shares[0]) && !asks(1, shares[1]);
    if (exchanged) {
        deviation.message =
            FlightText::tr("The circles have each other's method\n\nUnder gravity the way of "
                           "circle 1 in a step is %1, that of circle 2 %2; it "
                           "should be the other way round. Look at which circle goes with which "
                           "method.")
                .arg(wayBy(shares[0]), wayBy(shares[1]));
        return deviation;
    }
    if (ground.sameIntegrator && !isOneMethod(shares[0], shares[1]) && asks(0, shares[0])
        && asks(1, shares[1])) {
        deviation.message =
            FlightText::tr("The circles move by different methods\n\nUnder gravity circle 1 moves "
                           "by %1, with the way %2 in a step, and circle 2 by %3, with %4; both "
                           "need the same. Look at which lines move which circle.")
                .arg(methodName(shares[0]), wayBy(shares[0]), methodName(shares[1]),
                     wayBy(shares[1]));
        return deviation;
    }
    return std::nullopt;
}

} // namespace cradle
