// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"
#include "tasks/judging/flight_comparison.h"

namespace cradle {

namespace {

/// Tells of a wall that answers far from where it is.
class StrayJudge : FlightComparison
{
public:
    explicit StrayJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    [[nodiscard]] std::optional<FlightSaid> judge() const
    {
        const auto wall =
            right().isKnown ? m_own.strayWall(gravity(), timestep(), m_i, right()) : std::nullopt;
        if (!wall)
            return std::nullopt;
        QString seen =
            FlightText::tr("Thrown straight towards the %1 with %2 m/s from %3 m, circle %4 has "
                           "%5 m/s one step of %6 s later.")
                .arg(motion::wallName(wall->wall), brief(wall->before.velocity),
                     brief(wall->before.position))
                .arg(m_i + 1)
                .arg(brief(wall->after.velocity), briefTimestep(timestep()));
        const Vec2 off = wall->after.position - wall->wanted.position;
        if (length(off) > far)
            seen += QLatin1Char(' ')
                    + FlightText::tr("It is at %1 m then.").arg(brief(wall->after.position));
        const QString headline = wall->isOfStart
                                     ? FlightText::tr("A start towards the %1 turns %who round")
                                     : FlightText::tr("Far from the %1 something turns %who round");
        FlightSaid fault =
            said(headline.arg(motion::wallName(wall->wall)),
                 seen + QLatin1Char(' ') + where(*wall) + QLatin1Char(' ')
                     + (wall->isOfStart
                            ? FlightText::tr("Turned towards it by the wall opposite, it goes on. "
                                             "Look at what your program takes over of the "
                                             "velocity that a run begins with.")
                            : FlightText::tr("Look at what your program asks for that wall, at "
                                             "the lengths there and at their signs.")),
                 false);
        fault.moment = {wall->stage, 1, {m_i}, false};
        fault.suspect = wall->isOfStart ? Suspect::Answer : Suspect::Question;
        fault.isOfWall = true;
        return fault;
    }

private:
    static constexpr double far = 0.3;    ///< more than a step's way, m
    static constexpr double known = 1e-5; ///< of a limit, m

    [[nodiscard]] QString where(const StrayWall &wall) const
    {
        if (!wall.from)
            return FlightText::tr("So it is from all places tried; thrown the other way it goes on "
                                  "as it should.");
        const Vec2 n = outwardNormal(wall.wall);
        const auto coordinate = [&](double distance) {
            return (n.x != 0.0 ? QStringLiteral("x = %1 m") : QStringLiteral("y = %1 m"))
                .arg(brief((n.x + n.y) * std::round(distance / known) * known));
        };
        return FlightText::tr("So it is where its centre comes to %1 or farther, and its rim to "
                              "%2; the wall is at %3.")
            .arg(coordinate(*wall.from), coordinate(*wall.from + wall.before.radius),
                 coordinate(wall.stage.preset.halfWidth));
    }
};

} // namespace

std::optional<FlightSaid> strayWallSaid(const FlightComparison &comparison)
{
    return StrayJudge(comparison).judge();
}

} // namespace cradle
