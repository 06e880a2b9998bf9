// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/gas.h"

#include "model/world/world.h"

#include <algorithm>
#include <limits>

namespace cradle {

namespace {

Gas strewn(int count, double areaFraction, double rmsSpeed)
{
    Gas preset;
    preset.halfWidth =
        0.5 * std::sqrt(count * std::numbers::pi * gasRadius * gasRadius / areaFraction);
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact};
    preset.fill = CircleFill{
        .count = count, .radius = gasRadius, .rmsSpeed = rmsSpeed, .density = 1.0, .seed = 1};
    preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    preset.bodies = initialWorld(preset).circles;
    return preset;
}

} // namespace

Gas gas(int count, double gravity)
{
    Gas preset = strewn(count, gasAreaFraction, gasRmsSpeed);
    preset.gravity = Vec2{0.0, -gravity};
    preset.restitution = 1.0;
    return preset;
}

Gas heap(int count)
{
    Gas preset = strewn(count, heapAreaFraction, heapRmsSpeed);
    preset.gravity = Vec2{0.0, -9.81};
    preset.restitution = 0.5;
    return preset;
}

double specificEnergy(const Preset &gas, const std::vector<Motion> &motions)
{
    // Compensated (Kahan): the sum must be truer than the drift that it shows.
    double sum = 0.0;
    double lost = 0.0;
    for (const Motion &motion : motions) {
        const double height = motion.position.y + gas.halfWidth;
        const double term = 0.5 * lengthSquared(motion.velocity) - gas.gravity.y * height - lost;
        const double next = sum + term;
        lost = (next - sum) - term;
        sum = next;
    }
    return sum;
}

double worstOverlap(const Preset &gas, const std::vector<Motion> &motions)
{
    // A grid of cells one diameter wide, each a chain of circles; what is outside the square
    // counts to the cells at its edge.
    const double diameter = 2.0 * gasRadius;
    const auto columns = std::max(1, static_cast<int>(2.0 * gas.halfWidth / diameter));
    const auto cellOf = [&](double x) {
        const double cell = (x + gas.halfWidth) / (2.0 * gas.halfWidth) * columns;
        return static_cast<int>(std::clamp(cell, 0.0, columns - 1.0));
    };
    std::vector<int> heads(static_cast<std::size_t>(columns) * static_cast<std::size_t>(columns),
                           -1);
    std::vector<int> next(motions.size(), -1);
    double nearest = diameter * diameter; // squared distance of centres
    double outside = 0.0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const Vec2 p = motions[i].position;
        if (!isFinite(p) || !isFinite(motions[i].velocity))
            return std::numeric_limits<double>::infinity();
        outside = std::max({outside, std::abs(p.x) + gasRadius - gas.halfWidth,
                            std::abs(p.y) + gasRadius - gas.halfWidth});
        const int cx = cellOf(p.x);
        const int cy = cellOf(p.y);
        for (int y = std::max(cy - 1, 0); y <= std::min(cy + 1, columns - 1); ++y) {
            for (int x = std::max(cx - 1, 0); x <= std::min(cx + 1, columns - 1); ++x) {
                for (int j = heads[static_cast<std::size_t>(y * columns + x)]; j >= 0;
                     j = next[static_cast<std::size_t>(j)]) {
                    const Vec2 apart = p - motions[static_cast<std::size_t>(j)].position;
                    nearest = std::min(nearest, lengthSquared(apart));
                }
            }
        }
        int &head = heads[static_cast<std::size_t>(cy * columns + cx)];
        next[i] = head;
        head = static_cast<int>(i);
    }
    return std::max(diameter - std::sqrt(nearest), outside) / gasRadius;
}

} // namespace cradle
