// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <algorithm>

namespace cradle {

/// Two measured numbers that are the same but for what a step and rounding blur; relative.
inline constexpr double alike = 1e-5;

[[nodiscard]] inline bool isAlike(double a, double b, double tolerance = alike)
{
    return (std::isnan(a) && std::isnan(b))
           || std::abs(a - b) <= tolerance * (1.0 + std::max(std::abs(a), std::abs(b)));
}
[[nodiscard]] inline bool isAlike(Vec2 a, Vec2 b, double tolerance = alike)
{
    return isAlike(a.x, b.x, tolerance) && isAlike(a.y, b.y, tolerance);
}

} // namespace cradle
