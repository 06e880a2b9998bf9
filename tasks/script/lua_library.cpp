// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/lua_library.h"

#include "tasks/script/nearest_name.h"
#include "tasks/script/ordered_pairs.h"
#include "tasks/script/sandbox.h"
#include "tasks/script/script_host.h"
#include "tasks/script/vector_binding.h"
#include "tasks/script/world_binding.h"

#include <QCoreApplication>
#include <QStringList>

#include <initializer_list>

namespace cradle {

namespace {

struct LibraryText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

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

/// string.format without addresses. Upvalue: Lua's own.
int formatText(lua_State *L)
{
    checkTime(L);
    if (QByteArray(luaL_checkstring(L, 1)).contains("%p"))
        raise(L, LibraryText::tr("%p of string.format is not part of the lab's Lua"));
    for (int i = 2; i <= lua_gettop(L); ++i) {
        if (lua_type(L, i) == LUA_TTABLE || lua_type(L, i) == LUA_TFUNCTION) {
            pushText(L, i);
            lua_replace(L, i);
        }
    }
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
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

/// A library function that may work long without an instruction: the clock is looked at first.
int timed(lua_State *L)
{
    checkTime(L);
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

/// Tells a program that reads a member which the table on the top of the stack does not have.
/// Lua's own library lies below it.
void explainMembers(lua_State *L, const char *library)
{
    lua_newtable(L);
    lua_pushstring(L, library);
    lua_pushvalue(L, -4);
    lua_pushcclosure(L, refuseMember, 2);
    lua_setfield(L, -2, "__index");
    lua_setmetatable(L, -2);
}

/// Moves the named functions of the library table on the top of the stack into a new table there.
void keepOnly(lua_State *L, const char *library, std::initializer_list<const char *> names)
{
    lua_newtable(L);
    for (const char *name : names) {
        lua_getfield(L, -2, name);
        lua_pushcclosure(L, timed, 1);
        lua_setfield(L, -2, name);
    }
    explainMembers(L, library);
    lua_remove(L, -2);
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

void addString(lua_State *L)
{
    luaL_requiref(L, "string", luaopen_string, 0);
    lua_getfield(L, -1, "format");
    lua_insert(L, -2);
    keepOnly(L, "string", {"format", "sub", "len", "upper", "lower"});
    lua_insert(L, -2);
    lua_pushcclosure(L, formatText, 1);
    lua_setfield(L, -2, "format");
    // The methods of strings, ("x"):upper(), are the same few.
    lua_pushliteral(L, "");
    lua_getmetatable(L, -1);
    lua_pushvalue(L, -3);
    lua_setfield(L, -2, "__index");
    lua_pop(L, 2);
    lua_setglobal(L, "string");
}

void addTable(lua_State *L)
{
    luaL_requiref(L, "table", luaopen_table, 0);
    keepOnly(L, "table", {"insert", "remove", "concat", "sort", "unpack"});
    // In C a comparison of long strings is one step; in Lua it is counted.
    static constexpr char sort[] = "local sort = ...\n"
                                   "local function less(a, b) return a < b end\n"
                                   "return function(list, comparator)\n"
                                   "  sort(list, comparator or less)\n"
                                   "end";
    luaL_loadbufferx(L, sort, sizeof sort - 1, "=table.sort", "t");
    lua_getfield(L, -2, "sort");
    lua_call(L, 1, 1);
    lua_setfield(L, -2, "sort");
    lua_setglobal(L, "table");
}

} // namespace

void addLibraries(lua_State *L)
{
    addBase(L);
    addMath(L);
    addString(L);
    addTable(L);
    lua_settop(L, 0);
}

} // namespace cradle
