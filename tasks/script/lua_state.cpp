// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/lua_state.h"

#include <cstdlib>

namespace cradle {

void *LuaMemory::allocate(void *memory, void *block, std::size_t oldSize, std::size_t newSize)
{
    auto &self = *static_cast<LuaMemory *>(memory);
    // Without a block, oldSize tells the kind of object.
    const std::size_t old = block ? oldSize : 0;
    if (newSize == 0) {
        std::free(block);
        self.m_used -= old;
        return nullptr;
    }
    if (newSize > old && self.m_used + (newSize - old) > self.m_most) {
        self.m_refused = true;
        return nullptr;
    }
    void *moved = std::realloc(block, newSize);
    if (moved)
        self.m_used = self.m_used - old + newSize;
    return moved;
}

LuaState newLuaState(LuaMemory &memory)
{
    return LuaState(lua_newstate(&LuaMemory::allocate, &memory));
}

} // namespace cradle
