// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/script_host.h"

namespace cradle {

namespace {

constexpr qint64 instructionsPerError = 1000;

} // namespace

void raise(lua_State *L, const QString &message)
{
    ScriptHost::of(L).instructions += instructionsPerError;
    const QByteArray text = message.toUtf8();
    lua_pushlstring(L, text.constData(), static_cast<std::size_t>(text.size()));
    lua_error(L);
    Q_UNREACHABLE();
}

void abortRun(lua_State *L, ProgramError::Kind kind, const QString &message)
{
    ScriptHost &host = ScriptHost::of(L);
    if (!host.aborted)
        host.aborted = kind;
    raise(L, message);
}

} // namespace cradle
