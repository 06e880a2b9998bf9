// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/meeting_scene.h"

#include "model/world/world.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr double timeToContact = 0.5; ///< from the start of an encounter, s
/// Between two circles, when one that was hit comes to the wall: steps at the speed that they met
/// with.
constexpr double stepsToWall = 4.5;
constexpr double stepsAfter = 12.0;      ///< the second of two hits, that none of it is missed
constexpr double rallyStepsBefore = 6.0; ///< from the start of a rally to its first hit
constexpr double rallyStepsToWall = 6.0; ///< between its second hit and the wall, at any speed
constexpr double rallyStepsAfter = 7.0;  ///< that second hit, before there is a third
constexpr Vec2 rallyPause{0.15, 0.25};   ///< between the two, at least, s
constexpr double steepest = 1.2; ///< what the first has across the normal, of what is along it
constexpr double placeOfContact = 1.0; ///< encounters happen within ± this of the middle, m

double range(Vec2 lowHigh, Random &random)
{
    return random.between(lowHigh.x, lowHigh.y);
}

Vec2 anyVelocity(Random &random)
{
    const double speed = random.between(0.5, 1.5);
    return speed * fromAngle(random.between(0.0, 360.0));
}

/// The velocity of circle 2 where both move and approach with \p u. In turn: any; circle 1 catches
/// up with it; it catches up with circle 1; circle 1 rests; it rests. Only so it shows whose
/// velocity a program forgets when it asks whether they approach.
Vec2 secondVelocity(int i, Vec2 u, Vec2 n, Random &random)
{
    const Vec2 across = random.between(-0.8, 0.8) * perpendicular(n);
    const double ahead = random.between(0.3, 0.8);
    // Offset, so that this and the restitutions do not go in step.
    switch ((i + i / 5) % 5) {
    case 0:
        return anyVelocity(random);
    case 1:
        return ahead * n + across;
    case 2:
        return across - (dot(u, n) + ahead) * n;
    case 3:
        return -u;
    default:
        return {};
    }
}

/// How far to shift an encounter: anywhere about the middle where both begin in the square.
Vec2 placeOf(const Preset &preset, Random &random)
{
    Vec2 low{-placeOfContact, -placeOfContact};
    Vec2 high{placeOfContact, placeOfContact};
    for (std::size_t i = 0; i < 2; ++i) {
        const Circle &circle = preset.circles[i].body;
        const double room = preset.halfWidth - circle.radius - 1e-3;
        const Vec2 p = circle.position;
        low = {std::max(low.x, -room - p.x), std::max(low.y, -room - p.y)};
        high = {std::min(high.x, room - p.x), std::min(high.y, room - p.y)};
    }
    const double x = random.uniform();
    const double y = random.uniform();
    return {low.x + x * (high.x - low.x), low.y + y * (high.y - low.y)};
}

double massOf(const Circle &circle)
{
    return circle.density * circle.radius * circle.radius * circle.radius;
}

/// The second hit of a rally whose first one is at speed 1 and distance 1 from the wall.
struct Return {
    double time;    ///< from the first hit
    double place;   ///< its distance from the wall
    double fastest; ///< speed of the lighter circle from then on or just before
};

/// \param ratio  of the masses, the heavier by the lighter
/// \param wall  what of its speed a wall gives back
Return returnOf(double ratio, double e, double wall)
{
    const double heavy = (ratio - e) / (ratio + 1.0);
    const double light = ratio * (1.0 + e) / (ratio + 1.0);
    const double back = wall * light;
    const double between = 1.0 - heavy / light;
    const double meeting = between / (heavy + back);
    const double again = (ratio * heavy - back + e * ratio * (heavy + back)) / (ratio + 1.0);
    return {1.0 / light + meeting, back * meeting, std::max(back, std::abs(again))};
}

} // namespace

void placeEncounter(Preset &preset, const SceneSpec &spec, int i, double degrees, Random &random)
{
    Circle &a = preset.circles[0].body;
    Circle &b = preset.circles[1].body;
    const Vec2 n = fromAngle(degrees);
    // Off centre by the sine of the angle between the relative velocity and the normal.
    const double sine = spec.offset * random.between(-1.0, 1.0);
    // Some as slowly as they may, whatever the seed.
    const double drawn = range(spec.speeds, random);
    const double speed = i % 12 == 7 ? spec.speeds.x : drawn;
    const Vec2 u = speed * (std::sqrt(1.0 - sine * sine) * n + sine * perpendicular(n));
    b.velocity = spec.bothMove ? secondVelocity(i, u, n, random) : Vec2{};
    a.velocity = u + b.velocity;
    // A part of a step more, so that the moment of contact falls anywhere inside a step.
    const double t = timeToContact + preset.timestep * random.uniform();
    a.position = -t * a.velocity;
    b.position = (a.radius + b.radius) * n - t * b.velocity;
    const Vec2 place = placeOf(preset, random);
    a.position += place;
    b.position += place;
}

