// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/meeting_groups.h"

#include "model/world/world.h"

#include <algorithm>

namespace cradle {

namespace {

std::uint32_t memberOf(Crowd::Slot slot, Crowd &crowd, StepGroups &groups);

void join(Crowd::Slot a, Crowd::Slot b, Crowd &crowd, StepGroups &groups)
{
    const std::uint32_t first = memberOf(a, crowd, groups);
    groups.join(first, memberOf(b, crowd, groups));
}

/// The member that a circle is from now on. If it sleeps, all wake that sleep with it, and are of
/// its group.
std::uint32_t memberOf(Crowd::Slot slot, Crowd &crowd, StepGroups &groups)
{
    if (!groups.has(slot)) {
        groups.add(slot);
        if (crowd.sleeps(slot)) {
            for (const std::uint32_t id : crowd.sleep.wake(crowd.ids[slot]))
                join(slot, crowd.slotOf[id], crowd, groups);
        }
    }
    return groups.of(slot);
}

/// Whether two meet in a step if both fly freely.
bool meet(const Crowd &crowd, double dt, const Crowd::Pair &pair)
{
    const Path path = crowd.path(pair.a);
    if (pair.b != Crowd::wall) {
        const double reach = crowd.radii[pair.a] + crowd.radii[pair.b];
        return timeToDistance(path, crowd.path(pair.b), reach, dt).has_value();
    }
    const double room = crowd.rules.halfWidth - crowd.radii[pair.a];
    return std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall side) {
        const Vec2 n = outwardNormal(side);
        return timeToLine(room - dot(path.position, n), dot(path.velocity, n), dot(path.curve, n),
                          dt)
            .has_value();
    });
}

/// How fast a circle at most is in the step as far as is known, m/s: another may have kicked it.
double fastestOf(Crowd::Slot slot, const Crowd &crowd, const StepGroups &groups)
{
    const double speed = crowd.speed(slot);
    return groups.has(slot) ? std::max(speed, groups[groups.of(slot)].fastest) : speed;
}

} // namespace

void findGroups(Crowd &crowd, double dt, std::span<const Crowd::Pair> resting,
                std::span<const Crowd::Pair> due, StepGroups &groups,
                std::vector<Crowd::Pair> &inVain)
{
    groups.clear();
    inVain.clear();
    for (const Crowd::Pair &pair : resting)
        join(pair.a, pair.b, crowd, groups);
    for (const Crowd::Pair &pair : due) {
        if (crowd.sleeps(pair.a) && (pair.b == Crowd::wall || crowd.sleeps(pair.b)))
            continue;
        if (!meet(crowd, dt, pair))
            inVain.push_back(pair);
        else if (pair.b == Crowd::wall)
            memberOf(pair.a, crowd, groups);
        else
            join(pair.a, pair.b, crowd, groups);
    }
}

void foreseePiles(Crowd &crowd, const BroadPhase &near, StepGroups &groups)
{
    for (bool grown = crowd.hasPiles; grown;) {
        grown = false;
        for (std::uint32_t i = 0; i < groups.size(); ++i) { // while more of them join
            const StepGroups::Member &group = groups[groups.groupOf(i)];
            if (groups[i].foreseen >= 0.0 || !group.changed || !crowd.isPile(group.size))
                continue;
            const double fastest =
                length(crowd.motions[groups[i].slot].velocity) + crowd.gravity * near.dt();
            groups[i].fastest = groups[i].foreseen = fastest;
            groups.note(fastest);
            widen(crowd, near, i, groups);
            grown = true;
        }
    }
}

void widen(Crowd &crowd, const BroadPhase &near, std::uint32_t member, StepGroups &groups)
{
    if (crowd.rules.laws.circles == CircleLaw::None)
        return;
    const Crowd::Slot slot = groups[member].slot;
    const double fastest = groups[member].fastest;
    const Vec2 place = crowd.motions[slot].position;
    const SortSkin &skin = near.skin();
    const double dt = near.dt();
    const double reach = crowd.radii[slot] + skin.travel(dt, fastest);
    const auto consider = [&](Crowd::Slot other) {
        const double close =
            reach + crowd.radii[other] + skin.travel(dt, fastestOf(other, crowd, groups));
        if (other != slot && lengthSquared(crowd.motions[other].position - place) <= close * close)
            join(slot, other, crowd, groups);
    };
    // Most are farther than even the fastest could come. Where this one was kicked harder than the
    // grid knows, others that were, too, may come from farther than it knows.
    double farthest = skin.driftAfter(near.index() + 1);
    double foreseen =
        skin.travel(dt, skin.fastest() + crowd.gravity * static_cast<double>(near.index()) * dt);
    if (fastest > skin.fastest()) {
        const double kicked = skin.travel(dt, groups.fastest());
        farthest = std::max(farthest, skin.driftAfter(near.index()) + kicked);
        foreseen = std::max(foreseen, kicked);
    }
    const double far = reach + crowd.smallRadius + foreseen;
    const auto look = [&](Crowd::Slot begin, Crowd::Slot end) {
        for (Crowd::Slot other = begin; other < end; ++other) {
            if (lengthSquared(crowd.motions[other].position - place) <= far * far)
                consider(other);
        }
    };
    near.grid().visitRuns(place, reach + crowd.smallRadius + farthest, look);
    for (Crowd::Slot giant = crowd.small; giant < crowd.count(); ++giant)
        consider(giant);
}

} // namespace cradle
