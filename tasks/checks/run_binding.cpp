// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/run_binding.h"

#include "model/run/inferred_hits.h"
#include "tasks/script/sandbox.h"
#include "tasks/script/script_host.h"
#include "tasks/script/strict_table.h"
#include "tasks/script/vector_binding.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle {

namespace {

struct RunText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// Instructions that making the table of one circle counts as.
constexpr qint64 circleCost = 20;
/// A moment may lie outside the run by rounding, s.
constexpr double outside = 1e-9;

RunView &viewOf(lua_State *L)
{
    return *static_cast<RunView *>(lua_touserdata(L, lua_upvalueindex(1)));
}

void pushCircleState(lua_State *L, const Circle &circle, int index)
{
    charge(L, circleCost);
    lua_newtable(L);
    setVector(L, "position", circle.position);
    setVector(L, "velocity", circle.velocity);
    setNumber(L, "radius", circle.radius);
    setNumber(L, "density", circle.density);
    setWhole(L, "index", index + 1);
    makeStrict(L);
}

/// \param at  gives the circle with an index
template <typename At>
void pushState(lua_State *L, const Observation &run, double time, qint64 step, const At &at)
{
    lua_newtable(L);
    setNumber(L, "time", time);
    setWhole(L, "step", step);
    lua_createtable(L, run.circleCount(), 0);
    for (int i = 0; i < run.circleCount(); ++i) {
        pushCircleState(L, at(i), i);
        lua_rawseti(L, -2, i + 1);
    }
    lua_setfield(L, -2, "circles");
    makeStrict(L);
}

void pushStep(lua_State *L, const Observation &run, qint64 step)
{
    pushState(L, run, run.states.time(step), step, [&](int i) { return run.circle(i, step); });
}

/// What was called with a dot in place of the colon.
void requireColon(lua_State *L, const char *call)
{
    if (lua_type(L, 1) != LUA_TTABLE)
        raise(L, RunText::tr("write %1, with a colon").arg(QLatin1String(call)));
}

/// The moment in the second argument, s from the start.
double momentArgument(lua_State *L, const Observation &run)
{
    const double end = run.states.time(run.steps());
    const double t = lua_type(L, 2) == LUA_TNUMBER ? lua_tonumber(L, 2) : std::nan("");
    if (!(t >= -outside && t <= end + outside))
        raise(L, RunText::tr("the moment must be a number of seconds from 0 to %1, not %2")
                     .arg(QString::number(end, 'g', 10), nameValue(L, 2)));
    return std::clamp(t, 0.0, end);
}

/// The number of a step or a circle in the second argument.
qint64 wholeArgument(lua_State *L, qint64 least, qint64 most)
{
    int isWhole = 0;
    const lua_Integer value = lua_tointegerx(L, 2, &isWhole);
    if (lua_type(L, 2) != LUA_TNUMBER || isWhole == 0 || value < least || value > most)
        raise(L, RunText::tr("this must be a whole number from %1 to %2, not %3")
                     .arg(least)
                     .arg(most)
                     .arg(nameValue(L, 2)));
    return value;
}

int at(lua_State *L)
{
    requireColon(L, "run:at(t)");
    const Observation &run = viewOf(L).run;
    const double t = momentArgument(L, run);
    pushState(L, run, t, static_cast<qint64>(t / run.timestep()),
              [&](int i) { return run.circleAt(i, t); });
    return 1;
}

int step(lua_State *L)
{
    requireColon(L, "run:step(k)");
    const Observation &run = viewOf(L).run;
    pushStep(L, run, wholeArgument(L, 0, run.steps()));
    return 1;
}

/// The iterator of run:steps(); its second upvalue is the next step.
int nextStep(lua_State *L)
{
    const Observation &run = viewOf(L).run;
    const qint64 next = lua_tointeger(L, lua_upvalueindex(2));
    if (next > run.steps())
        return 0;
    lua_pushinteger(L, next + 1);
    lua_replace(L, lua_upvalueindex(2));
    pushStep(L, run, next);
    return 1;
}

int steps(lua_State *L)
{
    requireColon(L, "run:steps()");
    lua_pushlightuserdata(L, &viewOf(L));
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, nextStep, 2);
    return 1;
}

