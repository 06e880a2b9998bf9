// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_range.h"

#include "tasks/judging/likeness.h"

#include <algorithm>

namespace cradle {

namespace {

/// Of the slowest, m/s. Where e is varied a program may well keep so slow a circle at rest.
constexpr double creepingSpeed = 0.12;
constexpr double creepingWithLosses = 0.3;
/// Faster than that under which the floor may well keep one: see the check "bounces".
constexpr double creepingToFloor = 0.56;
/// What creeps starts so far from where its rim would be at the wall, m: it comes from outside of
/// what a margin of some mm takes for the wall.
constexpr double creepingWay = 0.03;
/// So much faster are the others under gravity: it does not turn them round meanwhile.
constexpr double fallingHaste = 3.0;
/// Of a circle whose place may be asked for another's, m/s.
constexpr double lentSpeed = 0.1;
/// Under gravity steps are so much shorter, so that the fall in the step of a hit hardly shows.
constexpr double finer = 16.0;

} // namespace

WallRange::WallRange(const QString *program, const Ground &ground, const MeasuredFlight &flight)
    : m_program(program)
    , m_ground(ground)
    , m_flight(flight)
    , m_gravity(ground.walls.gravity)
    , m_usual(ground.timesteps.empty() ? 1.0 / 60.0 : ground.timesteps.front())
    , m_h(m_usual)
{
    const auto &circles = ground.walls.circles;
    m_falls = std::any_of(circles.begin(), circles.end(),
                          [&](int circle) { return length(flightOf(circle).acceleration) > 1.0; });
    if (!m_falls)
        return;
    const auto suits = [&] {
        return std::all_of(circles.begin(), circles.end(),
                           [&](int circle) { return isKnown(circle); });
    };
    m_h = m_usual / finer;
    if (suits())
        return;
    m_h = m_usual;
    if (suits())
        return;
    // A fall that is wrong may hide the walls; without gravity they are seen.
    m_gravity = {};
    m_falls = false;
    if (suits())
        return;
    m_gravity = ground.walls.gravity;
    m_falls = true;
}

double WallRange::largeRadius() const
{
    const Ground::Range &radii = m_ground.walls.radii;
    return radii.isVaried() ? radii.low + 0.75 * (radii.high - radii.low) : radii.low;
}

bool WallRange::isKnown(int circle) const
{
    const Flight &f = flightOf(circle);
    if (!f.isKnown || f.way.x <= 0.0 || !isAlike(f.way.x, f.way.y))
        return false;
    const double speed = speedOf(circle, 1);
    if (length(f.drift) > 0.3 * speed * f.way.x * m_h)
        return false;
    if (!m_falls)
        return true;
    const double far = 0.6; // m to the wall
    return isAlike(f.way.x, 1.0, 0.5) && length(f.acceleration) * far < speed * speed
           && length(f.drift) < 0.3 * speed * m_h;
}

const Flight &WallRange::flightOf(int circle) const
{
    return m_flight.at(m_gravity, m_h, circle);
}

WallHit WallRange::shoot(int circle, Wall wall, double e, int place, bool corner) const
{
    WallHit hit{.circle = circle, .wall = wall, .restitution = e, .radius = largeRadius()};
    hit.otherRadius = m_ground.walls.radii.low;
    Aim aim{.corner = corner};
    double share = 0.29;
    if (place == 1) {
        std::swap(hit.radius, hit.otherRadius);
        aim = {.along = 2.4, .slant = -0.37, .others = {0.23, -0.41}};
        share = 0.62;
    }
    hit.stage = stageOf(hit, speedOf(circle, place), share, aim);
    watch(hit, corner);
    if (corner && !hit.turnsBoth && passesBeside(hit))
        hit.missed = true;
    return hit;
}

WallHit WallRange::shootAmongAlike(int circle, Wall wall, double e, bool large) const
{
    WallHit hit{.circle = circle, .wall = wall, .restitution = e};
    hit.radius = hit.otherRadius = large ? largeRadius() : m_ground.walls.radii.low;
    hit.stage = stageOf(hit, speedOf(circle, 0), 0.29, {});
    // From where the large ones start.
    Circle &c = hit.stage.preset.circles[static_cast<std::size_t>(circle)].body;
    c.position -= 2.4 * (largeRadius() - hit.radius) * outwardNormal(wall);
    watch(hit);
    return hit;
}

WallHit WallRange::shootDenser(int circle, Wall wall, double e) const
{
    WallHit hit{.circle = circle, .wall = wall, .restitution = e, .radius = largeRadius()};
    hit.otherRadius = m_ground.walls.radii.low;
    hit.stage = stageOf(hit, speedOf(circle, 0), 0.29, {});
    hit.stage.preset.circles[static_cast<std::size_t>(circle)].body.density *= 2.0;
    watch(hit);
    return hit;
}

WallHit WallRange::shootSlower(int circle, Wall wall, double e) const
{
    WallHit hit{.circle = circle, .wall = wall, .restitution = e, .radius = largeRadius()};
    hit.otherRadius = m_ground.walls.radii.low;
    hit.stage = stageOf(hit, speedOf(circle, 1), 0.29, {});
    watch(hit);
    return hit;
}

WallHit WallRange::shootSlanted(int circle, Wall wall, double e) const
{
    WallHit hit{.circle = circle, .wall = wall, .restitution = e, .radius = largeRadius()};
    hit.otherRadius = m_ground.walls.radii.low;
    hit.stage = stageOf(hit, speedOf(circle, 0), 0.29, {.slant = 0.93});
    watch(hit);
    return hit;
}

bool WallRange::passesBeside(const WallHit &corner) const
{
    const Vec2 n = outwardNormal(corner.wall);
    const Vec2 middle = 0.5 * m_ground.stage().halfWidth * (n + perpendicular(n));
    constexpr double slants[] = {0.37, -0.37};
    return std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
        if (dot(outwardNormal(wall), middle) <= 0.0)
            return false;
        // Out of the corner, too: the wall that came first has turned that part round.
        return std::any_of(std::begin(slants), std::end(slants), [&](double slant) {
            WallHit hit{.circle = corner.circle,
                        .wall = wall,
                        .restitution = corner.restitution,
                        .radius = corner.radius};
            hit.otherRadius = corner.otherRadius;
            hit.stage =
                stageOf(hit, speedOf(hit.circle, 0), 0.29,
                        {.along = dot(perpendicular(outwardNormal(wall)), middle), .slant = slant});
            watch(hit);
            return !hit.missed && !hit.turned && !hit.held;
        });
    });
}

