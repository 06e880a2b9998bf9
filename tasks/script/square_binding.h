// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <lua.hpp>

namespace cradle {

/// Adds \c square, whose sides a program can read: half_width, left, right, bottom, top, in m.
void addSquare(lua_State *L);

} // namespace cradle
