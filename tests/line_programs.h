// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Right programs of steps 5, 12, 15 and 16 in several styles, in which tests change what is at
/// fault.
namespace cradle::programs {

/// Step 12 in one function with a number for every part; what is between bars is at fault.
inline constexpr char flat[] = R"lua(function on_load()
  gravity = vec(0, 0)
  circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0)
  circle2.position, circle2.velocity = vec(2, -2), vec(0, 2)
end
function on_update(h)
  local ax, ay, avx, avy = circle1.position.x, circle1.position.y, circle1.velocity.x, circle1.velocity.y
  local bx, by, bvx, bvy = circle2.position.x, circle2.position.y, circle2.velocity.x, circle2.velocity.y
  ax = ax + avx * h
  ay = ay + avy * h
  bx = bx + bvx * h
  by = by + bvy * h
  local lim1 = square.half_width - circle1.radius
  local lim2 = square.half_width - circle2.radius
  if ax > lim1 then ax = lim1 avx = -math.abs(avx) end
  if ax < -lim1 then ax = -lim1 avx = math.abs(avx) end
  if ay > lim1 then ay = lim1 avy = -math.abs(avy) end
  if ay < -lim1 then ay = -lim1 avy = math.abs(avy) end
  if bx > lim2 then bx = lim2 bvx = -math.abs(bvx) end
  if bx < -lim2 then bx = -lim2 bvx = math.abs(bvx) end
  if by > lim2 then by = lim2 bvy = -math.abs(bvy) end
  if by < -lim2 then by = -lim2 bvy = math.abs(bvy) end
  local dx, dy = bx - ax, by - ay
  local d = math.sqrt(dx * dx + dy * dy)
  if d < circle1.radius + circle2.radius then
    local nx, ny = dx / d, dy / d
    local u = avx * nx + avy * ny
    local w = bvx * nx + bvy * ny
    if u > w then
      avx = avx + (w - u) * nx
      avy = avy + (w - u) * ny
      bvx = bvx + (u - w) * nx
      bvy = bvy + (u - w) * ny
    end
  end
  circle1.position, circle1.velocity = vec(ax, ay), vec(avx, avy)
  circle2.position, circle2.velocity = vec(bx, by), vec(bvx, bvy)
end
)lua";

/// The same with a small object for every circle.
inline constexpr char objects[] = R"lua(local balls = {}
local function ball(c)
  local self = {}
  function self.place() return c.position end
  function self.velocity() return c.velocity end
  function self.set(v) c.velocity = v end
  function self.radius() return c.radius end
  function self.move(h) c.position = c.position + c.velocity * h end
  function self.walls()
    local p, v, lim = c.position, c.velocity, square.half_width - c.radius
    if math.abs(p.x) > lim and p.x * v.x > 0 then v = vec(-v.x, v.y) end
    if math.abs(p.y) > lim and p.y * v.y > 0 then v = vec(v.x, -v.y) end
    c.velocity = v
  end
  return self
end
local function collide(a, b)
  local d = b.place() - a.place()
  if d:length() >= a.radius() + b.radius() then return end
  local n = d:normalized()
  local u = dot(a.velocity() - b.velocity(), n)
  if u <= 0 then return end
  a.set(a.velocity() - u * n)
  b.set(b.velocity() + u * n)
end
function on_load()
  gravity = vec(0, 0)
  circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0)
  circle2.position, circle2.velocity = vec(2, -2), vec(0, 2)
  for i, c in ipairs(circles) do balls[i] = ball(c) end
end
function on_update(h)
  for _, b in ipairs(balls) do b.move(h) end
  for _, b in ipairs(balls) do b.walls() end
  collide(balls[1], balls[2])
end
)lua";

/// The free motion and the walls of those that follow.
inline constexpr char moves[] = R"lua(
local function move(c, h)
  local was, lim = c.position, square.half_width - c.radius
  c.position = was + c.velocity * h
  local p, v = c.position, c.velocity
  if math.abs(p.x) > lim and p.x * v.x > 0 then v = vec(-v.x, v.y) c.position = was end
  if math.abs(p.y) > lim and p.y * v.y > 0 then v = vec(v.x, -v.y) c.position = was end
  c.velocity = v
