// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"
#include "tasks/script/asked_fields.h"
#include "tasks/script/lua_state.h"
#include "tasks/script/script_limits.h"
#include "tasks/script/trace.h"

#include <QStringList>

#include <array>
#include <chrono>
#include <functional>
#include <locale.h>
#include <map>
#include <string_view>

namespace cradle {

/// What the functions that a program calls work on: the world of the moment, what was shown, and
/// how much was used. One per Lua state; every function finds it by of().
struct ScriptHost {
    explicit ScriptHost(std::size_t mostMemory)
        : memory(mostMemory)
    {
    }

    [[nodiscard]] static ScriptHost &of(lua_State *L)
    {
        return **static_cast<ScriptHost **>(lua_getextraspace(L));
    }

    // The world.
    std::vector<Circle> circles{};
    Vec2 gravity{};
    double restitution = 1.0;
    double halfWidth = 4.0; ///< m
    double time = 0.0;      ///< s, at the start of the step
    qint64 step = 0;        ///< steps made
    bool loading = true;    ///< the file or on_load runs
    /// The scene keeps its values: what on_load assigns is ignored, and so are gravity,
    /// restitution, radii and densities ever after.
    bool pinned = false;
    /// What the step fixes, by the names of locks.h, with what people call it.
    std::map<QString, QString> locked{};

    // Where Lua keeps the names that are looked for in every step: one place a name.
    const void *xKey = nullptr;
    const void *yKey = nullptr;
    std::array<const void *, 5> fieldKeys{}; ///< of circles, see circle_binding.cpp

    /// The libraries that are in their global or were, by the order in lateLibraries.
    std::array<bool, 3> opened{};

    // What was shown.
    bool quiet = false;    ///< nobody looks: count it and drop it
    bool silent = false;   ///< nobody reads what errors say
    bool wordless = false; ///< nor may the program itself, and nobody asks what it took
    ProgramOutput output{};
    qint64 outputBytes = 0; ///< of this step

    // What was used; see script_limits.h.
    qint64 instructions = 0;        ///< of this step, and what counts as such
    qint64 earlierInstructions = 0; ///< of all steps before
    qint64 mostInstructions = limits::instructionsPerStep; ///< of a step
    qint64 looks = 0;                                      ///< at what was used
    bool counts = true; ///< instructions; else there are few, see work_bound.h
    bool timed = false; ///< a step ends by the clock, too
    std::chrono::steady_clock::time_point deadline{};
    std::function<bool()> stop{}; ///< asked again and again; true ends the run
    LuaMemory memory;
    locale_t outerLocale{}; ///< of this thread while no program runs
    /// Set once a limit is passed; no pcall of the program stops that.
    std::optional<ProgramError::Kind> aborted{};

    // Where it is.
    QString source{};
    std::optional<AskedFields> asked{}; ///< of source, from when one is missed
    Trace *trace = nullptr;             ///< of the update that runs, if it is written down
    ProgramError caught{};              ///< the line and the locals of the last error
    /// Of the function where that was: its parameters that held nothing, and the line that called
    /// it; 0 if that is not known.
    QStringList missing{};
    int calledFrom = 0;
};

/// Raises an error of the program at its current line. Never returns. Counts what it costs to find
/// the words, since a program may catch it and go on.
[[noreturn]] void raise(lua_State *L, const QString &message);

/// Raises it so that no pcall stops it: a limit was passed.
[[noreturn]] void abortRun(lua_State *L, ProgramError::Kind kind, const QString &message);

/// Whether that function is of the program, not of a library; "S" must be there.
[[nodiscard]] bool isOfProgram(const lua_Debug &where);

/// The text at a place of the stack; empty if something else is there. Ends with a NUL.
[[nodiscard]] inline std::string_view textAt(lua_State *L, int index)
{
    std::size_t size = 0;
    const char *text = lua_type(L, index) == LUA_TSTRING ? lua_tolstring(L, index, &size) : "";
    return {text, size};
}

/// The line of the program that runs now; 0 if none does.
[[nodiscard]] int currentLine(lua_State *L);

/// Whether \p line stands within the innermost function of the program that runs.
[[nodiscard]] bool isInCurrentFunction(lua_State *L, int line);

} // namespace cradle
