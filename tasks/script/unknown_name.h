// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

#include <QString>

namespace cradle {

/// Tells a program that reads the global \p name, which was given no value: why it is not there,
/// what is called so elsewhere, or which name is near.
[[noreturn]] void refuseUnknown(lua_State *L, const QString &name);

/// Tells a program that gives a value to what is nearly a name of the lab's: "on_updat" is hardly a
/// name of its own.
void refuseSlip(lua_State *L, const QString &name);

} // namespace cradle
