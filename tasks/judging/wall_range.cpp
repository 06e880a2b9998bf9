// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_range.h"

#include "tasks/judging/likeness.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr double wallKick = 1e-6; ///< of a velocity, relative: what no rounding makes
/// Of the slowest, m/s. Where e is varied a program may well keep so slow a circle at rest.
constexpr double creepingSpeed = 0.12;
constexpr double creepingWithLosses = 0.3;
/// Faster than that under which the floor may well keep one: see the check "bounces".
constexpr double creepingToFloor = 0.56;
/// What creeps starts so far from where its rim would be at the wall, m: it comes from outside of
/// what a margin of some mm takes for the wall.
constexpr double creepingWay = 0.03;
constexpr int stepsAfterwards = 6;
constexpr int stepsOfDrop = 70;
constexpr int stepsOfLob = 8;
/// Under gravity steps are so much shorter, so that the fall in the step of a hit hardly shows.
constexpr double finer = 16.0;

double distanceFrom(Wall wall, double halfWidth, Vec2 place)
{
    return halfWidth - dot(outwardNormal(wall), place);
}

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
    m_h = m_usual / finer;
    const bool suits =
        std::all_of(circles.begin(), circles.end(), [&](int circle) { return isKnown(circle); });
    m_h = suits ? m_h : m_usual;
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

bool WallRange::canDrop(int circle) const
{
    if (fall() == Vec2{})
        return false;
    const Flight &f = m_flight.at(fall(), m_usual, circle);
    return f.isKnown && isAlike(f.way.x, 1.0, 0.1) && isAlike(f.way.y, 1.0, 0.1);
}

const Flight &WallRange::flightOf(int circle) const
{
    return m_flight.at(m_gravity, m_h, circle);
}

WallHit WallRange::shoot(int circle, Wall wall, double e, int place, bool corner) const
{
    WallHit hit{.circle = circle, .wall = wall, .restitution = e};
    const Ground::Range &radii = m_ground.walls.radii;
    hit.radius = radii.isVaried() ? radii.low + 0.75 * (radii.high - radii.low) : radii.low;
    hit.otherRadius = radii.low;
    const double shares[] = {0.29, 0.62};
    hit.stage = stageOf(hit, speedOf(circle, place), shares[place], corner);
    watch(hit, corner);
    return hit;
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
    hit.stage = stageOf(hit, speed, 0.29, false);
    const Vec2 n = outwardNormal(wall);
    // On a longer way gravity would count more than the throw.
    const double way = m_falls || wall == Wall::Bottom ? 2.0 * creeps * m_usual : creepingWay;
    Circle &c = hit.stage.preset.circles[static_cast<std::size_t>(circle)].body;
    c.position +=
        (hit.stage.preset.halfWidth - c.radius - 0.4 * creeps * m_usual - way - dot(n, c.position))
        * n;
    watch(hit, false);
    return hit;
}

WallHit WallRange::comeFromFar(int circle, double speed) const
{
    WallHit hit{.circle = circle, .restitution = m_ground.walls.restitutions.back()};
    hit.radius = hit.otherRadius = m_ground.walls.radii.low;
    hit.stage = stageOf(hit, speed / flightOf(circle).way.x, 0.29, false);
    const Vec2 n = outwardNormal(hit.wall);
    Circle &c = hit.stage.preset.circles[static_cast<std::size_t>(circle)].body;
    const double way = 1.5 * speed;
    c.position += (hit.stage.preset.halfWidth - c.radius - way - dot(n, c.position)) * n;
    watch(hit, false);
    return hit;
}

Drop WallRange::lob(int circle, double e, double speed) const
{
    Drop lob{.circle = circle, .wall = Wall::Top, .restitution = e};
    Preset preset = m_ground.stage();
    preset.gravity = fall();
    preset.restitution = e;
    preset.timestep = *std::max_element(m_ground.timesteps.begin(), m_ground.timesteps.end());
    const double h = preset.timestep;
    const double g = length(preset.gravity);
    Circle &c = preset.circles[static_cast<std::size_t>(circle)].body;
    // It has this share of g h of its speed left when its rim is at the ceiling.
    const double last = speed * g * h;
    c.position = {circle % 2 == 0 ? -1.83 : 1.61, preset.halfWidth - c.radius - last * h};
    c.velocity = {0.41, last + g * h};
    lob.stage = {preset, true};
    const Flight &flight = m_flight.at(preset.gravity, h, circle);
    Probe probe(m_program, lob.stage);
    for (int k = 1; k <= stepsOfLob; ++k) {
        const Circle before = probe.circle(circle);
        if (!probe.step())
            break;
        const double free = flight.after(before, h).velocity.y;
        if (before.velocity.y < 0.0 && free < 0.0
            && probe.circle(circle).velocity.y > wallKick * (1.0 - free)) {
            ++lob.again;
            lob.step = lob.step == 0 ? k : lob.step;
        }
    }
    if (lob.step == 0)
        lob.step = stepsOfLob;
    return lob;
}

