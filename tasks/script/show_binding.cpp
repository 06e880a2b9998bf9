// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/show_binding.h"

#include "tasks/script/nearest_name.h"
#include "tasks/script/script_host.h"
#include "tasks/script/script_limits.h"
#include "tasks/script/vector_binding.h"

#include <QCoreApplication>

#include <array>
#include <cmath>

namespace cradle {

namespace {

struct ShowText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// What a point or a drawing counts, besides its text.
constexpr qint64 bytesPerItem = 64;
constexpr qsizetype longestLabel = 100;

void count(lua_State *L, qint64 bytes)
{
    ScriptHost &host = ScriptHost::of(L);
    host.outputBytes += bytes;
    if (host.outputBytes > limits::outputBytesPerStep)
        abortRun(L, ProgramError::Kind::Runtime,
                 ShowText::tr("the program shows more than %1 KiB in one step")
                     .arg(limits::outputBytesPerStep / 1024));
}

int print(lua_State *L)
{
    ScriptHost &host = ScriptHost::of(L);
    const int arguments = lua_gettop(L);
    QByteArray line;
    qint64 bytes = 1;
    for (int i = 1; i <= arguments; ++i) {
        if (host.quiet) {
            bytes += lua_type(L, i) == LUA_TSTRING ? static_cast<qint64>(lua_rawlen(L, i)) : 8;
            continue;
        }
        std::size_t size = 0;
        const char *text = pushText(L, i, &size);
        // A text that is too long is not worth a copy.
        count(L, static_cast<qint64>(size));
        if (i > 1)
            line += '\t';
        line.append(text, static_cast<qsizetype>(size));
        lua_pop(L, 1);
    }
    count(L, bytes);
    if (!host.quiet)
        host.output.text += QString::fromUtf8(line) + QLatin1Char('\n');
    return 0;
}

QString textArgument(lua_State *L, int index, const QString &what)
{
    const int type = lua_type(L, index);
    if (type != LUA_TSTRING && type != LUA_TNUMBER)
        raise(L, ShowText::tr("%1 must be a text, not %2").arg(what, nameValue(L, index)));
    std::size_t size = 0;
    const char *text = lua_tolstring(L, index, &size);
    count(L, static_cast<qint64>(size));
    return QString::fromUtf8(text, static_cast<qsizetype>(size));
}

QString optionalText(lua_State *L, int index, const QString &what)
{
    return lua_isnoneornil(L, index) ? QString() : textArgument(L, index, what);
}

int plot(lua_State *L)
{
    const QString name = textArgument(L, 1, ShowText::tr("the name in plot(name, number)"));
    if (name.isEmpty() || name.size() > longestLabel)
        raise(L, ShowText::tr("the name in plot(name, number) must have 1 to %1 letters")
                     .arg(longestLabel));
    if (lua_type(L, 2) != LUA_TNUMBER)
        raise(L, ShowText::tr("plot(name, number) takes a number, not %1").arg(nameValue(L, 2)));
    const double value = lua_tonumber(L, 2);
    if (!std::isfinite(value))
        raise(L, ShowText::tr("plot(\"%1\", …) would be %2; a finite number is right")
                     .arg(name, describeValue(L, 2)));
    count(L, bytesPerItem);
    ScriptHost &host = ScriptHost::of(L);
    if (!host.quiet)
        host.output.points.push_back({name, value});
    return 0;
}

Vec2 placeArgument(lua_State *L, int index, const QString &what)
{
    const Vec2 v = vectorArgument(L, index, what);
    if (!isFinite(v))
        raise(L, ShowText::tr("%1 would draw at %2; finite numbers are right")
                     .arg(what, describeValue(L, index)));
    return v;
}

int keep(lua_State *L, const Drawing &drawing)
{
    count(L, bytesPerItem);
    ScriptHost &host = ScriptHost::of(L);
    if (!host.quiet)
        host.output.drawings.push_back(drawing);
    return 0;
}

int drawArrow(lua_State *L)
{
    const QString what = QStringLiteral("draw.arrow(from, vector, colour, label)");
    const Vec2 from = placeArgument(L, 1, what);
    const Vec2 to = from + placeArgument(L, 2, what);
    if (!isFinite(to))
        raise(L, ShowText::tr("%1 would end beyond all numbers").arg(what));
    return keep(L, {.kind = Drawing::Kind::Arrow,
                    .from = from,
                    .to = to,
                    .colour = optionalText(L, 3, ShowText::tr("a colour")),
                    .text = optionalText(L, 4, ShowText::tr("a label"))});
}

int drawLine(lua_State *L)
{
    const QString what = QStringLiteral("draw.line(a, b, colour)");
    return keep(L, {.kind = Drawing::Kind::Line,
                    .from = placeArgument(L, 1, what),
                    .to = placeArgument(L, 2, what),
                    .colour = optionalText(L, 3, ShowText::tr("a colour"))});
}

int drawPoint(lua_State *L)
{
    return keep(L, {.kind = Drawing::Kind::Point,
                    .from = placeArgument(L, 1, QStringLiteral("draw.point(p, colour)")),
                    .colour = optionalText(L, 2, ShowText::tr("a colour"))});
}

int drawText(lua_State *L)
{
    return keep(L, {.kind = Drawing::Kind::Text,
                    .from = placeArgument(L, 1, QStringLiteral("draw.text(p, text)")),
                    .text = textArgument(L, 2, ShowText::tr("the text in draw.text(p, text)"))});
}

/// A member of draw that is not there.
int refuseUnknown(lua_State *L)
{
    const QString name = QString::fromUtf8(pushText(L, 2));
    const QStringList names{QStringLiteral("arrow"), QStringLiteral("line"),
                            QStringLiteral("point"), QStringLiteral("text")};
    const QString near = nearestName(name, names);
    raise(L, near.isEmpty() ? ShowText::tr("draw has no `%1`; it has %2")
                                  .arg(name, names.join(QStringLiteral(", ")))
                            : ShowText::tr("draw has no `%1`: did you mean `%2`?").arg(name, near));
}

} // namespace

void addShowing(lua_State *L)
{
    lua_register(L, "print", print);
    lua_register(L, "plot", plot);
    constexpr std::array<luaL_Reg, 4> functions{
        {{"arrow", drawArrow}, {"line", drawLine}, {"point", drawPoint}, {"text", drawText}}};
    lua_createtable(L, 0, static_cast<int>(functions.size()));
    for (const luaL_Reg &entry : functions) {
        lua_pushcfunction(L, entry.func);
        lua_setfield(L, -2, entry.name);
    }
    lua_newtable(L);
    lua_pushcfunction(L, refuseUnknown);
    lua_setfield(L, -2, "__index");
    lua_setmetatable(L, -2);
    lua_setglobal(L, "draw");
}

} // namespace cradle
