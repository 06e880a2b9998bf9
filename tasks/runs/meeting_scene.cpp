// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/meeting_scene.h"

#include "model/world/world.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr double timeToContact = 0.5;  ///< from the start of an encounter, s
constexpr double stepsToWall = 4.5;    ///< of circle 2 after a hit that is followed by another
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

} // namespace

void placeEncounter(Preset &preset, const SceneSpec &spec, int i, double degrees, Random &random)
{
    Circle &a = preset.circles[0].body;
    Circle &b = preset.circles[1].body;
    const Vec2 n = fromAngle(degrees);
    // Off centre by the sine of the angle between the relative velocity and the normal.
    const double sine = spec.offset * random.between(-1.0, 1.0);
    const Vec2 u =
        range(spec.speeds, random) * (std::sqrt(1.0 - sine * sine) * n + sine * perpendicular(n));
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

void placeAgain(Preset &preset, const SceneSpec &spec, Random &random)
{
    Circle &a = preset.circles[0].body;
    Circle &b = preset.circles[1].body;
    const Vec2 n = outwardNormal(allWalls[static_cast<std::size_t>(random.between(0.0, 3.999))]);
    const Vec2 along = perpendicular(n);
    b.radius = a.radius;
    b.density = a.density;
    preset.timestep = *std::min_element(spec.timesteps.begin(), spec.timesteps.end());
    const double speed = std::max(2.0, range(spec.speeds, random));
    b.velocity = random.between(-0.5, 0.5) * along;
    a.velocity = speed * n + b.velocity;
    const double step = speed * preset.timestep;
    b.position = (preset.halfWidth - b.radius - stepsToWall * step) * n
                 + random.between(-1.0, 1.0) * along - timeToContact * b.velocity;
    // A part of a step more, so that the moment of contact falls anywhere inside a step.
    a.position =
        b.position - (a.radius + b.radius + timeToContact * speed + random.uniform() * step) * n;
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
