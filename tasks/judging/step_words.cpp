// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/likeness.h"

namespace cradle {

namespace {

using Kind = TimestepPattern::Kind;

/// Judges whether all of a step is made with another timestep, or not at all: its way and what
/// gravity changes are one fault then.
class StepJudge : FlightComparison
{
public:
    explicit StepJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> step() const
    {
        const auto times = factor();
        if (!times)
            return std::nullopt;
        if (times->kind == Kind::Fixed) {
            FlightSaid fault =
                tell(FlightText::tr("A fixed number stands for the timestep of %who"),
                     FlightText::tr("At every timestep tried the whole step is made as if Δt "
                                    "were %1 s. Take the parameter of `on_update`.")
                         .arg(briefTimestep(times->value)),
                     shownTimestep(*times));
            fault.topic = Topic::Timestep;
            return fault;
        }
        if (times->value == 0.0) {
            FlightSaid fault =
                tell(FlightText::tr("In free flight a step leaves %who as it was"),
                     FlightText::tr("The position does not change, either. Look at whether the "
                                    "lines that move a circle are reached in every step, and for "
                                    "which circle."),
                     0);
            fault.suspect = Suspect::Omission;
            return fault;
        }
        return tell(
            (isOfMethod(times->value)
                 ? FlightText::tr("The whole step of %who is made as with %1 Δt")
                 : FlightText::tr("A step of %who does %1 times what it should"))
                .arg(briefBeside(times->value, 1.0)),
            FlightText::tr("The way is %1 times v Δt, too: look at which Δt the lines of a step "
                           "take, and at how often they run.")
                .arg(briefBeside(times->value, 1.0)),
            0);
    }

private:
    [[nodiscard]] static bool isOne(const TimestepPattern &a, const TimestepPattern &b)
    {
        return a.kind == b.kind && std::abs(a.value - b.value) < wrong * std::abs(b.value) + 1e-9;
    }

    /// The gravity of the checks in which it shows what a step makes of it.
    [[nodiscard]] std::optional<Vec2> falling() const
    {
        const auto at = std::find_if(m_ground.gravities.begin(), m_ground.gravities.end(),
                                     [](Vec2 g) { return g != Vec2{}; });
        return at == m_ground.gravities.end() ? std::nullopt : std::optional(*at);
    }

    /// What the timestep is multiplied by, or replaced by, in all that a step changes.
    [[nodiscard]] std::optional<TimestepPattern> factor() const
    {
        const auto g = falling();
        if (!g || !flight(0).isKnown || hasPull() || !right().isKnown
            || length(flight(0).growth) + length(right().growth) > wrong)
            return std::nullopt;
        const Vec2 asked = m_right.at(*g, timestep(), m_i).acceleration;
        const Vec2 made = m_own.at(*g, timestep(), m_i).acceleration;
        if (length(asked) < wrong || std::abs(cross(made, asked)) > wrong * lengthSquared(asked))
            return std::nullopt;
        const auto x = pattern(gravity(), [](const Flight &f) { return f.way.x; });
        const auto y = pattern(gravity(), [](const Flight &f) { return f.way.y; });
        const auto fall = pattern(*g, [&](const Flight &f) { return dot(f.acceleration, asked); });
        const bool isWhole =
            fall.kind == Kind::Fixed
            || (fall.kind == Kind::Constant && !isRight(fall) && fall.value >= 0.0);
        return isWhole && !isRight(x) && isOne(x, fall) && isOne(y, fall) ? std::optional(fall)
                                                                          : std::nullopt;
    }

    /// Whether what gravity adds to the way, too, is as a method has it in one step with so many
    /// Δt, or in so many steps.
    [[nodiscard]] bool isOfMethod(double times) const
    {
        const Vec2 g = *falling();
        const Vec2 fall = timestep() * timestep() * m_right.at(g, timestep(), m_i).acceleration;
        const double added = dot(m_own.at(g, timestep(), m_i).drift, fall) / lengthSquared(fall);
        const auto adds = [&](double share) { return std::abs(added - share) < 1e-3; };
        const bool isCount = std::abs(times - std::round(times)) < wrong;
        for (const double share : {0.0, 0.5, 1.0}) {
            if (adds(share * times * times)
                || (isCount && adds(share * times + 0.5 * times * (times - 1.0))))
                return true;
        }
        return false;
    }

    [[nodiscard]] FlightSaid tell(const QString &headline, const QString &where,
                                  std::size_t shown) const
    {
        const Vec2 g = *falling();
        const double h = m_ground.timesteps[shown];
        const Vec2 is = h * m_own.at(g, h, m_i).acceleration;
        const Vec2 asked = h * m_right.at(g, h, m_i).acceleration;
        return {
            headline,
            FlightText::tr("Under gravity %1 m/s² the velocity changes by %2 m/s in a step of "
                           "%3 s; it should change by %4 m/s.")
                    .arg(brief(g), briefBeside(is, asked), briefTimestep(h), briefBeside(asked, is))
                + QLatin1Char(' ') + where,
            moment(false, g)};
    }
};

} // namespace

std::optional<FlightSaid> stepSaid(const FlightComparison &comparison)
{
    return StepJudge(comparison).step();
}

} // namespace cradle
