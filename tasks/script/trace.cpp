// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/trace.h"

#include "tasks/script/sandbox.h"
#include "tasks/script/student_engine.h"

#include <algorithm>

namespace cradle {

namespace {

// A program may assign a million times, a thousand calls deep.
constexpr std::size_t mostAssignments = 20'000;
constexpr std::size_t mostCalls = 50;

/// The lines of the program on the stack, outermost first; the last is the one that runs.
std::vector<int> linesOnStack(lua_State *L)
{
    std::vector<int> lines;
    lua_Debug where{};
    for (int level = 0; lines.size() <= mostCalls && lua_getstack(L, level, &where) != 0; ++level) {
        lua_getinfo(L, "Sl", &where);
        if (where.currentline > 0 && isOfProgram(where))
            lines.push_back(where.currentline);
    }
    std::reverse(lines.begin(), lines.end());
    return lines;
}

} // namespace

void noteAssignment(lua_State *L, int circle, Assignment::Field field, bool changed)
{
    Trace *trace = ScriptHost::of(L).trace;
    if (!trace)
        return;
    std::vector<Assignment> &all = trace->assignments;
    if (all.size() == mostAssignments)
        all.erase(all.begin(), all.begin() + mostAssignments / 2);
    Assignment assignment{.circle = circle, .field = field, .changed = changed};
    assignment.calls = linesOnStack(L);
    if (!assignment.calls.empty()) {
        assignment.line = assignment.calls.back();
        assignment.calls.pop_back();
    }
    all.push_back(std::move(assignment));
}

/// One update of \p world, written down. A step that fails has done what it has done.
Trace StudentScript::traced(World world, double dt)
{
    Trace trace;
    ScriptHost &host = m_engine->host;
    host.trace = &trace;
    lua_State *L = m_engine->state;
    watch(L, true);
    (void)advance(world, dt);
    watch(L, false);
    host.trace = nullptr;
    return trace;
}

std::vector<Assignment> StudentScript::traceStart(Preset scene)
{
    Trace trace;
    m_startTrace = &trace;
    (void)begin(scene);
    m_startTrace = nullptr;
    if (m_engine)
        m_engine->host.trace = nullptr;
    return trace.assignments;
}

std::vector<Assignment> StudentScript::trace(const World &world, double dt)
{
    return traced(world, dt).assignments;
}

std::vector<int> StudentScript::linesOf(const World &world, double dt)
{
    const std::set<int> lines = traced(world, dt).lines;
    return {lines.begin(), lines.end()};
}

} // namespace cradle
