// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

#include <QtGlobal>

namespace cradle {

/// pcall for programs: as Lua's own, but it lets no limit pass.
int protectedCall(lua_State *L);

/// From now on instructions are counted and limited, and time where a step is timed, unless that
/// was left out; \p lines also counts, and
/// yields at every new line where that is possible, with line and locals in ScriptHost::caught.
void watch(lua_State *L, bool lines);

/// Leaves out the count of a program that takes few instructions, until it makes a long text or
/// large tables: what is done to these counts.
void leaveCountOut(lua_State *L);

/// Counts from here on, if the count was left out. It may be called in the midst of anything, as a
/// signal would.
void countFromHere(lua_State *L);

/// Begins a new count for a step that runs in \p L, in this thread until endCount().
void beginCount(lua_State *L);
/// That step has come to an end or pauses.
void endCount(lua_State *L);

/// Counts work that a library function does as so many instructions; past the limit the run stops.
void charge(lua_State *L, qint64 instructions);

/// What an instruction counts that may copy or compare the longest text that there is.
[[nodiscard]] qint64 instructionsPerText(lua_State *L);

/// A message handler for lua_pcall: keeps line and locals of the error in ScriptHost::caught.
int catchError(lua_State *L);

/// The same for the error of a thread that stopped, on the top of its stack.
void noteError(lua_State *L);

} // namespace cradle
