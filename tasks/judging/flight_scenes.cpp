// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_scenes.h"

namespace cradle::flights {

namespace {

/// Velocities of the flights, m/s: no two have a part or a ratio in common.
Vec2 velocityOf(int flight, std::size_t circle)
{
    static constexpr Vec2 velocities[][4] = {
        {{1.13, 0.71}, {-0.83, 1.31}, {0.57, -1.07}, {-1.23, -0.61}},
        {{-0.53, 0.97}, {1.19, 0.43}, {-0.91, -0.67}, {0.37, 1.41}}};
    const Vec2 v = velocities[flight][circle % 4];
    // Those of a crowd have velocities of their own, too: else one would seem to be the other's.
    const auto round = static_cast<double>(circle / 4);
    return {v.x * (1.0 + 0.11 * round), v.y * (1.0 - 0.07 * round)};
}

/// How much faster the circles are in Scene::Fast than in Scene::First, and how much slower in
/// Scene::Slow.
constexpr double fastFlight = 5.0;
constexpr double slow = 0.17;
/// How fast those of Scene::Falling come down at least, m/s: as what fell 4 m.
constexpr double deep = 9.0;

} // namespace

Preset flightPreset(const Ground &ground, Vec2 gravity, double h, Scene scene, std::size_t mover)
{
    Preset preset = ground.stage();
    preset.gravity = gravity;
    preset.timestep = h;
    for (std::size_t i = 0; i < preset.circles.size(); ++i) {
        Circle &c = preset.circles[i].body;
        if (scene == Scene::First || scene == Scene::Ahead)
            c.velocity = velocityOf(0, i);
        else if (scene == Scene::Second)
            c.velocity = velocityOf(1, i);
        else if (scene == Scene::Fast || scene == Scene::Behind)
            c.velocity = fastFlight * velocityOf(0, i);
        else if (scene == Scene::Slow)
            c.velocity = slow * velocityOf(0, i);
        else if (scene == Scene::Back)
            c.velocity = -velocityOf(0, i);
        else if (scene == Scene::Falling)
            c.velocity = {velocityOf(1, i).x, -deep - std::abs(velocityOf(0, i).x)};
        else if ((scene == Scene::Alone || scene == Scene::Apart) && i == mover)
            c.velocity = velocityOf(0, i);
        else if (scene == Scene::Shifted || scene == Scene::Apart)
            c.position += shift;
        if (scene == Scene::Ahead || scene == Scene::Behind)
            c.position +=
                (scene == Scene::Ahead ? 1.0 : -1.0) * (fastFlight - 1.0) * h * velocityOf(0, i);
    }
    return preset;
}

Steps fly(const QString *program, const Preset &preset, qint64 from)
{
    Steps steps;
    Probe probe(program, {preset, true});
    World start = probe.world();
    start.step = from;
    start.time = static_cast<double>(from) * preset.timestep;
    probe.place(start);
    steps.start = initialWorld(preset).circles;
    if (!probe.step())
        return steps;
    steps.before = probe.world().circles;
    if (!probe.step())
        return steps;
    steps.after = probe.world().circles;
    steps.made = true;
    return steps;
}

std::optional<Flight::Step> secondStep(const Steps &run, std::size_t i)
{
    if (!run.made)
        return std::nullopt;
    const Circle &before = run.before[i];
    const Circle &after = run.after[i];
    return Flight::Step{before.velocity, after.position - before.position,
                        after.velocity - before.velocity};
}

} // namespace cradle::flights
