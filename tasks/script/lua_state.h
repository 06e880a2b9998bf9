// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/large_blocks.h"
#include "tasks/script/small_blocks.h"

#include <lua.hpp>

#include <cstddef>
#include <utility>

namespace cradle {

/// Memory of one Lua state, which ends with it; capped while a program runs: past the cap an
/// allocation fails, which Lua turns into an error of the program. What we do to the state between
/// runs never fails.
class LuaMemory
{
public:
    explicit LuaMemory(std::size_t most)
        : m_most(most)
    {
    }

    [[nodiscard]] std::size_t used() const { return m_used; }

    /// The cap holds from now on, for what runs in \p L. A program that is refused again and again
    /// is given nothing more: else Lua would collect garbage anew for every allocation.
    void hold(lua_State *L);
    /// The cap holds no more.
    void release() { m_running = nullptr; }
    /// The line of the program that was last refused memory; 0 if none was.
    [[nodiscard]] int refusedLine() const { return m_refusedLine; }

    /// Bytes of the longest text that was made.
    [[nodiscard]] std::size_t longestText() const { return m_longestText; }
    /// Bytes of lists and tables that were made or moved to larger blocks since this was last
    /// asked.
    [[nodiscard]] std::size_t takeMoved() { return std::exchange(m_moved, 0); }
    /// The same, left as it is.
    [[nodiscard]] std::size_t moved() const { return m_moved; }
    /// Forgets what was moved meanwhile, since it was not the program's work.
    void setMoved(std::size_t bytes) { m_moved = bytes; }

    /// Calls \p told once, as soon as what runs makes a text that counts for more than an
    /// instruction, or has moved more in one go than limits::uncountedMovedBytes. It may not use
    /// the stack.
    void callWhenMuch(void (*told)(lua_State *running)) { m_whenMuch = told; }

    /// A lua_Alloc; \p memory is a LuaMemory.
    static void *allocate(void *memory, void *block, std::size_t oldSize, std::size_t newSize);

private:
    std::size_t m_most;
    std::size_t m_used = 0;
    lua_State *m_running = nullptr; ///< null while the cap does not hold
    int m_refusals = 0;             ///< in the whole run
    std::size_t m_longestText = 0;
    std::size_t m_moved = 0;
    int m_refusedLine = 0;
    void (*m_whenMuch)(lua_State *running) = nullptr;
    SmallBlocks m_small; ///< nearly all of it
    LargeBlocks m_large;

    [[nodiscard]] bool refuses(std::size_t more);
    void note(bool isText, std::size_t size);
    void drop(void *block, std::size_t size);
    [[nodiscard]] void *resize(void *block, std::size_t oldSize, std::size_t newSize);
};

/// A state without any library. It needs not be closed: all that it has goes with \p memory, and
/// nothing of ours or of a program waits for its end.
/// \return null if there is no memory for it
[[nodiscard]] lua_State *newLuaState(LuaMemory &memory);

} // namespace cradle
