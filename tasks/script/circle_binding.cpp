// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/circle_binding.h"

#include "tasks/script/circle_list.h"
#include "tasks/script/locked_value.h"
#include "tasks/script/own_fields.h"
#include "tasks/script/registry_keys.h"
#include "tasks/script/script_host.h"
#include "tasks/script/world_binding.h"

#include <QCoreApplication>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <new>

namespace cradle {

namespace {

struct CircleText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

enum class Field { Position, Velocity, Radius, Density, Index, Own };

/// In the order of Field.
constexpr std::array<const char *, 5> fieldNames{"position", "velocity", "radius", "density",
                                                 "index"};

/// The field that is named at \p place of the stack: all but the engine's are the program's own.
Field fieldAt(lua_State *L, int place)
{
    // Lua has one copy of each short text.
    const void *key = lua_topointer(L, place);
    const auto &keys = ScriptHost::of(L).fieldKeys;
    std::size_t field = 0;
    while (field < keys.size() && keys[field] != key)
        ++field;
    return static_cast<Field>(field);
}

Assignment::Field assignedField(char letter)
{
    using enum Assignment::Field;
    return letter == 'p' ? Position : letter == 'v' ? Velocity : letter == 'r' ? Radius : Density;
}

const char *keyAt(lua_State *L, int index, int circle)
{
    if (lua_type(L, index) == LUA_TSTRING)
        return lua_tostring(L, index);
    raise(L, CircleText::tr("%1 has no field %2; a field has a name")
                 .arg(circleName(circle), nameValue(L, index)));
}

/// Behind the program's own fields, what goes with a circle in Lua: the vectors of its place and
/// its velocity that the program read or assigned last.
enum Companion { LastPosition = ownFieldsOfCircle + 1, LastVelocity };

/// Vectors never change: while the circle has the same, the program gets the one that it had.
void pushVectorOf(lua_State *L, Companion last, Vec2 value)
{
    // 0 and -0 are two.
    const auto isSame = [](double a, double b) {
        return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
    };
    lua_getiuservalue(L, 1, last);
    const Vec2 *kept = vectorAt(L, -1);
    if (kept && isSame(kept->x, value.x) && isSame(kept->y, value.y))
        return;
    pushVector(L, value);
    lua_pushvalue(L, -1);
    lua_setiuservalue(L, 1, last);
}

int index(lua_State *L)
{
    const int circle = circleAt(L, 1);
    const Circle &c = ScriptHost::of(L).circles[static_cast<std::size_t>(circle)];
    switch (fieldAt(L, 2)) {
    case Field::Position:
        pushVectorOf(L, LastPosition, c.position);
        return 1;
    case Field::Velocity:
        pushVectorOf(L, LastVelocity, c.velocity);
        return 1;
    case Field::Radius:
        lua_pushnumber(L, c.radius);
        return 1;
    case Field::Density:
        lua_pushnumber(L, c.density);
        return 1;
    case Field::Index:
        lua_pushinteger(L, circle + 1);
        return 1;
    case Field::Own:
        break;
    }
    return pushOwnField(L, circle, keyAt(L, 2, circle));
}

/// "circle1.velocity", for messages.
QString fieldName(int circle, const char *key)
{
    return circleName(circle) + QLatin1Char('.') + QLatin1String(key);
}

Vec2 newVector(lua_State *L, int circle, const char *key)
{
    const Vec2 *v = vectorAt(L, 3);
    if (lua_isnil(L, 3))
        raise(L, CircleText::tr("%1 must be a vector, not nil: what it is to become has no value "
                                "here")
                     .arg(fieldName(circle, key)));
    if (!v)
        raise(L, CircleText::tr("%1 must be a vector, not %2; write vec(x, y)")
                     .arg(fieldName(circle, key), nameValue(L, 3)));
    if (!isFinite(*v))
        raise(L, CircleText::tr("%1 would be %2; every number of a circle must be finite. Look "
                                "for a division by zero, or for a value that grows in every step")
                     .arg(fieldName(circle, key), describeValue(L, 3)));
    return *v;
}

double newNumber(lua_State *L, int circle, const char *key)
{
    if (lua_type(L, 3) != LUA_TNUMBER)
        raise(L, CircleText::tr("%1 must be a number, not %2")
                     .arg(fieldName(circle, key), nameValue(L, 3)));
    const double value = lua_tonumber(L, 3);
    if (!std::isfinite(value) || value <= 0.0)
        raise(L, CircleText::tr("%1 would be %2; it must be finite and above 0")
                     .arg(fieldName(circle, key), describeValue(L, 3)));
    return value;
}

int setField(lua_State *L)
{
    const int circle = circleAt(L, 1);
    const Field field = fieldAt(L, 2);
    const char *key =
        field == Field::Own ? keyAt(L, 2, circle) : fieldNames[static_cast<std::size_t>(field)];
    ScriptHost &host = ScriptHost::of(L);
    Circle &c = host.circles[static_cast<std::size_t>(circle)];
    const bool startPinned = host.pinned && host.loading;
    switch (field) {
    case Field::Position:
    case Field::Velocity: {
        const Vec2 value = newVector(L, circle, key);
        Vec2 &old = *key == 'p' ? c.position : c.velocity;
        noteAssignment(L, circle, assignedField(*key), !startPinned && value != old);
        if (startPinned)
            return 0;
        if (host.loading && value != old)
            refuseIfLocked(L, circle, key);
        old = value;
        lua_settop(L, 3);
        lua_setiuservalue(L, 1, *key == 'p' ? LastPosition : LastVelocity);
        return 0;
    }
    case Field::Radius:
    case Field::Density: {
        const double value = newNumber(L, circle, key);
        double &old = *key == 'r' ? c.radius : c.density;
        noteAssignment(L, circle, assignedField(*key), !host.pinned && value != old);
        if (host.pinned)
            return 0;
        if (value != old)
            refuseIfLocked(L, circle, key);
        old = value;
        return 0;
    }
    case Field::Index:
        raise(L, CircleText::tr("%1.index is given and cannot be changed").arg(circleName(circle)));
    case Field::Own:
        break;
    }
    setOwnField(L, circle, key);
    return 0;
}

} // namespace

int circleAt(lua_State *L, int index)
{
    // Of anything but userdata it is null; light ones, without a kind, no program has.
    const auto *object = static_cast<const CircleObject *>(lua_touserdata(L, index));
    return object && object->kind == ObjectKind::Circle ? object->index : -1;
}

void pushCircle(lua_State *L, int index)
{
    lua_rawgeti(L, LUA_REGISTRYINDEX, registry::circleTable);
    lua_rawgeti(L, -1, index + 1);
    lua_remove(L, -2);
}

void pushCircles(lua_State *L)
{
    lua_createtable(L, 0, 4 + static_cast<int>(fieldNames.size()));
    constexpr luaL_Reg functions[] = {{"__index", index},
                                      {"__newindex", setField},
                                      {"__tostring", describeObject},
                                      {nullptr, nullptr}};
    luaL_setfuncs(L, functions, 0);
    lua_pushliteral(L, "circle");
    lua_setfield(L, -2, "__name");
    for (std::size_t i = 0; i < fieldNames.size(); ++i)
        ScriptHost::of(L).fieldKeys[i] = keepKey(L, fieldNames[i]);
    lua_rawseti(L, LUA_REGISTRYINDEX, registry::circleMetatable);

    const auto count = static_cast<int>(ScriptHost::of(L).circles.size());
    lua_createtable(L, count, 0);
    for (int i = 0; i < count; ++i) {
        new (lua_newuserdatauv(L, sizeof(CircleObject), LastVelocity))
            CircleObject{ObjectKind::Circle, i};
        lua_newtable(L);
        lua_setiuservalue(L, -2, ownFieldsOfCircle);
        lua_rawgeti(L, LUA_REGISTRYINDEX, registry::circleMetatable);
        lua_setmetatable(L, -2);
        lua_rawseti(L, -2, i + 1);
    }
    lua_rawseti(L, LUA_REGISTRYINDEX, registry::circleTable);

    pushCircleList(L);
}

} // namespace cradle
