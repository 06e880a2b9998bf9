// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <numbers>

namespace cradle {

/// A disc that slides but never spins; a plain value.
struct Circle {
    Vec2 position{};      ///< centre, m
    Vec2 velocity{};      ///< m/s
    double radius = 0.2;  ///< m, > 0
    double density = 7.8; ///< 1000 kg/m³, > 0 (7.8 is steel)

    friend constexpr bool operator==(const Circle &, const Circle &) = default;
};

/// Mass (kg) of a sphere of this radius: m = 1000 ρ · 4/3 π r³, ρ in 1000 kg/m³.
constexpr double mass(const Circle &c)
{
    return 1000.0 * c.density * (4.0 / 3.0) * std::numbers::pi * c.radius * c.radius * c.radius;
}

/// ½ m v², J
constexpr double kineticEnergy(const Circle &c)
{
    return 0.5 * mass(c) * lengthSquared(c.velocity);
}

} // namespace cradle
