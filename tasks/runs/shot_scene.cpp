// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/shot_scene.h"

#include "model/run/runner.h"

#include <algorithm>
#include <limits>

namespace cradle {

namespace {

constexpr double farFromMiddle = 1.0; ///< of the start of a shot, m
/// Share of the duration within which a shot meets its wall; the rest shows what comes of it.
constexpr double soon = 0.6;
/// Gravity counts for so much more while that is found out, for integrators differ.
constexpr double caution = 1.1;
/// Free of everything for a whole scene, or to be tried again, m: more than handling some hits
/// can bring a circle off its ideal way.
constexpr double clear = 0.6;
constexpr double beside = 0.05; ///< of a wall, more than a step from it, m
constexpr int mostTries = 60;
constexpr double slowest = 0.3; ///< of what drifts, m/s
constexpr double fastest = 0.9;
/// What flies under gravity may use so much of the height of the square.
constexpr double ownShare = 0.8;
/// Who has at least this speed from a wall clearly leaves it, m/s.
constexpr double leaving = 0.1;

/// The first positive root of distance = speed t + ½ pull t²; infinity if there is none.
double firstTime(double distance, double speed, double pull)
{
    constexpr double never = std::numeric_limits<double>::infinity();
    if (distance <= 0.0)
        return 0.0;
    if (pull == 0.0)
        return speed > 0.0 ? distance / speed : never;
    const double square = speed * speed + 2.0 * pull * distance;
    if (square < 0.0)
        return never;
    // The form that is sound for a small pull of either sign.
    const double root = speed + std::sqrt(square);
    return root > 0.0 ? 2.0 * distance / root : never;
}

double gapTo(const Preset &preset, const Circle &circle, Wall wall)
{
    return preset.halfWidth - circle.radius - dot(circle.position, outwardNormal(wall));
}

/// Where something is at every step.
struct Way {
    std::vector<Vec2> places;
    double radius = 0.0;
};

/// A wall and when something comes to it, s.
struct Arrival {
    Wall wall = Wall::Left;
    double time = 0.0;
};

/// When \p way comes to within a step of each wall for the first time, the earliest first.
std::vector<Arrival> arrivalsOn(const Way &way, const Preset &preset)
{
    std::vector<Arrival> arrivals;
    for (const Wall wall : allWalls) {
        const Vec2 n = outwardNormal(wall);
        for (std::size_t k = 1; k < way.places.size(); ++k) {
            const double gap = preset.halfWidth - way.radius - dot(way.places[k], n);
            if (gap > length(way.places[k] - way.places[k - 1]))
                continue;
            arrivals.push_back({wall, static_cast<double>(k) * preset.timestep});
            break;
        }
    }
    std::sort(arrivals.begin(), arrivals.end(),
              [](const Arrival &a, const Arrival &b) { return a.time < b.time; });
    return arrivals;
}

/// How far what flies as \p circle is from leaving each wall when the shot arrives there, 0 if it
/// leaves all of them; the first arrival counts more than the others together.
double staying(const Preset &preset, const Circle &circle, const std::vector<Arrival> &arrivals)
{
    double sum = 0.0;
    double weight = 1.0;
    for (const Arrival &arrival : arrivals) {
        const Vec2 velocity = circle.velocity + arrival.time * preset.gravity;
        if (dot(velocity, outwardNormal(arrival.wall)) > -leaving)
            sum += weight;
        weight *= 0.4;
    }
    return sum;
}

/// The way of a circle alone in the square, by exact walls.
Way idealWay(const Preset &preset, std::size_t index, double duration)
{
    Preset alone = preset;
    alone.circles = {preset.circles[index]};
    alone.laws = {WallLaw::Reflect, CircleLaw::None, Timing::Continuous};
    Runner run(alone);
    Way way{{}, preset.circles[index].body.radius};
    while (run.world().time < duration) {
        way.places.push_back(run.world().circles[0].position);
        run.step();
    }
    return way;
}

/// A share \p u of the way between the first and the last place, -room to room, from which one
/// coordinate stays within these for \p seconds; anywhere between if there is no such place.
double placeFor(double u, double room, double speed, double pull, double seconds)
{
    const auto wayAt = [&](double t) { return speed * t + 0.5 * pull * t * t; };
    const double end = wayAt(seconds);
    double least = std::min(0.0, end);
    double most = std::max(0.0, end);
    const double turn = pull != 0.0 ? -speed / pull : -1.0;
    if (turn > 0.0 && turn < seconds) {
        least = std::min(least, wayAt(turn));
        most = std::max(most, wayAt(turn));
    }
    const double low = -room - least;
    const double high = room - most;
    return low < high ? low + u * (high - low) : room * (2.0 * u - 1.0);
}

/// Least distance from the rim of what flies freely as \p circle to all \p ways, m.
double clearance(const Preset &preset, const Circle &circle, const std::vector<Way> &ways)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Way &way : ways) {
        for (std::size_t k = 0; k < way.places.size(); ++k) {
            const double t = static_cast<double>(k) * preset.timestep;
            const Vec2 place =
                circle.position + t * circle.velocity + (0.5 * t * t) * preset.gravity;
            least = std::min(least, length(place - way.places[k]) - circle.radius - way.radius);
        }
    }
    return least;
}

} // namespace

