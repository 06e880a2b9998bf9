// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/lua_state.h"

namespace cradle {

/// Adds what lets a program show things: print, plot, draw.arrow, draw.line, draw.point and
/// draw.text. All count towards the output of a step.
void addShowing(lua_State *L);

} // namespace cradle