end
function on_load()
  gravity = vec(0, 0)
  circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0)
  circle2.position, circle2.velocity = vec(2, -2), vec(0, 2)
end
function on_update(h)
  move(circle1, h)
  move(circle2, h)
  collide(circle1, circle2)
end
)lua";

/// Velocities turned by the angle of the line of centres, and back.
inline constexpr char angles[] = R"lua(local function turned(v, f)
  local c, s = math.cos(f), math.sin(f)
  return vec(c * v.x + s * v.y, c * v.y - s * v.x)
end
function collide(a, b)
  local d = b.position - a.position
  if d:length() >= a.radius + b.radius then return end
  local f = math.atan(d.y, d.x)
  local u, w = turned(a.velocity, f), turned(b.velocity, f)
  if u.x <= w.x then return end
  a.velocity = turned(vec(w.x, u.y), -f)
  local v = vec(u.x, w.y)
  b.velocity = turned(v, -f)
end
)lua";

/// A hit as it is seen by circle 2.
inline constexpr char frame[] = R"lua(function collide(a, b)
  local d = b.position - a.position
  if d:length() >= a.radius + b.radius then return end
  local base = b.velocity
  local rel = a.velocity - base
  if rel:dot(d) <= 0 then return end
  local push = d * (rel:dot(d) / d:length_squared())
  a.velocity = base + rel - push
  b.velocity = base + push
end
)lua";

/// With e, and a velocity of what both have in common.
inline constexpr char rebounds[] = R"lua(function collide(a, b)
  local d, e = b.position - a.position, restitution
  local far = d:length()
  if far >= a.radius + b.radius then return end
  local nx, ny = d.x / far, d.y / far
  local u, w = a.velocity.x * nx + a.velocity.y * ny, b.velocity.x * nx + b.velocity.y * ny
  local s, t = a.velocity.y * nx - a.velocity.x * ny, b.velocity.y * nx - b.velocity.x * ny
  if u <= w then return end
  local m1, m2 = a.density * a.radius ^ 3, b.density * b.radius ^ 3
  local mean = (m1 * u + m2 * w) / (m1 + m2)
  u, w = mean + e * (mean - u), mean + e * (mean - w)
  a.velocity = vec(u * nx - s * ny, u * ny + s * nx)
  b.velocity = vec(w * nx - t * ny, w * ny + t * nx)
end
restitution = 0.5
)lua";

/// The same with a table of what each circle has, read at first and written back at last.
inline constexpr char tables[] = R"lua(local walls = {vec(1, 0), vec(-1, 0), vec(0, 1), vec(0, -1)}
local function read()
  local state = {}
  for i, c in ipairs(circles) do
    state[i] = {p = c.position, v = c.velocity, r = c.radius}
  end
  return state
end
local function write(state)
  for i, s in ipairs(state) do
    circles[i].position = s.p
    circles[i].velocity = s.v
  end
end
local function touch(a, b)
  local n = (b.p - a.p):normalized()
  local depth = a.r + b.r - (b.p - a.p):dot(n)
  local closing = (a.v - b.v):dot(n)
  if depth <= 0 or closing <= 0 then return end
  a.p = a.p - depth / 2 * n
  b.p = b.p + depth / 2 * n
  a.v = a.v - closing * n
  b.v = b.v + closing * n
end
function on_load()
  gravity = vec(0, 0)
  circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0)
  circle2.position, circle2.velocity = vec(2, -2), vec(0, 2)
end
function on_update(h)
  local state = read()
  for _, s in ipairs(state) do
    s.p = s.p + s.v * h
    for _, w in ipairs(walls) do
      local depth = square.half_width - s.r - s.p:dot(w)
      local into = s.v:dot(w)
      if depth < 0 and into > 0 then
        s.p = s.p + depth * w
        s.v = s.v - 2 * into * w
      end
    end
  end
  touch(state[1], state[2])
  write(state)
end
)lua";

/// Step 15, with masses and a push.
inline constexpr char weighed[] = R"lua(function on_load()
  gravity = vec(0, 0)
  circle1.position, circle1.velocity = vec(-2.5, 2), vec(1, 0)
  circle2.position, circle2.velocity = vec(0, 2), vec(-1, 0)
  circle1.radius, circle1.density = 0.2, 1
  circle2.radius, circle2.density = 0.2, 2
