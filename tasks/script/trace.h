// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/assignment.h"

#include <lua.hpp>

#include <set>

namespace cradle {

/// What is written down of one update, or of the start.
struct Trace {
    std::vector<Assignment> assignments{}; ///< in order; of very many the last
    std::set<int> lines{};                 ///< of the program, that ran
};

/// Writes down an assignment that the program makes at its current line, if it is traced.
void noteAssignment(lua_State *L, int circle, Assignment::Field field, bool changed);

} // namespace cradle
