// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile.h"

#include <algorithm>
#include <limits>

namespace cradle {

namespace {

/// Of the smallest radius: what is left between two that touch, so that the error of a push makes
/// them no overlap,
constexpr double apartness = 1e-3;
/// and an overlap that may be.
constexpr double bearable = 5e-5;
/// The error of a push in the end, in a step: so much of it for the square of the number of
/// circles, for few of them cost little however exact, and no more than an overlap that may be.
constexpr double exactness = 5e-10;

} // namespace

Pile::Pile(const Rules &ruled, std::span<const Circle> unsorted,
           std::span<const std::uint32_t> names, double step)
    : rules(ruled)
    , dt(step)
    , gain(length(ruled.gravity) * step)
{
    const double g = length(rules.gravity);
    up = g > 0.0 ? rules.gravity / -g : Vec2{0.0, 1.0};
    grid.build(unsorted.size(), [&](std::size_t i) { return upright(unsorted[i].position); });
    const std::span<const std::uint32_t> sorted = grid.sorted();
    order.assign(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(unsorted.size()));
    ids.reserve(unsorted.size());
    circles.reserve(unsorted.size());
    inverseMasses.reserve(unsorted.size() + std::size(allWalls));
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : order) {
        ids.push_back(names[i]);
        circles.push_back(unsorted[i]);
        inverseMasses.push_back(1.0 / mass(unsorted[i]));
        least = std::min(least, unsorted[i].radius);
    }
    inverseMasses.resize(unsorted.size() + std::size(allWalls), 0.0);
    apart = apartness * least;
    borne = bearable * least;
    const auto whole = static_cast<double>(unsorted.size());
    tolerance = std::min(exactness * whole * whole, bearable) * least / dt;
}

double Pile::gapBetween(Body a, Body b, std::span<const Vec2> places) const
{
    const double radius = circles[a].radius;
    if (isWall(b))
        return rules.halfWidth - radius - dot(places[a], outwards(b));
    return quickLength(places[b] - places[a]) - radius - circles[b].radius;
}

void Pile::setFree(PileBodies &bodies) const
{
    bodies.velocities.assign(inverseMasses.size(), Vec2{});
    for (Body i = 0; i < count(); ++i)
        bodies.velocities[i] = circles[i].velocity + dt * rules.gravity;
}

} // namespace cradle
