// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/vector_binding.h"

namespace cradle {

struct CircleObject {
    ObjectKind kind = ObjectKind::Circle;
    int index = 0; ///< from 0
};

/// Makes the circles of the host and leaves the list of them on the stack.
void pushCircles(lua_State *L);

/// Pushes circle \p index as circles[i] does.
void pushCircle(lua_State *L, int index);

} // namespace cradle
