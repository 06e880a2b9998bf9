// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_script.h"

#include "tasks/checks/run_binding.h"
#include "tasks/script/error_message.h"
#include "tasks/script/lua_library.h"
#include "tasks/script/sandbox.h"
#include "tasks/script/script_host.h"
#include "tasks/script/script_limits.h"
#include "tasks/script/script_source.h"
#include "tasks/script/show_binding.h"
#include "tasks/script/vector_binding.h"

#include <QCoreApplication>

#include <cmath>
#include <utility>

namespace cradle {

namespace {

struct CheckText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

constexpr qsizetype longestMessage = 1000; ///< more would not be read
constexpr qsizetype longestUnit = 20;

int setUp(lua_State *L)
{
    addLibraries(L);
    addVectors(L);
    addShowing(L);
    return 0;
}

int pushRunHere(lua_State *L)
{
    pushRun(L, *static_cast<RunView *>(lua_touserdata(L, 1)));
    return 1;
}

/// One check in a Lua state of its own.
class CheckProgram
{
public:
    explicit CheckProgram(const QString &source)
        : m_source(source)
    {
        m_host.source = source;
        m_host.quiet = true;
    }

    /// Leaves the function `check` on the stack, above the message handler.
    std::optional<ProgramError> load()
    {
        if (auto error = tooLong(m_source))
            return error;
        m_state = newLuaState(m_host.memory);
        if (!m_state)
            return noMemory();
        lua_State *L = m_state;
        *static_cast<ScriptHost **>(lua_getextraspace(L)) = &m_host;
        lua_pushcfunction(L, setUp);
        if (lua_pcall(L, 0, 0, 0) != LUA_OK)
            return noMemory();
        lua_pushcfunction(L, catchError);
        beginCount(L);
        const int status = parse(L, m_source);
        endCount(L);
        if (status != LUA_OK)
            return errorOf(status);
        watch(L, false);
        if (auto error = call(0, 0))
            return error;
        if (lua_getglobal(L, "check") != LUA_TFUNCTION)
            return ProgramError{.message = CheckText::tr("there is no function check(run) … end")};
        return std::nullopt;
    }

    ScriptVerdict judge(const Observation &observation, const QString &language)
    {
        ScriptVerdict verdict;
        lua_State *L = m_state;
        RunView view{observation, language};
        beginCount(L);
        lua_pushcfunction(L, pushRunHere);
        lua_pushlightuserdata(L, &view);
        int status = lua_pcall(L, 1, 1, 1);
        endCount(L);
        if (status != LUA_OK)
            verdict.error = errorOf(status);
        else
            verdict.error = call(1, 3);
        if (!verdict.error)
            read(verdict, observation);
        return verdict;
    }

private:
    std::optional<ProgramError> call(int arguments, int results)
    {
        lua_State *L = m_state;
        beginCount(L);
        m_host.caught = {};
        const int status = lua_pcall(L, arguments, results, 1);
        endCount(L);
        return status == LUA_OK ? std::nullopt : std::optional(errorOf(status));
    }

    ProgramError errorOf(int status)
    {
        lua_State *L = m_state;
        ProgramError error = errorAtTop(
            L, m_host.aborted == ProgramError::Kind::Memory ? LUA_ERRMEM : status, m_source);
        if (m_host.aborted)
            error.kind = *m_host.aborted;
        if (error.kind == ProgramError::Kind::Memory)
            error.line = m_host.memory.refusedLine();
        else if (m_host.caught.line > 0)
            error.line = m_host.caught.line;
        error.locals = std::exchange(m_host.caught, {}).locals;
        return error;
    }

    /// The three results, on the top of the stack.
    void read(ScriptVerdict &verdict, const Observation &observation)
    {
        lua_State *L = m_state;
        if (lua_type(L, -3) != LUA_TBOOLEAN) {
            verdict.error = ProgramError{
                .message = CheckText::tr("check(run) returned %1; true, or false and a message, is "
                                         "right")
                               .arg(nameValue(L, -3))};
            return;
        }
        verdict.passed = lua_toboolean(L, -3) != 0;
        if (verdict.passed)
            return;
        std::size_t size = 0;
        const char *text = lua_type(L, -2) == LUA_TSTRING ? lua_tolstring(L, -2, &size) : nullptr;
        if (!text || size == 0) {
            verdict.error = ProgramError{
                .message = CheckText::tr("check(run) returned false without a message for the "
                                         "student; return false, \"what is wrong\" is right")};
            return;
        }
        verdict.message = printable(text, size, longestMessage);
        if (lua_type(L, -1) != LUA_TTABLE)
            return;
        verdict.time = number("time");
        verdict.expected = number("expected");
        verdict.observed = number("observed");
        lua_pushliteral(L, "unit");
        lua_rawget(L, -2);
        if (lua_type(L, -1) == LUA_TSTRING) {
            const char *unit = lua_tolstring(L, -1, &size);
            verdict.unit = printable(unit, size, longestUnit);
        }
        lua_pop(L, 1);
        if (verdict.time)
            verdict.time =
                std::clamp(*verdict.time, 0.0, observation.states.time(observation.steps()));
    }

    /// A finite number of the table on the top of the stack.
    std::optional<double> number(const char *name)
    {
        lua_State *L = m_state;
        lua_pushstring(L, name);
        lua_rawget(L, -2);
        const double value = lua_type(L, -1) == LUA_TNUMBER ? lua_tonumber(L, -1) : std::nan("");
        lua_pop(L, 1);
        return std::isfinite(value) ? std::optional(value) : std::nullopt;
    }

    /// One line of at most \p most letters.
    static QString printable(const char *text, std::size_t size, qsizetype most)
    {
        QString line = QString::fromUtf8(text, static_cast<qsizetype>(
                                                   std::min<std::size_t>(size, 8 * longestMessage)))
                           .left(most);
        for (QChar &letter : line) {
            if (letter.category() == QChar::Other_Control || letter == QChar::ReplacementCharacter)
                letter = QLatin1Char(' ');
        }
        return line;
    }

    const QString &m_source;
    ScriptHost m_host{limits::scriptBytes};
    lua_State *m_state = nullptr; ///< ends with the memory of m_host
};

} // namespace

ScriptVerdict runCheckScript(const QString &source, const Observation &observation,
                             const QString &language)
{
    CheckProgram program(source);
    if (auto error = program.load()) {
        ScriptVerdict verdict;
        verdict.error = std::move(error);
        return verdict;
    }
    return program.judge(observation, language);
}

std::optional<ProgramError> findCheckScriptError(const QString &source)
{
    return CheckProgram(source).load();
}

} // namespace cradle
