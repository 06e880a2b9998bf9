// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

namespace cradle {

/// Adds the part of Lua's libraries that a program may use, and nothing else: no files, no
/// processes, no loading of code, no metatables, no coroutines, no string patterns. Random numbers
/// begin alike in every run.
void addLibraries(lua_State *L);

/// The same, but math, string and table are only made when the program asks for them: most never
/// do, and making them takes longer than a step.
void addLibrariesLate(lua_State *L);

/// Makes the library of that name, if it is one that was not asked for yet, and puts it into its
/// global. \return whether it is there now
bool openLibrary(lua_State *L, const char *name);

/// Whether that is a library that was not asked for yet; from now on it counts as such: the program
/// gives its name to something else.
bool replaceLibrary(lua_State *L, const char *name);

/// Makes those that were not asked for yet: for who lists all names.
void openLibraries(lua_State *L);

} // namespace cradle
