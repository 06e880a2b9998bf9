// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/vector_binding.h"

#include "tasks/script/nearest_name.h"
#include "tasks/script/registry_keys.h"
#include "tasks/script/script_host.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <array>
#include <new>

namespace cradle {

namespace {

struct VectorText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

constexpr qsizetype longestLine = 300; ///< letters in which an assignment is looked for

/// Operands of an arithmetic function: numbers and vectors as they come.
struct Operand {
    const Vec2 *vector = nullptr;
    double number = 0.0;
    bool isNumber = false;
};

Operand operandAt(lua_State *L, int index)
{
    Operand operand;
    operand.vector = vectorAt(L, index);
    if (!operand.vector && lua_type(L, index) == LUA_TNUMBER) {
        operand.isNumber = true;
        operand.number = lua_tonumber(L, index);
    }
    return operand;
}

[[noreturn]] void refuse(lua_State *L, const QString &sign, const QString &right)
{
    raise(L, VectorText::tr("%1 %2 %3 has no meaning: %4")
                 .arg(nameValue(L, 1), sign, nameValue(L, 2), right));
}

int add(lua_State *L)
{
    const Vec2 *a = vectorAt(L, 1);
    const Vec2 *b = vectorAt(L, 2);
    if (!a || !b)
        refuse(L, QStringLiteral("+"), VectorText::tr("a vector is added to a vector"));
    pushVector(L, *a + *b);
    return 1;
}

int subtract(lua_State *L)
{
    const Vec2 *a = vectorAt(L, 1);
    const Vec2 *b = vectorAt(L, 2);
    if (!a || !b)
        refuse(L, QStringLiteral("-"), VectorText::tr("a vector is taken from a vector"));
    pushVector(L, *a - *b);
    return 1;
}

int multiply(lua_State *L)
{
    const Operand a = operandAt(L, 1);
    const Operand b = operandAt(L, 2);
    if (a.vector && b.isNumber)
        pushVector(L, b.number * *a.vector);
    else if (a.isNumber && b.vector)
        pushVector(L, a.number * *b.vector);
    else if (a.vector && b.vector)
        refuse(L, QStringLiteral("*"),
               VectorText::tr("a vector is multiplied by a number; for the dot product write "
                              "a:dot(b)"));
    else
        refuse(L, QStringLiteral("*"), VectorText::tr("a vector is multiplied by a number"));
    return 1;
}

int divide(lua_State *L)
{
    const Operand a = operandAt(L, 1);
    const Operand b = operandAt(L, 2);
    if (!a.vector || !b.isNumber)
        refuse(L, QStringLiteral("/"), VectorText::tr("a vector is divided by a number"));
    pushVector(L, *a.vector / b.number);
    return 1;
}

int negate(lua_State *L)
{
    pushVector(L, -*vectorAt(L, 1));
    return 1;
}

int equals(lua_State *L)
{
    const Vec2 *a = vectorAt(L, 1);
    const Vec2 *b = vectorAt(L, 2);
    lua_pushboolean(L, static_cast<int>(a && b && *a == *b));
    return 1;
}

int concatenate(lua_State *L)
{
    luaL_tolstring(L, 1, nullptr);
    luaL_tolstring(L, 2, nullptr);
    lua_concat(L, 2);
    return 1;
}

/// x and y at once; methods from the table in upvalue 1.
int readComponent(lua_State *L)
{
    const Vec2 *v = vectorAt(L, 1);
    const void *key = lua_topointer(L, 2);
    const ScriptHost &host = ScriptHost::of(L);
    if (v && (key == host.xKey || key == host.yKey)) {
        lua_pushnumber(L, key == host.xKey ? v->x : v->y);
        return 1;
    }
    lua_pushvalue(L, 2);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL)
        return 1;
    static const QStringList names{QStringLiteral("x"),
                                   QStringLiteral("y"),
                                   QStringLiteral("length"),
                                   QStringLiteral("length_squared"),
                                   QStringLiteral("normalized"),
                                   QStringLiteral("dot"),
                                   QStringLiteral("perpendicular")};
    const QString name = describeValue(L, 2).remove(QLatin1Char('"'));
    const QString near = nearestName(name, names);
    raise(L, near.isEmpty()
                 ? VectorText::tr("a vector has no `%1`; it has %2")
                       .arg(name, names.join(QStringLiteral(", ")))
                 : VectorText::tr("a vector has no `%1`: did you mean `%2`?").arg(name, near));
}

/// Says what to write instead, from the very line if it can be read.
int refuseChange(lua_State *L)
{
    const ScriptHost &host = ScriptHost::of(L);
    const QString line =
        host.source.section(QLatin1Char('\n'), currentLine(L) - 1, currentLine(L) - 1)
            .left(longestLine);
    static const QRegularExpression assignment(QStringLiteral(
        "([A-Za-z_][A-Za-z_0-9.\\[\\]]*)\\.([xy])\\s*=\\s*([^=;]+?)\\s*(?:;|--|end\\b|$)"));
    const QRegularExpressionMatch match = assignment.match(line);
    const QString vector =
        match.hasMatch() ? match.captured(1) : QStringLiteral("circle1.position");
    const QString value = match.hasMatch() ? match.captured(3) : QStringLiteral("…");
    const bool x = !match.hasMatch() || match.captured(2) == QLatin1String("x");
    raise(L, VectorText::tr("a vector cannot be changed; build a new one: %1 = %2")
                 .arg(vector, x ? QStringLiteral("vec(%1, %2.y)").arg(value, vector)
                                : QStringLiteral("vec(%1.x, %2)").arg(vector, value)));
}

Vec2 self(lua_State *L, const char *method)
{
    if (const Vec2 *v = vectorAt(L, 1))
        return *v;
    raise(L, VectorText::tr("`%1` belongs to a vector; write v:%1(), with a colon")
                 .arg(QLatin1String(method)));
}

int lengthOf(lua_State *L)
{
    lua_pushnumber(L, length(self(L, "length")));
    return 1;
}

int lengthSquaredOf(lua_State *L)
{
    lua_pushnumber(L, lengthSquared(self(L, "length_squared")));
    return 1;
}

int normalizedOf(lua_State *L)
{
    const Vec2 v = self(L, "normalized");
    if (lengthSquared(v) == 0.0)
        raise(L, VectorText::tr("the vector (0, 0) has no direction, so it cannot be normalized"));
    pushVector(L, normalized(v));
    return 1;
}

int perpendicularOf(lua_State *L)
{
    pushVector(L, perpendicular(self(L, "perpendicular")));
    return 1;
}

int dotOf(lua_State *L)
{
    const Vec2 a = vectorArgument(L, 1, QStringLiteral("dot"));
    // As if from a point: a.dot(b).
    if (lua_gettop(L) == 1)
        raise(L, VectorText::tr("dot got one vector and takes two: write a:dot(b) with a colon, or "
                                "dot(a, b)"));
    const Vec2 b = vectorArgument(L, 2, QStringLiteral("dot"));
    lua_pushnumber(L, dot(a, b));
    return 1;
}

int makeVector(lua_State *L)
{
    for (int i = 1; i <= 2; ++i) {
        if (lua_type(L, i) != LUA_TNUMBER)
            raise(L, VectorText::tr("vec(x, y) takes two numbers; %1 is %2")
                         .arg(i == 1 ? QStringLiteral("x") : QStringLiteral("y"), nameValue(L, i)));
    }
    if (lua_gettop(L) > 2)
        raise(L, VectorText::tr("vec(x, y) takes two numbers, not %1").arg(lua_gettop(L)));
    pushVector(L, {lua_tonumber(L, 1), lua_tonumber(L, 2)});
    return 1;
}

} // namespace

