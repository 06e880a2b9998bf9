// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/line_test.h"

#include "tasks/reading/lab_reader.h"

using namespace cradle;

/// Where a value is wrong that was worked out above the answer, in a local, a table or a function,
/// that line is marked, not the answer or the question that takes it.
class TestLineOfValue : public LineTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void findingMarksTheLine_data();
    void findingMarksTheLine() { compareLine(); }
};

namespace {

/// Step 15 in small functions, each with a local of its own.
constexpr char helpers[] = R"lua(local function mass_of(c)
  local volume = 4 / 3 * math.pi * c.radius ^ 3
  return volume * c.density * 1000
end
function on_load()
  gravity = vec(0, 0)
  circle1.position, circle1.velocity = vec(-2.5, 2), vec(1, 0)
  circle2.position, circle2.velocity = vec(0, 2), vec(-1, 0)
  circle1.radius, circle1.density = 0.2, 1
  circle2.radius, circle2.density = 0.2, 2
end
local function bounce(c)
  local bound = square.half_width - c.radius
  local p, v = c.position, c.velocity
  if math.abs(p.x) > bound and p.x * v.x > 0 then
    v = vec(-v.x, v.y)
  end
  if math.abs(p.y) > bound and p.y * v.y > 0 then
    v = vec(v.x, -v.y)
  end
  c.velocity = v
end
local function direction(a, b)
  local way = b.position - a.position
  return way:normalized()
end
local function touching(a, b)
  local reach = a.radius + b.radius
  return (b.position - a.position):length() < reach
end
local function hit(a, b)
  if not touching(a, b) then return end
  local n = direction(a, b)
  local rel = a.velocity - b.velocity
  local closing = dot(rel, n)
  if closing <= 0 then return end
  local m1 = mass_of(a)
  local m2 = mass_of(b)
  local mu = m1 * m2 / (m1 + m2)
  local j = 2 * mu * closing
  a.velocity = a.velocity - j / m1 * n
  b.velocity = b.velocity + j / m2 * n
end
function on_update(h)
  for _, c in ipairs(circles) do
    c.velocity = c.velocity + gravity * h
    c.position = c.position + c.velocity * h
    bounce(c)
  end
  hit(circle1, circle2)
end
)lua";

/// Step 16 with a table for every circle, of any number.
constexpr char bodies[] = R"lua(function on_load()
  gravity = vec(0, 0)
  restitution = 0.5
  circle1.position, circle1.velocity = vec(-2.5, 2), vec(1, 0)
  circle1.radius, circle1.density = 0.2, 1
  circle2.position, circle2.velocity = vec(0, 2), vec(-1, 0)
  circle2.radius, circle2.density = 0.2, 2
end
local bodies = {}
local function collect()
  for i, c in ipairs(circles) do
    local r = c.radius
    bodies[i] = {
      pos = c.position,
      vel = c.velocity,
      r = r,
      inv = 1 / (c.density * r * r * r),
    }
  end
end
local function confine(body)
  local low_x, high_x = square.left + body.r, square.right - body.r
  local low_y, high_y = square.bottom + body.r, square.top - body.r
  local vx, vy = body.vel.x, body.vel.y
  if body.pos.x < low_x and vx < 0 then vx = -vx end
  if body.pos.x > high_x and vx > 0 then vx = -vx end
  if body.pos.y < low_y and vy < 0 then vy = -vy end
  if body.pos.y > high_y and vy > 0 then vy = -vy end
  body.vel = vec(vx, vy)
end
local function resolve(p, q)
  local delta = q.pos - p.pos
  local dist = delta:length()
  local overlap = p.r + q.r - dist
  if overlap <= 0 then return end
  local normal = delta / dist
  local vn = (q.vel - p.vel):dot(normal)
  if vn >= 0 then return end
  local lambda = -(1 + restitution) * vn / (p.inv + q.inv)
  local impulse = lambda * normal
  p.vel = p.vel - impulse * p.inv
  q.vel = q.vel + impulse * q.inv
end
function on_update(dt)
  collect()
  for _, body in ipairs(bodies) do
    body.pos = body.pos + body.vel * dt
    confine(body)
  end
  for i = 1, #bodies - 1 do
    for j = i + 1, #bodies do
      resolve(bodies[i], bodies[j])
    end
  end
  for i, c in ipairs(circles) do
    c.position = bodies[i].pos
    c.velocity = bodies[i].vel
  end
end
)lua";

/// Step 5 with methods from a table, which return a new state.
constexpr char methods[] = R"lua(function on_load()
  gravity = vec(0, -9.81)
  circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0)
  circle2.position, circle2.velocity = vec(-2, 2), vec(2, 0)
