// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/slow_scene.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double slowestHit = 0.1;      ///< where nothing pulls, a quarter of it, m/s
constexpr int slowStepsToWall = 3;      ///< before a slow hit
constexpr double stepsAfterLetGo = 6.0; ///< behind the hit, before there is another
/// Of what is let go: the timestep, s, and the speed at the wall in what gravity makes in a step.
constexpr Vec2 letGo[letGoScenes] = {{1.0 / 60.0, 11.0}, {1.0 / 60.0, 4.5}, {1.0 / 120.0, 4.5}};

/// Where gravity pulls; downwards where there is none.
Vec2 pullOf(const Preset &preset)
{
    return preset.gravity == Vec2{} ? Vec2{0.0, -1.0} : normalized(preset.gravity);
}

} // namespace

SlowHits drawSlowHits(Random &random)
{
    const double speed = random.between(3.8, 4.2);
    return {speed, random.uniform()};
}

void placeSlowHit(Preset &preset, const SceneSpec &spec, int i, const SlowHits &hits,
                  Random &random)
{
    const Vec2 toWall = i % 2 == 0 ? pullOf(preset) : -pullOf(preset);
    const double dt = preset.timestep;
    const double pull = dot(preset.gravity, toWall) * dt;
    const double speed = hits.speed * std::max(std::abs(pull), slowestHit);
    const int half = (spec.count + 1) / 2;
    const int pair = i / 2; // one to the floor, one to the ceiling
    const double phase = (pair + hits.firstMoment) / half;
    for (const int circle : spec.circles) {
        Circle &c = preset.circles[static_cast<std::size_t>(circle)].body;
        const double room = preset.halfWidth - c.radius;
        const double gap = (slowStepsToWall + phase) * dt * speed;
        const double across = -2.0 + circle * 2.5 + random.between(-0.3, 0.3);
        c.position = (room - gap) * toWall + across * perpendicular(toWall);
        c.velocity = (speed - slowStepsToWall * pull) * toWall
                     + random.between(-0.5, 0.5) * perpendicular(toWall);
    }
}

double placeLetGo(Preset &preset, const SceneSpec &spec, int k, Random &random)
{
    const auto [timestep, steps] = letGo[k];
    preset.timestep = timestep;
    const Vec2 down = pullOf(preset);
    const double pull = std::max(quickLength(preset.gravity), slowestHit);
    for (const int circle : spec.circles) {
        Circle &c = preset.circles[static_cast<std::size_t>(circle)].body;
        const double time = (steps + random.between(-0.5, 0.5)) * timestep;
        const double across = -2.0 + circle * 2.5 + random.between(-0.3, 0.3);
        c.position = (preset.halfWidth - c.radius - 0.5 * pull * time * time) * down
                     + across * perpendicular(down);
    }
    return (steps + stepsAfterLetGo) * timestep;
}

void placeCreepingHit(Preset &preset, const SceneSpec &spec, double side, Random &random)
{
    const Vec2 down = pullOf(preset);
    const Vec2 toWall = side * perpendicular(down);
    for (const int circle : spec.circles) {
        Circle &c = preset.circles[static_cast<std::size_t>(circle)].body;
        const double speed = random.between(creepingSpeeds.x, creepingSpeeds.y);
        const double gap = random.between(0.2, 0.5) * spec.duration * speed;
        const double height = -1.0 + circle * 2.0 + random.between(-0.3, 0.3);
        c.position = (preset.halfWidth - c.radius - gap) * toWall - height * down;
        c.velocity = speed * toWall;
    }
}

} // namespace cradle
