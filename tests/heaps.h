// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CRADLE_TESTS_HEAPS_H
#define CRADLE_TESTS_HEAPS_H

#include "tests/scenes.h"

#include <algorithm>

/// Heaps of many circles, and what a heap must not do.
namespace cradle::scenes {

/// \p count circles of radius \p radius in rows on the floor, \p apart (m) from each other.
inline Preset rows(int count, int columns, double radius, double apart)
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {0, -g};
    preset.restitution = 0.5;
    const double pitch = 2.0 * radius + apart;
    for (int i = 0; i < count; ++i) {
        // Every second row half a place aside: they lie in the gaps.
        const int row = i / columns;
        const double x = -halfWidth + radius + pitch * (i % columns) + (row % 2) * 0.5 * pitch;
        const double y = -halfWidth + radius + row * (std::sqrt(0.75) * pitch + apart);
        preset.circles.push_back(circle({x, y}, {}, radius));
    }
    return preset;
}

/// The deepest overlap of two circles, or of one with a wall of a square of half width \p wall (m),
/// as a share of the smaller radius.
inline double deepestOverlap(const std::vector<Circle> &circles, double wall = halfWidth)
{
    double deepest = 0.0;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        const Circle &a = circles[i];
        const double out = std::max(std::abs(a.position.x), std::abs(a.position.y)) + a.radius;
        deepest = std::max(deepest, (out - wall) / a.radius);
        for (std::size_t j = 0; j < i; ++j) {
            const double sum = a.radius + circles[j].radius;
            if (std::abs(circles[j].position.x - a.position.x) < sum)
                deepest = std::max(deepest, (sum - length(circles[j].position - a.position))
                                                / std::min(a.radius, circles[j].radius));
        }
    }
    return deepest;
}

} // namespace cradle::scenes

#endif
