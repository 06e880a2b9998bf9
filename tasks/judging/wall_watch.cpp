// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_range.h"

namespace cradle {

namespace {

constexpr int stepsAfterwards = 6;
constexpr double farOutside = 1.0; ///< of a centre, m: who is turned there is not let through
/// Of a way: what steps that are parted at a hit lose of it is no disturbance.
constexpr double smallShare = 0.1;
constexpr double nearWall = 0.8; ///< of a rim, m
constexpr double outside = 1.3;  ///< of a centre, in radii: all of it is beyond the wall

constexpr double fartherInside = 1.5; ///< m: there no wall is near

bool isTurned(const Circle &now, const Motion &free)
{
    // What no rounding makes.
    return length(now.velocity - free.velocity) > 1e-6 * (1.0 + length(free.velocity));
}

bool isMoved(const Circle &now, const Motion &free)
{
    return length(now.position - free.position) > 1e-7;
}

Stage beginningAt(Stage stage, const World &from)
{
    for (std::size_t i = 0; i < from.circles.size(); ++i)
        stage.preset.circles[i].body = from.circles[i];
    return stage;
}

double distanceFrom(Wall wall, double halfWidth, Vec2 place)
{
    return halfWidth - dot(outwardNormal(wall), place);
}

} // namespace

bool WallRange::isNearWall(const Circle &c, Vec2 direction, double halfWidth)
{
    return std::abs(dot(c.position, direction)) > halfWidth - 2.5 * c.radius;
}

void WallRange::watch(WallHit &hit, bool corner) const
{
    Probe probe(m_program, hit.stage);
    watch(hit, probe, corner, true);
    if (hit.turned || hit.held)
        follow(hit, probe);
}

void WallRange::watch(WallHit &hit, Probe &probe, bool corner, bool isFirst) const
{
    const Preset &preset = hit.stage.preset;
    const Vec2 n = outwardNormal(hit.wall);
    const Flight &flight = flightOf(hit.circle);
    const double step = dot(n, probe.circle(hit.circle).velocity) * flight.way.x * m_h;
    bool wasOutside = false;
    for (int k = 1; k < 400 && probe.runs(); ++k) {
        const std::vector<Circle> before = probe.world().circles;
        const Circle &c = before[static_cast<std::size_t>(hit.circle)];
        const double distance = distanceFrom(hit.wall, preset.halfWidth, c.position);
        if (distance < -farOutside - 2.0 * step)
            return; // nothing will turn it any more
        wasOutside = wasOutside || distance < -outside * hit.radius - 2.0 * step;
        if (wasOutside && dot(n, c.velocity) < 0.0)
            return; // gravity brings back what was let through
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
        const bool turned = isTurned(now, free);
        const bool moved = isMoved(now, free);
        if (!turned && !moved)
            continue;
        if (isFirst && !corner && goesOnNear(hit, c, now, free)
            && (hit.near || isFreeFarther(hit, k))) {
            hit.near = hit.near ? hit.near : WallStep{c, {now.position, now.velocity}, free, k};
            continue;
        }
        note(hit, before, now, free, k);
        // What is moved along a wall before it is there was moved by something else.
        if (!turned && !corner && std::abs(dot(now.position - free.position, n)) < 1e-7
            && hit.reached > hit.radius + std::abs(hit.travel)) {
            hit.missed = true;
            return;
        }
        // A wall turns it round, or its rim is there; else something on the way changes it, which
        // may be a hit that stops it.
        const bool isStopped = m_ground.pair.asked && hit.left == Vec2{};
        if ((hit.back < 0.0 || isStopped) && (!moved || (turned && k == 1))
            && hit.reached > hit.radius + std::abs(hit.travel)) {
            hit.missed = true;
            return;
        }
        hit.turned = turned;
        hit.held = !turned;
        lookAtOthers(hit, before, probe);
        return;
    }
    // It never came there, or so slowly that all of this time has not brought it through.
    const Vec2 place = probe.circle(hit.circle).position;
    hit.missed = distanceFrom(hit.wall, preset.halfWidth, place) > hit.radius - 0.02;
}

bool WallRange::isFreeFarther(const WallHit &hit, int k) const
{
    Stage stage = hit.stage;
    stage.preset.circles[static_cast<std::size_t>(hit.circle)].body.position -=
        fartherInside * outwardNormal(hit.wall);
    Probe probe(m_program, stage);
    for (int i = 1; i < k && probe.runs(); ++i) {
        if (!probe.step())
            return false;
    }
    const Motion free = flightOf(hit.circle).after(probe.circle(hit.circle), m_h);
    return probe.runs() && probe.step() && !isTurned(probe.circle(hit.circle), free)
           && !isMoved(probe.circle(hit.circle), free);
}

bool WallRange::goesOnNear(const WallHit &hit, const Circle &was, const Circle &now,
                           const Motion &free)
{
    const Vec2 n = outwardNormal(hit.wall);
    const double room =
        distanceFrom(hit.wall, hit.stage.preset.halfWidth, free.position) - hit.radius;
    return room > 1e-9 && room < nearWall && dot(n, now.velocity) > 0.0
           && dot(n, now.position - was.position) > 0.0;
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
    hit.was = c.velocity;
    hit.came = free.velocity;
    hit.left = now.velocity;
    hit.back = -dot(n, now.velocity) / dot(n, free.velocity);
    hit.along = dot(t, now.velocity) / dot(t, free.velocity);
    hit.after = distanceFrom(hit.wall, preset.halfWidth, now.position);
    hit.leap = std::min(length(now.position - c.position), length(now.position - free.position));
    hit.landed = now.position;
}

bool WallRange::isSoAnew(const WallHit &hit, const World &from) const
{
    Probe probe(m_program, beginningAt(hit.stage, from));
    return probe.runs() && probe.step()
           && length(probe.circle(hit.circle).position - hit.unchanged->now.position) < 1e-9;
}

bool WallRange::turnsAnew(const Stage &stage, const World &from, int circle, Wall wall) const
{
    Probe probe(m_program, beginningAt(stage, from));
    return probe.runs() && probe.step()
           && dot(outwardNormal(wall), probe.circle(circle).velocity) > 0.0;
}

void WallRange::follow(WallHit &hit, Probe &probe) const
{
    const Vec2 n = outwardNormal(hit.wall);
    Circle c = probe.circle(hit.circle);
    const World left = probe.world();
    WallStep next{};
    int unmoved = 0;      // steps, though its velocity points away from the wall
    bool pointsIn = true; // in all of them
    for (int k = 0; k < stepsAfterwards; ++k) {
        const World before = probe.world();
        if (!probe.step())
            return;
        const Circle &now = probe.circle(hit.circle);
        const Motion free = flightOf(hit.circle).after(c, m_h);
        const bool leaves = dot(n, c.velocity) < 0.0 && dot(n, free.velocity) < 0.0;
        const double away = distanceFrom(hit.wall, hit.stage.preset.halfWidth, c.position);
        if (leaves && dot(n, now.velocity) > 0.0 && away < hit.radius + hit.travel) {
            if (hit.again == 0)
                hit.isAgainAnew = turnsAnew(hit.stage, before, hit.circle, hit.wall);
            ++hit.again;
        }
        const bool staysThere = dot(n, now.position - c.position) > -smallShare * hit.travel
                                && dot(n, now.position - free.position) > 0.5 * hit.travel;
        unmoved = leaves && staysThere && k == unmoved ? unmoved + 1 : unmoved;
        if (hit.turnsLater == 0 && dot(n, now.velocity) < 0.0 && dot(n, free.velocity) > 0.0)
            hit.turnsLater = k + 1;
        pointsIn &= dot(n, now.velocity) > 0.0;
        if (k == 0)
            next = {c, {now.position, now.velocity}, free, hit.step + 1};
        c = now;
    }
    const bool goesOut = dot(n, next.now.position - next.was.position) > 0.5 * hit.travel;
    // Who would still be beyond the wall may be put back once more.
    const bool isInside =
        distanceFrom(hit.wall, hit.stage.preset.halfWidth, next.free.position) > hit.radius;
    if (unmoved > 0 && (goesOut || (unmoved > 1 && isInside && hit.fits(hit.radius))))
        hit.unchanged = next;
    if (hit.unchanged)
        hit.isAnewSo = isSoAnew(hit, left);
    hit.turnsBoth = dot(n, c.velocity) < 0.0
                    && dot(perpendicular(n), c.velocity) * dot(perpendicular(n), hit.came) < 0.0;
    const double distance = distanceFrom(hit.wall, hit.stage.preset.halfWidth, c.position);
    hit.stays = distance < hit.after + 0.5 * hit.travel;
    hit.goesBack = pointsIn && distance > hit.after + 3.5 * hit.travel;
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
        if (!hit.disturbs) {
            hit.otherFree = free;
            hit.otherWas = {now.position, now.velocity};
        }
        hit.kicks |= length(now.velocity - free.velocity) > 1e-6;
        const double slack = 1e-6 + smallShare * length(free.position - was.position);
        hit.disturbs |= hit.kicks || length(now.position - free.position) > slack;
    }
}

} // namespace cradle
