// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

namespace cradle {

/// Where the table of all circle objects lies in the registry.
inline constexpr lua_Integer circleTableKey = 103;

/// Pushes what programs know as `circles`: it can be indexed, counted and walked, not changed.
void pushCircleList(lua_State *L);

} // namespace cradle
