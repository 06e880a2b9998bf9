// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/sandbox.h"

#include "tasks/script/script_host.h"
#include "tasks/script/script_limits.h"
#include "tasks/script/vector_binding.h"
#include "tasks/script/world_binding.h"

#include <QCoreApplication>

#include <initializer_list>

namespace cradle {

namespace {

struct SandboxText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// Instructions between two looks at the clock: few, since one may copy a string of many MB.
constexpr int instructionsPerLook = 100;

void checkTime(lua_State *L, const ScriptHost &host)
{
    if (std::chrono::steady_clock::now() > host.deadline)
        abortRun(L, ProgramError::Kind::Time,
                 SandboxText::tr("this step has run for more than %1 s; is there a loop that does "
                                 "not end?")
                     .arg(limits::wallTimePerStep.count()));
}

void hook(lua_State *L, lua_Debug *event)
{
    ScriptHost &host = ScriptHost::of(L);
    if (event->event == LUA_HOOKLINE) {
        if (lua_isyieldable(L))
            lua_yield(L, 0);
        return;
    }
    if (host.aborted) // Something went on after all.
        abortRun(L, *host.aborted, SandboxText::tr("the run was stopped"));
    host.instructions += instructionsPerLook;
    if (host.instructions > limits::instructionsPerStep)
        abortRun(L, ProgramError::Kind::Time,
                 SandboxText::tr("this step takes more than %1 million instructions; is there a "
                                 "loop that does not end?")
                     .arg(limits::instructionsPerStep / 1'000'000));
    checkTime(L, host);
}

/// The end of a pcall: true and the results, or false and the error, unless a limit was passed.
int finishCall(lua_State *L, int status, lua_KContext)
{
    if (status == LUA_OK || status == LUA_YIELD)
        return lua_gettop(L);
    ScriptHost &host = ScriptHost::of(L);
    if (status == LUA_ERRMEM && !host.aborted)
        host.aborted = ProgramError::Kind::Memory;
    if (host.aborted)
        lua_error(L);
    lua_pushboolean(L, 0);
    lua_insert(L, -2);
    return 2;
}

int protectedCall(lua_State *L)
{
    luaL_checkany(L, 1);
    lua_pushboolean(L, 1);
    lua_insert(L, 1);
    const int status = lua_pcallk(L, lua_gettop(L) - 2, LUA_MULTRET, 0, 0, finishCall);
    return finishCall(L, status, 0);
}

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
    checkTime(L, ScriptHost::of(L));
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/// Moves the named functions of the library table on the top of the stack into a new table there.
void keepOnly(lua_State *L, std::initializer_list<const char *> names)
{
    lua_newtable(L);
    for (const char *name : names) {
        lua_getfield(L, -2, name);
        lua_pushcclosure(L, timed, 1);
        lua_setfield(L, -2, name);
    }
    lua_remove(L, -2);
}

void addBase(lua_State *L)
{
    lua_pushcfunction(L, luaopen_base);
    lua_call(L, 0, 0); // fills the globals
    lua_pushglobaltable(L);
    lua_newtable(L);
    for (const char *name : {"ipairs", "pairs", "select", "tostring", "tonumber", "assert",
                             "error"}) {
        lua_getfield(L, -2, name);
        lua_setfield(L, -2, name);
    }
    lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    lua_pop(L, 1);
    lua_register(L, "pcall", protectedCall);
    lua_register(L, "type", typeName);
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
    lua_setglobal(L, "math");
}

void addString(lua_State *L)
{
    luaL_requiref(L, "string", luaopen_string, 0);
    keepOnly(L, {"format", "sub", "len", "upper", "lower"});
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
    keepOnly(L, {"insert", "remove", "concat", "sort", "unpack"});
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

/// The innermost function of the program on the stack, with its line.
bool findLevel(lua_State *L, lua_Debug &where)
{
    for (int level = 0; lua_getstack(L, level, &where) != 0; ++level) {
        lua_getinfo(L, "Sl", &where);
        if (where.currentline > 0 && qstrcmp(where.source, "=lab.lua") == 0)
            return true;
    }
    return false;
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

void watch(lua_State *L, bool lines)
{
    lua_sethook(L, hook, LUA_MASKCOUNT | (lines ? LUA_MASKLINE : 0), instructionsPerLook);
}

void beginCount(lua_State *L)
{
    ScriptHost &host = ScriptHost::of(L);
    host.instructions = 0;
    host.outputBytes = 0;
    host.deadline = std::chrono::steady_clock::now() + limits::wallTimePerStep;
    host.memory.clear();
}

int currentLine(lua_State *L)
{
    lua_Debug where{};
    return findLevel(L, where) ? where.currentline : 0;
}

void noteError(lua_State *L)
{
    ScriptHost &host = ScriptHost::of(L);
    ProgramError &error = host.caught;
    error = {};
    lua_Debug where{};
    if (findLevel(L, where)) {
        error.line = where.currentline;
        for (int i = 1; const char *name = lua_getlocal(L, &where, i); ++i) {
            // Those in brackets are Lua's own.
            if (*name != '(')
                error.locals.push_back({QString::fromUtf8(name), describeValue(L, -1)});
            lua_pop(L, 1);
        }
    }
}

int catchError(lua_State *L)
{
    noteError(L);
    return 1;
}

} // namespace cradle