end
local methods = {
  euler = function(p, v, a, dt)
    local new_p = p + v * dt
    local new_v = v + a * dt
    return new_p, new_v
  end,
  symplectic = function(p, v, a, dt)
    local new_v = v + a * dt
    local new_p = p + new_v * dt
    return new_p, new_v
  end,
}
local chosen = {"euler", "symplectic"}
local function turn(x, vx, low, high)
  if x < low and vx < 0 then return -vx, true end
  if x > high and vx > 0 then return -vx, true end
  return vx, false
end
local function walls(p, v, old, r)
  local vx, hit_x = turn(p.x, v.x, square.left + r, square.right - r)
  local vy, hit_y = turn(p.y, v.y, square.bottom + r, square.top - r)
  if hit_x or hit_y then
    p = old
  end
  return p, vec(vx, vy)
end
function on_update(dt)
  for i, c in ipairs(circles) do
    local name = chosen[i]
    local old = c.position
    local p, v = methods[name](c.position, c.velocity, gravity, dt)
    p, v = walls(p, v, old, c.radius)
    c.position = p
    c.velocity = v
  end
end
)lua";

} // namespace

void TestLineOfValue::findingMarksTheLine_data()
{
    addColumns();
    const auto helper = [](const char *name, const char *right, const char *wrong) {
        rowOfStep(name, "L42T15", QString::fromLatin1(helpers), right, wrong);
    };
    helper("nothing wrong", "local way", "local way");
    helper("where walls turn: two radii", "half_width - c.radius", "half_width - 2 * c.radius");
    helper("where walls turn: no radius", "square.half_width - c.radius", "square.half_width");
    helper("radii of one circle", "a.radius + b.radius", "2 * a.radius");
    helper("greater radius", "a.radius + b.radius", "math.max(a.radius, b.radius)");
    helper("where walls turn: a number", "square.half_width - c.radius", "3.9 - c.radius");
    helper("returned, not normalised", "return way:normalized()", "return way * 1.1");
    helper("relative velocity, sum", "local rel = a.velocity - b.velocity",
           "local rel = a.velocity + b.velocity");
    helper("closing speed: length", "local closing = dot(rel, n)", "local closing = rel:length()");
    helper("reduced mass: lesser", "m1 * m2 / (m1 + m2)", "math.min(m1, m2)");
    helper("push without 2", "local j = 2 * mu", "local j = mu");
    helper("a number at the question", "< reach", "< 0.4");
    helper("density forgotten at last", "volume * c.density * 1000", "volume * 1000");
    helper("area of a disc", "4 / 3 * math.pi * c.radius ^ 3", "math.pi * c.radius * c.radius");
    const auto body = [](const char *name, const char *right, const char *wrong) {
        rowOfStep(name, "L42T16", QString::fromLatin1(bodies), right, wrong);
    };
    body("table: nothing wrong", "local delta", "local delta");
    body("table: mass of an area", "c.density * r * r * r", "c.density * r * r");
    body("table: mass without density", "c.density * r * r * r", "r * r * r");
    body("table: overlap of one radius", "p.r + q.r - dist", "p.r - dist");
    body("table: normal of another length", "local normal = delta / dist",
         "local normal = delta / (p.r + q.r) * 0.9");
    body("table: speed along what is no normal", "(q.vel - p.vel):dot(normal)",
         "(q.vel - p.vel):dot(delta)");
    body("table: low and high exchanged", "square.bottom + body.r, square.top - body.r",
         "square.bottom - body.r, square.top + body.r");
    const auto method = [](const char *name, const char *right, const char *wrong) {
        rowOfStep(name, "L42T5", QString::fromLatin1(methods), right, wrong);
    };
    method("new state: nothing wrong", "local name", "local name");
    method("new state: the old velocity", "new_v * dt", "v * dt");
    method("new state: handed on without a radius", "square.left + r, square.right - r",
           "square.left + r, square.right");
    method("method chosen at the start", "{\"euler\", \"symplectic\"}", "{\"euler\", \"euler\"}");
    method("new state: not turned", "> high and vx > 0 then return -vx",
           "> high and vx > 0 then return vx");
    // Who only sets what he is given is right: whoever calls him gave it.
    const QString given =
        QStringLiteral("local function put(c, p, v)\n  c.position, c.velocity = p, v\nend\n")
        + QString::fromLatin1(helpers).replace(
            QLatin1String("circle2.position, circle2.velocity = vec(0, 2), vec(-1, 0)"),
            QLatin1String("put(circle2, vec(0, 2), vec(-1, 0))"));
    rowOfStep("start: a call, right", "L42T15", given, "vec(0, 2), vec(-1, 0)",
              "vec(0, 2), vec(-1, 0)");
    rowOfStep("start: a call", "L42T15", given, "vec(0, 2), vec(-1, 0)", "vec(0, 2), vec(1, 0)");
}

QTEST_GUILESS_MAIN(TestLineOfValue)

#include "test_line_of_value.moc"