WallHit WallRange::creep(int circle, Wall wall, double e) const
{
    WallHit hit{.circle = circle, .wall = wall, .restitution = e};
    hit.radius = hit.otherRadius = m_ground.walls.radii.low;
    const bool hasLosses = m_ground.walls.restitutions.size() > 1;
    const double creeps = !hasLosses             ? creepingSpeed
                          : wall == Wall::Bottom ? creepingToFloor
                                                 : creepingWithLosses;
    const double speed = creeps / flightOf(circle).way.x;
    hit.stage = stageOf(hit, speed, 0.29, {});
    const Vec2 n = outwardNormal(wall);
    // On a longer way gravity would count more than the throw.
    const double way = m_falls || wall == Wall::Bottom ? 2.0 * creeps * m_usual : creepingWay;
    Circle &c = hit.stage.preset.circles[static_cast<std::size_t>(circle)].body;
    c.position +=
        (hit.stage.preset.halfWidth - c.radius - 0.4 * creeps * m_usual - way - dot(n, c.position))
        * n;
    watch(hit);
    return hit;
}

WallHit WallRange::comeFromMiddle(int circle, Wall wall, double e) const
{
    WallHit hit{.circle = circle, .wall = wall, .restitution = e, .radius = largeRadius()};
    hit.otherRadius = m_ground.walls.radii.low;
    hit.stage = stageOf(hit, (m_falls ? 9.3 : 2.9) / flightOf(circle).way.x, 0.29, {});
    Circle &c = hit.stage.preset.circles[static_cast<std::size_t>(circle)].body;
    const Vec2 n = outwardNormal(wall);
    c.position += (0.5 - dot(n, c.position)) * n;
    watch(hit);
    return hit;
}

