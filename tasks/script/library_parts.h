// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <lua.hpp>

#include <initializer_list>

namespace cradle {

/// Tells a program that reads a member which the table on the top of the stack does not have.
/// Lua's own library lies below it.
void explainMembers(lua_State *L, const char *library);

/// Moves the named functions of the library table on the top of the stack into a new table there,
/// each behind the function that is given, as its upvalue, or as it is where none is.
void keepOnly(lua_State *L, const char *library, std::initializer_list<luaL_Reg> functions);

void addBase(lua_State *L);        ///< ipairs, pcall, tonumber and the other globals
void addTextMethods(lua_State *L); ///< what texts can do without `string`: ("x"):upper(), "1" + 1

void pushTexts(lua_State *L);  ///< `string`, and the methods of texts
void pushTables(lua_State *L); ///< `table`

} // namespace cradle
