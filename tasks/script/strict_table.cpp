// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/strict_table.h"

#include "tasks/script/nearest_name.h"
#include "tasks/script/registry_keys.h"
#include "tasks/script/script_host.h"
#include "tasks/script/vector_binding.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct TableText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// A field that a run, a state or a circle does not have.
int refuseUnknownKey(lua_State *L)
{
    QStringList names;
    lua_pushnil(L);
    while (lua_next(L, 1) != 0) {
        lua_pop(L, 1);
        if (lua_type(L, -1) == LUA_TSTRING)
            names.append(QString::fromUtf8(lua_tostring(L, -1)));
    }
    names.sort();
    const QString name = describeValue(L, 2);
    const QString key =
        lua_type(L, 2) == LUA_TSTRING ? QString::fromUtf8(lua_tostring(L, 2)) : name;
    const QString near = nearestName(key, names);
    raise(L, near.isEmpty() ? TableText::tr("there is no field `%1` here; there are %2")
                                  .arg(key.left(64), names.join(QStringLiteral(", ")))
                            : TableText::tr("there is no field `%1` here: did you mean `%2`?")
                                  .arg(key.left(64), near));
}

} // namespace

void makeStrict(lua_State *L)
{
    if (lua_rawgeti(L, LUA_REGISTRYINDEX, registry::strictMetatable) == LUA_TNIL) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushcfunction(L, refuseUnknownKey);
        lua_setfield(L, -2, "__index");
        lua_pushvalue(L, -1);
        lua_rawseti(L, LUA_REGISTRYINDEX, registry::strictMetatable);
    }
    lua_setmetatable(L, -2);
}

void setNumber(lua_State *L, const char *name, double value)
{
    lua_pushnumber(L, value);
    lua_setfield(L, -2, name);
}

void setWhole(lua_State *L, const char *name, qint64 value)
{
    lua_pushinteger(L, value);
    lua_setfield(L, -2, name);
}

void setVector(lua_State *L, const char *name, Vec2 value)
{
    pushVector(L, value);
    lua_setfield(L, -2, name);
}

} // namespace cradle
