// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/inferred_hits.h"

#include <algorithm>
#include <array>

namespace cradle {

namespace {

/// A change of velocity below this (relative, and in m/s) is rounding.
constexpr double noise = 1e-9;
/// More circles than this are not looked at in pairs; students' programs move a handful.
constexpr std::size_t mostInPairs = 300;

/// What one circle did in the step.
struct Change {
    Vec2 kick{};        ///< change of velocity besides gravity's, m/s
    double reach = 0.0; ///< the furthest it comes in the step, m
    bool kicked = false;
    bool byWalls = false;   ///< walls that it reaches explain the whole kick
    bool explained = false; ///< by a hit that was found

    [[nodiscard]] bool isOpen() const { return kicked && !byWalls; }
};

std::vector<Change> changesOf(const Preset &scene, std::span<const Circle> before,
                              std::span<const Circle> after, double dt)
{
    std::vector<Change> changes(before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        Change &c = changes[i];
        const double speed = std::max(length(before[i].velocity), length(after[i].velocity));
        c.kick = after[i].velocity - before[i].velocity - dt * scene.gravity;
        c.reach = (speed + length(scene.gravity) * dt) * dt;
        // Whether the program lets gravity act in the step of a hit or not.
        c.kicked = length(c.kick) > noise * (1.0 + speed)
                   && length(c.kick + dt * scene.gravity) > noise * (1.0 + speed);
    }
    return changes;
}

/// A circle in the step of a hit.
struct Struck {
    double mass = 0.0; ///< kg
    Vec2 before{};     ///< velocity, m/s
    Vec2 after{};
};

/// Kinetic energy that the hit took, J.
double kineticLoss(std::span<const Struck> all)
{
    double loss = 0.0;
    for (const Struck &one : all)
        loss += 0.5 * one.mass * (lengthSquared(one.before) - lengthSquared(one.after));
    return loss;
}

/// Takes gravity's part of the step, \p fall (m/s), out of the hit. Whether the program adds that
/// before the hit or after it is not known, so that holds for which the hit takes or gives less.
void takeOutFall(std::span<Struck> all, Vec2 fall)
{
    std::vector<Struck> first(all.begin(), all.end());
    std::vector<Struck> last = first;
    for (std::size_t i = 0; i < all.size(); ++i) {
        first[i].before += fall;
        last[i].after -= fall;
    }
    const bool isFirst = std::abs(kineticLoss(first)) < std::abs(kineticLoss(last));
    const std::vector<Struck> &likely = isFirst ? first : last;
    std::copy(likely.begin(), likely.end(), all.begin());
}

std::optional<Hit> hitOfPair(std::span<const Circle> before, std::span<const Circle> after,
                             std::size_t a, std::size_t b, const std::vector<Change> &changes,
                             Vec2 fall)
{
    const Vec2 apart = before[b].position - before[a].position;
    const double gap = length(apart) - before[a].radius - before[b].radius;
    if (gap > changes[a].reach + changes[b].reach)
        return std::nullopt;
    const Vec2 n = normalized(apart);
    if (n == Vec2{})
        return std::nullopt;
    Hit hit{
        .kind = Hit::Kind::Circle, .a = static_cast<int>(a), .b = static_cast<int>(b), .normal = n};
    hit.impulse = mass(before[b]) * dot(changes[b].kick, n);
    if (hit.impulse == 0.0)
        hit.impulse = -mass(before[a]) * dot(changes[a].kick, n);
    std::array struck{Struck{mass(before[a]), before[a].velocity, after[a].velocity},
                      Struck{mass(before[b]), before[b].velocity, after[b].velocity}};
    takeOutFall(struck, fall);
    hit.beforeA = struck[0].before;
    hit.afterA = struck[0].after;
    hit.beforeB = struck[1].before;
    hit.afterB = struck[1].after;
    hit.loss = kineticLoss(struck);
    return hit;
}

std::optional<Hit> hitAtWall(const Preset &scene, const Circle &before, const Circle &after,
                             std::size_t i, Wall wall, const Change &change, Vec2 fall)
{
    const Vec2 n = outwardNormal(wall);
    const double gap = scene.halfWidth - before.radius - dot(before.position, n);
    const double push = dot(change.kick, n);
    if (gap > change.reach || push > -noise * (1.0 + length(before.velocity)))
        return std::nullopt;
    Hit hit{.kind = Hit::Kind::Wall,
            .a = static_cast<int>(i),
            .b = static_cast<int>(wall),
            .normal = n};
    hit.impulse = -mass(before) * push;
    std::array struck{Struck{mass(before), before.velocity, after.velocity}};
    takeOutFall(struck, fall);
    hit.beforeA = struck[0].before;
    hit.afterA = struck[0].after;
    hit.loss = kineticLoss(struck);
    return hit;
}

} // namespace

void inferHits(const Preset &scene, std::span<const Circle> before, std::span<const Circle> after,
               double dt, qint64 step, double time, std::vector<Hit> &hits)
{
    std::vector<Change> changes = changesOf(scene, before, after, dt);
    const Vec2 fall = dt * scene.gravity;
    const auto add = [&](Hit hit) {
        hit.step = step;
        hit.time = time;
        hits.push_back(hit);
    };
    // Two circles that meet the floor side by side have not met each other.
    for (std::size_t i = 0; i < before.size(); ++i) {
        Vec2 rest = changes[i].kick;
        for (const Wall wall : allWalls) {
            if (const auto hit = hitAtWall(scene, before[i], after[i], i, wall, changes[i], fall))
                rest -= dot(changes[i].kick, hit->normal) * hit->normal;
        }
        changes[i].byWalls =
            length(rest) <= noise * (1.0 + length(before[i].velocity)) && changes[i].kicked;
    }
    if (before.size() <= mostInPairs) {
        for (std::size_t a = 0; a < before.size(); ++a) {
            for (std::size_t b = a + 1; b < before.size(); ++b) {
                if (!changes[a].isOpen() && !changes[b].isOpen())
                    continue;
                if (const auto hit = hitOfPair(before, after, a, b, changes, fall)) {
                    add(*hit);
                    changes[a].explained = changes[b].explained = true;
                }
            }
        }
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!changes[i].kicked || (changes[i].explained && !changes[i].byWalls))
            continue;
        for (const Wall wall : allWalls) {
            if (const auto hit = hitAtWall(scene, before[i], after[i], i, wall, changes[i], fall))
                add(*hit);
        }
    }
}

} // namespace cradle
