// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/line_test.h"

#include "tasks/reading/lab_reader.h"

using namespace cradle;

namespace {

/// Step 12 with a table of numbers for each circle, written back at the end of a step.
constexpr char numbers[] = R"lua(function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, -2)
  circle2.velocity = vec(0, 2)
end

local function load_state(c)
  return { x = c.position.x, y = c.position.y, vx = c.velocity.x, vy = c.velocity.y, r = c.radius }
end

local function store_state(c, s)
  c.position = vec(s.x, s.y)
  c.velocity = vec(s.vx, s.vy)
end

local function advance(s, dt)
  s.x = s.x + s.vx * dt
  s.y = s.y + s.vy * dt
end

local function box(s)
  local limit = square.half_width - s.r
  if s.x < -limit and s.vx < 0 then s.x, s.vx = -limit, -s.vx end
  if s.x > limit and s.vx > 0 then s.x, s.vx = limit, -s.vx end
  if s.y < -limit and s.vy < 0 then s.y, s.vy = -limit, -s.vy end
  if s.y > limit and s.vy > 0 then s.y, s.vy = limit, -s.vy end
end

local function unit(dx, dy)
  local d = math.sqrt(dx * dx + dy * dy)
  return dx / d, dy / d
end

local function exchange(a, b)
  local dx, dy = b.x - a.x, b.y - a.y
  if dx * dx + dy * dy >= (a.r + b.r) ^ 2 then return end
  local nx, ny = unit(dx, dy)
  local rel = (a.vx - b.vx) * nx + (a.vy - b.vy) * ny
  if rel <= 0 then return end
  local jx, jy = rel * nx, rel * ny
  a.vx, a.vy = a.vx - jx, a.vy - jy
  b.vx, b.vy = b.vx + jx, b.vy + jy
end

function on_update(dt)
  local a, b = load_state(circle1), load_state(circle2)
  advance(a, dt)
  advance(b, dt)
  box(a)
  box(b)
  exchange(a, b)
  store_state(circle1, a)
  store_state(circle2, b)
end
)lua";

/// Step 16 with functions that are given numbers.
constexpr char library[] = R"lua(local phys = {}

function phys.mass(r, rho) return rho * r ^ 3 end

function phys.normal(p, q) return (q - p) / (q - p):length() end

function phys.after(m1, m2, u1, u2, e)
  local p = m1 * u1 + m2 * u2
  local v = p / (m1 + m2)
  return v - e * m2 * (u1 - u2) / (m1 + m2), v + e * m1 * (u1 - u2) / (m1 + m2)
end

function phys.replace(v, n, speed)
  local across = v - v:dot(n) * n
  return across + speed * n
end

function phys.wall(x, v, limit)
  if x > limit and v > 0 or x < -limit and v < 0 then return -v end
  return v
end

function on_load()
  gravity = vec(0, 0)
  restitution = 0.5
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle1.radius = 0.2
  circle1.density = 1
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle2.radius = 0.2
  circle2.density = 2
end

local function move(c, dt)
  c.velocity = c.velocity + gravity * dt
  c.position = c.position + c.velocity * dt
end

local function walls(c)
  local w = square.half_width - c.radius
  local vx = phys.wall(c.position.x, c.velocity.x, w)
  local vy = phys.wall(c.position.y, c.velocity.y, w)
  c.velocity = vec(vx, vy)
end

local function pair(a, b)
  if (a.position - b.position):length() >= a.radius + b.radius then return end
  local n = phys.normal(a.position, b.position)
  local ua, ub = a.velocity:dot(n), b.velocity:dot(n)
  if ua - ub <= 0 then return end
  local ma, mb = phys.mass(a.radius, a.density), phys.mass(b.radius, b.density)
  local va, vb = phys.after(ma, mb, ua, ub, restitution)
  a.velocity = phys.replace(a.velocity, n, va)
  b.velocity = phys.replace(b.velocity, n, vb)
end

function on_update(dt)
  move(circle1, dt)
  move(circle2, dt)
  walls(circle1)
  walls(circle2)
  pair(circle1, circle2)
