// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/world_binding.h"

#include "tasks/script/circle_binding.h"
#include "tasks/script/locked_value.h"
#include "tasks/script/lua_library.h"
#include "tasks/script/registry_keys.h"
#include "tasks/script/script_host.h"
#include "tasks/script/square_binding.h"
#include "tasks/script/unknown_name.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace cradle {

namespace {

struct GlobalText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// So many circles get a name of their own; all are in circles[i].
constexpr std::size_t mostNamed = 100;
/// A global that the program has not set itself.
int readGlobal(lua_State *L)
{
    const ScriptHost &host = ScriptHost::of(L);
    const std::string_view key = textAt(L, 2);
    if (key == "gravity")
        pushVector(L, host.gravity);
    else if (key == "restitution")
        lua_pushnumber(L, host.restitution);
    else if (key == "time")
        lua_pushnumber(L, host.time);
    else if (key == "step")
        lua_pushinteger(L, host.step);
    else if (key == "on_load" || key == "on_update")
        lua_pushnil(L);
    else if (openLibrary(L, key.data())) {
        lua_pushglobaltable(L);
        lua_pushvalue(L, 2);
        lua_rawget(L, -2);
    } else
        refuseUnknown(L, QString::fromUtf8(key.data()));
    return 1;
}

void refuseWhileRunning(lua_State *L, const char *key)
{
    if (!ScriptHost::of(L).loading)
        raise(L, GlobalText::tr("`%1` is set once, in on_load; in on_update it can only be read")
                     .arg(QLatin1String(key)));
}

/// The y part of a gravity that pulls down as strongly as the number there, if it is one.
QString downwards(lua_State *L, int index)
{
    if (lua_type(L, index) != LUA_TNUMBER || !std::isfinite(lua_tonumber(L, index)))
        return QStringLiteral("-9.81");
    const QString size = describeValue(L, index).remove(QLatin1Char('-'));
    return lua_tonumber(L, index) == 0.0 ? QStringLiteral("0") : QLatin1Char('-') + size;
}

void setGravity(lua_State *L)
{
    refuseWhileRunning(L, "gravity");
    ScriptHost &host = ScriptHost::of(L);
    const Vec2 *v = vectorAt(L, 3);
    if (!v)
        raise(L, GlobalText::tr("gravity must be a vector in m/s², not %1; write gravity = "
                                "vec(0, %2)")
                     .arg(nameValue(L, 3), downwards(L, 3)));
    if (!isFinite(*v) || length(*v) > limits::maxAcceleration)
        raise(L, GlobalText::tr("gravity would be %1 m/s²; at most %2 is right")
                     .arg(describeValue(L, 3))
                     .arg(limits::maxAcceleration));
    noteAssignment(L, -1, Assignment::Field::Gravity, !host.pinned && *v != host.gravity);
    if (host.pinned)
        return;
    if (*v != host.gravity)
        refuseIfLocked(L, QStringLiteral("gravity"));
    host.gravity = *v;
}

void setRestitution(lua_State *L)
{
    refuseWhileRunning(L, "restitution");
    ScriptHost &host = ScriptHost::of(L);
    const double value = lua_type(L, 3) == LUA_TNUMBER ? lua_tonumber(L, 3) : std::nan("");
    if (!(value >= 0.0 && value <= 1.0))
        raise(L, GlobalText::tr("restitution must be a number from 0 to 1, not %1")
                     .arg(nameValue(L, 3)));
    noteAssignment(L, -1, Assignment::Field::Restitution,
                   !host.pinned && value != host.restitution);
    if (host.pinned)
        return;
    if (value != host.restitution)
        refuseIfLocked(L, QStringLiteral("restitution"));
    host.restitution = value;
}

int writeGlobal(lua_State *L)
{
    const std::string_view key = textAt(L, 2);
    if (key == "gravity") {
        setGravity(L);
        return 0;
    }
    if (key == "restitution") {
        setRestitution(L);
        return 0;
    }
    if (key == "time" || key == "step")
        raise(L, GlobalText::tr("`%1` can only be read; choose another name for a variable of "
                                "your own")
                     .arg(QLatin1String(key.data())));
    if (replaceLibrary(L, key.data())) {
        lua_rawset(L, 1);
        return 0;
    }
    lua_pushvalue(L, 2);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL)
        raise(L, GlobalText::tr("`%1` is given by the lab and cannot be replaced; choose another "
                                "name for a variable of your own")
                     .arg(QLatin1String(key.data())));
    lua_pop(L, 1);
    const bool given = key == "on_load" || key == "on_update";
    if (!given)
        refuseSlip(L, QString::fromUtf8(key.data()));
    else if (lua_type(L, 3) != LUA_TFUNCTION && lua_type(L, 3) != LUA_TNIL)
        raise(L, GlobalText::tr("`%1` must be a function, not %2")
                     .arg(QLatin1String(key.data()), nameValue(L, 3)));
    lua_rawset(L, 1);
    return 0;
}

/// "circle1" and so on, for those that have a name.
const std::vector<std::string> &circleNames()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> made;
        for (std::size_t i = 1; i <= mostNamed; ++i)
            made.push_back("circle" + std::to_string(i));
        return made;
    }();
    return names;
}

/// Puts the lab's own names behind the globals, where they are found but cannot be replaced.
/// Functions of Lua may be: a program may well have a dot or a print of its own.
void hideGiven(lua_State *L)
{
    constexpr std::array<const char *, 5> names{"circles", "square", "vec", "draw", "plot"};
    const std::size_t circles = std::min(ScriptHost::of(L).circles.size(), mostNamed);
    lua_pushglobaltable(L);
    const int globals = lua_gettop(L);
    lua_newtable(L);
    const int given = globals + 1;
    for (const char *name : names) {
        lua_getfield(L, globals, name);
        lua_setfield(L, given, name);
        lua_pushnil(L);
        lua_setfield(L, globals, name);
    }
    for (std::size_t i = 0; i < circles; ++i) {
        pushCircle(L, static_cast<int>(i));
        lua_setfield(L, given, circleNames()[i].c_str());
    }
    lua_newtable(L);
    lua_pushcfunction(L, readGlobal);
    lua_setfield(L, -2, "__index");
    lua_setmetatable(L, given);
    lua_newtable(L);
    lua_pushvalue(L, given);
    lua_setfield(L, -2, "__index");
    lua_pushvalue(L, given);
    lua_pushcclosure(L, writeGlobal, 1);
    lua_setfield(L, -2, "__newindex");
    lua_setmetatable(L, globals);
    lua_rawseti(L, LUA_REGISTRYINDEX, registry::givenNames);
    lua_pop(L, 1);
}

} // namespace

void addWorld(lua_State *L)
{
    pushCircles(L);
    lua_setglobal(L, "circles");
    addSquare(L);
    hideGiven(L);
}

} // namespace cradle
