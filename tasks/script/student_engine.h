// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/script_host.h"
#include "tasks/script/script_limits.h"
#include "tasks/script/student_script.h"

namespace cradle {

/// A program at work: its Lua state and what that works on.
struct StudentScript::Engine {
    ScriptHost host{limits::scriptBytes};
    lua_State *state = nullptr;  ///< ends with the host's memory
    lua_State *thread = nullptr; ///< of an update that runs line by line
    bool linesDone = false;      ///< that update has come to its end; advance() takes it over
};

/// Pushes a name that a program leaves to us, without the error of an unknown global.
/// \return the type of what is pushed
int rawGlobal(lua_State *L, const char *name);

} // namespace cradle
