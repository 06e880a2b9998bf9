// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/draws.h"

#include "tasks/judging/measured_wall.h"

/// Measured hits at walls that answer by other laws, and of which numbers are changed.
namespace cradle::approved {

/// Leaves with that velocity.
inline void leave(WallHit &hit, Vec2 left)
{
    const Vec2 n = outwardNormal(hit.wall);
    const Vec2 t = perpendicular(n);
    hit.left = left;
    if (dot(hit.came, n) != 0.0)
        hit.back = -dot(left, n) / dot(hit.came, n);
    if (dot(hit.came, t) != 0.0)
        hit.along = dot(left, t) / dot(hit.came, t);
}

/// Leaves with such shares of the parts into the wall, turned round, and along it.
inline void leaveWith(WallHit &hit, double back, double along)
{
    const Vec2 n = outwardNormal(hit.wall);
    const Vec2 t = perpendicular(n);
    leave(hit, -back * dot(hit.came, n) * n + along * dot(hit.came, t) * t);
}

/// Turned by the step in which the centre comes so near to the wall.
inline void turnAt(WallHit &hit, double distance)
{
    hit.before = distance + 0.4 * std::abs(hit.travel);
    hit.reached = hit.before - hit.travel;
    hit.after = hit.before;
}

/// Put there, seen from the wall.
inline void putAt(WallHit &hit, double distance)
{
    hit.after = distance;
    hit.landed = (hit.stage.preset.halfWidth - distance) * outwardNormal(hit.wall);
    hit.leap = std::min(std::abs(distance - hit.before), std::abs(distance - hit.reached));
}

inline bool isOfY(const WallHit &hit)
{
    return outwardNormal(hit.wall).y != 0.0;
}

struct WallAnswer {
    const char *name;
    void (*answer)(WallHit &);
};

inline constexpr WallAnswer wallAnswers[] = {
    {"right", [](WallHit &) {}},
    {"not at all", [](WallHit &h) { h.turned = h.held = false, leaveWith(h, -1.0, 1.0); }},
    {"held", [](WallHit &h) { h.turned = false, h.held = true, leaveWith(h, -1.0, 1.0); }},
    {"it never came", [](WallHit &h) { h.turned = h.held = false, h.missed = true; }},
    {"whole velocity turned", [](WallHit &h) { leave(h, -h.came); }},
    {"whole velocity turned, with e", [](WallHit &h) { leave(h, -h.restitution * h.came); }},
    {"other part turned", [](WallHit &h) { leaveWith(h, -1.0, -1.0); }},
    {"other part turned, with e", [](WallHit &h) { leaveWith(h, -1.0, -h.restitution); }},
    {"stops", [](WallHit &h) { leave(h, {}); }},
    {"no rebound", [](WallHit &h) { leaveWith(h, 0.0, 1.0); }},
    {"without e", [](WallHit &h) { leaveWith(h, 1.0, 1.0); }},
    {"e squared", [](WallHit &h) { leaveWith(h, h.restitution * h.restitution, 1.0); }},
    {"root of e", [](WallHit &h) { leaveWith(h, std::sqrt(h.restitution), 1.0); }},
    {"what e takes", [](WallHit &h) { leaveWith(h, 1.0 - h.restitution, 1.0); }},
    {"half of e", [](WallHit &h) { leaveWith(h, 0.5 * h.restitution, 1.0); }},
    {"divided by e", [](WallHit &h) { leaveWith(h, 1.0 / h.restitution, 1.0); }},
    {"1 + e", [](WallHit &h) { leaveWith(h, 1.0 + h.restitution, 1.0); }},
    {"e of a number", [](WallHit &h) { leaveWith(h, 0.8, 1.0); }},
    {"e on both parts", [](WallHit &h) { leaveWith(h, h.restitution, h.restitution); }},
    {"e on the part along", [](WallHit &h) { leaveWith(h, 1.0, h.restitution); }},
    {"e on the part along alone", [](WallHit &h) { leaveWith(h, -1.0, h.restitution); }},
    {"part along is lost", [](WallHit &h) { leaveWith(h, h.restitution, 0.0); }},
    {"some of the part along", [](WallHit &h) { leaveWith(h, h.restitution, 0.7); }},
    {"part along twice", [](WallHit &h) { leaveWith(h, h.restitution, 2.0); }},
    {"parts exchanged",
     [](WallHit &h) {
         leave(h, {h.came.y, h.came.x});
     }},
    {"part along counts",
     [](WallHit &h) {
         const Vec2 n = outwardNormal(h.wall);
         leave(h, h.came - (1.0 + h.restitution) * length(h.came) * n);
     }},
    {"the same speed back",
     [](WallHit &h) {
         const Vec2 n = outwardNormal(h.wall);
         leave(h, dot(h.came, perpendicular(n)) * perpendicular(n) - 1.0 * n);
     }},
    {"the same speed less", [](WallHit &h) { leave(h, h.left + 0.1 * outwardNormal(h.wall)); }},
    {"the same speed more", [](WallHit &h) { leave(h, h.left - 0.1 * outwardNormal(h.wall)); }},
    {"by whether it is slow",
     [](WallHit &h) { leaveWith(h, length(h.came) < 1.0 ? 0.0 : h.restitution, 1.0); }},
    {"by whether it is fast",
     [](WallHit &h) { leaveWith(h, length(h.came) > 1.5 ? 0.3 : h.restitution, 1.0); }},
    {"by its radius", [](WallHit &h) { leaveWith(h, 5.0 * h.radius * h.restitution, 1.0); }},
    {"kept positive",
     [](WallHit &h) {
         leave(h, {std::abs(h.left.x), std::abs(h.left.y)});
     }},
    {"x alone",
     [](WallHit &h) {
         if (isOfY(h))
             h.turned = false;
     }},
    {"top and right alone",
     [](WallHit &h) { h.turned = h.turned && (h.wall == Wall::Right || h.wall == Wall::Top); }},
    {"floor missing", [](WallHit &h) { h.turned = h.turned && h.wall != Wall::Bottom; }},
    {"circle 1 alone", [](WallHit &h) { h.turned = h.turned && h.circle == 0; }},
    {"at the centre", [](WallHit &h) { turnAt(h, 0.0); }},
    {"at the diameter", [](WallHit &h) { turnAt(h, 2.0 * h.radius); }},
    {"at half of the radius", [](WallHit &h) { turnAt(h, 0.5 * h.radius); }},
    {"at the square of the radius", [](WallHit &h) { turnAt(h, h.radius * h.radius); }},
    {"at the radius of the other", [](WallHit &h) { turnAt(h, h.otherRadius); }},
    {"at both radii", [](WallHit &h) { turnAt(h, h.radius + h.otherRadius); }},
    {"at a number", [](WallHit &h) { turnAt(h, 0.25); }},
    {"beyond the wall", [](WallHit &h) { turnAt(h, -h.radius); }},
    {"far beyond the wall", [](WallHit &h) { turnAt(h, -3.0 * h.radius); }},
    {"early", [](WallHit &h) { turnAt(h, h.radius + 0.1); }},
    {"in the middle", [](WallHit &h) { turnAt(h, h.stage.preset.halfWidth); }},
    {"at a wall elsewhere", [](WallHit &h) { turnAt(h, h.radius + 1.0); }},
    {"at the rim where it is too far to the left",
     [](WallHit &h) { turnAt(h, h.wall == Wall::Left ? 0.0 : h.radius); }},
    {"put beyond the wall", [](WallHit &h) { putAt(h, -0.2); }},
    {"put inside", [](WallHit &h) { putAt(h, h.radius + 0.3); }},
    {"put into the wall", [](WallHit &h) { putAt(h, 0.0); }},
    {"put into the middle", [](WallHit &h) { putAt(h, h.stage.preset.halfWidth), h.landed = {}; }},
    {"stays there", [](WallHit &h) { h.stays = true; }},
    {"comes away by its place", [](WallHit &h) { h.goesBack = true, leaveWith(h, -1.0, 1.0); }},
    {"turned later", [](WallHit &h) { h.turned = false, h.held = true, h.turnsLater = 3; }},
    {"turned again", [](WallHit &h) { h.again = 2; }},
    {"pushes the other", [](WallHit &h) { h.kicks = h.disturbs = true; }},
    {"both parts turned later", [](WallHit &h) { h.turnsBoth = true; }},
};

/// Changes a number of a hit.
inline void changeNumber(WallHit &hit, std::size_t which, double by)
{
    const Vec2 n = outwardNormal(hit.wall);
    switch (which) {
    case 0:
        leave(hit, hit.left + by * n);
        break;
    case 1:
        leave(hit, hit.left + by * perpendicular(n));
        break;
    case 2:
        leave(hit, (1.0 + by) * hit.left);
        break;
    case 3:
        leaveWith(hit, (1.0 + by) * hit.back, hit.along);
        break;
    case 4:
        leaveWith(hit, hit.back, (1.0 + by) * hit.along);
        break;
    case 5:
        hit.before += by;
        break;
    case 6:
        hit.reached += by;
        break;
    case 7:
        hit.before += by, hit.reached += by, hit.after += by;
        break;
    case 8:
        hit.after += by;
        break;
    case 9:
        putAt(hit, hit.after + by);
        break;
    case 10:
        hit.leap += by;
        break;
    case 11:
        hit.travel *= 1.0 + by;
        break;
    case 12:
        hit.came += by * n;
        break;
    case 13:
        hit.was += by * perpendicular(n);
        break;
    case 14:
        hit.otherWas.velocity += by * n;
        break;
    case 15:
        hit.otherWas.position += by * n;
        break;
    case 16:
        hit.landed += by * perpendicular(n);
        break;
    default:
        turnAt(hit, hit.radius * (1.0 + by));
        break;
    }
}
inline constexpr std::size_t wallNumbers = 18;

/// Changes what is known of a hit besides numbers.
inline void changeFact(WallHit &hit, std::size_t which)
{
    bool *const facts[] = {&hit.missed, &hit.turned,   &hit.held,       &hit.turnsBoth,
                           &hit.isLost, &hit.stays,    &hit.goesBack,   &hit.disturbs,
                           &hit.kicks,  &hit.isAnewSo, &hit.isAgainAnew};
    if (which < std::size(facts))
        *facts[which] = !*facts[which];
    else if (which == std::size(facts))
        ++hit.again;
    else if (which == std::size(facts) + 1)
        ++hit.turnsLater;
    else
        ++hit.step;
}
inline constexpr std::size_t wallFacts = 14;

/// A step in which it does not fly freely.
inline WallStep strayStep(const WallHit &hit, double by)
{
    WallStep step;
    step.was = hit.stage.preset.circles[std::size_t(hit.circle)].body;
    step.free = {step.was.position + hit.stage.preset.timestep * hit.came, hit.came};
    step.now = {step.free.position + by * outwardNormal(hit.wall), (1.0 + by) * hit.came};
    step.step = hit.step;
    return step;
}

} // namespace cradle::approved
