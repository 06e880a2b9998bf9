// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/vector_binding.h"

namespace cradle {

/// The user value of a circle in Lua that is a table of the program's own fields.
constexpr int ownFieldsOfCircle = 1;

/// "circle1", for messages; \p circle counts from 0.
[[nodiscard]] QString circleName(int circle);

/// Pushes the own field named \p key of the circle that is the first argument, or raises an error
/// that names the nearest.
int pushOwnField(lua_State *L, int circle, const char *key);

/// Sets it to the third argument. A new one that is an engine's but for a slip raises an error:
/// "velocty" does, "velocity2" and "old_position" do not.
void setOwnField(lua_State *L, int circle, const char *key);

} // namespace cradle
