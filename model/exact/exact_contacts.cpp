// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/exact_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cradle {

// How the contacts of one moment answer.

namespace {

/// A rebound from a floor that would rise less than this share of the radius is no rebound.
constexpr double restHeight = 1e-9;
/// A rebound from a disc that would rise less than this share of the smaller radius loses nothing,
/// and they shake from then on.
constexpr double shakeHeight = 1e-6;
/// What shakes loses nothing below this share for each row that the heap may have,
constexpr double hopHeight = 2.5e-4;
/// and what lies on each other is kept hopping to this share for each.
constexpr double lyingHeight = 1e-5;
/// Of a speed.
constexpr double rounding = 1e-9;

} // namespace

/// What \p disc has lost of its kinetic energy since it had the velocity \p before, J.
double ExactSolver::kineticLoss(Vec2 before, const Disc &disc)
{
    return 0.5 * (lengthSquared(before) - lengthSquared(disc.velocity)) / disc.inverseMass;
}

/// Puts \p disc right against \p wall: rounding must not leave it a hair beyond.
void ExactSolver::setAgainst(Disc &disc, Wall wall) const
{
    const Vec2 n = outwardNormal(wall);
    disc.position -= (dot(disc.position, n) - (m_rules.halfWidth - disc.radius)) * n;
}

/// Whether \p a and \p b would meet again at once: one falls onto what a wall holds, or both hop as
/// they do in a heap, where those above press them together.
bool ExactSolver::arePressed(Slot a, Slot b, Vec2 normal) const
{
    const Disc &first = m_discs[a];
    const Disc &second = m_discs[b];
    if (first.held != second.held)
        return dot(accelerationOf(first) - accelerationOf(second), normal) > 0.0;
    return m_gravity > 0.0 && first.held == 0 && shakes(a) && shakes(b);
}

double ExactSolver::closingSpeed(Slot a, Slot b, Vec2 normal) const
{
    const Vec2 other = isWall(b) ? Vec2{} : m_discs[b].velocity;
    return dot(m_discs[a].velocity - other, normal);
}

/// When e < 1: the speed up to which discs rebound from each other without loss, m/s. So their hits
/// cannot come ever faster, and real ones lose less the slower they are, too.
/// \param shaking  whether one of them did so when it was hit last
/// Source: Bizon et al., Phys. Rev. Lett. 80 (1998) 57; Ramírez et al., Phys. Rev. E 60 (1999)
/// 4465.
double ExactSolver::softSpeed(double radius, bool shaking) const
{
    if (!m_lossy)
        return 0.0;
    if (m_gravity == 0.0)
        return m_quiet;
    return riseSpeed((shaking ? hopHeight * m_rows : shakeHeight) * radius);
}

ExactSolver::Rebound ExactSolver::reboundOf(Slot a, Slot b, Vec2 normal, double closing) const
{
    const CircleLaw law = m_rules.laws.circles;
    const Disc &disc = m_discs[a];
    if (isWall(b)) {
        const double press = dot(m_rules.gravity, normal);
        const double speed = m_rules.restitution * closing;
        if (press > 0.0) {
            const double height = 2.0 * press * restHeight * disc.radius;
            const bool soft = shakes(a) && closing <= softSpeed(disc.radius, true);
            return {speed * speed > height ? speed : 0.0, soft,
                    soft || closing * closing <= height};
        }
        const bool soft = shakes(a) && closing <= softSpeed(disc.radius, true);
        return {soft ? closing : speed, soft, soft};
    }
    const double e = law == CircleLaw::Impulse ? m_rules.restitution
                     : law == CircleLaw::Stop  ? 0.0
                                               : 1.0;
    const double radius = std::min(disc.radius, m_discs[b].radius);
    const bool shaking = shakes(a) || shakes(b);
    const bool isSoft = closing <= softSpeed(radius, shaking);
    const bool lasts = isSoft && shaking;
    const double speed = isSoft ? closing : e * closing;
    if (arePressed(a, b, normal)) {
        const double hop = riseSpeed(lyingHeight * m_rows * radius);
        if (speed < hop)
            return {hop, isSoft, lasts || closing <= hop * (1.0 + rounding)};
    }
    return {speed, isSoft, lasts};
}

void ExactSolver::noteHit(Slot slot, bool soft)
{
    Disc &disc = m_discs[slot];
    ++disc.hits;
    ++m_hits;
    if (m_lossy)
        m_shaking[slot] = soft;
}