/// run:circle(i):at(t); its second upvalue is the index.
int circleAt(lua_State *L)
{
    requireColon(L, "run:circle(i):at(t)");
    const Observation &run = viewOf(L).run;
    const auto index = static_cast<int>(lua_tointeger(L, lua_upvalueindex(2)));
    pushCircleState(L, run.circleAt(index, momentArgument(L, run)), index);
    return 1;
}

int circle(lua_State *L)
{
    requireColon(L, "run:circle(i)");
    RunView &view = viewOf(L);
    const qint64 number = wholeArgument(L, 1, view.run.circleCount());
    lua_newtable(L);
    setWhole(L, "index", number);
    lua_pushlightuserdata(L, &view);
    lua_pushinteger(L, number - 1);
    lua_pushcclosure(L, circleAt, 2);
    lua_setfield(L, -2, "at");
    makeStrict(L);
    return 1;
}

/// A program does not tell its hits, so they are read from what it did.
void findHits(lua_State *L, RunView &view)
{
    if (std::exchange(view.knowsHits, true))
        return;
    const Observation &run = view.run;
    for (qint64 k = 0; k < run.steps(); ++k) {
        charge(L, run.circleCount());
        inferHits(run.variant.preset, run.states.circles(k), run.states.circles(k + 1),
                  run.timestep(), k + 1, run.states.time(k + 1), view.hits);
    }
}

void pushHit(lua_State *L, const Hit &hit)
{
    charge(L, circleCost);
    lua_newtable(L);
    setNumber(L, "time", hit.time);
    setWhole(L, "step", hit.step);
    const bool wall = hit.kind == Hit::Kind::Wall;
    lua_pushstring(L, wall ? "wall" : "circle");
    lua_setfield(L, -2, "kind");
    setWhole(L, "a", hit.a + 1);
    if (wall) {
        static constexpr const char *names[] = {"left", "right", "bottom", "top"};
        static_assert(static_cast<int>(Wall::Left) == 0 && static_cast<int>(Wall::Right) == 1
                      && static_cast<int>(Wall::Bottom) == 2 && static_cast<int>(Wall::Top) == 3);
        lua_pushstring(L, names[hit.b]);
        lua_setfield(L, -2, "b");
    } else {
        setWhole(L, "b", hit.b + 1);
    }
    setVector(L, "normal", hit.normal);
    setNumber(L, "impulse", hit.impulse);
    makeStrict(L);
}

int hits(lua_State *L)
{
    requireColon(L, "run:hits()");
    RunView &view = viewOf(L);
    findHits(L, view);
    lua_newtable(L);
    lua_Integer number = 0;
    for (const Hit &hit : view.hits) {
        pushHit(L, hit);
        lua_rawseti(L, -2, ++number);
    }
    return 1;
}

void pushSquare(lua_State *L, double half)
{
    lua_newtable(L);
    for (const char *name : {"half_width", "right", "top"})
        setNumber(L, name, half);
    for (const char *name : {"left", "bottom"})
        setNumber(L, name, -half);
    makeStrict(L);
}

} // namespace

void pushRun(lua_State *L, RunView &view)
{
    const Observation &run = view.run;
    lua_newtable(L);
    setNumber(L, "duration", run.states.time(run.steps()));
    setNumber(L, "timestep", run.timestep());
    setNumber(L, "restitution", run.variant.preset.restitution);
    setVector(L, "gravity", run.variant.preset.gravity);
    setWhole(L, "step_count", run.steps());
    setWhole(L, "circle_count", run.circleCount());
    lua_pushstring(L, view.language.toUtf8().constData());
    lua_setfield(L, -2, "language");
    pushSquare(L, run.variant.preset.halfWidth);
    lua_setfield(L, -2, "square");
    constexpr luaL_Reg functions[] = {
        {"at", at}, {"step", step}, {"steps", steps}, {"circle", circle}, {"hits", hits}};
    for (const luaL_Reg &entry : functions) {
        lua_pushlightuserdata(L, &view);
        lua_pushcclosure(L, entry.func, 1);
        lua_setfield(L, -2, entry.name);
    }
    makeStrict(L);
}

} // namespace cradle
