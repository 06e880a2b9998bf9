// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"
#include "tasks/script/lua_state.h"

#include <QtGlobal>

namespace cradle {

// Tables with a fixed set of fields, for programs to read. All work on the table on the top of the
// stack.

void setNumber(lua_State *L, const char *name, double value);
void setWhole(lua_State *L, const char *name, qint64 value);
void setVector(lua_State *L, const char *name, Vec2 value);

/// From now on reading a field that it does not have is an error that names those it has.
void makeStrict(lua_State *L);

} // namespace cradle
