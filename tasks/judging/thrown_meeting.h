// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/meeting_division.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>
#include <numbers>

namespace cradle {

struct DivisionText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// A meeting as a program sees it.
struct ThrownMeeting {
    ThrownMeeting(const PairHit &hit, bool right)
        : meeting(hit.meeting)
        , normal(directionOf(hit.meeting.degrees))
        , v1(worldOf(hit.meeting.velocities.along1, hit.meeting.velocities.across1))
        , v2(worldOf(hit.meeting.velocities.along2, hit.meeting.velocities.across2))
        , slowness(hit.slowness)
        , isRight(right)
    {
    }

    [[nodiscard]] Vec2 relative() const { return v1 - v2; }
    /// A part of \p v, in x or y; not a number where rounding alone would tell its sign.
    [[nodiscard]] static double partOf(Vec2 v, double Vec2::*part)
    {
        return v != Vec2{} && std::abs(v.*part) < 1e-9 * length(v)
                   ? std::numeric_limits<double>::quiet_NaN()
                   : v.*part;
    }
    /// How fast circle 1, seen from circle 2, moves away from the origin; not a number where that
    /// is not so from both places alike.
    [[nodiscard]] double outward() const
    {
        const Vec2 half = 0.5 * meeting.sum() * normal;
        const double from1 = dot(relative(), meeting.middle - half);
        const double from2 = dot(relative(), meeting.middle + half);
        return from1 * from2 > 0.0 ? from1 : std::numeric_limits<double>::quiet_NaN();
    }
    [[nodiscard]] static double massOf(double radius, double density)
    {
        return density * radius * radius * radius;
    }

    Meeting meeting;
    Vec2 normal;
    Vec2 v1;
    Vec2 v2;
    double slowness;
    bool isRight;

private:
    static Vec2 directionOf(double degrees)
    {
        const double angle = degrees * std::numbers::pi / 180.0;
        return {std::cos(angle), std::sin(angle)};
    }
    [[nodiscard]] Vec2 worldOf(double along, double across) const
    {
        return along * normal + across * perpendicular(normal);
    }
};

/// All divisions of \p meetings by the sign of a quantity that tell those that come out right from
/// the others.
[[nodiscard]] std::vector<MeetingDivision>
divisionsBySign(const std::vector<ThrownMeeting> &meetings);

/// A speed or a place from which on they come out right, or wrong; nothing if several may be meant.
[[nodiscard]] std::optional<MeetingDivision>
divisionByLimit(const std::vector<ThrownMeeting> &meetings);

} // namespace cradle
