// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/condition_comparison.h"
#include "tasks/judging/flight_comparison.h"

namespace cradle {

namespace {

/// Judges steps of free flight.
class FlightConditions : ConditionComparison
{
public:
    explicit FlightConditions(const ConditionComparison &comparison)
        : ConditionComparison(comparison)
    {
    }

    [[nodiscard]] ConditionedAspect judge()
    {
        for (const auto law : {&FlightConditions::sayTurns, &FlightConditions::sayWays,
                               &FlightConditions::sayMethods}) {
            if (m_said.deviations.empty() || !m_said.deviations.front().isConditional)
                (this->*law)();
        }
        return std::move(m_said);
    }

private:
    /// What the reference makes of \p seen.
    [[nodiscard]] Motion wantedOf(const FlightOccasion &seen) const
    {
        return m_right.flight()
            .at(m_ground.gravities.front(), timestep(), seen.circle)
            .after(seen.before, timestep());
    }
    [[nodiscard]] double timestep() const { return m_ground.stage().timestep; }

    /// Whether a wall may have a part in it: it is near one, or comes past one in that step.
    [[nodiscard]] bool isNearWall(const FlightOccasion &seen) const
    {
        const auto reaches = [&](Vec2 place, double radii) {
            return std::max(std::abs(place.x), std::abs(place.y))
                   > m_ground.stage().halfWidth - radii * seen.before.radius;
        };
        return reaches(seen.before.position, 5.0) || reaches(wantedOf(seen).position, 1.0);
    }

    /// The steps of circles that do not always make them rightly.
    template <class Takes, class IsRight>
    [[nodiscard]] Series<FlightOccasion> mixed(Takes takes, IsRight isRight) const
    {
        Series<FlightOccasion> series;
        for (const FlightOccasion &seen : m_own.flightAgain()) {
            const Flight &flight =
                m_own.flight().at(m_ground.gravities.front(), timestep(), seen.circle);
            if (m_ground.flights[static_cast<std::size_t>(seen.circle)].asked
                && (flight.isKnown || !flight.isTimeless) && takes(seen))
                series.add(seen, seen, isRight(seen));
        }
        const std::vector<int> circles =
            series.wrongCircles([](const FlightOccasion &seen) { return seen.circle; });
        return series.those([&](const FlightOccasion &seen) {
            return std::find(circles.begin(), circles.end(), seen.circle) != circles.end();
        });
    }

    /// What divides the right ones from the others; else something may be hit that is not there.
    [[nodiscard]] std::optional<Condition> dividing(const Series<FlightOccasion> &series) const
    {
        const auto condition = conditionOf(series.when);
        if (condition && condition->isOfPlace() && isOfAWall(series.firstWrong().own->circle))
            return std::nullopt;
        const bool isDivided = condition && condition->kind != Condition::Kind::Sometimes
                               && condition->kind != Condition::Kind::Setting;
        return isDivided ? condition : std::nullopt;
    }

    /// Whether a wall that is elsewhere than it should be turns it: that is no fault of its flight.
    [[nodiscard]] bool isOfAWall(int circle) const
    {
        const Vec2 g = m_ground.gravities.front();
        return m_own.flight()
            .strayWall(g, timestep(), circle, m_right.flight().at(g, timestep(), circle))
            .has_value();
    }

    void sayTurns()
    {
        const auto off = [&](const FlightOccasion &seen) {
            return length(seen.after.velocity - wantedOf(seen).velocity);
        };
        const auto series = mixed(
            [&](const FlightOccasion &seen) {
                // What turns or stops it near a wall is no fault of its flight.
                return !isNearWall(seen) || off(seen) <= 0.5 * length(seen.before.velocity);
            },
            [&](const FlightOccasion &seen) {
                return off(seen) < 1e-6 * (1.0 + length(seen.before.velocity));
            });
        const auto condition = dividing(series);
        if (!condition)
            return;
        const FlightOccasion &seen = *series.firstWrong().own;
        const Vec2 was = seen.after.velocity - seen.before.velocity;
        const Vec2 wanted = wantedOf(seen).velocity - seen.before.velocity;
        const bool isFall =
            wanted != Vec2{} && std::abs(cross(was, wanted)) < 1e-6 * length(wanted);
        sayOf(series, *condition,
              isFall ? ConditionText::tr("At times gravity acts wrongly on %who")
                     : ConditionText::tr("At times the velocity of %who changes wrongly"),
              ConditionText::tr("At %1 s of its run circle %2, at %3 m and touching nothing, "
                                "changed its velocity by %4 m/s in a step of %5 s; %6 m/s is "
                                "right."),
              was, wanted);
    }