end
)lua";

/// Step 16 with pushes that are gathered and applied at last.
constexpr char gathered[] = R"lua(function on_load()
  gravity = vec(0, 0)
  restitution = 0.5
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle1.radius = 0.2
  circle1.density = 1
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle2.radius = 0.2
  circle2.density = 2
end

local impulses = {}

local function mass_of(c) return 4 / 3 * math.pi * c.radius ^ 3 * c.density * 1000 end

local function add_impulse(i, J) impulses[i] = impulses[i] + J end

local function find_contact(a, b)
  local d = b.position - a.position
  local gap = d:length() - a.radius - b.radius
  if gap > 0 then return nil end
  return { normal = d:normalized(), depth = -gap }
end

local function relative_speed(a, b, n) return n:dot(a.velocity) - n:dot(b.velocity) end

local function effective_mass(a, b) return 1 / (1 / mass_of(a) + 1 / mass_of(b)) end

local function solve(i, j)
  local a, b = circles[i], circles[j]
  local contact = find_contact(a, b)
  if not contact then return end
  local speed = relative_speed(a, b, contact.normal)
  if speed < 0 then return end
  local size = (1 + restitution) * speed * effective_mass(a, b)
  add_impulse(i, -size * contact.normal)
  add_impulse(j, size * contact.normal)
end

local function solve_walls(c)
  local p, v, r = c.position, c.velocity, c.radius
  if p.x + r > square.right and v.x > 0 then v = vec(-v.x, v.y) end
  if p.x - r < square.left and v.x < 0 then v = vec(-v.x, v.y) end
  if p.y + r > square.top and v.y > 0 then v = vec(v.x, -v.y) end
  if p.y - r < square.bottom and v.y < 0 then v = vec(v.x, -v.y) end
  c.velocity = v
end

function on_update(dt)
  for i, c in ipairs(circles) do
    impulses[i] = vec(0, 0)
    c.velocity = c.velocity + gravity * dt
    c.position = c.position + c.velocity * dt
    solve_walls(c)
  end
  solve(1, 2)
  for i, c in ipairs(circles) do
    c.velocity = c.velocity + impulses[i] / mass_of(c)
  end
end
)lua";

/// Step 9 with a helper in a helper.
constexpr char chained[] = R"lua(function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, 2)
  circle2.velocity = vec(0, 0)
end

local function squared(p, q)
  local dx, dy = p.x - q.x, p.y - q.y
  return dx * dx + dy * dy
end

local function reach(a, b)
  local sum = a.radius + b.radius
  return sum * sum
end

local function hit(a, b)
  return squared(a.position, b.position) < reach(a, b)
end

local function stop(c)
  c.velocity = vec(0, 0)
end

local function walls(c)
  local w = square.half_width - c.radius
  local p, v = c.position, c.velocity
  if p.x * v.x > 0 and math.abs(p.x) > w then v = vec(-v.x, v.y) end
  if p.y * v.y > 0 and math.abs(p.y) > w then v = vec(v.x, -v.y) end
  c.velocity = v
end

function on_update(dt)
  for _, c in ipairs(circles) do
    c.position = c.position + c.velocity * dt
    walls(c)
  end
  if hit(circle1, circle2) then
    stop(circle1)
    stop(circle2)
  end
end
)lua";

/// Step 14 with objects that are pushed.
constexpr char pushed[] = R"lua(local Ball = {}

function Ball.new(c)
  local self = {}
  for name, f in pairs(Ball) do self[name] = f end
  self.c = c
  self.m = self:weight()
  return self
end

function Ball:volume()
  return 4 / 3 * math.pi * self.c.radius ^ 3
end

function Ball:weight()
  return 1000 * self.c.density * self:volume()
end

function Ball:fly(dt)
  self.c.position = self.c.position + self.c.velocity * dt
end

function Ball:kick(dv)
  self.c.velocity = self.c.velocity + dv
end

function Ball:speed_along(n)
  return self.c.velocity:dot(n)
end

