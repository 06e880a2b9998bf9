// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

namespace cradle {

/// pairs for programs. Lua's own goes through a table in an order that differs from run to run;
/// this one takes whole numbers, other numbers, texts, false and true, circles and vectors, each in
/// ascending order. Of what has no order, such as a table, it takes one. Fields that are set to nil
/// on the way are left out, new ones do not come up.
int orderedPairs(lua_State *L);

} // namespace cradle
