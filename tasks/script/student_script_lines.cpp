// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/student_script.h"

#include "tasks/script/registry_keys.h"
#include "tasks/script/sandbox.h"
#include "tasks/script/student_engine.h"

#include <utility>

namespace cradle {

// An update line by line: a coroutine that the line hook lets yield.

StudentScript::Pause StudentScript::beginLines(const World &world, double dt)
{
    Q_ASSERT(m_moves);
    dropLines();
    lua_State *L = m_engine->state;
    place(world);
    lua_State *thread = lua_newthread(L);
    lua_rawseti(L, LUA_REGISTRYINDEX, registry::updateThread);
    m_engine->thread = thread;
    watch(thread, true);
    if (rawGlobal(thread, "on_update") != LUA_TFUNCTION) {
        dropLines();
        Pause pause;
        pause.circles = m_engine->host.circles;
        pause.error = lostUpdate();
        return pause;
    }
    lua_pushnumber(thread, dt);
    return resume(1);
}

StudentScript::Pause StudentScript::nextLine()
{
    if (!m_engine || !m_engine->thread)
        return {};
    return resume(0);
}

StudentScript::Pause StudentScript::resume(int arguments)
{
    lua_State *thread = m_engine->thread;
    beginCount(thread);
    int results = 0;
    const int status = lua_resume(thread, nullptr, arguments, &results);
    endCount(thread);
    ScriptHost &host = m_engine->host;
    Pause pause;
    pause.circles = host.circles;
    if (status == LUA_YIELD) {
        pause.line = host.caught.line;
        pause.locals = std::exchange(host.caught, {}).locals;
        return pause;
    }
    if (status != LUA_OK) {
        noteError(thread);
        pause.error = errorOf(thread, status);
        pause.line = pause.error->line;
    }
    dropLines();
    m_engine->linesDone = !pause.error;
    return pause;
}

/// The rest of an update that was begun line by line.
std::optional<ProgramError> StudentScript::endLines(World &world)
{
    if (m_engine->thread) {
        watch(m_engine->thread, false);
        if (const Pause end = nextLine(); end.error)
            return end.error;
    }
    m_engine->linesDone = false;
    world.circles = m_engine->host.circles;
    return std::nullopt;
}

void StudentScript::dropLines()
{
    if (!m_engine)
        return;
    m_engine->linesDone = false;
    if (!m_engine->thread)
        return;
    lua_pushnil(m_engine->state);
    lua_rawseti(m_engine->state, LUA_REGISTRYINDEX, registry::updateThread);
    m_engine->thread = nullptr;
}

} // namespace cradle
