// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/sandbox.h"

#include "tasks/script/script_host.h"
#include "tasks/script/script_limits.h"
#include "tasks/script/vector_binding.h"

#include <QCoreApplication>

#include <optional>
#include <utility>

namespace cradle {

namespace {

struct SandboxText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// Instructions between two looks at what was used: few, since one may copy a text of many MB.
constexpr qint64 instructionsPerLook = 100;

/// Looks between two at how deep calls are: that goes through all of them.
constexpr qint64 looksPerDepth = 16;

/// Unwinding the stack takes some microseconds.
constexpr qint64 instructionsPerCatch = 50;

/// Where 3/2 is 1.5, and texts are compared by their bytes, whatever language the desktop speaks.
locale_t plainLocale()
{
    static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
    return plain;
}

/// The innermost function of the program on the stack, with its line: its level, or none.
std::optional<int> findLevel(lua_State *L, lua_Debug &where)
{
    for (int level = 0; lua_getstack(L, level, &where) != 0; ++level) {
        lua_getinfo(L, "Slut", &where);
        if (where.currentline > 0 && isOfProgram(where))
            return level;
    }
    return std::nullopt;
}

/// The line of the program that called the function \p where of \p level; 0 if that is not known.
int callerOf(lua_State *L, const lua_Debug &where, int level)
{
    lua_Debug caller{};
    if (where.istailcall != 0 || lua_getstack(L, level + 1, &caller) == 0)
        return 0;
    lua_getinfo(L, "Sl", &caller);
    return isOfProgram(caller) ? std::max(0, caller.currentline) : 0;
}

} // namespace

bool isOfProgram(const lua_Debug &where)
{
    return qstrcmp(where.source, "=lab.lua") == 0;
}

void charge(lua_State *L, qint64 instructions)
{
    ScriptHost &host = ScriptHost::of(L);
    host.instructions += instructions;
    if (host.instructions <= host.mostInstructions)
        return;
    const bool dear = host.memory.longestText() >= limits::textBytesPerInstruction
                      || instructions > instructionsPerLook;
    const QString message =
        dear ? SandboxText::tr("this step does as much work as %1 million instructions (what is "
                               "done to long texts and lists counts by their length); is there a "
                               "loop that does not end?")
             : SandboxText::tr("this step takes more than %1 million instructions; is there a "
                               "loop that does not end?");
    abortRun(L, ProgramError::Kind::Time, message.arg(limits::instructionsPerStep / 1'000'000));
}

qint64 instructionsPerText(lua_State *L)
{
    const std::size_t longest = ScriptHost::of(L).memory.longestText();
    return 1 + static_cast<qint64>(longest / limits::textBytesPerInstruction);
}

namespace {

void lookAtClock(lua_State *L)
{
    const ScriptHost &host = ScriptHost::of(L);
    if (host.timed && std::chrono::steady_clock::now() > host.deadline)
        abortRun(L, ProgramError::Kind::Time,
                 SandboxText::tr("this step has run for more than %1 s; is there a loop that does "
                                 "not end?")
                     .arg(limits::wallTimePerStep.count()));
    if (host.stop && host.stop())
        abortRun(L, ProgramError::Kind::Time, SandboxText::tr("the run was stopped"));
}

/// What the instructions since the last look count; what they did to texts and lists is not told,
/// so it is bounded by the longest text and by what memory was moved.
qint64 costOfLook(lua_State *L)
{
    const std::size_t moved = ScriptHost::of(L).memory.takeMoved();
    return instructionsPerLook * instructionsPerText(L)
           + static_cast<qint64>(moved / limits::movedBytesPerInstruction);
}

void hook(lua_State *L, lua_Debug *event)
{
    ScriptHost &host = ScriptHost::of(L);
    if (event->event == LUA_HOOKLINE) {
        lua_getinfo(L, "Sl", event);
        if (host.trace && isOfProgram(*event))
            host.trace->lines.insert(event->currentline);
        // Noted here: once it has yielded, Lua tells the line before.
        if (lua_isyieldable(L) && isOfProgram(*event)) {
            noteError(L);
            lua_yield(L, 0);
        }
        return;
    }
    if (host.aborted) // Something went on after all.
        abortRun(L, *host.aborted, SandboxText::tr("the run was stopped"));
    charge(L, costOfLook(L));
    lookAtClock(L);
    if (++host.looks % looksPerDepth == 0 && lua_getstack(L, limits::callDepth, event) != 0)
        raise(L, SandboxText::tr("functions call each other %1 deep; does one call itself without "
                                 "end?")
                     .arg(limits::callDepth));
}

/// The end of a pcall: true and the results, or false and the error, unless a limit was passed.
int finishCall(lua_State *L, int status, lua_KContext)
{
    if (status == LUA_OK || status == LUA_YIELD)
        return lua_gettop(L);
    ScriptHost &host = ScriptHost::of(L);
    host.instructions += instructionsPerCatch;
    if (status == LUA_ERRMEM && !host.aborted)
        host.aborted = ProgramError::Kind::Memory;
    if (host.aborted)
        lua_error(L);
    lua_pushboolean(L, 0);
    lua_insert(L, -2);
    return 2;
}

} // namespace

int protectedCall(lua_State *L)
{
    luaL_checkany(L, 1);
    ScriptHost::of(L).wordless = false; // It may read the error.
    lua_pushboolean(L, 1);
    lua_insert(L, 1);
    const int status = lua_pcallk(L, lua_gettop(L) - 2, LUA_MULTRET, 0, 0, finishCall);
    return finishCall(L, status, 0);
}

void watch(lua_State *L, bool lines)
{
    // Where there is a hook, Lua asks at every instruction and every return.
    const bool looks = lines || ScriptHost::of(L).counts;
    lua_sethook(L, looks ? hook : nullptr, looks ? LUA_MASKCOUNT | (lines ? LUA_MASKLINE : 0) : 0,
                static_cast<int>(instructionsPerLook));
}

void leaveCountOut(lua_State *L)
{
    ScriptHost &host = ScriptHost::of(L);
    host.counts = false;
    host.memory.callWhenMuch(countFromHere);
}

void countFromHere(lua_State *L)
{
    ScriptHost::of(L).counts = true;
    if (lua_gethookmask(L) == 0)
        watch(L, false);
}

void beginCount(lua_State *L)
{
    ScriptHost &host = ScriptHost::of(L);
    host.earlierInstructions += std::exchange(host.instructions, 0);
    host.outputBytes = 0;
    (void)host.memory.takeMoved(); // What we did in between is not the program's.
    if (host.timed)
        host.deadline = std::chrono::steady_clock::now() + limits::wallTimePerStep;
    host.memory.hold(L);
    host.outerLocale = uselocale(plainLocale());
}

void endCount(lua_State *L)
{
    ScriptHost &host = ScriptHost::of(L);
    uselocale(host.outerLocale);
    host.memory.release();
}

int currentLine(lua_State *L)
{
    lua_Debug where{};
    return findLevel(L, where) ? where.currentline : 0;
}

bool isInCurrentFunction(lua_State *L, int line)
{
    lua_Debug where{};
    // The outermost one has no first line.
    return findLevel(L, where)
           && (where.linedefined <= 0
               || (where.linedefined <= line && where.lastlinedefined >= line));
}

void noteError(lua_State *L)
{
    ScriptHost &host = ScriptHost::of(L);
    ProgramError &error = host.caught;
    error = {};
    host.missing.clear();
    host.calledFrom = 0;
    lua_Debug where{};
    const std::optional<int> level = findLevel(L, where);
    if (!level)
        return;
    error.line = where.currentline;
    host.calledFrom = callerOf(L, where, *level);
    for (int i = 1; const char *name = lua_getlocal(L, &where, i); ++i) {
        if (i <= where.nparams && lua_isnil(L, -1))
            host.missing.append(QString::fromUtf8(name));
        // Those in brackets are Lua's own.
        if (*name != '(')
            error.locals.push_back({QString::fromUtf8(name), describeValue(L, -1)});
        lua_pop(L, 1);
    }
}

int catchError(lua_State *L)
{
    if (!ScriptHost::of(L).silent)
        noteError(L);
    return 1;
}

} // namespace cradle
