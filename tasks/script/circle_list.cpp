// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/circle_list.h"

#include "tasks/script/registry_keys.h"
#include "tasks/script/script_host.h"
#include "tasks/script/vector_binding.h"

#include <QCoreApplication>

#include <climits>
#include <new>

namespace cradle {

namespace {

struct ListText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// circles[i]; nil beyond the last, as ipairs wants it.
int listIndex(lua_State *L)
{
    if (lua_type(L, 2) != LUA_TNUMBER) {
        const std::string_view name = textAt(L, 2);
        for (const char *length : {"Length", "length", "Count", "count", "size"}) {
            if (name == length)
                raise(L, ListText::tr("how many circles there are is #circles"));
        }
        raise(L, ListText::tr("circles[i] takes a number from 1 to %1, not %2")
                     .arg(ScriptHost::of(L).circles.size())
                     .arg(nameValue(L, 2)));
    }
    lua_rawgeti(L, LUA_REGISTRYINDEX, registry::circleTable);
    lua_pushvalue(L, 2);
    lua_rawget(L, -2);
    return 1;
}

int listLength(lua_State *L)
{
    lua_pushinteger(L, static_cast<lua_Integer>(ScriptHost::of(L).circles.size()));
    return 1;
}

int refuseListChange(lua_State *L)
{
    raise(L, ListText::tr("circles cannot be added or removed by a program; set the position "
                          "and velocity of those that are there"));
}

int listNext(lua_State *L)
{
    const lua_Integer last = luaL_optinteger(L, 2, 0);
    const lua_Integer next = last < 0 || last > INT_MAX ? 0 : last + 1;
    lua_pushinteger(L, next);
    lua_rawgeti(L, LUA_REGISTRYINDEX, registry::circleTable);
    lua_rawgeti(L, -1, next);
    if (lua_isnil(L, -1))
        return 1; // nil ends the loop
    lua_replace(L, -2);
    return 2;
}

int listPairs(lua_State *L)
{
    lua_pushcfunction(L, listNext);
    lua_pushvalue(L, 1);
    lua_pushnil(L);
    return 3;
}

void setFunction(lua_State *L, const char *name, lua_CFunction function)
{
    lua_pushcfunction(L, function);
    lua_setfield(L, -2, name);
}

} // namespace

void pushCircleList(lua_State *L)
{
    new (lua_newuserdatauv(L, sizeof(ObjectKind), 0)) ObjectKind{ObjectKind::Circles};
    lua_createtable(L, 0, 6);
    setFunction(L, "__index", listIndex);
    setFunction(L, "__len", listLength);
    setFunction(L, "__newindex", refuseListChange);
    setFunction(L, "__pairs", listPairs);
    setFunction(L, "__tostring", describeObject);
    lua_pushliteral(L, "list of circles");
    lua_setfield(L, -2, "__name");
    lua_setmetatable(L, -2);
}

} // namespace cradle
