// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/lua_library.h"

#include "tasks/script/library_parts.h"
#include "tasks/script/nearest_name.h"
#include "tasks/script/ordered_pairs.h"
#include "tasks/script/sandbox.h"
#include "tasks/script/script_host.h"
#include "tasks/script/vector_binding.h"
#include "tasks/script/world_binding.h"

#include <QCoreApplication>
#include <QStringList>

namespace cradle {

namespace {

struct LibraryText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

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

/// math.randomseed without a number would make every run another.
int seedRandom(lua_State *L)
{
    if (lua_gettop(L) == 0)
        lua_pushinteger(L, 1);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, 0);
    return 0;
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

/// A member of a library that is not there. Upvalues: the name of the library, and Lua's own.
int refuseMember(lua_State *L)
{
    const QString library = QString::fromUtf8(lua_tostring(L, lua_upvalueindex(1)));
    const QString name =
        lua_type(L, 2) == LUA_TSTRING ? QString::fromUtf8(lua_tostring(L, 2)) : describeValue(L, 2);
    QStringList names;
    lua_pushnil(L);
    while (lua_next(L, 1) != 0) {
        if (lua_type(L, -2) == LUA_TSTRING)
            names.append(QString::fromUtf8(lua_tostring(L, -2)));
        lua_pop(L, 1);
    }
    names.sort();
    const QString all = names.join(QStringLiteral(", "));
    lua_pushvalue(L, 2);
    if (lua_rawget(L, lua_upvalueindex(2)) != LUA_TNIL)
        raise(L, LibraryText::tr("`%1.%2` is not part of the lab's Lua; %1 has %3")
                     .arg(library, name, all));
    const QString near = nearestName(name, names);
    if (near.isEmpty())
        raise(L, LibraryText::tr("%1 has no `%2`; it has %3").arg(library, name, all));
    raise(L, LibraryText::tr("%1 has no `%2`: did you mean `%1.%3`?").arg(library, name, near));
}

void addBase(lua_State *L)
{
    lua_pushcfunction(L, luaopen_base);
    lua_call(L, 0, 0); // fills the globals
    lua_pushglobaltable(L);
    lua_newtable(L);
    for (const char *name : {"ipairs", "select", "tonumber", "assert", "error"}) {
        lua_getfield(L, -2, name);
        lua_setfield(L, -2, name);
    }
    lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    lua_pop(L, 1);
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

void addMath(lua_State *L)
{
    luaL_requiref(L, "math", luaopen_math, 0);
    lua_getfield(L, -1, "randomseed");
    lua_pushvalue(L, -1);
    lua_pushinteger(L, 1);
    lua_call(L, 1, 0);
    lua_pushcclosure(L, seedRandom, 1);
    lua_setfield(L, -2, "randomseed");
    lua_pushvalue(L, -1);
    explainMembers(L, "math");
    lua_setglobal(L, "math");
}

} // namespace

void explainMembers(lua_State *L, const char *library)
{
    lua_newtable(L);
    lua_pushstring(L, library);
    lua_pushvalue(L, -4);
    lua_pushcclosure(L, refuseMember, 2);
    lua_setfield(L, -2, "__index");
    lua_setmetatable(L, -2);
}

void keepOnly(lua_State *L, const char *library, std::initializer_list<luaL_Reg> functions)
{
    lua_newtable(L);
    for (const luaL_Reg &entry : functions) {
        lua_getfield(L, -2, entry.name);
        if (entry.func)
            lua_pushcclosure(L, entry.func, 1);
        lua_setfield(L, -2, entry.name);
    }
    explainMembers(L, library);
    lua_remove(L, -2);
}

void addLibraries(lua_State *L)
{
    addBase(L);
    addMath(L);
    addTexts(L);
    addTables(L);
    lua_settop(L, 0);
}

} // namespace cradle
