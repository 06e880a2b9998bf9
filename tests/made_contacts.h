// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/pair_words.h"

#include "tests/made_hits.h"

#include <QString>

#include <functional>
#include <numbers>

/// Meetings that no program had, and what is found of when they are answered.
namespace cradle::made {

/// That is answered in the fifth step, between 1 cm more and 1 cm less than that distance, m.
inline PairHit contactAt(double degrees, double radius1, double radius2, double distance)
{
    PairHit hit;
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vec2 n{std::cos(angle), std::sin(angle)};
    hit.meeting = {.degrees = degrees,
                   .radius1 = radius1,
                   .radius2 = radius2,
                   .velocities = {0.7, 0.0, -0.5, 0.0}};
    hit.answered = true;
    hit.before = hit.after = distance + 0.01;
    hit.reached = distance - 0.01;
    hit.normal = hit.nextNormal = n;
    hit.came1 = hit.left2 = 0.7 * n;
    hit.came2 = hit.left1 = -0.5 * n;
    hit.step = 5;
    hit.stage.preset.timestep = 1.0 / 60.0;
    hit.stage.preset.circles.resize(2);
    hit.stage.preset.circles[0].body.position = -0.5 * n;
    hit.stage.preset.circles[1].body.position = 0.5 * n;
    return hit;
}

/// Of radii of 0.2 and 0.35 m, at \p share of the right distance.
inline std::vector<PairHit> contactsAt(double share)
{
    std::vector<PairHit> all;
    for (const double degrees : {3.0, 88.0, 222.0})
        all.push_back(contactAt(degrees, 0.2, 0.2, share * 0.4));
    for (const double degrees : {33.0, 205.0})
        all.push_back(contactAt(degrees, 0.2, 0.35, share * 0.55));
    all.push_back(contactAt(111.0, 0.35, 0.2, share * 0.55));
    return all;
}

/// Two programs, of which the second is right, and a way to spoil the first.
struct BothPairs {
    MeasuredPair own;
    MeasuredPair right;
};
using Spoil = std::function<void(BothPairs &)>;

inline MeasuredPair rightPair()
{
    MeasuredPair pair = noHits();
    pair.contacts = contactsAt(1.0);
    pair.equals = {contactAt(33.0, 0.2, 0.2, 0.4)};
    pair.ownContacts = 2;
    return pair;
}

inline std::vector<LawDeviation> contactsFound(const Spoil &spoil, const Preset &scene = {})
{
    BothPairs pairs{rightPair(), rightPair()};
    spoil(pairs);
    return contactDeviations(pairs.own, pairs.right, Ground(Task{}, scene));
}

inline void forget(PairHit &hit)
{
    hit.answered = false;
    hit.left1 = hit.came1;
    hit.left2 = hit.came2;
}

inline void forgetAll(std::vector<PairHit> &hits)
{
    std::for_each(hits.begin(), hits.end(), forget);
}

inline PairHit unanswered(PairHit hit)
{
    forget(hit);
    return hit;
}

} // namespace cradle::made
