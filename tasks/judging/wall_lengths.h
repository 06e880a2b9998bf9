// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/measured_wall.h"

#include <QString>

#include <functional>
#include <vector>

namespace cradle {

/// A length that a program may take for the radius where it asks about walls.
struct WallLength {
    std::function<double(const WallHit &)> distance; ///< of the centre from the wall, m
    QString headline{}; ///< with %who for the circles and %walls for the walls
    QString body{};     ///< with %1 for the radius, %2 for the length, %3 for the circle
};

[[nodiscard]] std::vector<WallLength> wallLengths();

} // namespace cradle