Hit ExactSolver::newHit(Slot a, Slot b, Vec2 normal) const
{
    Hit hit{.time = m_startTime + m_eventTime,
            .step = m_step,
            .kind = isWall(b) ? Hit::Kind::Wall : Hit::Kind::Circle,
            .a = static_cast<int>(m_ids[a]),
            .b = static_cast<int>(isWall(b) ? b - firstWall : m_ids[b]),
            .normal = normal,
            .beforeA = m_discs[a].velocity};
    if (!isWall(b))
        hit.beforeB = m_discs[b].velocity;
    return hit;
}

/// The first circle of a hit is the one that comes first in the list.
void ExactSolver::report(Hit hit, std::vector<Hit> &hits)
{
    if (hit.kind == Hit::Kind::Circle && hit.a > hit.b) {
        std::swap(hit.a, hit.b);
        std::swap(hit.beforeA, hit.beforeB);
        std::swap(hit.afterA, hit.afterB);
        hit.normal = -hit.normal;
    }
    hits.push_back(hit);
}

void ExactSolver::hitWall(Slot a, Wall wall, std::vector<Hit> &hits)
{
    Disc &disc = m_discs[a];
    const Vec2 n = outwardNormal(wall);
    carryTo(disc, m_eventTime);
    setAgainst(disc, wall);
    const double closing = dot(disc.velocity, n);
    const Rebound rebound = reboundOf(a, wallSlot(wall), n, std::max(0.0, closing));
    Hit hit = newHit(a, wallSlot(wall), n);
    disc.velocity -= (closing + rebound.speed) * n;
    if (rebound.speed == 0.0 && dot(m_rules.gravity, n) > 0.0)
        disc.held |= heldBy(wall);
    noteHit(a, rebound.soft);
    if (!rebound.lasting) {
        hit.afterA = disc.velocity;
        hit.impulse = (closing + rebound.speed) / disc.inverseMass;
        hit.loss = 0.5 * (closing - rebound.speed) * hit.impulse;
        report(hit, hits);
    } else {
        noteLasting();
    }
    findEvents(a);
}

void ExactSolver::hitPair(Slot slotA, Slot slotB, std::vector<Hit> &hits)
{
    Disc &a = m_discs[slotA];
    Disc &b = m_discs[slotB];
    carryTo(a, m_eventTime);
    carryTo(b, m_eventTime);
    const Vec2 d = b.position - a.position;
    const Vec2 n = d / std::sqrt(lengthSquared(d));
    const double closing = dot(a.velocity - b.velocity, n);
    if (closing <= 0.0) {
        // They graze, and rounding has them part already.
        findEvents(slotA);
        findEvents(slotB);
        return;
    }
    const Rebound rebound = reboundOf(slotA, slotB, n, closing);
    Hit hit = newHit(slotA, slotB, n);
    respond(a, b, n, closing + rebound.speed, rebound.lasting);
    noteHit(slotA, rebound.soft);
    noteHit(slotB, rebound.soft);
    if (!rebound.lasting) {
        hit.afterA = a.velocity;
        hit.afterB = b.velocity;
        hit.impulse = dot(hit.beforeA - hit.afterA, n) / a.inverseMass;
        hit.loss = m_rules.laws.circles == CircleLaw::Impulse
                       ? 0.5 * (closing - rebound.speed) * hit.impulse
                       : kineticLoss(hit.beforeA, a) + kineticLoss(hit.beforeB, b);
        report(hit, hits);
    } else {
        noteLasting();
    }
    findEvents(slotA);
    findEvents(slotB);
}

/// Lets the law answer for two discs alone; \p change is by how much the closing speed falls.
void ExactSolver::respond(Disc &a, Disc &b, Vec2 n, double change, bool lasting) const
{
    const CircleLaw law = m_rules.laws.circles;
    if (law == CircleLaw::Stop && !lasting) {
        a.velocity = b.velocity = Vec2{};
    } else if (law == CircleLaw::SwapVelocities && !lasting) {
        std::swap(a.velocity, b.velocity);
    } else {
        const double impulse = change / (weight(a) + weight(b));
        a.velocity -= (impulse * weight(a)) * n;
        b.velocity += (impulse * weight(b)) * n;
    }
}

} // namespace cradle