std::optional<LentWall> WallRange::lend(int circle, Wall wall, double e) const
{
    WallHit hit{.circle = circle, .wall = wall, .restitution = e, .radius = largeRadius()};
    hit.otherRadius = m_ground.walls.radii.low;
    const Vec2 n = outwardNormal(wall);
    const Stage alone = stageOf(hit, speedOf(circle, 0), 0.29, {});
    for (std::size_t other = 0; other < alone.preset.circles.size(); ++other) {
        if (static_cast<int>(other) == circle)
            continue;
        hit.stage = alone;
        Circle &c = hit.stage.preset.circles[static_cast<std::size_t>(circle)].body;
        c.position += (0.5 - dot(n, c.position)) * n;
        Circle &beyond = hit.stage.preset.circles[other].body;
        beyond.velocity = -lentSpeed * n;
        beyond.position += (hit.stage.preset.halfWidth - dot(n, beyond.position)) * n;
        Probe probe(m_program, hit.stage);
        const Circle before = probe.circle(circle);
        if (!probe.runs() || !probe.step())
            continue;
        const Motion free = flightOf(circle).after(before, m_h);
        hit.came = free.velocity;
        hit.left = probe.circle(circle).velocity;
        hit.step = 1;
        hit.turned = dot(n, hit.came) > 0.0 && dot(n, hit.left) < 0.0;
        if (hit.turned)
            return LentWall{hit, static_cast<int>(other)};
    }
    return std::nullopt;
}

WallHit WallRange::comeFromFar(int circle, double speed) const
{
    WallHit hit{.circle = circle, .restitution = m_ground.walls.restitutions.back()};
    hit.radius = hit.otherRadius = m_ground.walls.radii.low;
    hit.stage = stageOf(hit, speed / flightOf(circle).way.x, 0.29, {});
    const Vec2 n = outwardNormal(hit.wall);
    Circle &c = hit.stage.preset.circles[static_cast<std::size_t>(circle)].body;
    const double way = 1.5 * speed;
    c.position += (hit.stage.preset.halfWidth - c.radius - way - dot(n, c.position)) * n;
    watch(hit);
    return hit;
}

double WallRange::speedOf(int circle, int place) const
{
    const double speeds[] = {2.9, 1.07};
    const double falling[] = {6.1, 4.7};
    return (m_falls ? falling[place] : speeds[place]) / flightOf(circle).way.x;
}

Stage WallRange::stageOf(const WallHit &hit, double speed, double share, const Aim &aim) const
{
    Preset preset = m_ground.stage();
    preset.gravity = m_gravity;
    preset.restitution = hit.restitution;
    preset.timestep = m_h;
    const Vec2 n = outwardNormal(hit.wall);
    const Vec2 t = perpendicular(n);
    const double along = aim.corner ? speed : aim.slant * speed;
    // Far enough away for a program that takes the diameter.
    const double step = speed * flightOf(hit.circle).way.x * m_h;
    const double room = aim.isNear
                            ? hit.radius + (2.3 + share) * step
                            : 2.4 * std::max(hit.radius, hit.otherRadius) + (0.3 + share) * step;
    double out = 0.4; // of the next of the others: where no circle is shot, along x or along y
    for (std::size_t i = 0; i < preset.circles.size(); ++i) {
        Circle &c = preset.circles[i].body;
        if (static_cast<int>(i) == hit.circle) {
            c.radius = hit.radius;
            c.velocity = speed * n + along * t;
            c.position = (preset.halfWidth - room) * n + aim.along * t;
            if (aim.corner)
                aimAtCorner(c, hit.circle, n, preset.halfWidth);
        } else {
            // The others fly on in the middle; what happens at the wall is not their affair.
            c.radius = hit.otherRadius;
            c.position = aim.setting == 0 ? out * t - 0.6 * n : -out * t - 1.7 * n;
            out += 0.9;
            const Flight &flight = flightOf(static_cast<int>(i));
            c.velocity = (m_falls ? fallingHaste : 1.0) / std::max(1.0, flight.way.x) * aim.others;
        }
    }
    return {preset, true};
}

void WallRange::aimAtCorner(Circle &c, int circle, Vec2 n, double halfWidth) const
{
    const Vec2 t = perpendicular(n);
    Circle flies = c;
    for (int k = 0; k < 400 && dot(n, flies.position) < halfWidth - c.radius; ++k) {
        const Motion next = flightOf(circle).after(flies, m_h);
        flies.position = next.position;
        flies.velocity = next.velocity;
    }
    c.position += dot(flies.position, n - t) * t;
}

} // namespace cradle
