// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/lab_test.h"

#include "tasks/judging/flight_words.h"
#include "tasks/judging/measured_laws.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/wall_words.h"

/// Programs with known laws, in several structures, for steps of Lab 4.2: what is measured of them
/// must be what was put in.
namespace cradle::programs {

/// Pieces of Lua. In them `c` is a circle and `old` where it was, `h` the timestep; in a hit `p`
/// and `q` are the circles, `oldp` and `oldq` where they were.
struct LawProgram {
    int circles = 2;
    QString start{};
    QString move = QStringLiteral("c.velocity = c.velocity + gravity * h "
                                  "c.position = c.position + c.velocity * h");
    QString walls{};
    QString hit{};
};

/// One way of writing the same down.
struct Structure {
    const char *name;
    const char *text; ///< with MOVE, WALLS, HIT and START in it
};

inline constexpr Structure structures[] = {{"flat", R"lua(
function on_load() START end
function on_update(h)
  local c, old = circle1, circle1.position
  MOVE
  WALLS
  local p, oldp = c, old
  if #circles > 1 then
    local c, old = circle2, circle2.position
    MOVE
    WALLS
    local q, oldq = c, old
    HIT
  end
end
)lua"},
                                           {"table", R"lua(
function on_load() START end
function on_update(h)
  local all = {}
  for i = 1, #circles do
    local s = circles[i]
    all[i] = {position = s.position, velocity = s.velocity, old = s.position,
              radius = s.radius, density = s.density, index = i}
  end
  for i = 1, #all do local c, old = all[i], all[i].old MOVE end
  for i = 1, #all do local c, old = all[i], all[i].old WALLS end
  local p, q = all[1], all[2]
  if q then local oldp, oldq = p.old, q.old HIT end
  for i = 1, #all do
    circles[i].position, circles[i].velocity = all[i].position, all[i].velocity
  end
end
)lua"},
                                           {"closure", R"lua(
local bodies = {}
local function body(c)
  local self, old = {circle = c}, c.position
  function self.was() return old end
  function self.move(h) old = c.position MOVE end
  function self.walls(h) WALLS end
  return self
end
local function meet(a, b, h)
  local p, q, oldp, oldq = a.circle, b.circle, a.was(), b.was()
  HIT
end
function on_load()
  START
  for i = 1, #circles do bodies[i] = body(circles[i]) end
end
function on_update(h)
  for _, b in ipairs(bodies) do b.move(h) end
  for _, b in ipairs(bodies) do b.walls(h) end
  if bodies[2] then meet(bodies[1], bodies[2], h) end
end
)lua"},
                                           {"general", R"lua(
function on_load() START end
local function move(c, h) MOVE end
local function walls(c, old, h) WALLS end
local function meet(p, q, oldp, oldq, h) HIT end
function on_update(h)
  local old = {}
  for i, c in ipairs(circles) do old[i] = c.position move(c, h) end
  for i, c in ipairs(circles) do walls(c, old[i], h) end
  for i = 1, #circles - 1 do
    for k = i + 1, #circles do meet(circles[i], circles[k], old[i], old[k], h) end
  end
end
)lua"}};

inline QString written(const LawProgram &program, const Structure &structure)
{
    return QString::fromLatin1(structure.text)
        .replace(QLatin1String("START"), program.start)
        .replace(QLatin1String("MOVE"), program.move)
        .replace(QLatin1String("WALLS"), program.walls)
        .replace(QLatin1String("HIT"), program.hit);
}

/// A way of treating a wall; what it does in one coordinate. E is the factor, R the radius.
struct WallWay {
    const char *name;
    const char *place; ///< of the coordinate s with the velocity v, past the limit `edge`
};

inline constexpr WallWay wallWays[] = {
    {"restore", "s = was"},
    {"clamp", "s = edge"},
    {"mirror", "s = 2 * edge - s"},
    {"time of impact",
     "local late = math.max(0, math.min(h, (s - edge) / v)) s = edge - E * v * late"}};

/// Walls that turn a circle at the distance \p reach and give \p back of its speed back, and
/// \p along of that along the wall.
inline QString wallsOf(const WallWay &way, const char *reach = "c.radius",
                       const char *back = "restitution", const char *along = "1")
{
    return QString::fromLatin1(R"lua(
      local x, y, vx, vy = c.position.x, c.position.y, c.velocity.x, c.velocity.y
      local function one(s, v, w, was)
        local room = square.half_width - (REACH)
        local edge = s > 0 and room or -room
        if math.abs(s) > room and s * v > 0 then
          PLACE
          v, w = -(E) * v, (ALONG) * w
        end
        return s, v, w
      end
      x, vx, vy = one(x, vx, vy, old.x)
      y, vy, vx = one(y, vy, vx, old.y)
      c.position, c.velocity = vec(x, y), vec(vx, vy)
    )lua")
        .replace(QLatin1String("PLACE"), QLatin1String(way.place))
        .replace(QLatin1String("REACH"), QLatin1String(reach))
        .replace(QLatin1String("ALONG"), QLatin1String(along))
        .replace(QLatin1String("E)"), QLatin1String(back) + QLatin1Char(')'))
        .replace(QLatin1String("E *"), QStringLiteral("(%1) *").arg(QLatin1String(back)));
}

/// A way of treating two circles that touch; BACK is before the answer, FORTH after it.
struct HitWay {
    const char *name;
    const char *back;
    const char *forth;
};

inline constexpr HitWay hitWays[] = {
    {"restore", "p.position, q.position = oldp, oldq", ""},
    {"in place", "", ""},
    {"push apart", "",
     "local deep = reach - d:length() if deep > 0 then "
     "p.position, q.position = p.position - deep / 2 * n, q.position + deep / 2 * n end"},
    {"time of impact",
     "local late = math.max(0, math.min(h, (reach - d:length()) / closing)) "
     "p.position, q.position = p.position - late * p.velocity, q.position - late * q.velocity",
     "p.position, q.position = p.position + late * p.velocity, q.position + late * q.velocity"}};

struct HitLaw {
    QString reach = QStringLiteral("p.radius + q.radius");
    QString touch = QStringLiteral("d:length() < reach");
    QString approach = QStringLiteral("closing > 0");
    QString normal = QStringLiteral("d:normalized()");
    QString mass = QStringLiteral("c.density * c.radius ^ 3");
    QString e = QStringLiteral("1");
    QString answer = QStringLiteral("local j = (1 + e) * closing / (1 / m1 + 1 / m2) "
                                    "p.velocity = p.velocity - j / m1 * n "
                                    "q.velocity = q.velocity + j / m2 * n");
};

inline QString hitOf(const HitWay &way, const HitLaw &law = {})
{
    return QStringLiteral(R"lua(
      local d, reach, e = q.position - p.position, %1, %2
      local function weigh(c) return %3 end
      if %4 then
        local n = %5
        local m1, m2 = weigh(p), weigh(q)
        local closing = (p.velocity - q.velocity):dot(n)
        if %6 then
          %7
          %8
          %9
        end
      end
    )lua")
        .arg(law.reach, law.e, law.mass, law.touch, law.normal, law.approach,
             QString::fromLatin1(way.back), law.answer, QString::fromLatin1(way.forth));
}

/// What is measured of programs on the ground of one step, and what is said of it.
struct LawBench {
    explicit LawBench(const Task &of)
        : task(of)
        , ground(of, of.preset)
        , right(&task.solution, ground)
    {
    }
    LawBench(const LawBench &) = delete;

    [[nodiscard]] QStringList flight(const QString &program) const
    {
        const MeasuredLaws own(&program, ground);
        return headlines(flightDeviations(own.flight(), right.flight(), ground));
    }
    [[nodiscard]] QStringList walls(const QString &program) const
    {
        const MeasuredLaws own(&program, ground);
        return headlines(wallDeviations(own.walls(), right.walls(), ground));
    }
    [[nodiscard]] QStringList contact(const QString &program) const
    {
        return headlines(contactFound(program));
    }
    [[nodiscard]] std::vector<LawDeviation> contactFound(const QString &program) const
    {
        const MeasuredLaws own(&program, ground);
        return contactDeviations(own.pair(), right.pair(), ground);
    }
    [[nodiscard]] QStringList response(const QString &program) const
    {
        const MeasuredLaws own(&program, ground);
        return headlines(responseDeviations(own.pair(), right.pair(), ground));
    }
    /// All of them, aspect by aspect.
    [[nodiscard]] QStringList all(const QString &program) const
    {
        return flight(program) + walls(program) + contact(program) + response(program);
    }

    static QStringList headlines(const std::vector<LawDeviation> &deviations)
    {
        QStringList lines;
        for (const LawDeviation &deviation : deviations)
            lines.append(deviation.message.section(QLatin1Char('\n'), 0, 0));
        return lines;
    }

    const Task task;
    const Ground ground;
    const MeasuredLaws right;
};

/// A program with those \p walls, in which circles pass through each other.
inline LawProgram withWalls(const QString &walls)
{
    return {.walls = walls};
}

/// A program with right walls, in which \p hit answers the circles.
inline LawProgram withHit(const QString &hit)
{
    return {.walls = wallsOf(wallWays[1], "c.radius", "1"), .hit = hit};
}

} // namespace cradle::programs