Drop WallRange::drop(int circle, double e, double height) const
{
    Drop drop{.circle = circle, .restitution = e};
    Preset preset = m_ground.stage();
    preset.gravity = fall();
    preset.restitution = e;
    preset.timestep = m_usual;
    Circle &c = preset.circles[static_cast<std::size_t>(circle)].body;
    c.position = {circle % 2 == 0 ? -1.83 : 1.61, -preset.halfWidth + c.radius + height};
    c.velocity = {0.41, 0.0};
    drop.stage = {preset, true};
    const Flight &flight = m_flight.at(preset.gravity, m_usual, circle);
    const auto depth = [&](const Circle &now) {
        return -preset.halfWidth + now.radius - now.position.y;
    };
    Probe probe(m_program, drop.stage);
    double halfway = 0.0;
    for (int k = 1; k <= stepsOfDrop; ++k) {
        const Circle before = probe.world().circles[static_cast<std::size_t>(circle)];
        if (!probe.step())
            break;
        const Circle &after = probe.circle(circle);
        const double free = flight.after(before, m_usual).velocity.y;
        const bool isLow = before.position.y < -preset.halfWidth + 2.0 * before.radius;
        if (isLow && before.velocity.y > 0.0 && free > 0.0
            && after.velocity.y < -wallKick * (1.0 + free)) {
            ++drop.again;
            drop.step = drop.step == 0 ? k : drop.step;
        }
        if (k == stepsOfDrop / 2)
            halfway = depth(after);
    }
    drop.depth = depth(probe.circle(circle));
    drop.sinks = drop.depth > halfway + 1e-3;
    if (drop.step == 0)
        drop.step = stepsOfDrop;
    return drop;
}

Vec2 WallRange::fall() const
{
    Vec2 strongest{};
    for (const Vec2 g : m_ground.gravities)
        strongest = g.x == 0.0 && g.y < strongest.y ? g : strongest;
    return strongest;
}

double WallRange::speedOf(int circle, int place) const
{
    const double speeds[] = {2.9, 1.07};
    const double falling[] = {6.1, 4.7};
    return (m_falls ? falling[place] : speeds[place]) / flightOf(circle).way.x;
}

