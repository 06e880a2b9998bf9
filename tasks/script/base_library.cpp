// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/library_parts.h"
#include "tasks/script/lua_library.h"
#include "tasks/script/ordered_pairs.h"
#include "tasks/script/sandbox.h"
#include "tasks/script/script_host.h"
#include "tasks/script/vector_binding.h"
#include "tasks/script/world_binding.h"

#include <array>
#include <memory>

namespace cradle {

namespace {

constexpr qint64 digitsPerInstruction = 32;

/// "vector", "circle" and the names of Lua's own types.
int typeName(lua_State *L)
{
    luaL_checkany(L, 1);
    if (vectorAt(L, 1))
        lua_pushliteral(L, "vector");
    else if (circleAt(L, 1) >= 0)
        lua_pushliteral(L, "circle");
    else
        lua_pushstring(L, luaL_typename(L, 1));
    return 1;
}

int toText(lua_State *L)
{
    luaL_checkany(L, 1);
    pushText(L, 1);
    return 1;
}

/// tonumber reads a text of any length. Upvalue: Lua's own.
int toNumber(lua_State *L)
{
    if (lua_type(L, 1) == LUA_TSTRING)
        charge(L, static_cast<qint64>(lua_rawlen(L, 1)) / digitsPerInstruction);
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/// select gives back nearly all that it is given. Upvalue: Lua's own.
int selectValues(lua_State *L)
{
    charge(L, lua_gettop(L));
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/// Functions of Lua's own, which are the same in every state.
struct OwnFunctions {
    std::array<luaL_Reg, 5> base{{{"ipairs", nullptr},
                                  {"select", nullptr},
                                  {"tonumber", nullptr},
                                  {"assert", nullptr},
                                  {"error", nullptr}}};
    /// Reckoning with texts that are numbers.
    std::array<luaL_Reg, 8> texts{{{"__add", nullptr},
                                   {"__sub", nullptr},
                                   {"__mul", nullptr},
                                   {"__mod", nullptr},
                                   {"__pow", nullptr},
                                   {"__div", nullptr},
                                   {"__idiv", nullptr},
                                   {"__unm", nullptr}}};

    OwnFunctions()
    {
        const std::unique_ptr<lua_State, decltype(&lua_close)> state(luaL_newstate(), lua_close);
        lua_State *L = state.get();
        if (!L)
            return;
        luaL_requiref(L, LUA_GNAME, luaopen_base, 0);
        for (luaL_Reg &entry : base)
            entry.func = member(L, entry.name);
        luaL_requiref(L, LUA_STRLIBNAME, luaopen_string, 0);
        lua_pushliteral(L, "");
        lua_getmetatable(L, -1);
        for (luaL_Reg &entry : texts)
            entry.func = member(L, entry.name);
    }

private:
    static lua_CFunction member(lua_State *L, const char *name)
    {
        lua_getfield(L, -1, name);
        const lua_CFunction function = lua_tocfunction(L, -1);
        lua_pop(L, 1);
        return function;
    }
};

const OwnFunctions &ownFunctions(lua_State *L)
{
    static const OwnFunctions own;
    if (!own.base.front().func)
        luaL_error(L, "there is no memory");
    return own;
}

/// So many globals as the lab gives and a program of the lab has.
constexpr int usualGlobals = 32;

/// The first member of a text that is asked for: they are those of `string`.
int firstMember(lua_State *L)
{
    if (!openLibrary(L, "string")) { // Its name was given to something else.
        const std::size_t moved = ScriptHost::of(L).memory.moved();
        pushTexts(L);
        ScriptHost::of(L).memory.setMoved(moved);
    }
    lua_settop(L, 2);
    lua_gettable(L, 1); // Now they are there.
    return 1;
}

} // namespace

void addBase(lua_State *L)
{
    lua_createtable(L, 0, usualGlobals);
    lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    for (const luaL_Reg &entry : ownFunctions(L).base)
        lua_register(L, entry.name, entry.func);
    for (const luaL_Reg &entry : {luaL_Reg{"tonumber", toNumber}, {"select", selectValues}}) {
        lua_getglobal(L, entry.name);
        lua_pushcclosure(L, entry.func, 1);
        lua_setglobal(L, entry.name);
    }
    lua_register(L, "pcall", protectedCall);
    lua_register(L, "pairs", orderedPairs);
    lua_register(L, "type", typeName);
    lua_register(L, "tostring", toText);
}

void addTextMethods(lua_State *L)
{
    lua_pushliteral(L, "");
    lua_createtable(L, 0, static_cast<int>(ownFunctions(L).texts.size()) + 1);
    for (const luaL_Reg &entry : ownFunctions(L).texts) {
        lua_pushcfunction(L, entry.func);
        lua_setfield(L, -2, entry.name);
    }
    lua_pushcfunction(L, firstMember);
    lua_setfield(L, -2, "__index");
    lua_setmetatable(L, -2);
    lua_pop(L, 1);
}

} // namespace cradle
