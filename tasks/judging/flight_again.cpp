// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/long_run.h"
#include "tasks/judging/measured_flight.h"

#include <algorithm>
#include <array>

namespace cradle {

namespace {

/// Heights at which circles are seen, m: in one the rim is just above the floor.
constexpr std::array heights{2.87, 0.41, 3.41, 1.79, -0.37, -3.17, -1.13, -2.31, -3.79, -2.89};
constexpr std::array columns{-3.03, 1.61, -0.71, 2.83, 0.59, -2.17, 3.31, -1.43};
constexpr double lowest = -3.5; ///< from where none goes down, m
constexpr int looks = 30;
constexpr int looksAfterHit = 4;
constexpr double between = 0.7; ///< s

/// Where a circle is at a look: two are far from each other in x and in y.
Vec2 placeAt(int look, std::size_t circle)
{
    const auto k = static_cast<std::size_t>(look);
    return {columns[(k + 4 * circle + circle / 2) % columns.size()],
            heights[(k + 5 * circle + circle / 2) % heights.size()]};
}

/// Some are so much faster, where they come to nothing.
constexpr double fastAgain = 6.0;
constexpr int fastLook = 5;
constexpr double middle = 2.5; ///< m

bool isInMiddle(Vec2 place)
{
    return std::max(std::abs(place.x), std::abs(place.y)) < middle;
}

/// Sets the circles of \p scene to where they are at that look.
void placeFor(int look, Preset &scene)
{
    for (std::size_t i = 0; i < scene.circles.size(); ++i) {
        Circle &c = scene.circles[i].body;
        c.position = placeAt(look, i);
        // Up and down at all heights, but away from the floor.
        const bool isUp = look % 2 != 0 || c.position.y < lowest;
        const double side = (static_cast<std::size_t>(look) / 3 + i) % 2 == 0 ? 1.13 : -1.21;
        const bool isFast = look % fastLook == 0 && isInMiddle(c.position);
        c.velocity = (isFast ? fastAgain : 1.0) * Vec2{side, isUp ? 1.37 : -1.43};
    }
}

/// Throws all circles at the floor. \return whether all came back
bool hitFloor(LongRun &run, Preset scene)
{
    constexpr int most = 60; // steps
    for (std::size_t i = 0; i < scene.circles.size(); ++i) {
        Circle &c = scene.circles[i].body;
        c.position = {columns[i % columns.size()], -scene.halfWidth + c.radius + 0.3};
        c.velocity = {0.0, -3.0};
    }
    run.set(scene);
    for (int k = 0; k < most && run.probe().step(); ++k) {
        const std::vector<Circle> &all = run.probe().world().circles;
        if (std::all_of(all.begin(), all.end(), [](const Circle &c) { return c.velocity.y > 0.0; }))
            return true;
    }
    return false;
}

/// Adds what is seen in so many looks.
/// \return whether the program goes on from where its circles are set, without an error
bool look(LongRun &run, const Ground &ground, Preset scene, int count, bool hasHit,
          std::vector<FlightOccasion> &all)
{
    for (int k = 0; k < count; ++k) {
        placeFor(k, scene);
        if (k > 0)
            run.wait(between);
        run.set(scene);
        const std::vector<Circle> start = run.probe().world().circles;
        // What a program keeps from one step to the next has settled in the second.
        if (!run.probe().step())
            return false;
        const std::vector<Circle> before = run.probe().world().circles;
        if (!run.probe().step() || !run.runs())
            return false;
        for (std::size_t i = 0; i < ground.flights.size(); ++i) {
            // Who is stopped in the first rests rightly in the second.
            const bool isStopped = before[i].velocity == Vec2{};
            all.push_back({static_cast<int>(i),
                           isStopped ? start[i] : before[i],
                           isStopped ? before[i] : run.probe().circle(static_cast<int>(i)),
                           {.time = run.time(), .place = before[i].position, .hasHit = hasHit}});
        }
    }
    return true;
}

} // namespace

std::vector<FlightOccasion> measureFlightAgain(const QString *program, const Ground &ground)
{
    if (!program)
        return {};
    Preset scene = ground.stage();
    scene.gravity = ground.gravities.front();
    std::vector<FlightOccasion> all;
    LongRun run(program, ground, scene);
    if (!look(run, ground, scene, looks, false, all))
        return {};
    LongRun second(program, ground, scene);
    if (!ground.walls.circles.empty() && hitFloor(second, scene))
        look(second, ground, scene, looksAfterHit, true, all);
    return all;
}

} // namespace cradle
