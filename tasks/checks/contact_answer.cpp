// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/contact_answer.h"

#include "model/contacts/collision_response.h"
#include "tasks/checks/motion.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// How far a normal may lie outside the honest range, rad: rounding of two subtractions.
constexpr double sameDirection = 1e-6;

} // namespace

/// The direction of the push that circle b got: what the program took for the normal.
Vec2 ContactAnswer::usedNormal() const
{
    const Vec2 pushB = contact.afterB - contact.beforeB;
    const Vec2 pushA = contact.beforeA - contact.afterA;
    return normalized(lengthSquared(pushB) >= lengthSquared(pushA) ? pushB : pushA);
}

Vec2 ContactAnswer::middleNormal() const
{
    return normalized(contact.normalFirst + contact.normalLast);
}

Vec2 ContactAnswer::normal() const
{
    const Vec2 used = usedNormal();
    return isHonest(used) ? used : middleNormal();
}

double ContactAnswer::approach() const
{
    const Vec2 u = contact.beforeA - contact.beforeB;
    return std::max(dot(u, contact.normalFirst), dot(u, contact.normalLast));
}

Vec2 ContactAnswer::gravity() const
{
    return (o.circle(a, contact.step + 1).velocity - contact.afterA) / o.timestep();
}

/// With discrete steps the normal may be that of any moment between the step before the hit and
/// the step of the hit, also while one of the circles has made its step and the other has not.
bool ContactAnswer::isHonest(Vec2 n) const
{
    const auto angle = [](Vec2 p, Vec2 q) { return std::abs(std::atan2(cross(p, q), dot(p, q))); };
    const Vec2 first = contact.normalFirst;
    const Vec2 lasts[] = {contact.normalLast, contact.normalA, contact.normalB};
    return std::any_of(std::begin(lasts), std::end(lasts), [&](Vec2 last) {
        return angle(n, first) + angle(n, last) <= angle(first, last) + 2.0 * sameDirection;
    });
}

std::pair<Vec2, Vec2> ContactAnswer::expected(CircleLaw law, Vec2 n) const
{
    Circle ca = o.circle(a, contact.step);
    Circle cb = o.circle(b, contact.step);
    ca.velocity = contact.beforeA;
    cb.velocity = contact.beforeB;
    respond(law, ca, cb, n, restitution);
    return {ca.velocity, cb.velocity};
}

bool ContactAnswer::follows(CircleLaw law) const
{
    // Only the last two laws know a direction.
    const bool directed = law == CircleLaw::SwapNormal || law == CircleLaw::Impulse;
    const Vec2 n = directed ? usedNormal() : middleNormal();
    if (directed && !isHonest(n))
        return false;
    const auto [afterA, afterB] = expected(law, n);
    return motion::isSame(contact.afterA, afterA, tolerance)
           && motion::isSame(contact.afterB, afterB, tolerance);
}

} // namespace cradle
