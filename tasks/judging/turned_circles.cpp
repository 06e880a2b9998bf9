// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/turned_circles.h"

#include <algorithm>

namespace cradle {

bool isTurnedAhead(const MeasuredLaws &laws, const Ground &ground, const StepDeviations &deviations)
{
    for (std::size_t i = 0; i < ground.flights.size(); ++i) {
        const Flight &flight = laws.flight().at(ground.gravities.front(), ground.timesteps.front(),
                                                static_cast<int>(i));
        if (!flight.isKnown || (flight.leap && flight.leap->speed != Flight::Speed::Fast))
            return false;
    }
    if (ground.walls.circles.empty() || deviations.of(laws, Aspect::Motion).size() != 1)
        return false;
    const auto walls = deviations.of(laws, Aspect::Walls);
    return deviations.failedOf(Aspect::Walls)
           && std::any_of(walls.begin(), walls.end(), [](const LawDeviation &wall) {
                  return wall.family == QLatin1String("ahead");
              });
}

bool isTurnedFar(const MeasuredLaws &laws, const Ground &ground, const StepDeviations &deviations)
{
    const auto motion = deviations.of(laws, Aspect::Motion);
    if (ground.walls.circles.empty() || motion.size() != 1 || motion.front().moment.stage.pinned
        || !deviations.failedOf(Aspect::Walls))
        return false;
    const MeasuredFlight::Own &own = laws.flight().own();
    const std::vector<int> &circles = motion.front().moment.circles;
    return std::all_of(circles.begin(), circles.end(), [&](int circle) {
        const auto i = static_cast<std::size_t>(circle);
        const Circle &c = own.scene.circles[i].body;
        const Vec2 next = c.velocity + own.scene.timestep * own.accelerations[i];
        return std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
            const Vec2 n = outwardNormal(wall);
            return dot(n, c.velocity) * dot(n, next) < 0.0
                   && laws.walls().turnsFarAt(circle, wall,
                                              own.scene.halfWidth - dot(n, c.position));
        });
    });
}

bool isTurnedByAWall(int circle, const MeasuredLaws &laws)
{
    const std::vector<WallHit> &hits = laws.walls().hits;
    return std::any_of(hits.begin(), hits.end(),
                       [&](const WallHit &hit) { return hit.circle == circle && hit.turned; });
}

bool isPushed(int circle, const MeasuredLaws &laws)
{
    const auto pushes = [circle](const PairHit &hit) {
        return hit.answered && length(circle == 0 ? hit.push1() : hit.push2()) > 1e-9;
    };
    const MeasuredPair &pair = laws.pair();
    return circle < 2
           && (std::any_of(pair.contacts.begin(), pair.contacts.end(), pushes)
               || std::any_of(pair.varied.begin(), pair.varied.end(), pushes));
}

} // namespace cradle
