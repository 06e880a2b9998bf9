// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/script_host.h"
#include "tasks/script/vector_binding.h"
#include "tasks/script/world_binding.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct ValueText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

constexpr qsizetype longestText = 60; ///< letters of a string that are shown

QString figure(double value)
{
    return QString::number(value, 'g', 7);
}

QString shortened(const char *text, std::size_t size)
{
    const QString all = QString::fromUtf8(
        text, static_cast<qsizetype>(std::min<std::size_t>(size, longestText * 4)));
    return all.size() > longestText ? all.left(longestText) + QStringLiteral("…") : all;
}

} // namespace

const char *pushText(lua_State *L, int index, std::size_t *size)
{
    const int type = lua_type(L, index);
    if (type == LUA_TTABLE || type == LUA_TFUNCTION)
        lua_pushstring(L, lua_typename(L, type));
    else
        luaL_tolstring(L, index, nullptr);
    return lua_tolstring(L, -1, size);
}

QString describeValue(lua_State *L, int index)
{
    switch (lua_type(L, index)) {
    case LUA_TNUMBER:
        return lua_isinteger(L, index) ? QString::number(lua_tointeger(L, index))
                                       : figure(lua_tonumber(L, index));
    case LUA_TSTRING: {
        std::size_t size = 0;
        const char *text = lua_tolstring(L, index, &size);
        return QLatin1Char('"') + shortened(text, size) + QLatin1Char('"');
    }
    case LUA_TBOOLEAN:
        return lua_toboolean(L, index) ? QStringLiteral("true") : QStringLiteral("false");
    case LUA_TUSERDATA:
        if (const Vec2 *v = vectorAt(L, index))
            return QStringLiteral("(%1, %2)").arg(figure(v->x), figure(v->y));
        if (const int circle = circleAt(L, index); circle >= 0)
            return QStringLiteral("circle%1").arg(circle + 1);
        return *static_cast<const ObjectKind *>(lua_touserdata(L, index)) == ObjectKind::Square
                   ? QStringLiteral("square")
                   : QStringLiteral("circles");
    default:
        return QString::fromLatin1(luaL_typename(L, index));
    }
}

int describeObject(lua_State *L)
{
    lua_pushstring(L, describeValue(L, 1).toUtf8().constData());
    return 1;
}

QString nameValue(lua_State *L, int index)
{
    const QString value = describeValue(L, index);
    if (vectorAt(L, index))
        return ValueText::tr("the vector %1").arg(value);
    switch (lua_type(L, index)) {
    case LUA_TNUMBER:
        return ValueText::tr("the number %1").arg(value);
    case LUA_TSTRING:
        return ValueText::tr("the text %1").arg(value);
    case LUA_TTABLE:
        return ValueText::tr("a table");
    case LUA_TFUNCTION:
        return ValueText::tr("a function");
    case LUA_TNONE:
        return ValueText::tr("nothing");
    default:
        return value;
    }
}

} // namespace cradle
