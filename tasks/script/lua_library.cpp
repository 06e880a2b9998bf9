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

#include <array>
#include <cstring>

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

/// What texts can do without `string`: ("x"):upper(), "1" + 1.
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
