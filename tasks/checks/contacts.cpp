// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/contacts.h"

#include "tasks/checks/motion.h"

#include <algorithm>
#include <cmath>

namespace cradle::motion {

namespace {

/// Least distance of two centres while both go straight for \p seconds from their state. Gravity
/// acts on both alike and takes no part.
double nearestCentres(const Circle &a, const Circle &b, double seconds)
{
    const Vec2 d = b.position - a.position;
    const Vec2 v = b.velocity - a.velocity;
    const double speed2 = lengthSquared(v);
    const double s = speed2 > 0.0 ? std::clamp(-dot(d, v) / speed2, 0.0, seconds) : 0.0;
    return quickLength(d + s * v);
}

/// Whether all that circle \p i gets in the step after \p k may be the push of a wall it is at.
bool isOfWall(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const Vec2 push = kick(o, i, k, gravity);
    return std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
        const Vec2 n = outwardNormal(wall);
        return wallGap(o, o.circle(i, k), wall) <= travel(o, i, k, gravity) && dot(push, n) < 0.0
               && dot(o.circle(i, k).velocity, n) > 0.0
               && std::abs(cross(push, n)) <= sameVelocity * (1.0 + quickLength(push));
    });
}

} // namespace

std::vector<Contact> contactsOf(const Observation &o, int a, int b, Vec2 gravity)
{
    std::vector<Contact> contacts;
    for (qint64 k = 0; k < o.steps(); ++k) {
        const bool kickedA = isKicked(o, a, k, gravity);
        const bool kickedB = isKicked(o, b, k, gravity);
        if (!kickedA && !kickedB)
            continue;
        const Circle &ca = o.circle(a, k);
        const Circle &cb = o.circle(b, k);
        const double dt = o.timestep();
        const double sum = ca.radius + cb.radius;
        Contact contact{.step = k};
        const Vec2 movedA = ca.position + dt * ca.velocity;
        const Vec2 movedB = cb.position + dt * cb.velocity;
        contact.nearest = std::min({nearestCentres(ca, cb, dt), quickLength(cb.position - movedA),
                                    quickLength(movedB - ca.position)})
                          - sum;
        // What happens at a wall, far from the other circle, is not theirs.
        const bool wall = (!kickedA || isNearWall(o, a, k, gravity))
                          && (!kickedB || isNearWall(o, b, k, gravity));
        if (wall && contact.nearest > travel(o, a, k, gravity) + travel(o, b, k, gravity))
            continue;
        // Nor is what they get along the normals of walls that they are at.
        if ((!kickedA || isOfWall(o, a, k, gravity)) && (!kickedB || isOfWall(o, b, k, gravity)))
            continue;
        contact.beforeA = ca.velocity;
        contact.beforeB = cb.velocity;
        contact.afterA = o.circle(a, k + 1).velocity - dt * gravity;
        contact.afterB = o.circle(b, k + 1).velocity - dt * gravity;
        // A program that sees the hit late may still use the step before.
        const qint64 early = std::max<qint64>(0, k - 1);
        const Circle &ea = o.circle(a, early);
        const Circle &eb = o.circle(b, early);
        contact.normalFirst = normalized(eb.position - ea.position);
        contact.normalLast = normalized(movedB - movedA);
        contact.normalA = normalized(cb.position - movedA);
        contact.normalB = normalized(movedB - ca.position);
        contacts.push_back(contact);
    }
    return contacts;
}

std::optional<Fault> steadyFaultOf(const Observation &o, int a, int b, Vec2 gravity)
{
    const auto fault = steadyFault(o, a, gravity);
    return fault ? fault : steadyFault(o, b, gravity);
}

bool isBesideWall(const Observation &o, int a, int b, const Contact &contact, Vec2 gravity)
{
    return isNearWall(o, a, contact.step, gravity) || isNearWall(o, b, contact.step, gravity);
}

qint64 missedContact(const Observation &o, int a, int b)
{
    int inside = 0;
    for (qint64 k = 0; k <= o.steps(); ++k) {
        const Circle &ca = o.circle(a, k);
        const Circle &cb = o.circle(b, k);
        const Vec2 d = cb.position - ca.position;
        const double sum = ca.radius + cb.radius;
        // Two that stay in touch (e = 0) come nearer by rounding only.
        const double noise =
            sameVelocity * (1.0 + quickLength(ca.velocity) + quickLength(cb.velocity));
        const bool nearer = dot(normalized(d), ca.velocity - cb.velocity) > noise;
        const bool in = quickLength(d) < sum * (1.0 - 1e-9);
        inside = in && nearer ? inside + 1 : 0;
        // One state may show the overlap that the next step answers.
        if (inside > 2)
            return k - 2;
    }
    return -1;
}

bool leavesInside(const Observation &o, int a, int b, Vec2 gravity)
{
    const std::vector<Contact> contacts = contactsOf(o, a, b, gravity);
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        const Circle &ca = o.circle(a, contact.step + 1);
        const Circle &cb = o.circle(b, contact.step + 1);
        const Vec2 d = cb.position - ca.position;
        const double sum = ca.radius + cb.radius;
        const double parting = dot(normalized(d), cb.velocity - ca.velocity);
        return quickLength(d) < sum * (1.0 - samePosition)
               && parting
                      > sameVelocity * (1.0 + quickLength(ca.velocity) + quickLength(cb.velocity));
    });
}

} // namespace cradle::motion
