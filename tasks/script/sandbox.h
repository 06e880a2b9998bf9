// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

namespace cradle {

/// Adds the part of Lua's libraries that a program may use, and nothing else: no files, no
/// processes, no loading of code, no metatables, no coroutines, no string patterns. Random numbers
/// begin alike in every run. Its pcall lets no limit pass.
void addLibraries(lua_State *L);

/// From now on instructions and time are counted and limited; \p lines also yields at every new
/// line where that is possible.
void watch(lua_State *L, bool lines);

/// Begins a new count for a step.
void beginCount(lua_State *L);

/// A message handler for lua_pcall: keeps line and locals of the error in ScriptHost::caught.
int catchError(lua_State *L);

/// The same for the error of a thread that stopped, on the top of its stack.
void noteError(lua_State *L);

} // namespace cradle
