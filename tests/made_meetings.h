// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/meeting_division.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

/// Meetings of all kinds, and what can be asked of them.
namespace cradle::made {

inline Vec2 lineOf(const PairHit &hit)
{
    const double angle = hit.meeting.degrees * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle)};
}

inline Vec2 velocityOf(const PairHit &hit, int circle)
{
    const PairVelocities &v = hit.meeting.velocities;
    const Vec2 n = lineOf(hit);
    return circle == 1 ? v.along1 * n + v.across1 * perpendicular(n)
                       : v.along2 * n + v.across2 * perpendicular(n);
}

inline double massOf(double radius, double density)
{
    return density * std::pow(radius, 3);
}

/// 300 of them: everywhere, from all sides, each circle at rest now and then, of few sizes.
inline std::vector<PairHit> manyMeetings()
{
    std::minstd_rand random(7);
    const auto among = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 100000) / 1e5;
    };
    std::vector<PairHit> all;
    while (all.size() < 300) {
        PairHit hit;
        Meeting &m = hit.meeting;
        m.degrees = among(1.0, 359.0);
        m.radius1 = 0.1 + 0.1 * static_cast<double>(random() % 3);
        m.radius2 = 0.1 + 0.1 * static_cast<double>(random() % 3);
        m.density1 = 1.0 + static_cast<double>(random() % 3);
        m.density2 = 1.0 + static_cast<double>(random() % 3);
        m.restitution = random() % 2 == 0 ? 1.0 : 0.5;
        m.middle = {among(-3.0, 3.0), among(-3.0, 3.0)};
        m.velocities = {among(-1.0, 2.0), among(-1.0, 1.0), among(-2.0, 1.0), among(-1.0, 1.0)};
        const auto rest = random() % 8;
        if (rest == 0)
            m.velocities.along1 = m.velocities.across1 = 0.0;
        if (rest == 1)
            m.velocities.along2 = m.velocities.across2 = 0.0;
        if (m.closing() > 0.1)
            all.push_back(hit);
    }
    return all;
}

/// Which of them come out right.
using MeetingRule = std::function<bool(const PairHit &)>;

inline std::optional<MeetingDivision> divisionBy(const std::vector<PairHit> &hits,
                                                 const MeetingRule &rule)
{
    std::vector<JudgedMeeting> all;
    for (const PairHit &hit : hits)
        all.push_back({&hit, rule(hit)});
    return cradle::divisionBy(all);
}

/// How fast circle 1, seen from circle 2, moves away from the origin: from its place (−1) or from
/// that of circle 2 (1).
inline double outwardFrom(const PairHit &hit, double side)
{
    return dot(velocityOf(hit, 1) - velocityOf(hit, 2),
               hit.meeting.middle + side * 0.5 * hit.meeting.sum() * lineOf(hit));
}

} // namespace cradle::made
