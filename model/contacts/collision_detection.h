// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/circle.h"

#include <optional>

namespace cradle {

/// Motion inside a step (docs/physics.md, 2 and 4): x(s) = position + velocity s + curve s², s in
/// seconds from now. \c curve is ½ a for a parabola, 0 for the straight line of Euler, a for
/// symplectic Euler.
struct Path {
    Vec2 position{}; ///< m
    Vec2 velocity{}; ///< m/s
    Vec2 curve{};    ///< m/s²

    [[nodiscard]] constexpr Vec2 at(double s) const
    {
        return position + s * velocity + (s * s) * curve;
    }
};

/// Whether two circles reach into each other; touching is not overlapping.
[[nodiscard]] bool overlap(const Circle &a, const Circle &b);

/// The first s in [0, end] at which a point that starts \p gap (m) before a line, moves towards
/// it at \p speed (m/s) and curves towards it by \p curve (m/s²) crosses it outwards:
///     gap = speed s + curve s²
/// A point on or beyond the line (gap ≤ 0) crosses at once if it goes on outwards.
[[nodiscard]] std::optional<double> timeToLine(double gap, double speed, double curve, double end);

/// The first s in [0, end] at which two centres come as near as \p distance (m) while they
/// approach: |x_b(s) − x_a(s)| = distance. A quadratic if both curve alike, else a quartic.
/// Centres already that near meet at once if they approach.
[[nodiscard]] std::optional<double> timeToDistance(const Path &a, const Path &b, double distance,
                                                   double end);

} // namespace cradle
