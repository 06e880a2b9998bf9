// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/own_fields.h"

#include "tasks/script/circle_binding.h"
#include "tasks/script/nearest_name.h"
#include "tasks/script/script_host.h"
#include "tasks/script/world_binding.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct FieldText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// Of a circle that has more fields of the program's own none are told.
constexpr std::size_t mostFields = 100;

constexpr qint64 instructionsPerNewField = 50; ///< its name is compared with the engine's

const QStringList &engineFields()
{
    static const QStringList names{QStringLiteral("position"), QStringLiteral("velocity"),
                                   QStringLiteral("radius"), QStringLiteral("density"),
                                   QStringLiteral("index")};
    return names;
}

/// Whether it is one of the globals that addWorld() gives, and no circle's.
bool isOfWorld(const QString &name)
{
    static const QStringList names{QStringLiteral("gravity"), QStringLiteral("restitution"),
                                   QStringLiteral("time"), QStringLiteral("step")};
    return names.contains(name);
}

/// A new field whose name is all but an engine's.
void refuseSlip(lua_State *L, int circle, const char *key)
{
    ScriptHost::of(L).instructions += instructionsPerNewField;
    const QString name = QString::fromUtf8(key);
    for (const QString &known : engineFields()) {
        if (name.size() >= 5 && !name.startsWith(known) && editDistance(name, known) <= 2)
            raise(L, FieldText::tr("%1 has no field `%2`: did you mean `%3`?")
                         .arg(circleName(circle), name, known));
    }
}

} // namespace

QString circleName(int circle)
{
    return QStringLiteral("circle%1").arg(circle + 1);
}

int pushOwnField(lua_State *L, int circle, const char *key)
{
    lua_getiuservalue(L, 1, ownFieldsOfCircle);
    lua_pushvalue(L, 2);
    if (lua_rawget(L, -2) != LUA_TNIL)
        return 1;
    ScriptHost &host = ScriptHost::of(L);
    if (!host.asked)
        host.asked.emplace(host.source);
    if (host.asked->contains(currentLine(L), QString::fromUtf8(key)))
        return 1; // nil
    lua_pop(L, 1);
    QStringList known = engineFields();
    lua_pushnil(L);
    while (lua_next(L, -2) != 0) {
        if (lua_type(L, -2) == LUA_TSTRING)
            known.append(QString::fromUtf8(lua_tostring(L, -2)));
        lua_pop(L, 1);
        if (known.size() > static_cast<qsizetype>(mostFields)) {
            lua_pop(L, 1);
            break;
        }
    }
    const QString name = QString::fromUtf8(key);
    if (isOfWorld(name))
        raise(L,
              FieldText::tr("%1 has no field `%2`: it belongs to the whole world; write `%2` alone")
                  .arg(circleName(circle), name));
    const QString near = nearestName(name, known);
    if (!near.isEmpty())
        raise(L, FieldText::tr("%1 has no field `%2`: did you mean `%3`?")
                     .arg(circleName(circle), name, near));
    raise(L, FieldText::tr("%1 has no field `%2`; it has %3. A field of your own must be set "
                           "before it is read: %1.%2 = …")
                 .arg(circleName(circle), name, engineFields().join(QStringLiteral(", "))));
}

void setOwnField(lua_State *L, int circle, const char *key)
{
    lua_getiuservalue(L, 1, ownFieldsOfCircle);
    lua_pushvalue(L, 2);
    if (lua_rawget(L, -2) == LUA_TNIL)
        refuseSlip(L, circle, key);
    lua_pop(L, 1);
    lua_pushvalue(L, 2);
    lua_pushvalue(L, 3);
    lua_rawset(L, -3);
}

std::vector<CircleField> ownFields(lua_State *L)
{
    std::vector<CircleField> fields;
    const auto count = static_cast<int>(ScriptHost::of(L).circles.size());
    for (int i = 0; i < count; ++i) {
        pushCircle(L, i);
        lua_getiuservalue(L, -1, ownFieldsOfCircle);
        const std::size_t before = fields.size();
        lua_pushnil(L);
        while (lua_next(L, -2) != 0) {
            if (lua_type(L, -2) == LUA_TSTRING && lua_type(L, -1) == LUA_TNUMBER)
                fields.push_back({i, QString::fromUtf8(lua_tostring(L, -2)), lua_tonumber(L, -1)});
            lua_pop(L, 1);
            if (fields.size() > before + mostFields) {
                fields.resize(before);
                lua_pop(L, 1);
                break;
            }
        }
        lua_pop(L, 2);
    }
    std::sort(fields.begin(), fields.end(), [](const CircleField &a, const CircleField &b) {
        return a.circle != b.circle ? a.circle < b.circle : a.name < b.name;
    });
    return fields;
}

} // namespace cradle
