// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"
#include "tasks/script/lua_state.h"

namespace cradle {

/// Reads \p source as a program and leaves it on the stack as a function, or the error.
/// \param once  it will not be read again; see readProgram()
/// \return a status of Lua; LUA_ERRSYNTAX for all that is wrong with the text
[[nodiscard]] int parse(lua_State *L, const QString &source, bool once = false);

/// What is wrong with a program that is longer than it may be.
[[nodiscard]] std::optional<ProgramError> tooLong(const QString &source);

[[nodiscard]] ProgramError noMemory();

/// What is wrong with a program that Lua accepts and that cannot be meant so: on_load or on_update
/// is local, so that nobody can call it; a number is written with a comma, restitution = 0,5.
[[nodiscard]] std::optional<ProgramError> meantOtherwise(const QString &source);

} // namespace cradle
