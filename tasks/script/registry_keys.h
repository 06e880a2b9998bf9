// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <lua.hpp>

namespace cradle::registry {

/// Where what is ours lies in Lua's registry: one beside the other, so that Lua keeps it in an
/// array, where it is found without a search. In the order in which they are set.
enum Key : lua_Integer {
    vectorMetatable = LUA_RIDX_LAST + 1,
    circleMetatable,
    circleTable,     ///< all circle objects
    givenNames,      ///< the lab's own, behind the globals
    strictMetatable, ///< of all tables that have a fixed set of fields
    updateThread     ///< an update that runs line by line
};

} // namespace cradle::registry