const void *keepKey(lua_State *L, const char *name)
{
    lua_pushstring(L, name);
    const void *key = lua_topointer(L, -1);
    lua_pushboolean(L, 1);
    lua_rawset(L, -3);
    return key;
}

const Vec2 *vectorAt(lua_State *L, int index)
{
    // Of anything but userdata it is null; light ones, without a kind, no program has.
    const auto *object = static_cast<const VectorObject *>(lua_touserdata(L, index));
    return object && object->kind == ObjectKind::Vector ? &object->value : nullptr;
}

void pushVector(lua_State *L, Vec2 value)
{
    new (lua_newuserdatauv(L, sizeof(VectorObject), 0)) VectorObject{ObjectKind::Vector, value};
    lua_rawgeti(L, LUA_REGISTRYINDEX, registry::vectorMetatable);
    lua_setmetatable(L, -2);
}

Vec2 vectorArgument(lua_State *L, int index, const QString &what)
{
    if (const Vec2 *v = vectorAt(L, index))
        return *v;
    raise(L, VectorText::tr("%1 needs a vector, not %2").arg(what, nameValue(L, index)));
}

void addVectors(lua_State *L)
{
    constexpr std::array<luaL_Reg, 9> operators{{{"__add", add},
                                                 {"__sub", subtract},
                                                 {"__mul", multiply},
                                                 {"__div", divide},
                                                 {"__unm", negate},
                                                 {"__eq", equals},
                                                 {"__tostring", describeObject},
                                                 {"__concat", concatenate},
                                                 {"__newindex", refuseChange}}};
    constexpr std::array<luaL_Reg, 5> methods{{{"length", lengthOf},
                                               {"length_squared", lengthSquaredOf},
                                               {"normalized", normalizedOf},
                                               {"perpendicular", perpendicularOf},
                                               {"dot", dotOf}}};
    lua_createtable(L, 0, static_cast<int>(operators.size()) + 4);
    for (const luaL_Reg &entry : operators) {
        lua_pushcfunction(L, entry.func);
        lua_setfield(L, -2, entry.name);
    }
    lua_createtable(L, 0, static_cast<int>(methods.size()));
    for (const luaL_Reg &entry : methods) {
        lua_pushcfunction(L, entry.func);
        lua_setfield(L, -2, entry.name);
    }
    lua_pushcclosure(L, readComponent, 1);
    lua_setfield(L, -2, "__index");
    lua_pushliteral(L, "vector");
    lua_setfield(L, -2, "__name");
    ScriptHost::of(L).xKey = keepKey(L, "x");
    ScriptHost::of(L).yKey = keepKey(L, "y");
    lua_rawseti(L, LUA_REGISTRYINDEX, registry::vectorMetatable);
    lua_register(L, "vec", makeVector);
    lua_register(L, "dot", dotOf);
}

} // namespace cradle
