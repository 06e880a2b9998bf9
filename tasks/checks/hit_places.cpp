// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/hit_places.h"

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

/// Each of the two may move by the whole overlap, and some programs leave both as far apart again.
constexpr double mostOverlaps = 2.0;
/// A gap that some leave between the rims so that they do not touch by rounding, m.
constexpr double smallGap = 0.01;

/// The ends of what velocities explain along a direction, m.
struct Span {
    double low = 0.0;
    double high = 0.0;

    Span(const HitPlace &place, Vec2 along)
    {
        const double free = dot(place.free, along);
        const double back = place.isLate ? -free : 0.0;
        const double bounced = dot(place.bounced, along);
        low = std::min({0.0, free, back}) + std::min(0.0, bounced);
        high = std::max({0.0, free, back}) + std::max(0.0, bounced);
    }
};

} // namespace

std::optional<Misplacement> misplacementOf(const HitPlace &place, double slack)
{
    using Where = Misplacement::Where;
    const double along = dot(place.made, place.apart);
    const Span own(place, place.apart);
    // Who moves them apart does so where they came in the step, or overlapped before it.
    const double pushed = place.isLate ? own.high
                                       : dot(place.free, place.apart)
                                             + std::max(0.0, dot(place.bounced, place.apart));
    const double away = along - std::max(own.high, pushed + mostOverlaps * place.overlap);
    const Vec2 aside = perpendicular(place.apart);
    const double side = dot(place.made, aside);
    const Span across(place, aside);
    const double beside = std::max(side - across.high, across.low - side);
    // A push apart points along the line of centres of any moment of the step.
    const double askew = place.turn * std::max(0.0, along - own.low);
    const std::pair<Misplacement, bool> all[] = {
        {{Where::Into, own.low - along}, own.low - along > slack},
        {{Where::Away, away}, away > smallGap + slack},
        {{Where::Aside, beside}, beside > askew + slack}};
    std::optional<Misplacement> worst;
    for (const auto &[found, isWrong] : all) {
        if (isWrong && (!worst || found.by > worst->by))
            worst = found;
    }
    return worst;
}

} // namespace cradle
