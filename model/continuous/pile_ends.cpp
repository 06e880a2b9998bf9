// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile_ends.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// What overlaps in the end is parted in so many sweeps over what lies closer than so many overlaps
/// that may be; then it is seen who else does, so often for each row that the circles would fill.
constexpr int sweepsPerLook = 8;
constexpr double tightness = 4.0;
constexpr double looksPerRow = 4.0;

/// Moves two apart, each by its mass, if they overlap at the end by more than may be. \return
/// whether they did
bool part(const Pile &pile, const NearPair &near, PileEnds &ends)
{
    const double gap = pile.gapBetween(near.a, near.b, ends.places);
    if (gap >= -pile.borne)
        return false;
    const bool wall = pile.isWall(near.b);
    const Vec2 normal = wall ? near.normal : normalized(ends.places[near.b] - ends.places[near.a]);
    const double weightA = pile.inverseMasses[near.a];
    const double weightB = pile.inverseMasses[near.b];
    const Vec2 way = ((0.5 * pile.borne - gap) / (weightA + weightB)) * normal;
    ends.places[near.a] -= weightA * way;
    if (!wall)
        ends.places[near.b] += weightB * way;
    ends.pushed[near.a] = ends.pushed[near.b] = 1;
    return true;
}

/// Parts all that overlap, as often as that makes others overlap. \return whether any did
bool partAll(const Pile &pile, std::span<const NearPair> near, PileEnds &ends)
{
    bool any = false;
    std::vector<std::uint32_t> tight; // who overlaps, or may do so when those are parted
    const double rows = std::sqrt(static_cast<double>(pile.count()));
    for (int look = static_cast<int>(looksPerRow * rows); look >= 0; --look) {
        bool overlap = false;
        tight.clear();
        for (std::uint32_t k = 0; k < near.size(); ++k) {
            const double gap = pile.gapBetween(near[k].a, near[k].b, ends.places);
            overlap = overlap || gap < -pile.borne;
            if (gap < tightness * pile.borne)
                tight.push_back(k);
        }
        any = any || overlap;
        if (!overlap)
            break;
        // Up and down again, for what is lifted may now overlap with what lies on it.
        for (int sweep = 0; sweep < sweepsPerLook && overlap; ++sweep) {
            overlap = false;
            for (const std::uint32_t k : tight)
                overlap = part(pile, near[k], ends) || overlap;
            std::reverse(tight.begin(), tight.end());
        }
    }
    return any;
}

} // namespace

PileEnds fly(const Pile &pile, const PileMotion &motion)
{
    PileEnds ends;
    ends.places.resize(pile.count());
    ends.pushed.assign(pile.inverseMasses.size(), 0);
    for (const PileContact &c : motion.contacts) {
        if (c.push > 0.0)
            ends.pushed[c.a] = ends.pushed[c.b] = 1;
    }
    const auto move = [&](Pile::Body i) {
        const Circle &c = pile.circles[i];
        const double curve = pathCurvature(pile.rules.integrators[pile.order[i]]);
        const Vec2 w = ends.pushed[i] != 0 ? motion.velocities[i]
                                           : c.velocity + (curve * pile.dt) * pile.rules.gravity;
        ends.places[i] = c.position + pile.dt * w;
    };
    for (Pile::Body i = 0; i < pile.count(); ++i)
        move(i);
    for (bool grown = true; grown;) {
        grown = false;
        for (const NearPair &near : motion.near) {
            const bool even =
                ends.pushed[near.a] != 0 && (pile.isWall(near.b) || ends.pushed[near.b] != 0);
            if (even || pile.gapBetween(near.a, near.b, ends.places) >= 0.0)
                continue;
            for (const Pile::Body body : {near.a, near.b}) {
                if (!pile.isWall(body) && ends.pushed[body] == 0) {
                    ends.pushed[body] = 1;
                    move(body);
                    grown = true;
                }
            }
        }
    }
    return ends;
}

void partOverlaps(const Pile &pile, const PileMotion &motion, PileEnds &ends)
{
    std::vector<Vec2> flown = ends.places;
    if (!partAll(pile, motion.near, ends))
        return;
    const double lifted = gained(pile, ends, motion.velocities);
    ends.places.swap(flown);
    const std::vector<Vec2> &parted = flown;
    const double before = gained(pile, ends, motion.velocities);
    const double share = lifted <= 0.0 ? 1.0 : before < 0.0 ? before / (before - lifted) : 0.0;
    for (std::size_t i = 0; i < parted.size(); ++i)
        ends.places[i] += share * (parted[i] - ends.places[i]);
}

double gained(const Pile &pile, const PileEnds &ends, std::span<const Vec2> velocities)
{
    double sum = 0.0;
    for (Pile::Body i = 0; i < pile.count(); ++i) {
        if (ends.pushed[i] == 0)
            continue;
        const Circle &c = pile.circles[i];
        const Vec2 way = ends.places[i] - c.position;
        sum += (0.5 * (lengthSquared(velocities[i]) - lengthSquared(c.velocity))
                - dot(pile.rules.gravity, way))
               / pile.inverseMasses[i];
    }
    return sum;
}

} // namespace cradle
