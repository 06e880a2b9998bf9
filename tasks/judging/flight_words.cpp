// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"

#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/likeness.h"

#include <algorithm>

namespace cradle {

namespace {

/// Whether what is told of one circle, with its numbers, may be told of the other: where both
/// follow a law it is one law, or one method.
bool isOneLaw(const Flight &a, const Flight &b, bool isMethod)
{
    if (!a.isKnown || !b.isKnown)
        return true;
    return isMethod ? isAlike(a.drift, b.drift)
                    : isAlike(a.way, b.way) && isAlike(a.acceleration, b.acceleration)
                          && isAlike(a.growth, b.growth) && isAlike(a.pull, b.pull);
}

/// What is said of each circle that is asked for.
std::vector<std::pair<int, std::vector<FlightSaid>>>
saidOfAll(const MeasuredFlight &own, const MeasuredFlight &right, const Ground &ground)
{
    std::vector<std::pair<int, std::vector<FlightSaid>>> all;
    if (ground.timesteps.empty() || ground.gravities.empty())
        return all;
    bool isOfWall = false;
    for (std::size_t i = 0; i < ground.flights.size(); ++i) {
        if (!ground.flights[i].asked)
            continue;
        const int circle = static_cast<int>(i);
        all.emplace_back(circle, flightSaid({own, right, ground, circle}));
        isOfWall |= !all.back().second.empty() && all.back().second.front().isOfWall;
    }
    // A wall that turns one may turn others that flew where it does not.
    for (auto &[circle, said] : all) {
        const auto wall = isOfWall && said.empty()
                              ? strayWallSaid(FlightComparison(own, right, ground, circle))
                              : std::nullopt;
        if (wall)
            said.push_back(*wall);
    }
    return all;
}

QString withNames(QString text, const std::vector<int> &circles, std::size_t all)
{
    const QString names = circleNames(circles, all);
    return text.replace(QLatin1String("%who"), names);
}

} // namespace

std::vector<LawDeviation> flightDeviations(const MeasuredFlight &own, const MeasuredFlight &right,
                                           const Ground &ground)
{
    std::vector<std::pair<FlightSaid, std::vector<int>>> groups;
    const auto flightOf = [&](int circle) -> const Flight & {
        return own.at(ground.gravities.front(), ground.timesteps.front(), circle);
    };
    for (const auto &[circle, all] : saidOfAll(own, right, ground)) {
        const Flight &flight = flightOf(circle);
        for (const FlightSaid &said : all) {
            const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto &group) {
                return group.first.headline == said.headline
                       && (group.first.body == said.body
                           || (!said.isOfOne
                               && isOneLaw(flightOf(group.second.front()), flight, said.isMethod)));
            });
            if (same == groups.end())
                groups.push_back({said, {circle}});
            else
                same->second.push_back(circle);
        }
    }
    // Methods can be compared only where the rest is right.
    const bool onlyMethods = std::all_of(groups.begin(), groups.end(),
                                         [](const auto &group) { return group.first.isMethod; });
    const auto together = onlyMethods ? methodsTogether(own, ground) : std::nullopt;
    std::vector<LawDeviation> deviations;
    for (auto &[said, circles] : groups) {
        const QString headline = withNames(said.headline, circles, ground.flights.size());
        if (together && said.isMethod)
            continue;
        said.moment.circles = circles;
        deviations.push_back({.aspect = Aspect::Motion,
                              .message = headline + QStringLiteral("\n\n")
                                         + withNames(said.body, circles, ground.flights.size()),
                              .moment = said.moment,
                              .suspect = said.suspect,
                              .topic = said.topic,
                              .isMethod = said.isMethod,
                              .hidesHits = said.hidesHits,
                              .hidesWalls = said.hidesWalls});
    }
    if (together)
        deviations.push_back(*together);
    return deviations;
}

} // namespace cradle