double timeToWall(const Preset &preset, const Circle &circle)
{
    double first = std::numeric_limits<double>::infinity();
    for (const Wall wall : allWalls) {
        const Vec2 n = outwardNormal(wall);
        first = std::min(first, firstTime(gapTo(preset, circle, wall), dot(circle.velocity, n),
                                          dot(preset.gravity, n)));
    }
    return first;
}

Vec2 drawStart(Random &random)
{
    const double x = random.between(-farFromMiddle, farFromMiddle);
    return {x, random.between(-farFromMiddle, farFromMiddle)};
}

void bringNear(Preset &preset, std::size_t shot, double duration)
{
    Circle &circle = preset.circles[shot].body;
    Preset strict = preset;
    strict.gravity = caution * preset.gravity;
    Preset floating = preset;
    floating.gravity = {};
    for (int i = 0; i < mostTries && timeToWall(strict, circle) > soon * duration; ++i) {
        const double straight = timeToWall(floating, circle);
        if (straight == std::numeric_limits<double>::infinity())
            return;
        circle.position += 0.2 * straight * circle.velocity;
    }
}

void drawOthers(Preset &preset, std::size_t shot, double duration, Random &random)
{
    if (preset.circles.size() < 2)
        return;
    std::vector<Way> ways{idealWay(preset, shot, duration)};
    const std::vector<Arrival> arrivals = arrivalsOn(ways.front(), preset);
    const double pull = length(preset.gravity);
    for (std::size_t other = 0; other < preset.circles.size(); ++other) {
        if (other == shot)
            continue;
        Circle &circle = preset.circles[other].body;
        const double room = preset.halfWidth - circle.radius;
        // As high as the square allows, and as long as the scene lasts.
        const double flight =
            pull > 0.0 ? std::min(duration, std::sqrt(8.0 * ownShare * 2.0 * room / pull))
                       : duration;
        double best = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < mostTries && best < clear; ++i) {
            Circle drawn = circle;
            const double angle = random.between(0.0, 2.0 * std::numbers::pi);
            const double x = random.uniform();
            const double y = random.uniform();
            drawn.velocity =
                random.between(slowest, fastest) * Vec2{std::cos(angle), std::sin(angle)}
                - (0.5 * flight) * preset.gravity;
            // Who flies along a wall within a step of it counts as being at the wall.
            const double dt = preset.timestep;
            const double within =
                std::max(0.0, room - (length(drawn.velocity) + pull * dt) * dt - beside);
            drawn.position = {placeFor(x, within, drawn.velocity.x, preset.gravity.x, flight),
                              placeFor(y, within, drawn.velocity.y, preset.gravity.y, flight)};
            // A wall on its own way is worse than not to leave those of the shot, and that is worse
            // than any distance, of which no more than enough counts.
            const double early = flight - timeToWall(preset, drawn);
            const double most = early > 0.0
                                    ? -3.0 * preset.halfWidth - early
                                    : clear - preset.halfWidth * staying(preset, drawn, arrivals);
            if (most <= best)
                continue;
            const double found =
                early > 0.0 ? most : most - clear + std::min(clear, clearance(preset, drawn, ways));
            if (found > best) {
                best = found;
                circle = drawn;
            }
        }
        ways.push_back(idealWay(preset, other, duration));
    }
}

} // namespace cradle
