// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

namespace cradle {

/// Adds the part of Lua's libraries that a program may use, and nothing else: no files, no
/// processes, no loading of code, no metatables, no coroutines, no string patterns. Random numbers
/// begin alike in every run.
void addLibraries(lua_State *L);

} // namespace cradle
