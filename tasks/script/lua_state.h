// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <lua.hpp>

#include <cstddef>
#include <memory>

namespace cradle {

/// Memory of one Lua state, capped: past the cap an allocation fails, which Lua turns into an
/// error of the program.
class LuaMemory
{
public:
    explicit LuaMemory(std::size_t most)
        : m_most(most)
    {
    }

    [[nodiscard]] std::size_t used() const { return m_used; }
    /// Whether an allocation was refused since clear().
    [[nodiscard]] bool wasRefused() const { return m_refused; }
    void clear() { m_refused = false; }

    /// A lua_Alloc; \p memory is a LuaMemory.
    static void *allocate(void *memory, void *block, std::size_t oldSize, std::size_t newSize);

private:
    std::size_t m_most;
    std::size_t m_used = 0;
    bool m_refused = false;
};

struct LuaCloser {
    void operator()(lua_State *state) const { lua_close(state); }
};
using LuaState = std::unique_ptr<lua_State, LuaCloser>;

/// A state without any library. \return null if there is no memory for it
[[nodiscard]] LuaState newLuaState(LuaMemory &memory);

} // namespace cradle
