// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/student_script.h"

#include "tasks/script/error_message.h"
#include "tasks/script/locks.h"
#include "tasks/script/lua_library.h"
#include "tasks/script/sandbox.h"
#include "tasks/script/script_source.h"
#include "tasks/script/show_binding.h"
#include "tasks/script/student_engine.h"
#include "tasks/script/vector_binding.h"
#include "tasks/script/work_bound.h"
#include "tasks/script/work_limit.h"
#include "tasks/script/world_binding.h"

#include <QCoreApplication>

#include <utility>

namespace cradle {

namespace {

struct StudentText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

int setUp(lua_State *L)
{
    addLibrariesLate(L);
    addVectors(L);
    addShowing(L);
    addWorld(L);
    return 0;
}

} // namespace

int rawGlobal(lua_State *L, const char *name)
{
    lua_pushglobaltable(L);
    lua_pushstring(L, name);
    const int type = lua_rawget(L, -2);
    lua_remove(L, -2);
    return type;
}

StudentScript::StudentScript(QString source, Options options)
    : m_source(std::move(source))
    , m_options(std::move(options))
{
}

StudentScript::~StudentScript() = default;

std::optional<ProgramError> StudentScript::begin(Preset &scene)
{
    m_moves = false;
    if (auto error = tooLong(m_source))
        return error;
    m_engine = std::make_unique<Engine>();
    WorkLimit::count(WorkLimit::ofBegin);
    ScriptHost &host = m_engine->host;
    host.source = m_source;
    host.pinned = m_options.pinned;
    host.quiet = m_options.quiet;
    host.silent = m_options.silent;
    host.wordless = m_options.silent && m_options.once;
    host.mostInstructions = m_options.mostWork;
    host.timed = m_options.timed;
    host.stop = m_options.stop;
    host.trace = m_startTrace;
    host.gravity = scene.gravity;
    host.restitution = scene.restitution;
    host.halfWidth = scene.halfWidth;
    host.circles = initialWorld(scene).circles;
    for (const QString &field : m_options.locked)
        host.locked[field] = lockedName(field, scene);
    m_engine->state = newLuaState(host.memory);
    lua_State *L = m_engine->state;
    if (!L)
        return noMemory();
    *static_cast<ScriptHost **>(lua_getextraspace(L)) = &host;
    lua_pushcfunction(L, setUp);
    if (lua_pcall(L, 0, 0, 0) != LUA_OK)
        return noMemory();
    if (auto error = load(L))
        return error;
    scene.gravity = host.gravity;
    scene.restitution = host.restitution;
    for (std::size_t i = 0; i < host.circles.size(); ++i)
        scene.circles[i].body = host.circles[i];
    const int type = rawGlobal(L, "on_update");
    lua_settop(L, 0);
    if (type != LUA_TFUNCTION && type != LUA_TNIL)
        return lostUpdate();
    m_moves = type == LUA_TFUNCTION;
    host.loading = false;
    return checkScene(scene);
}

std::optional<ProgramError> StudentScript::load(lua_State *L)
{
    lua_pushcfunction(L, catchError);
    beginCount(L);
    const int status = parse(L, m_source, m_options.once);
    endCount(L);
    if (status != LUA_OK)
        return errorOf(L, status);
    // Nobody reads what is meant by a program that is made and run but once.
    if (auto error = m_options.once ? std::nullopt : meantOtherwise(m_source))
        return error;
    if (m_engine->host.memory.longestText() < limits::textBytesPerInstruction
        && takesLittle(m_source, m_engine->host.circles.size()))
        leaveCountOut(L);
    watch(L, false);
    if (auto error = call(0))
        return error;
    if (rawGlobal(L, "on_load") == LUA_TFUNCTION)
        return call(0);
    lua_settop(L, 1);
    return std::nullopt;
}

/// Calls the function below the arguments; the message handler lies at the bottom of the stack.
std::optional<ProgramError> StudentScript::call(int arguments)
{
    lua_State *L = m_engine->state;
    beginCount(L);
    if (m_engine->host.counts && lua_gethookmask(L) == 0)
        watch(L, false); // It began in a thread of this one.
    m_engine->host.caught = {};
    const int status = lua_pcall(L, arguments, 0, 1);
    endCount(L);
    const ScriptHost &host = m_engine->host;
    WorkLimit::count(host.counts ? host.instructions : WorkLimit::ofUncountedCall);
    if (status != LUA_OK)
        return errorOf(L, status);
    return std::nullopt;
}

/// Where the laws move the circles, they need a scene that can be run; one that keeps its values
/// is as it was made.
std::optional<ProgramError> StudentScript::checkScene(const Preset &scene) const
{
    if (m_moves || m_options.pinned)
        return std::nullopt;
    const std::optional<Error> fault = findFault(scene);
    if (!fault)
        return std::nullopt;
    return ProgramError{
        .message =
            StudentText::tr("after on_load the scene cannot be run: %1").arg(fault->toString())};
}

ProgramError StudentScript::errorOf(lua_State *L, int status)
{
    ScriptHost &host = m_engine->host;
    ProgramError error;
    if (!host.silent)
        error = errorAtTop(L, host.aborted == ProgramError::Kind::Memory ? LUA_ERRMEM : status,
                           m_source);
    if (host.aborted)
        error.kind = *host.aborted;
    if (error.kind == ProgramError::Kind::Memory)
        error.line = host.memory.refusedLine();
    else if (host.caught.line > 0)
        error.line = host.caught.line;
    error.locals = std::exchange(host.caught, {}).locals;
    error.step = host.loading ? 0 : host.step + 1;
    error.time = host.time;
    lua_settop(L, 0);
    return error;
}

void StudentScript::place(const World &world)
{
    ScriptHost &host = m_engine->host;
    host.circles = world.circles;
    host.time = world.time;
    host.step = world.step;
}

std::optional<ProgramError> StudentScript::advance(World &world, double dt)
{
    Q_ASSERT(m_moves);
    if (m_engine->thread || m_engine->linesDone)
        return endLines(world);
    lua_State *L = m_engine->state;
    place(world);
    lua_settop(L, 0);
    lua_pushcfunction(L, catchError);
    if (rawGlobal(L, "on_update") != LUA_TFUNCTION)
        return lostUpdate();
    lua_pushnumber(L, dt);
    if (auto error = call(1))
        return error;
    world.circles = m_engine->host.circles;
    return std::nullopt;
}

/// The program put something else in the place of its update.
ProgramError StudentScript::lostUpdate() const
{
    const ScriptHost &host = m_engine->host;
    return {.message = StudentText::tr("`on_update` is no function any more; it is given once: "
                                       "function on_update(timestep) … end"),
            .step = host.loading ? 0 : host.step + 1,
            .time = host.time};
}

ProgramOutput StudentScript::takeOutput()
{
    return m_engine ? std::exchange(m_engine->host.output, {}) : ProgramOutput{};
}

void StudentScript::setRestitution(double restitution)
{
    m_engine->host.restitution = restitution;
}

qint64 StudentScript::instructions() const
{
    return m_engine ? m_engine->host.earlierInstructions + m_engine->host.instructions : 0;
}

std::vector<CircleField> StudentScript::ownFields() const
{
    return m_engine ? cradle::ownFields(m_engine->state) : std::vector<CircleField>{};
}

} // namespace cradle
