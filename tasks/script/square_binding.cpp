// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/square_binding.h"

#include "tasks/script/nearest_name.h"
#include "tasks/script/script_host.h"
#include "tasks/script/vector_binding.h"

#include <QCoreApplication>

#include <new>

namespace cradle {

namespace {

struct SquareText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

[[noreturn]] void refuseSquareField(lua_State *L)
{
    const QStringList names{QStringLiteral("half_width"), QStringLiteral("left"),
                            QStringLiteral("right"), QStringLiteral("bottom"),
                            QStringLiteral("top")};
    const QString key =
        lua_type(L, 2) == LUA_TSTRING ? QString::fromUtf8(lua_tostring(L, 2)) : describeValue(L, 2);
    const QString near = nearestName(key, names);
    raise(L, near.isEmpty()
                 ? SquareText::tr("square has no `%1`; it has %2")
                       .arg(key, names.join(QStringLiteral(", ")))
                 : SquareText::tr("square has no `%1`: did you mean `%2`?").arg(key, near));
}

int readSquare(lua_State *L)
{
    const double half = ScriptHost::of(L).halfWidth;
    const std::string_view key = textAt(L, 2);
    const bool low = key == "left" || key == "bottom";
    const bool high = key == "right" || key == "top" || key == "half_width";
    if (!low && !high)
        refuseSquareField(L);
    lua_pushnumber(L, low ? -half : half);
    return 1;
}

int refuseSquareChange(lua_State *L)
{
    raise(L, SquareText::tr("the square can only be read"));
}

} // namespace

void addSquare(lua_State *L)
{
    new (lua_newuserdatauv(L, sizeof(ObjectKind), 0)) ObjectKind{ObjectKind::Square};
    lua_createtable(L, 0, 4);
    lua_pushcfunction(L, readSquare);
    lua_setfield(L, -2, "__index");
    lua_pushcfunction(L, refuseSquareChange);
    lua_setfield(L, -2, "__newindex");
    lua_pushliteral(L, "square");
    lua_setfield(L, -2, "__name");
    lua_pushcfunction(L, describeObject);
    lua_setfield(L, -2, "__tostring");
    lua_setmetatable(L, -2);
    lua_setglobal(L, "square");
}

} // namespace cradle