function Ball:stay_inside()
  local p, v, w = self.c.position, self.c.velocity, square.half_width - self.c.radius
  if math.abs(p.x) > w and p.x * v.x > 0 then self:kick(vec(-2 * v.x, 0)) end
  if math.abs(p.y) > w and p.y * v.y > 0 then self:kick(vec(0, -2 * v.y)) end
end

function Ball:touches(other)
  local d = other.c.position - self.c.position
  return d:length() < self.c.radius + other.c.radius
end

function Ball:hit(other)
  local n = (other.c.position - self.c.position):normalized()
  local u1, u2 = self:speed_along(n), other:speed_along(n)
  if u1 <= u2 then return end
  local m1, m2 = self.m, other.m
  local w1 = ((m1 - m2) * u1 + 2 * m2 * u2) / (m1 + m2)
  local w2 = ((m2 - m1) * u2 + 2 * m1 * u1) / (m1 + m2)
  self:kick((w1 - u1) * n)
  other:kick((w2 - u2) * n)
end

local one, two

function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle1.radius = 0.2
  circle1.density = 7.8
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle2.radius = 0.252
  circle2.density = 7.8
  one, two = Ball.new(circle1), Ball.new(circle2)
end

function on_update(dt)
  one:fly(dt)
  two:fly(dt)
  one:stay_inside()
  two:stay_inside()
  if one:touches(two) then one:hit(two) end
end
)lua";

} // namespace

/// Where a value is wrong that no change of a word mends, the first line is marked in which another
/// value would, and that is not known to be right.
class TestMendingValue : public LineTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void findingMarksTheLine_data();
    void findingMarksTheLine() { compareLine(); }
};

void TestMendingValue::findingMarksTheLine_data()
{
    addColumns();
    const QString tables = QString::fromLatin1(numbers);
    const QString functions = QString::fromLatin1(library);
    const QString pushes = QString::fromLatin1(gathered);
    const QString helpers = QString::fromLatin1(chained);
    const QString objects = QString::fromLatin1(pushed);
    rowOfStep("nothing wrong: tables", "L42T12", tables, "local d =", "local d =", false);
    rowOfStep("nothing wrong: functions", "L42T16", functions, "local p =", "local p =", false);
    rowOfStep("nothing wrong: pushes", "L42T16", pushes, "local size", "local size", false);
    rowOfStep("nothing wrong: helpers", "L42T9", helpers, "local sum", "local sum", false);
    rowOfStep("nothing wrong: objects", "L42T14", objects, "local m1", "local m1", false);
    rowOfStep("length of a normal, in a helper", "L42T12", tables, "math.sqrt(dx * dx + dy * dy)",
              "math.abs(dx) + math.abs(dy)");
    rowOfStep("square of it", "L42T12", tables, "math.sqrt(dx * dx + dy * dy)",
              "dx * dx + dy * dy");
    rowOfStep("relative speed, half of one circle", "L42T12", tables, "(a.vy - b.vy) * ny",
              "a.vy * ny");
    rowOfStep("momentum without masses", "L42T16", functions, "m1 * u1 + m2 * u2", "u1 + u2");
    rowOfStep("common velocity as a mean", "L42T16", functions, "p / (m1 + m2)\n", "p / 2\n");
    rowOfStep("way for a normal, in a table", "L42T16", pushes, "normal = d:normalized()",
              "normal = d");
    rowOfStep("known momentum is passed over", "L42T16", functions, "return v - e * m2 *",
              "return v - 0.3 * e * m2 *");
    rowOfStep("of two equal lines the second", "L42T9", helpers, "    stop(circle2)\n",
              "    stop(circle1)\n");
    rowOfStep("what is handed to a push", "L42T14", objects,
              "if math.abs(p.y) > w and p.y * v.y > 0 then self:kick(vec(0, -2 * v.y)) end",
              "if math.abs(p.y) > w and p.y * v.y > 0 then self:kick(vec(0, -v.y)) end");
}

QTEST_GUILESS_MAIN(TestMendingValue)
#include "test_mending_value.moc"
