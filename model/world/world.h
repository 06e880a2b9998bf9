// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

#include <vector>

namespace cradle {

/// The state of a run at one moment; a plain value. Bodies are known by index.
struct World {
    double time = 0.0; ///< s since the start
    qint64 step = 0;   ///< steps since the start
    std::vector<Circle> circles{};

    friend bool operator==(const World &, const World &) = default;
};

/// The sides of the square.
enum class Wall { Left, Right, Bottom, Top };

/// The unit vector from the inside of the square to \p wall.
[[nodiscard]] constexpr Vec2 outwardNormal(Wall wall)
{
    switch (wall) {
    case Wall::Left:
        return {-1.0, 0.0};
    case Wall::Right:
        return {1.0, 0.0};
    case Wall::Bottom:
        return {0.0, -1.0};
    case Wall::Top:
        break;
    }
    return {0.0, 1.0};
}

inline constexpr Wall allWalls[] = {Wall::Left, Wall::Right, Wall::Bottom, Wall::Top};

/// A collision that has happened.
struct Hit {
    enum class Kind { Circle, Wall };

    double time = 0.0; ///< s
    qint64 step = 0;   ///< the step at whose end it shows
    Kind kind = Kind::Circle;
    int a = 0;            ///< index of the circle
    int b = 0;            ///< index of the other circle, or the Wall as an int
    Vec2 normal{};        ///< unit vector from a to b
    double impulse = 0.0; ///< along the normal, on b, N s; −impulse on a
    Vec2 beforeA{};       ///< velocity of a before, m/s
    Vec2 afterA{};        ///< and after
    Vec2 beforeB{};       ///< velocity of b before, m/s; zero for a wall
    Vec2 afterB{};        ///< and after
    double loss = 0.0;    ///< kinetic energy that it took, J; negative if it gave

    friend bool operator==(const Hit &, const Hit &) = default;
};

/// The world that a run of \p preset starts from.
[[nodiscard]] World initialWorld(const Preset &preset);

} // namespace cradle