double placeAgain(Preset &preset, const SceneSpec &spec, Random &random)
{
    Circle &a = preset.circles[0].body;
    Circle &b = preset.circles[1].body;
    const Vec2 n = outwardNormal(allWalls[static_cast<std::size_t>(random.between(0.0, 3.999))]);
    const Vec2 along = perpendicular(n);
    b.radius = a.radius;
    b.density = a.density;
    const double dt = *std::min_element(spec.timesteps.begin(), spec.timesteps.end());
    preset.timestep = dt;
    const double e = preset.restitution;
    const double speed = std::max(2.0, range(spec.speeds, random));
    // Equal circles: 1 goes on with (1 − e) / 2 of the speed along n, 2 with (1 + e) / 2, so that
    // the gap is some steps wide when 2 comes to the wall. That gives it e times its speed back, or
    // all of it.
    const double toWall = stepsToWall * dt / e;
    const double nearing = 0.5 * (e * (1.0 + e) + 1.0 - e);
    // What circle 1 keeps across n brings it to one side of 2, and turns their line of centres.
    const double touching = a.radius + b.radius;
    const double side = random.between(0.25, 0.35);
    const double sunk = touching * (1.0 - std::sqrt(1.0 - side * side));
    const double back = (stepsToWall * dt + sunk / speed) / nearing;
    const double way = random.uniform() < 0.5 ? -1.0 : 1.0;
    const double across = way * std::min(steepest, side * touching / ((toWall + back) * speed));
    b.velocity = random.between(-0.5, 0.5) * along;
    a.velocity = speed * (n + across * along) + b.velocity;
    const Vec2 place = (preset.halfWidth - b.radius - 0.5 * (1.0 + e) * speed * toWall) * n
                       + random.between(-1.0, 1.0) * along;
    // A part of a step more, so that the moment of contact falls anywhere inside a step.
    const double t = timeToContact + dt * random.uniform();
    b.position = place - t * b.velocity;
    a.position = place - touching * n - t * a.velocity;
    return t + toWall + back + stepsAfter * dt;
}

double placeRally(Preset &preset, const SceneSpec &spec, Random &random)
{
    const bool isOneHeavier = massOf(preset.circles[0].body) >= massOf(preset.circles[1].body);
    Circle &heavy = preset.circles[isOneHeavier ? 0 : 1].body;
    Circle &light = preset.circles[isOneHeavier ? 1 : 0].body;
    const Vec2 n = outwardNormal(allWalls[static_cast<std::size_t>(random.between(0.0, 3.999))]);
    const double dt = *std::min_element(spec.timesteps.begin(), spec.timesteps.end());
    preset.timestep = dt;
    const double e = preset.restitution;
    // A wall gives e times its speed back, or all of it.
    const Return returns[] = {returnOf(massOf(heavy) / massOf(light), e, 1.0),
                              returnOf(massOf(heavy) / massOf(light), e, e)};
    const double pause = range(rallyPause, random);
    double scale = 0.0; // of their times, s
    for (const Return &second : returns)
        scale = std::max(
            {scale, pause / second.time, rallyStepsToWall * dt * second.fastest / second.place});
    const double speed = random.between(1.0, 1.5);
    light.position = (preset.halfWidth - light.radius - scale * speed) * n
                     + random.between(-1.0, 1.0) * perpendicular(n);
    // A part of a step more, so that the moment of contact falls anywhere inside a step.
    const double t = (rallyStepsBefore + random.uniform()) * dt;
    heavy.position = light.position - (heavy.radius + light.radius + t * speed) * n;
    heavy.velocity = speed * n;
    return t + scale * std::max(returns[0].time, returns[1].time) + rallyStepsAfter * dt;
}

void placeParting(Preset &preset, const SceneSpec &spec, double degrees, Random &random)
{
    Circle &a = preset.circles[0].body;
    Circle &b = preset.circles[1].body;
    const Vec2 n = fromAngle(degrees);
    const double speed = range(spec.speeds, random);
    const Vec2 common = anyVelocity(random);
    a.velocity = common - 0.5 * speed * n;
    b.velocity = common + 0.5 * speed * n;
    const double touching = a.radius + b.radius;
    const double overlap = speed * preset.timestep * random.between(1.2, 1.8);
    b.position = std::max(touching - overlap, 0.5 * touching) * n;
}

} // namespace cradle