end
local function mass_of(c)
  local volume = 4 / 3 * math.pi * c.radius ^ 3
  return c.density * 1000 * volume
end
local function push(c, p)
  c.velocity = c.velocity + p / mass_of(c)
end
local function meet(a, b)
  local line = b.position - a.position
  local gap = line:length() - a.radius - b.radius
  if gap > 0 then return end
  local n = line:normalized()
  local closing = dot(a.velocity - b.velocity, n)
  if closing <= 0 then return end
  local ma, mb = mass_of(a), mass_of(b)
  local m = ma * mb / (ma + mb)
  local p = 2 * m * closing * n
  push(a, -p)
  push(b, p)
end
function on_update(h)
  for _, c in ipairs(circles) do
    local p, v, w = c.position, c.velocity, square.half_width - c.radius
    if math.abs(p.x) > w and p.x * v.x > 0 then v = vec(-v.x, v.y) end
    if math.abs(p.y) > w and p.y * v.y > 0 then v = vec(v.x, -v.y) end
    c.velocity = v
    c.position = p + v * h
  end
  meet(circle1, circle2)
end
)lua";

/// Step 5 with questions of two lines, whose answers change values that are written down at last.
inline constexpr char walled[] = R"lua(function on_load()
  gravity = vec(0, -9.81)
  circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0)
  circle2.position, circle2.velocity = vec(-2, 2), vec(2, 0)
end
local function keep(c, old)
  local p, v, r = c.position, c.velocity, c.radius
  if (p.x + r > square.right and v.x > 0)
    or (p.x - r < square.left and v.x < 0) then
    c.position = vec(old.x, p.y)
    v = vec(-v.x, v.y)
  end
  if (p.y + r > square.top and v.y > 0)
    or (p.y - r < square.bottom and v.y < 0) then
    c.position = vec(c.position.x, old.y)
    v = vec(v.x, -v.y)
  end
  c.velocity = v
end
function on_update(h)
  local old1, old2 = circle1.position, circle2.position
  circle1.position = old1 + circle1.velocity * h
  circle1.velocity = circle1.velocity + gravity * h
  circle2.velocity = circle2.velocity + gravity * h
  circle2.position = old2 + circle2.velocity * h
  keep(circle1, old1)
  keep(circle2, old2)
end
)lua";

/// Step 16 with one function for the new velocity of either circle.
inline constexpr char called[] = R"lua(function on_load()
  gravity = vec(0, 0)
  restitution = 0.5
  circle1.position, circle1.velocity = vec(-2.5, 2), vec(1, 0)
  circle2.position, circle2.velocity = vec(0, 2), vec(-1, 0)
  circle1.radius, circle2.radius = 0.2, 0.2
  circle1.density, circle2.density = 1, 2
  for _, c in ipairs(circles) do
    c.mass = 1000 * c.density * 4 / 3 * math.pi * c.radius ^ 3
  end
end
local function after(m, u, w, k)
  return (m * u + w * k + restitution * w * (k - u)) / (m + w)
end
local function move(c, h)
  local old = c.position
  c.velocity = c.velocity + gravity * h
  c.position = c.position + c.velocity * h
  local lim, p, v = square.half_width - c.radius, c.position, c.velocity
  if math.abs(p.x) > lim and p.x * v.x > 0 then v, c.position = vec(-v.x, v.y), old end
  if math.abs(p.y) > lim and p.y * v.y > 0 then v, c.position = vec(v.x, -v.y), old end
  c.velocity = v
end
function on_update(h)
  local p1, p2 = circle1.position, circle2.position
  move(circle1, h)
  move(circle2, h)
  local d = circle2.position - circle1.position
  if d:length() < circle1.radius + circle2.radius then
    local n = (p2 - p1):normalized()
    local u1 = dot(circle1.velocity, n)
    local u2 = dot(circle2.velocity, n)
    if u1 > u2 then
      local v1 = after(circle1.mass, u1, circle2.mass, u2)
      local v2 = after(circle2.mass, u2, circle1.mass, u1)
      circle1.velocity = circle1.velocity + (v1 - u1) * n
      circle2.velocity = circle2.velocity + (v2 - u2) * n
      circle1.position, circle2.position = p1, p2
    end
  end
end
)lua";

} // namespace cradle::programs
