// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/long_run.h"
#include "tasks/judging/wall_range.h"

#include <algorithm>
#include <array>

namespace cradle {

namespace {

/// How a shot comes to its wall, of the usual speed towards walls. What a program may ask about a
/// velocity, its part into the wall, its part along it or its length, divides them differently.
struct Throw {
    double into = 1.0;
    double along = 0.37;
};
constexpr std::array throws{Throw{1.0, 0.37},   Throw{0.37, -0.137}, Throw{0.37, 0.41},
                            Throw{0.37, -1.07}, Throw{1.0, -0.07},   Throw{1.6, 0.59}};
/// How the others move meanwhile, m/s.
constexpr std::array ways{Vec2{0.31, 0.47}, Vec2{-0.31, 0.47},  Vec2{-0.31, -0.47},
                          Vec2{0.31, 0.47}, Vec2{-0.31, -0.47}, Vec2{0.31, -0.47}};
static_assert(ways.size() == throws.size());
/// So many shots of each circle: every throw at every wall, where there are four.
constexpr std::size_t shotsOfCircle = throws.size() * std::size(allWalls);
/// Before every so many shots there is a wait, s; the others come as soon as the one before is
/// over.
constexpr std::size_t shotsPerWait = 3;
constexpr std::array waits{0.0, 0.3, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0};
/// Where circles come to the walls, from their middles, m.
constexpr std::array places{1.45, -2.65};
/// Who is faster along the wall than that comes from the end that he flies away from.
constexpr double steep = 0.5;
/// Of one whose first shots are late, s: what counts the time is told from what counts shots.
constexpr double lateStart = 12.0;
constexpr int stepsOfMeeting = 12;
constexpr int stepsToWall = 3; ///< of those that start near it

/// Lets circles 1 and 2 run into each other. \return whether one of them was turned
/// \param way  what they go in a step, of v h
bool meet(LongRun &run, const Preset &stage, double way)
{
    Preset scene = stage;
    const double touching = scene.circles[0].body.radius + scene.circles[1].body.radius;
    const double speed = 0.1 * touching / (way * stage.timestep);
    scene.circles[0].body.position = {-0.6 * touching, 0.31};
    scene.circles[0].body.velocity = {speed, 0.0};
    scene.circles[1].body.position = {0.6 * touching, 0.31};
    scene.circles[1].body.velocity = {};
    run.set(scene);
    for (int k = 0; k < stepsOfMeeting && run.probe().step(); ++k) {
    }
    return std::abs(run.probe().circle(0).velocity.x - speed)
               + std::abs(run.probe().circle(1).velocity.x)
           > 0.01 * speed;
}

} // namespace

WallOccasion WallRange::shotOf(std::size_t number, int circle, const WallShots &shots) const
{
    const std::size_t turn = number / (shots.walls.size() * throws.size()); // of all throws
    const std::size_t round = number / shots.walls.size() % throws.size();
    const std::size_t wall = (number + round / 2) % shots.walls.size();
    const Throw &how = throws[round];
    double along = places[(round + turn + wall) % places.size()];
    if (std::abs(how.along) > steep)
        along = -std::copysign(places[1], how.along);
    const auto radiusOf = [&](int one) {
        return one == m_ground.walls.circles.front() ? largeRadius() : m_ground.walls.radii.low;
    };
    WallOccasion shot{.hit = {.circle = circle,
                              .wall = shots.walls[wall],
                              .restitution = shots.restitution,
                              .radius = radiusOf(circle),
                              .otherRadius = radiusOf(circle == 0 ? 1 : 0)}};
    WallHit &hit = shot.hit;
    shot.when.setting = static_cast<int>((round + wall / 2) % 2);
    hit.stage = stageOf(hit, how.into * speedOf(circle, 0), 0.29,
                        {.along = along,
                         .slant = how.along / how.into,
                         .others = ways[round],
                         .setting = shot.when.setting,
                         .isNear = true});
    for (std::size_t i = 0; i < hit.stage.preset.circles.size(); ++i)
        hit.stage.preset.circles[i].body.radius = radiusOf(static_cast<int>(i));
    const Circle &c = hit.stage.preset.circles[static_cast<std::size_t>(circle)].body;
    const Vec2 n = outwardNormal(hit.wall);
    const double room = hit.stage.preset.halfWidth - c.radius - dot(n, c.position);
    shot.when.place = c.position + room * n;
    shot.when.comesWith(c.velocity, n);
    if (m_ground.flights.size() > 1)
        shot.when.otherVelocity = ways[round];
    return shot;
}

bool WallRange::shootIn(LongRun &run, WallOccasion &shot) const
{
    run.set(shot.hit.stage.preset);
    shot.when.time = run.time();
    watch(shot.hit, run.probe());
    shot.when.time += static_cast<double>(stepsToWall) * m_h;
    return run.runs();
}

std::vector<WallOccasion> WallRange::again(const WallShots &shots) const
{
    std::vector<int> circles = m_ground.walls.circles;
    std::erase_if(circles, [&](int circle) { return !isKnown(circle); });
    if (!m_program || circles.empty() || shots.walls.empty())
        return {};
    const Preset scene = shotOf(0, circles.front(), shots).hit.stage.preset;
    std::vector<WallOccasion> all;
    LongRun late(m_program, m_ground, scene);
    late.wait(lateStart);
    double last = -std::numeric_limits<double>::infinity();
    const auto take = [&](LongRun &run, WallOccasion &shot, int number) {
        if (!shootIn(run, shot))
            return false;
        shot.when.run = number;
        shot.when.pause = shot.when.time - last;
        last = run.time(); // who is turned late comes the sooner again
        all.push_back(shot);
        return true;
    };
    for (std::size_t k = 0; k < shots.walls.size(); ++k) {
        for (const int circle : circles) {
            WallOccasion shot = shotOf(k, circle, shots);
            if (!take(late, shot, 2))
                return {};
        }
    }
    LongRun run(m_program, m_ground, scene);
    last = -std::numeric_limits<double>::infinity();
    bool hasMet = false;
    const std::size_t count = shotsOfCircle * circles.size();
    for (std::size_t k = 0; k < count; ++k) {
        // Each makes every throw at every wall: now one, now another.
        const std::size_t round = k / shots.walls.size();
        const std::size_t who = k + round + round / throws.size();
        WallOccasion shot = shotOf(k, circles[who % circles.size()], shots);
        // In the midst of the waits: the first shots of the other run come later.
        if (k == count / 3 && m_ground.pair.asked && m_ground.flights.size() > 1)
            hasMet = meet(run, shot.hit.stage.preset, flightOf(0).way.x);
        if (k % shotsPerWait == 0 && k / shotsPerWait < waits.size())
            run.wait(waits[k / shotsPerWait]);
        shot.when.hasMet = hasMet;
        if (!take(run, shot, 1))
            return {};
    }
    return all;
}

std::vector<WallOccasion> measureWallsAgain(const QString *program, const Ground &ground,
                                            const MeasuredFlight &flight,
                                            const std::vector<Wall> &walls)
{
    return WallRange(program, ground, flight).again({walls, middleOf(ground.walls.restitutions)});
}

} // namespace cradle
