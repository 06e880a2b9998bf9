// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

#include <QString>

namespace cradle {

// What people mean who come from another language, where Lua reads it and then stumbles.

/// What is meant at \p line of \p source, where the program failed with Lua's own \p message; as an
/// end of a message, empty if we do not know.
[[nodiscard]] QString meantAtRunTime(lua_State *L, const QString &message, int line,
                                     const QString &source);

/// What to write for a name that is not known, such as null, new or Math; empty if it is none of
/// these.
[[nodiscard]] QString meantByName(lua_State *L, const QString &name);

/// Why a name that is local somewhere is not known at the line that runs: it stands below, or in
/// another block; empty if it is local nowhere.
/// \param visible  receives the local names that are known there
[[nodiscard]] QString meantByLocals(lua_State *L, const QString &name, QStringList &visible);

} // namespace cradle
