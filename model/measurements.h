// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world.h"

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

} // namespace cradle
