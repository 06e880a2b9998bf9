// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

namespace cradle {

/// Pushes what programs know as `circles`: it can be indexed, counted and walked, not changed.
void pushCircleList(lua_State *L);

} // namespace cradle
