// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/world_binding.h"

#include "tasks/script/circle_binding.h"
#include "tasks/script/locked_value.h"
#include "tasks/script/lua_library.h"
#include "tasks/script/meant.h"
#include "tasks/script/nearest_name.h"
#include "tasks/script/registry_keys.h"
#include "tasks/script/script_host.h"
#include "tasks/script/square_binding.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace cradle {

namespace {

struct WorldText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// So many circles get a name of their own; all are in circles[i].
constexpr std::size_t mostNamed = 100;
/// Names among which the nearest is looked for; a program of the lab has a handful.
constexpr qsizetype mostNames = 1000;
constexpr lua_Unsigned longestName = 64;
constexpr qint64 instructionsPerName = 50; ///< that comparing two names counts

/// What a program is likely to look for, and why it is not there.
QString whyAbsent(const QString &name)
{
    static const QStringList forbidden{QStringLiteral("os"),
                                       QStringLiteral("io"),
                                       QStringLiteral("debug"),
                                       QStringLiteral("require"),
                                       QStringLiteral("load"),
                                       QStringLiteral("loadstring"),
                                       QStringLiteral("dofile"),
                                       QStringLiteral("loadfile"),
                                       QStringLiteral("package"),
                                       QStringLiteral("coroutine"),
                                       QStringLiteral("utf8"),
                                       QStringLiteral("setmetatable"),
                                       QStringLiteral("getmetatable"),
                                       QStringLiteral("rawset"),
                                       QStringLiteral("rawget"),
                                       QStringLiteral("rawequal"),
                                       QStringLiteral("rawlen"),
                                       QStringLiteral("next"),
                                       QStringLiteral("collectgarbage"),
                                       QStringLiteral("xpcall"),
                                       QStringLiteral("_G"),
                                       QStringLiteral("_ENV"),
                                       QStringLiteral("warn")};
    if (forbidden.contains(name))
        return WorldText::tr("`%1` is not part of the lab's Lua; see the API page (F1) for what is")
            .arg(name);
    return {};
}

/// Appends the keys of the table on the top of the stack, and takes it away.
void appendKeys(lua_State *L, QStringList &names)
{
    lua_pushnil(L);
    while (lua_next(L, -2) != 0) {
        if (lua_type(L, -2) == LUA_TSTRING && lua_rawlen(L, -2) <= longestName)
            names.append(QString::fromUtf8(lua_tostring(L, -2)));
        ScriptHost::of(L).instructions += instructionsPerName;
        lua_pop(L, 1);
        if (names.size() > mostNames) {
            lua_pop(L, 1);
            break;
        }
    }
    lua_pop(L, 1);
}

QStringList globalNames(lua_State *L)
{
    QStringList names{QStringLiteral("gravity"), QStringLiteral("restitution"),
                      QStringLiteral("time"), QStringLiteral("step")};
    openLibraries(L);
    lua_pushglobaltable(L);
    appendKeys(L, names);
    lua_rawgeti(L, LUA_REGISTRYINDEX, registry::givenNames);
    appendKeys(L, names);
    names.sort();
    return names;
}

[[noreturn]] void refuseUnknown(lua_State *L, const QString &name)
{
    if (ScriptHost::of(L).wordless)
        raise(L, {});
    const QString unknown =
        WorldText::tr("`%1` is not known: nothing of that name was given a value before");
    if (name.size() > static_cast<qsizetype>(longestName))
        raise(L, unknown.arg(name.left(longestName) + QStringLiteral("…")));
    if (const QString why = whyAbsent(name); !why.isEmpty())
        raise(L, why);
    const auto count = ScriptHost::of(L).circles.size();
    if (name.startsWith(QLatin1String("circle")) && name.mid(6).toUInt() > count)
        raise(L,
              count == 1
                  ? WorldText::tr("there is no %1: the scene has 1 circle").arg(name)
                  : WorldText::tr("there is no %1: the scene has %2 circles").arg(name).arg(count));
    if (const QString meant = meantByName(L, name); !meant.isEmpty())
        raise(L, meant);
    QStringList locals;
    if (const QString meant = meantByLocals(L, name, locals); !meant.isEmpty())
        raise(L, meant);
    const QString near = nearestName(name, locals + globalNames(L));
    if (near == name)
        raise(L, WorldText::tr("`%1` is not known yet: a local can be used only after the "
                               "statement that makes it")
                     .arg(name));
    if (!near.isEmpty())
        raise(L, WorldText::tr("`%1` is not known: did you mean `%2`?").arg(name, near));
    raise(L, unknown.arg(name));
}

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
        raise(L, WorldText::tr("`%1` is set once, in on_load; in on_update it can only be read")
                     .arg(QLatin1String(key)));
}

void setGravity(lua_State *L)
{
    refuseWhileRunning(L, "gravity");
    ScriptHost &host = ScriptHost::of(L);
    const Vec2 *v = vectorAt(L, 3);
    if (!v)
        raise(L, WorldText::tr("gravity must be a vector in m/s², not %1; write gravity = "
                               "vec(0, -9.81)")
                     .arg(nameValue(L, 3)));
    if (!isFinite(*v) || length(*v) > limits::maxAcceleration)
        raise(L, WorldText::tr("gravity would be %1 m/s²; at most %2 is right")
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
        raise(
            L,
            WorldText::tr("restitution must be a number from 0 to 1, not %1").arg(nameValue(L, 3)));
    noteAssignment(L, -1, Assignment::Field::Restitution,
                   !host.pinned && value != host.restitution);
    if (host.pinned)
        return;
    if (value != host.restitution)
        refuseIfLocked(L, QStringLiteral("restitution"));
    host.restitution = value;
}

/// "on_updat" is hardly a name of the program's own.
void refuseSlip(lua_State *L, const QString &name)
{
    ScriptHost::of(L).instructions += instructionsPerName;
    for (const char *known : {"on_load", "on_update", "gravity", "restitution"}) {
        const QString right = QLatin1String(known);
        if (!name.startsWith(right) && editDistance(name.toLower(), right) <= 2)
            raise(L, WorldText::tr("`%1` is not known: did you mean `%2`?").arg(name, right));
    }
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
        raise(L, WorldText::tr("`%1` can only be read; choose another name for a variable of "
                               "your own")
                     .arg(QLatin1String(key.data())));
    if (replaceLibrary(L, key.data())) {
        lua_rawset(L, 1);
        return 0;
    }
    lua_pushvalue(L, 2);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL)
        raise(L, WorldText::tr("`%1` is given by the lab and cannot be replaced; choose another "
                               "name for a variable of your own")
                     .arg(QLatin1String(key.data())));
    lua_pop(L, 1);
    const bool given = key == "on_load" || key == "on_update";
    if (!given)
        refuseSlip(L, QString::fromUtf8(key.data()));
    else if (lua_type(L, 3) != LUA_TFUNCTION && lua_type(L, 3) != LUA_TNIL)
        raise(L, WorldText::tr("`%1` must be a function, not %2")
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
    lua_createtable(L, 0, static_cast<int>(names.size() + circles));
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
