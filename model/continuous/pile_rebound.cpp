// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile_rebound.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Of what gravity gives in a step: the error of a rebound.
constexpr double reboundTolerance = 0.01;
/// Sweeps over the contacts for it, at most.
constexpr int mostReboundSweeps = 60;

/// Takes the rebounds only as far as there is energy for them.
/// \param velocities  with all of them, m/s; then with as much as there may be
void boundEnergy(const Pile &pile, const PileMotion &motion, const PileEnds &ends,
                 std::span<Vec2> velocities)
{
    if (gained(pile, ends, velocities) <= 0.0)
        return;
    double linear = 0.0;
    double square = 0.0;
    for (Pile::Body i = 0; i < pile.count(); ++i) {
        const Vec2 more = velocities[i] - motion.velocities[i];
        linear += dot(motion.velocities[i], more) / pile.inverseMasses[i];
        square += 0.5 * lengthSquared(more) / pile.inverseMasses[i];
    }
    if (square == 0.0)
        return;
    const double spare = std::max(0.0, -gained(pile, ends, motion.velocities));
    const double share = std::clamp(
        (std::sqrt(linear * linear + 4.0 * square * spare) - linear) / (2.0 * square), 0.0, 1.0);
    for (Pile::Body i = 0; i < pile.count(); ++i)
        velocities[i] = motion.velocities[i] + share * (velocities[i] - motion.velocities[i]);
}

} // namespace

PileRebound findRebound(const Pile &pile, const PileMotion &motion, PileEnds &ends)
{
    PileRebound rebound{motion.velocities, {}};
    rebound.impulses.reserve(motion.contacts.size());
    std::vector<PileContact> contacts;
    std::vector<std::uint32_t> contactOf; // of each of these in the motion
    contacts.reserve(motion.contacts.size());
    contactOf.reserve(motion.contacts.size());
    const double e = pile.rules.restitution;
    bool any = false;
    for (std::uint32_t k = 0; k < motion.contacts.size(); ++k) {
        const NearPair &near = motion.pairOf(k);
        PileContact c = motion.contacts[k];
        const bool hit = c.push > 0.0 && 2.0 * e * near.speed > pile.gain;
        any = any || hit;
        c.limit = hit ? -e * near.speed : 0.0;
        rebound.impulses.push_back(c.push);
        if (c.push <= 0.0 && pile.gapBetween(near.a, near.b, ends.places) > 2.0 * pile.apart)
            continue;
        contacts.push_back(c);
        contactOf.push_back(k);
    }
    if (!any)
        return rebound;
    PileBodies bodies{{}, pile.inverseMasses};
    pile.setFree(bodies);
    solvePile(contacts, bodies, reboundTolerance * pile.gain, mostReboundSweeps);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const PileContact &c = contacts[i];
        rebound.impulses[contactOf[i]] = c.push;
        if (c.push > 0.0)
            ends.pushed[c.a] = ends.pushed[c.b] = 1;
    }
    bodies.velocities.resize(pile.count());
    rebound.velocities = std::move(bodies.velocities);
    boundEnergy(pile, motion, ends, rebound.velocities);
    return rebound;
}

void reportHits(const Pile &pile, const PileMotion &motion, const PileRebound &rebound,
                const World &world, std::vector<Hit> &hits)
{
    const double e = std::max(pile.rules.restitution, 0.5);
    for (std::size_t k = 0; k < motion.contacts.size(); ++k) {
        const NearPair &near = motion.pairOf(k);
        if (motion.contacts[k].push <= 0.0 || 2.0 * e * near.speed <= pile.gain)
            continue;
        const bool wall = pile.isWall(near.b);
        const bool swapped = !wall && pile.order[near.b] < pile.order[near.a];
        const Pile::Body a = swapped ? near.b : near.a;
        const Pile::Body b = swapped ? near.a : near.b;
        const Vec2 fall = near.met * pile.rules.gravity;
        Hit hit{.time = world.time - pile.dt + std::max(near.met, 0.0),
                .step = world.step,
                .kind = wall ? Hit::Kind::Wall : Hit::Kind::Circle,
                .a = static_cast<int>(pile.order[a]),
                .b = static_cast<int>(wall ? b - pile.count() : pile.order[b]),
                .normal = swapped ? -near.normal : near.normal,
                .impulse = rebound.impulses[k],
                .beforeA = pile.circles[a].velocity + fall,
                .afterA = rebound.velocities[a]};
        if (!wall) {
            hit.beforeB = pile.circles[b].velocity + fall;
            hit.afterB = rebound.velocities[b];
        }
        const double after = dot(hit.afterA - hit.afterB, hit.normal);
        hit.loss = 0.5 * hit.impulse * (near.speed + after);
        hits.push_back(hit);
    }
}

} // namespace cradle