Stage WallRange::stageOf(const WallHit &hit, double speed, double share, bool corner) const
{
    Preset preset = m_ground.stage();
    preset.gravity = m_gravity;
    preset.restitution = hit.restitution;
    preset.timestep = m_h;
    const Vec2 n = outwardNormal(hit.wall);
    const Vec2 t = perpendicular(n);
    const double along = corner ? speed : 0.37 * speed;
    // Far enough away for a program that takes the diameter.
    const double step = speed * flightOf(hit.circle).way.x * m_h;
    const double room = 2.4 * hit.radius + (0.3 + share) * step;
    for (std::size_t i = 0; i < preset.circles.size(); ++i) {
        Circle &c = preset.circles[i].body;
        if (static_cast<int>(i) == hit.circle) {
            c.radius = hit.radius;
            c.velocity = speed * n + along * t;
            c.position = (preset.halfWidth - room) * n - 0.7 * t;
            if (corner)
                aimAtCorner(c, hit.circle, n, preset.halfWidth);
        } else {
            // The others fly on in the middle; what happens at the wall is not their affair.
            c.radius = hit.otherRadius;
            c.position = (0.4 + 0.9 * static_cast<double>(i)) * t - 0.6 * n;
            const Flight &flight = flightOf(static_cast<int>(i));
            c.velocity = Vec2{0.31, 0.47} / std::max(1.0, flight.way.x);
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

bool WallRange::isNearWall(const Circle &c, Vec2 direction, double halfWidth)
{
    return std::abs(dot(c.position, direction)) > halfWidth - 2.5 * c.radius;
}

void WallRange::watch(WallHit &hit, bool corner) const
{
    Probe probe(m_program, hit.stage);
    const Preset &preset = hit.stage.preset;
    const Vec2 n = outwardNormal(hit.wall);
    const Flight &flight = flightOf(hit.circle);
    const double step = dot(n, probe.circle(hit.circle).velocity) * flight.way.x * m_h;
    for (int k = 1; k < 400 && probe.runs(); ++k) {
        const std::vector<Circle> before = probe.world().circles;
        const Circle &c = before[static_cast<std::size_t>(hit.circle)];
        const double distance = distanceFrom(hit.wall, preset.halfWidth, c.position);
        if (distance < -1.3 * hit.radius - 2.0 * step)
            return; // all of it is outside
        if (dot(n, c.velocity) < 0.0
            || (!corner && isNearWall(c, perpendicular(n), preset.halfWidth))) {
            hit.missed = true; // something else turns it, or may, before it is there
            return;
        }
        if (!probe.step()) {
            hit.missed = true; // the program stopped: what is said of that is its error
            return;
        }
        const Motion free = flight.after(c, m_h);
        const Circle &now = probe.circle(hit.circle);
        const bool turned =
            length(now.velocity - free.velocity) > wallKick * (1.0 + length(free.velocity));
        const bool moved = length(now.position - free.position) > 1e-7;
        if (!turned && !moved)
            continue;
        note(hit, before, now, free, k);
        // A wall turns it round, or its rim is there; else something on the way changes it.
        if (hit.back < 0.0 && (!moved || (turned && k == 1))
            && hit.reached > hit.radius + std::abs(hit.travel)) {
            hit.missed = true;
            return;
        }
        hit.turned = turned;
        hit.held = !turned;
        lookAtOthers(hit, before, probe);
        follow(hit, probe);
        return;
    }
    // It never came there, or so slowly that all of this time has not brought it through.
    const Vec2 place = probe.circle(hit.circle).position;
    hit.missed = distanceFrom(hit.wall, preset.halfWidth, place) > hit.radius - 0.02;
}

void WallRange::note(WallHit &hit, const std::vector<Circle> &before, const Circle &now,
                     const Motion &free, int k) const
{
    const Preset &preset = hit.stage.preset;
    const Vec2 n = outwardNormal(hit.wall);
    const Vec2 t = perpendicular(n);
    const Circle &c = before[static_cast<std::size_t>(hit.circle)];
    hit.step = k;
    hit.before = distanceFrom(hit.wall, preset.halfWidth, c.position);
    hit.reached = distanceFrom(hit.wall, preset.halfWidth, free.position);
    hit.travel = hit.before - hit.reached;
    hit.came = free.velocity;
    hit.left = now.velocity;
    hit.back = -dot(n, now.velocity) / dot(n, free.velocity);
    hit.along = dot(t, now.velocity) / dot(t, free.velocity);
    hit.after = distanceFrom(hit.wall, preset.halfWidth, now.position);
    hit.leap = std::min(length(now.position - c.position), length(now.position - free.position));
    hit.landed = now.position;
}

void WallRange::follow(WallHit &hit, Probe &probe) const
{
    const Vec2 n = outwardNormal(hit.wall);
    Circle c = probe.circle(hit.circle);
    for (int k = 0; k < stepsAfterwards; ++k) {
        if (!probe.step())
            return;
        const Circle &now = probe.circle(hit.circle);
        const Motion free = flightOf(hit.circle).after(c, m_h);
        const bool leaves = dot(n, c.velocity) < 0.0 && dot(n, free.velocity) < 0.0;
        const double away = distanceFrom(hit.wall, hit.stage.preset.halfWidth, c.position);
        if (leaves && dot(n, now.velocity) > 0.0 && away < hit.radius + hit.travel)
            ++hit.again;
        c = now;
    }
    hit.turnsBoth = dot(n, c.velocity) < 0.0
                    && dot(perpendicular(n), c.velocity) * dot(perpendicular(n), hit.came) < 0.0;
    const double distance = distanceFrom(hit.wall, hit.stage.preset.halfWidth, c.position);
    hit.stays = distance < hit.after + 0.5 * hit.travel;
}

void WallRange::lookAtOthers(WallHit &hit, const std::vector<Circle> &before,
                             const Probe &probe) const
{
    const double halfWidth = hit.stage.preset.halfWidth;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const int other = static_cast<int>(i);
        const Flight &flight = flightOf(other);
        const Circle &was = before[i];
        if (other == hit.circle || !flight.isKnown || isNearWall(was, {1.0, 0.0}, halfWidth)
            || isNearWall(was, {0.0, 1.0}, halfWidth))
            continue;
        const Motion free = flight.after(was, m_h);
        const Circle &now = probe.circle(other);
        hit.kicks |= length(now.velocity - free.velocity) > 1e-6;
        hit.disturbs |= hit.kicks || length(now.position - free.position) > 1e-6;
    }
}

} // namespace cradle
