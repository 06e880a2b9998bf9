// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/condition_comparison.h"

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
        judgeFlight();
        return std::move(m_said);
    }

private:
    void judgeFlight()
    {
        Series<FlightOccasion> series;
        const double h = m_ground.stage().timestep;
        const auto wantedOf = [&](const FlightOccasion &seen) {
            return m_right.flight()
                .at(m_ground.gravities.front(), h, seen.circle)
                .after(seen.before, h);
        };
        for (const FlightOccasion &seen : m_own.flightAgain()) {
            const Flight &flight = m_own.flight().at(m_ground.gravities.front(), h, seen.circle);
            if (!m_ground.flights[static_cast<std::size_t>(seen.circle)].asked
                || (!flight.isKnown && flight.isTimeless))
                continue;
            const Vec2 off = seen.after.velocity - wantedOf(seen).velocity;
            // What turns or stops it near a wall is no fault of its flight.
            const Vec2 p = seen.before.position;
            const bool isNearWall = std::max(std::abs(p.x), std::abs(p.y))
                                    > m_ground.stage().halfWidth - 5.0 * seen.before.radius;
            if (isNearWall && length(off) > 0.5 * length(seen.before.velocity))
                continue;
            series.add(seen, seen, length(off) < 1e-6 * (1.0 + length(seen.before.velocity)));
        }
        const std::vector<int> circles =
            series.wrongCircles([](const FlightOccasion &seen) { return seen.circle; });
        series = series.those([&](const FlightOccasion &seen) {
            return std::find(circles.begin(), circles.end(), seen.circle) != circles.end();
        });
        const auto condition = conditionOf(series.when);
        // Else something may be hit that is not there.
        if (!condition || condition->kind == Condition::Kind::Sometimes
            || condition->kind == Condition::Kind::Setting)
            return;
        const FlightOccasion &seen = *series.firstWrong().own;
        const Vec2 was = seen.after.velocity - seen.before.velocity;
        const Vec2 wanted = wantedOf(seen).velocity - seen.before.velocity;
        const bool isFall =
            wanted != Vec2{} && std::abs(cross(was, wanted)) < 1e-6 * length(wanted);
        Preset stage = m_ground.stage();
        stage.gravity = m_ground.gravities.front();
        stage.circles[static_cast<std::size_t>(seen.circle)].body = seen.before;
        say(Aspect::Motion,
            (isFall ? ConditionText::tr("Gravity acts on %who as it should only %1")
                    : ConditionText::tr("The velocity of %who changes as it should only %1"))
                    .arg(phraseOf(*condition))
                + counted(series.when)
                + ConditionText::tr("At %1 s of that run circle %2, at %3 m and far from all "
                                    "others, changed its velocity by %4 m/s in a step of %5 s; "
                                    "%6 m/s is right.")
                      .arg(brief(seen.when.time))
                      .arg(seen.circle + 1)
                      .arg(brief(seen.before.position), brief(was), briefTimestep(h),
                           brief(wanted)),
            *condition, circles, {.stage = {stage, true}},
            [](const LawDeviation &) { return true; });
    }
};

} // namespace

ConditionedAspect conditionedFlight(const ConditionComparison &comparison)
{
    return FlightConditions(comparison).judge();
}

} // namespace cradle
