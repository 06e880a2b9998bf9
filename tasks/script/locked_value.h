// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

struct lua_State;

namespace cradle {

/// Raises an error at the line of the program that would change a value which the step fixes.
/// \param field  as in tasks/script/locks.h: "gravity", "circles/1/velocity"
void refuseIfLocked(lua_State *L, const QString &field);

/// The same for a field of circle \p circle, counted from 0; radius and density are fixed by
/// "mass", too.
void refuseIfLocked(lua_State *L, int circle, const char *field);

} // namespace cradle
