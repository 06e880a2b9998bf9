// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/lua_state.h"

#include "tasks/script/script_host.h"
#include "tasks/script/script_limits.h"

#include <algorithm>
#include <cstring>

namespace cradle {

namespace {

/// Each has cost a look at all that the program keeps, some 50 ms.
constexpr int mostRefusals = 50;
constexpr int kilobytesBeforeCollection = 512;

} // namespace

void LuaMemory::hold(lua_State *L)
{
    m_running = L;
    m_refusedLine = 0;
}

bool LuaMemory::refuses(std::size_t more)
{
    if (!m_running || (m_refusals < mostRefusals && m_used + more <= m_most))
        return false;
    // Lua tells no line of this error; the stack can be read here without memory.
    m_refusedLine = currentLine(m_running);
    m_refusals = std::min(m_refusals + 1, mostRefusals);
    return true;
}

void *LuaMemory::allocate(void *memory, void *block, std::size_t oldSize, std::size_t newSize)
{
    auto &self = *static_cast<LuaMemory *>(memory);
    // Nearly all that is asked for: a small object more.
    if (!block && newSize - 1 < SmallBlocks::largest && self.m_used + newSize <= self.m_most
        && self.m_refusals < mostRefusals) {
        void *made = self.m_small.take(newSize);
        self.m_used += made ? newSize : 0;
        return made;
    }
    // Without a block, oldSize tells the kind of object.
    const std::size_t old = block ? oldSize : 0;
    if (newSize == 0) {
        self.drop(block, old);
        self.m_used -= old;
        return nullptr;
    }
    if (newSize > old && self.refuses(newSize - old))
        return nullptr;
    void *moved = self.resize(block, old, newSize);
    if (!moved)
        return nullptr;
    self.m_used = self.m_used - old + newSize;
    self.note(!block && oldSize == LUA_TSTRING, newSize);
    return moved;
}

/// Small blocks cost no more than the instructions that ask for them, and hold no long text.
void LuaMemory::note(bool isText, std::size_t size)
{
    if (isText)
        m_longestText = std::max(m_longestText, size);
    else if (size > SmallBlocks::largest)
        m_moved += size;
    if (m_whenMuch && m_running
        && (m_longestText >= limits::textBytesPerInstruction
            || m_moved > limits::uncountedMovedBytes))
        std::exchange(m_whenMuch, nullptr)(m_running);
}

void LuaMemory::drop(void *block, std::size_t size)
{
    if (!block)
        return;
    if (size > SmallBlocks::largest)
        m_large.giveBack(block);
    else
        m_small.giveBack(block, size);
}

void *LuaMemory::resize(void *block, std::size_t oldSize, std::size_t newSize)
{
    if (oldSize > SmallBlocks::largest && newSize > SmallBlocks::largest)
        return m_large.resize(block, newSize);
    void *moved = newSize > SmallBlocks::largest ? m_large.take(newSize) : m_small.take(newSize);
    if (moved && block) {
        std::memcpy(moved, block, std::min(oldSize, newSize));
        drop(block, oldSize);
    }
    return moved;
}

lua_State *newLuaState(LuaMemory &memory)
{
    lua_State *state = lua_newstate(&LuaMemory::allocate, &memory);
    // A step of that size taken back: that much later begins the first collection, which a run of
    // some hundred steps needs not at all. What is refused is collected first, as ever.
    if (state)
        lua_gc(state, LUA_GCSTEP, -kilobytesBeforeCollection);
    return state;
}

} // namespace cradle
