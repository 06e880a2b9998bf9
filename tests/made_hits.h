// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/measured_pair.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

/// Hits that no program made: what is read from them must be what was put in, to the bounds that
/// are promised.
namespace cradle::made {

inline constexpr Vec2 normal{0.6, 0.8};
inline constexpr Vec2 tangent{-0.8, 0.6};
/// With it circle 1 comes 1.2 m/s along the line of centres and 0.4 m/s across it, circle 2 −0.3
/// and 0.1 m/s: they come nearer by 1.5 m/s.
inline constexpr PairVelocities arrival{1.2, 0.4, -0.3, 0.1};

/// Circles of which both parts are known, before and after, along a line at so many degrees.
inline PairHit hitAlong(double degrees, const PairVelocities &in, const PairVelocities &left,
                        double e = 1.0)
{
    PairHit hit;
    const double angle = degrees * std::atan(1.0) / 45.0;
    const Vec2 n{std::cos(angle), std::sin(angle)};
    const Vec2 t = perpendicular(n);
    hit.meeting.restitution = e;
    hit.meeting.degrees = degrees;
    hit.meeting.velocities = in;
    hit.answered = true;
    hit.before = 0.41;
    hit.reached = 0.39;
    hit.normal = hit.nextNormal = n;
    hit.came1 = in.along1 * n + in.across1 * t;
    hit.came2 = in.along2 * n + in.across2 * t;
    hit.left1 = left.along1 * n + left.across1 * t;
    hit.left2 = left.along2 * n + left.across2 * t;
    return hit;
}

/// What circles that come so leave with.
inline PairHit hitThatLeaves(const PairVelocities &left, double e = 1.0)
{
    return hitAlong(std::atan2(normal.y, normal.x) * 45.0 / std::atan(1.0), arrival, left, e);
}

/// One of two masses by conserved momentum and Newton's law of restitution.
inline PairHit hitOfMasses(double mass1, double mass2, double e)
{
    const double impulse = (1.0 + e) * 1.5 * mass1 * mass2 / (mass1 + mass2);
    return hitThatLeaves({1.2 - impulse / mass1, 0.4, -0.3 + impulse / mass2, 0.1}, e);
}

/// One of circles of so many metres and 1000 kg/m³, with masses r^p ρ^s.
inline PairHit hitOfUnlike(Vec2 radii, Vec2 densities, double p, double s, double e = 1.0)
{
    PairHit hit = hitOfMasses(std::pow(radii.x, p) * std::pow(densities.x, s),
                              std::pow(radii.y, p) * std::pow(densities.y, s), e);
    hit.meeting.radius1 = radii.x;
    hit.meeting.radius2 = radii.y;
    hit.meeting.density1 = densities.x;
    hit.meeting.density2 = densities.y;
    return hit;
}

/// A pair of which nothing was measured.
inline MeasuredPair noHits()
{
    const Ground ground(Task{}, Preset{});
    const MeasuredFlight flight(nullptr, ground);
    MeasuredPair pair(nullptr, ground, flight);
    pair.isJudged = true;
    return pair;
}

/// A pair whose masses are r^p ρ^s: equal circles, and those of other radii and densities.
inline MeasuredPair pairOfPowers(double p, double s)
{
    MeasuredPair pair = noHits();
    pair.equals = {hitOfMasses(1.0, 1.0, 1.0)};
    for (const Vec2 radii : {Vec2{0.2, 0.35}, Vec2{0.35, 0.2}, Vec2{0.35, 0.35}})
        pair.radii.push_back(hitOfUnlike(radii, {7.8, 7.8}, p, s));
    for (const Vec2 densities : {Vec2{2.0, 7.0}, Vec2{7.0, 2.0}, Vec2{7.0, 7.0}})
        pair.densities.push_back(hitOfUnlike({0.2, 0.2}, densities, p, s));
    return pair;
}

/// The headlines of findings.
inline QStringList headlinesOf(const std::vector<LawDeviation> &found)
{
    QStringList all;
    for (const LawDeviation &each : found)
        all.append(each.message.section(QLatin1Char('\n'), 0, 0));
    return all;
}

} // namespace cradle::made