    void sayWays()
    {
        // Whichever method moves it.
        const double ofMethods =
            1.01 * length(m_ground.gravities.front()) * timestep() * timestep();
        const auto series = mixed([&](const FlightOccasion &seen) { return !isNearWall(seen); },
                                  [&](const FlightOccasion &seen) {
                                      return length(seen.after.position - wantedOf(seen).position)
                                             < 1e-6 + ofMethods;
                                  });
        const auto condition = dividing(series);
        if (!condition)
            return;
        const FlightOccasion &seen = *series.firstWrong().own;
        sayOf(series, *condition,
              ConditionText::tr("At times the way of %who in a step is not v Δt"),
              ConditionText::tr("At %1 s of its run circle %2, at %3 m and touching nothing, "
                                "went %4 m in a step of %5 s; %6 m is right."),
              seen.after.position - seen.before.position,
              wantedOf(seen).position - seen.before.position, true);
    }

    /// Where one method is asked for, or the same for all, that is right; else the one of its
    /// first step, which a circle must keep.
    void sayMethods()
    {
        const Vec2 fall = timestep() * timestep() * m_ground.gravities.front();
        if (lengthSquared(fall) == 0.0)
            return;
        const auto shareOf = [&](const FlightOccasion &seen) {
            const Vec2 more =
                seen.after.position - seen.before.position - timestep() * seen.before.velocity;
            return dot(more, fall) / lengthSquared(fall);
        };
        const auto &all = m_own.flightAgain();
        const auto wanted = [&](int circle) {
            const auto &shares = m_ground.flights[static_cast<std::size_t>(circle)].shares;
            if (shares.size() == 1)
                return shares.front();
            const auto at = std::find_if(all.begin(), all.end(), [&](const FlightOccasion &seen) {
                return m_ground.sameIntegrator || seen.circle == circle;
            });
            return shareOf(*at);
        };
        const auto mixedUp = mixed(
            [&](const FlightOccasion &seen) {
                return !isNearWall(seen) && !methodName(wanted(seen.circle)).isEmpty();
            },
            [&](const FlightOccasion &seen) {
                return std::abs(shareOf(seen) - wanted(seen.circle)) < 0.01;
            });
        if (rightOnes(mixedUp.when) == static_cast<int>(mixedUp.when.size()))
            return;
        const double share = wanted(mixedUp.firstWrong().own->circle);
        const auto series =
            mixedUp.those([&](const FlightOccasion &seen) { return wanted(seen.circle) == share; });
        const auto condition = dividing(series);
        if (!condition)
            return;
        const FlightOccasion &seen = *series.firstWrong().own;
        sayOf(series, *condition,
              ConditionText::tr("At times the motion of %who is not %1").arg(methodName(share)),
              ConditionText::tr("At %1 s of its run circle %2, at %3 m and touching nothing, "
                                "went %4 m in a step of %5 s; by that method it is %6 m."),
              seen.after.position - seen.before.position,
              timestep() * seen.before.velocity + share * fall, true);
    }

    /// \param text  of the first wrong one, with what \p was seen and what was \p wanted
    void sayOf(const Series<FlightOccasion> &series, const Condition &condition,
               const QString &headline, const QString &text, Vec2 was, Vec2 wanted,
               bool isPosition = false)
    {
        const FlightOccasion &seen = *series.firstWrong().own;
        Preset stage = m_ground.stage();
        stage.gravity = m_ground.gravities.front();
        stage.circles[static_cast<std::size_t>(seen.circle)].body = seen.before;
        say(Aspect::Motion,
            {headline,
             text.arg(brief(seen.when.time))
                 .arg(seen.circle + 1)
                 .arg(brief(seen.before.position), brief(was), briefTimestep(timestep()),
                      brief(wanted)),
             triesTold(series.when)},
            condition, series.wrongCircles([](const FlightOccasion &one) { return one.circle; }),
            {.stage = {stage, true}, .isPosition = isPosition},
            [](const LawDeviation &) { return true; });
    }
};

} // namespace

ConditionedAspect conditionedFlight(const ConditionComparison &comparison)
{
    return FlightConditions(comparison).judge();
}

} // namespace cradle
