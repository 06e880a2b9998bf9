// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"
#include "tasks/script/lua_state.h"

namespace cradle {

/// What the error on the top of the stack says, in the words of the lab where we know it, with the
/// line and kind that it tells; line 0 if it tells none. In \p source, the program, is looked for
/// what is meant.
[[nodiscard]] ProgramError errorAtTop(lua_State *L, int status, const QString &source);

} // namespace cradle
