// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

#include <QByteArray>

namespace cradle {

/// Reads \p text (UTF-8, never bytecode) as a program of that name and leaves it on the stack as a
/// function, or the error. A verdict reads the same program some hundred times, so what was
/// compiled is kept in this process and loaded again. For any thread.
/// \return a status of Lua
[[nodiscard]] int loadProgram(lua_State *L, const QByteArray &text, const char *name);

/// The same of a text that is read once; nothing is kept, which takes half the time.
[[nodiscard]] int readProgram(lua_State *L, const QByteArray &text, const char *name);

} // namespace cradle
