// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/flight_reading.h"

#include "model/world/world.h"

#include <optional>

namespace cradle {

/// What a program asks for a wall comes true far from it: circles that fly straight to the wall are
/// turned round there, and those that fly the other way go on.
struct StrayWall {
    Wall wall = Wall::Left;
    /// How far from the middle, towards the wall, the centre comes in a step where that begins, m;
    /// nothing where it is so at all places tried.
    std::optional<double> from{};
    /// Whether only the start is turned so: once the opposite wall has turned a circle towards this
    /// one, it goes on.
    bool isOfStart = false;
    Circle before{}; ///< one that was turned
    Motion after{};  ///< and what it was one step later
    Motion wanted{}; ///< and should have been
    Stage stage{};   ///< in which it was
};

/// The first of the walls of \p ground of which that is so for circle \p i.
/// \param right  how it should fly, under \p gravity with the timestep \p h
[[nodiscard]] std::optional<StrayWall> measureStrayWall(const QString *program,
                                                        const Ground &ground, const Flight &right,
                                                        Vec2 gravity, double h, int i);

} // namespace cradle
