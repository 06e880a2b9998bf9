// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/measured_pair.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cradle {

namespace {

PairVelocities partsOf(Vec2 v1, Vec2 v2, Vec2 n)
{
    const Vec2 t = perpendicular(n);
    return {dot(v1, n), dot(v1, t), dot(v2, n), dot(v2, t)};
}

} // namespace

PairVelocities PairHit::cameParts() const
{
    return partsOf(came1, came2, normal);
}

PairVelocities PairHit::leftParts() const
{
    return partsOf(left1, left2, normal);
}

bool PairHit::isAligned() const
{
    const double angle = meeting.degrees * std::numbers::pi / 180.0;
    return length(normal - Vec2{std::cos(angle), std::sin(angle)}) < 0.002;
}

double PairHit::seenPart(double part, const std::vector<double> &known) const
{
    const double came = std::max(length(came1), length(came2));
    const double left = std::max(length(left1), length(left2));
    const double turned = length(nextNormal - normal);
    const double blur = 2e-3 * came + turned * std::max(left - came, 0.0);
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](double each) { return std::abs(part - each) < blur; });
    return found != known.end() ? *found : std::abs(part) < blur ? 0.0 : part;
}

double PairHit::rebound() const
{
    const Vec2 n = normalized(push2());
    return dot(left2 - left1, n) / dot(came1 - came2, n);
}

bool LaterHit::isOfHistory() const
{
    return anew.isMet() && std::abs(second.rebound() - anew.rebound()) > 0.03;
}

bool LaterHit::isFirstOdd() const
{
    const double e = first.meeting.restitution;
    return std::abs(first.rebound() - e) > 0.03 && std::abs(second.rebound() - e) < 0.01;
}

bool PairHit::isInTime() const
{
    return isMet() && meeting.sum() <= before + (before - reached) + 1e-9;
}

bool PairHit::isAlongCentres() const
{
    const auto across = [&](Vec2 n) {
        const Vec2 t = perpendicular(n);
        return std::abs(dot(push1(), t)) + std::abs(dot(push2(), t));
    };
    return std::min(across(normal), across(nextNormal))
           < 0.02 * (length(push1()) + length(push2()));
}

bool PairHit::isPutFar() const
{
    const double way = length(left2 - left1) * slowness * stage.preset.timestep;
    return answered && after - std::max(before, meeting.sum()) > 2.0 * (way + before - reached);
}

bool PairHit::isPutTogether() const
{
    const double way = length(left2 - left1) * slowness * stage.preset.timestep;
    const double near = std::min(before, reached);
    return answered && after < std::min(0.99 * meeting.sum(), 0.5 * near)
           && reached > 0.5 * meeting.sum() && near - after > 2.0 * (way + before - reached);
}

bool PairHit::fits(double distance) const
{
    // Who answers at once may have done so long before.
    return reached - 1e-9 <= distance
           && (isAtOnce || distance <= before + (before - reached) + 1e-9);
}

} // namespace cradle
