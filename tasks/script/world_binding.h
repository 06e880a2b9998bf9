// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/circle_field.h"
#include "tasks/script/lua_state.h"

#include <vector>

namespace cradle {

/// Adds circle1, circle2 …, circles, square, and the globals that stand for values of the world:
/// gravity, restitution, time, step. From then on an unknown global is an error.
void addWorld(lua_State *L);

/// The fields that the program has added to the circles, those that are numbers, in order.
[[nodiscard]] std::vector<CircleField> ownFields(lua_State *L);

/// The index of the circle at a place of the stack, from 0; -1 if something else is there.
[[nodiscard]] int circleAt(lua_State *L, int index);

} // namespace cradle
