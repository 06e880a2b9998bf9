// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/unknown_name.h"

#include "tasks/script/lua_library.h"
#include "tasks/script/meant.h"
#include "tasks/script/nearest_name.h"
#include "tasks/script/registry_keys.h"
#include "tasks/script/sandbox.h"
#include "tasks/script/script_host.h"

#include <QCoreApplication>
#include <QStringList>

namespace cradle {

namespace {

struct WorldText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// Names among which the nearest is looked for; a program of the lab has a handful.
constexpr qsizetype mostNames = 1000;
constexpr lua_Unsigned longestKnownName = 64;
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
        if (lua_type(L, -2) == LUA_TSTRING && lua_rawlen(L, -2) <= longestKnownName)
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

} // namespace

void refuseUnknown(lua_State *L, const QString &name)
{
    if (ScriptHost::of(L).wordless)
        raise(L, {});
    const QString unknown =
        WorldText::tr("`%1` is not known: nothing of that name was given a value before");
    if (name.size() > static_cast<qsizetype>(longestKnownName))
        raise(L, unknown.arg(name.left(longestKnownName) + QStringLiteral("…")));
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

void refuseSlip(lua_State *L, const QString &name)
{
    ScriptHost::of(L).instructions += instructionsPerName;
    for (const char *known : {"on_load", "on_update", "gravity", "restitution"}) {
        const QString right = QLatin1String(known);
        if (!name.startsWith(right) && editDistance(name.toLower(), right) <= 2)
            raise(L, WorldText::tr("`%1` is not known: did you mean `%2`?").arg(name, right));
    }
}

} // namespace cradle
