// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/wall_words.h"

#include "tests/made_hits.h"

#include <functional>

/// Hits at walls that no program made.
namespace cradle::made {

/// A hit of circle 1 at its rim, right but for what is done to it later: with so many m/s into the
/// wall and along it.
inline WallHit wallHit(Wall wall, double e, double into, double along)
{
    const Vec2 n = outwardNormal(wall);
    const Vec2 t = perpendicular(n);
    WallHit hit;
    hit.wall = wall;
    hit.restitution = e;
    hit.radius = 0.2;
    hit.otherRadius = 0.3;
    hit.turned = true;
    hit.travel = into / 60.0;
    hit.before = hit.after = 0.205;
    hit.reached = hit.before - hit.travel;
    hit.was = hit.came = into * n + along * t;
    hit.back = e;
    hit.left = -e * into * n + along * t;
    hit.step = 9;
    hit.landed = (4.0 - hit.after) * n;
    hit.stage.preset.halfWidth = 4.0;
    hit.stage.preset.timestep = 1.0 / 60.0;
    hit.stage.preset.circles.resize(2);
    hit.stage.preset.circles[0].body.position = n;
    hit.stage.preset.circles[0].body.velocity = hit.came;
    return hit;
}

/// What comes back of the part into the wall, and what stays of that along it, of such an e.
struct WallLaw {
    std::function<double(double)> back = [](double e) { return e; };
    std::function<double(double)> along = [](double) { return 1.0; };
};

inline void give(WallHit &hit, double back, double along)
{
    const Vec2 n = outwardNormal(hit.wall);
    const Vec2 t = perpendicular(n);
    hit.back = back;
    hit.along = along;
    hit.left = -back * dot(hit.came, n) * n + along * dot(hit.came, t) * t;
}

/// At each wall with e = 1 fast and slowly, and with 0.5; and at one with 0.8.
inline MeasuredWalls wallsOf(const WallLaw &law, bool hasE = true)
{
    const Ground ground(Task{}, Preset{});
    const MeasuredFlight flight(nullptr, ground);
    MeasuredWalls walls(nullptr, ground, flight);
    walls.judged = {0};
    for (const Wall wall : allWalls) {
        walls.hits.push_back(wallHit(wall, 1.0, 1.5, 0.7));
        walls.hits.push_back(wallHit(wall, 1.0, 0.6, -0.9));
        if (hasE)
            walls.hits.push_back(wallHit(wall, 0.5, 1.2, 0.4));
    }
    if (hasE)
        walls.hits.push_back(wallHit(Wall::Right, 0.8, 1.1, 0.3));
    for (WallHit &hit : walls.hits)
        give(hit, law.back(hit.restitution), law.along(hit.restitution));
    return walls;
}

/// Where e is varied, or not.
inline Ground wallGround(bool hasE = true)
{
    Preset scene;
    scene.circles.resize(2);
    Ground ground(Task{}, scene);
    ground.walls.circles = {0};
    ground.walls.restitutions = hasE ? std::vector{1.0, 0.5, 0.8} : std::vector{1.0};
    ground.flights.resize(2);
    return ground;
}

} // namespace cradle::made
