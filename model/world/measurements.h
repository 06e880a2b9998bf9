// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/world.h"

#include <span>

namespace cradle {

/// What is measured of one circle, or of all together.
struct Totals {
    Vec2 momentum{};        ///< Σ m v, kg m/s
    double kinetic = 0.0;   ///< Σ ½ m v², J
    double potential = 0.0; ///< Σ −m g·(position − (0, −half width)), J: zero at the floor

    [[nodiscard]] double total() const { return kinetic + potential; } ///< J
    Totals &operator+=(const Totals &other);
    friend bool operator==(const Totals &, const Totals &) = default;
};

/// Momentum and energies of one circle. \param gravity in m/s² \param halfWidth in m
[[nodiscard]] Totals measure(const Circle &circle, Vec2 gravity, double halfWidth);

/// The sum over all circles.
[[nodiscard]] Totals measure(std::span<const Circle> circles, Vec2 gravity, double halfWidth);

/// Σ m x / Σ m, m; the origin without any circles.
[[nodiscard]] Vec2 centreOfMass(std::span<const Circle> circles);

/// How far a run is from another run of the same circles, above all from the exact one.
struct Deviation {
    double greatest = 0.0;       ///< max |x_i − y_i|, m
    double rootMeanSquare = 0.0; ///< √(1/N Σ |x_i − y_i|²), m
    double energy = 0.0;         ///< total energy of the run minus that of the other, J

    friend bool operator==(const Deviation &, const Deviation &) = default;
};

/// The deviation of \p run from \p exact; both have the same number of circles, and without any it
/// is zero. Explicit Euler falls behind the exact parabola by ½ g h t and gains ½ m g² h² a step,
/// symplectic Euler is as far ahead of it and loses as much.
/// \param gravity in m/s² \param halfWidth in m
[[nodiscard]] Deviation deviation(std::span<const Circle> run, std::span<const Circle> exact,
                                  Vec2 gravity, double halfWidth);

/// The greatest distance (m) of a circle from the one of the same number in \p other; 0 without
/// any.
[[nodiscard]] double greatestDistance(std::span<const Circle> circles,
                                      std::span<const Circle> other);

} // namespace cradle
