// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/lua_library.h"

#include "tasks/script/library_parts.h"
#include "tasks/script/nearest_name.h"
#include "tasks/script/script_host.h"
#include "tasks/script/vector_binding.h"

#include <QCoreApplication>
#include <QStringList>

#include <array>
#include <cstring>

namespace cradle {

namespace {

struct LibraryText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

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

void pushMath(lua_State *L)
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
    lua_remove(L, -2);
}

struct LateLibrary {
    const char *name;
    void (*push)(lua_State *L);
};
constexpr std::array<LateLibrary, 3> lateLibraries{
    {{"math", pushMath}, {"string", pushTexts}, {"table", pushTables}}};

int openHere(lua_State *L)
{
    const auto *library = static_cast<const LateLibrary *>(lua_touserdata(L, 1));
    lua_pushglobaltable(L);
    lua_pushstring(L, library->name);
    library->push(L);
    lua_rawset(L, -3);
    return 0;
}

/// It is our work, not the program's, so it counts for nothing.
void open(lua_State *L, std::size_t i)
{
    ScriptHost &host = ScriptHost::of(L);
    const std::size_t moved = host.memory.moved();
    lua_pushcfunction(L, openHere);
    lua_pushlightuserdata(L, const_cast<LateLibrary *>(&lateLibraries[i]));
    lua_call(L, 1, 0);
    host.memory.setMoved(moved);
    host.opened[i] = true;
}

/// The index of a library that was not asked for yet, or the number of all.
std::size_t lateIndex(lua_State *L, const char *name)
{
    const ScriptHost &host = ScriptHost::of(L);
    std::size_t i = 0;
    while (i < lateLibraries.size()
           && (host.opened[i] || std::strcmp(lateLibraries[i].name, name) != 0))
        ++i;
    return i;
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

void addLibrariesLate(lua_State *L)
{
    addBase(L);
    addTextMethods(L);
    lua_settop(L, 0);
}

void addLibraries(lua_State *L)
{
    addLibrariesLate(L);
    openLibraries(L);
}

bool openLibrary(lua_State *L, const char *name)
{
    const std::size_t i = lateIndex(L, name);
    if (i == lateLibraries.size())
        return false;
    open(L, i);
    return true;
}

bool replaceLibrary(lua_State *L, const char *name)
{
    const std::size_t i = lateIndex(L, name);
    if (i == lateLibraries.size())
        return false;
    ScriptHost::of(L).opened[i] = true;
    return true;
}

void openLibraries(lua_State *L)
{
    for (const LateLibrary &library : lateLibraries)
        openLibrary(L, library.name);
}

} // namespace cradle
