// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/locked_value.h"

#include "tasks/script/script_host.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct LockedText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

} // namespace

void refuseIfLocked(lua_State *L, const QString &field)
{
    const auto &locked = ScriptHost::of(L).locked;
    const auto found = locked.find(field);
    if (found == locked.end())
        return;
    raise(L, LockedText::tr("the author of this step has fixed this: %1. It stays as the scene "
                            "has it; take this line out")
                 .arg(found->second));
}

void refuseIfLocked(lua_State *L, int circle, const char *field)
{
    if (ScriptHost::of(L).locked.empty())
        return;
    const QString own = QStringLiteral("circles/%1/").arg(circle + 1);
    refuseIfLocked(L, own + QLatin1String(field));
    if (*field == 'r' || *field == 'd')
        refuseIfLocked(L, own + QStringLiteral("mass"));
}

} // namespace cradle
