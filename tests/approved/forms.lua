--== nothing
--== a line
x = 1
--== a comment
-- x = 1
--== assignments of all kinds
a, b.c, d[1], e[2].f = 1, x.y, {1, z = 2}, f()
local p, q = f()
local r <const> = 3
circles[1].velocity, circles[2].velocity = circles[2].velocity, circles[1].velocity
self.radius = self.circle.radius
t = {x = a.radius, y = 2 * b, ["k"] = 1, [1] = z, u = {v = w}}
x = -a + not b == #c
x = nil
x = true and y or false
for k = 1, 3 do x = k end
for k, v in pairs(t) do x = v end
--== functions of all kinds
local function one(a, b, ...) return a + b end
function two() end
function Ball.new(x, y) return {x = x, y = y} end
function Ball:move(h) self.x = self.x + h end
local three = function(c) return c.radius end
kept.four = function(c) if c then return one(c, 1) end end
on_update = function(dt)
  repeat two() until three(circles[1]) > 1
  while one(1, 2) < 3 do kept.four(circles[1]) end
  do local ball = Ball.new(1, 2) ball:move(dt) end
end
local function unused(a) return never(a) end
local function never(a) return unused(a) end
--== blocks that do not end
function on_update(h)
  if h then
    for i = 1, 2 do
--== blocks that end too often
end end
x = 1 end
--== brackets that do not close
x = f(a, (b
y = t[1
--== twins
function on_update(h)
  a.position = a.position + h * a.velocity
  b.position = b.position + h * b.velocity
  if a.position.x + a.radius > 4 then a.velocity = vec(-a.velocity.x, a.velocity.y) end
  if b.position.x + b.radius > 4 then b.velocity = vec(-b.velocity.x, b.velocity.y) end
  if a.position.x - a.radius < 4 then a.velocity = vec(-a.velocity.x, a.velocity.y) end
  x = 1
  y = 2
end
--== twins that are far apart
a.velocity = a.velocity + 1 * h

local forgotten = 1
local also, both = 2, 3







local near = 4


b.velocity = b.velocity + 2 * h
c.velocity = c.velocity + 3 * h
--== names of the timestep
function on_load() timestep = 1 end
function on_update(step_length)
  dt = step_length
  x = v * dt + a * h ^ 2 + timestep
end
--== three circles and more
function on_update(h)
  one.position = two.position + three.velocity + four.radius * h
  five.radius = six.position.x
  self.ball.position = other.ball.velocity
end
--== masses by other names
function on_update(h)
  local mass1, mass2 = c1.density * c1.radius ^ 3, c2.density * c2.radius ^ 3
  local ma, mb = mass1, mass2
  local r1, r2, reach = c1.radius, c2.radius, c1.radius + c2.radius
  local normal, dir, direction = (c2.position - c1.position):normalized(), n, dn
  local weight = 4 / 3 * math.pi * r1 ^ 3
  c1.velocity = c1.velocity - mb / (ma + mb) * normal
end
--== masses of a helper
local function mass(radius, density)
  return density * radius ^ 3
end
local function mass_of(c)
  local r, rho = c.radius, c.density
  return 4 / 3 * math.pi * r * r * r * rho
end
local function push(p, q, n)
  local j = mass_of(p) * mass_of(q) / (mass_of(p) + mass_of(q))
  p.velocity, q.velocity = p.velocity - j * n, q.velocity + j * n
end
function on_update(h) push(circles[1], circles[2], vec(1, 0)) end
--== pairs in loops
function on_update(dt)
  for i = 1, #circles do
    for j = i + 1, #circles do
      local p, q = circles[i], circles[j]
      local d = q.position - p.position
      if d:length() < p.radius + q.radius and (p.velocity - q.velocity):dot(d) > 0 then
        p.velocity, q.velocity = q.velocity, p.velocity
      end
    end
  end
end
--== walls asked for in all ways
function on_update(h)
  local c = circle1
  if c.position.x + c.radius > square.right or c.position.x - c.radius < square.left then
    c.velocity = vec(-c.velocity.x, c.velocity.y)
  end
  if math.abs(c.position.y) >= square.half_width - c.radius then c.velocity = -c.velocity end
  if c.position.y <= -4 + c.radius then c.position = vec(c.position.x, -4 + c.radius) end
  local y = math.max(c.position.y, square.bottom + c.radius)
  local inside = square.left < c.position.x and c.position.x < square.right
  if not inside then c.position = old end
end
--== questions behind names
function on_update(h)
  local d = circle2.position - circle1.position
  local dist, reach = d:length(), circle1.radius + circle2.radius
  local touches = dist <= reach
  local nears = (circle1.velocity - circle2.velocity):dot(d) > 0
  local both = touches and nears
  if both then circle1.velocity = vec(0, 0) end
  if touches == true and not (nears == false) then circle2.velocity = vec(0, 0) end
end
--== text, numbers and comments
x = "a.radius + 1" -- b.radius * 2
y = [[ c.velocity ]] --[[ d.position
e.position ]] z = 0x1F + 1e-3 + .5 + 3. + 1E+2
w = 'it\'s' .. "\"q\"" ; v = x
goto done ::done::
--== two that are not alike
a.velocity = u + w * h
a.velocity = u * w * h
b.velocity = u - w * h
b.velocity = u / w * h
--== one after the other
a.velocity = b.velocity
b.velocity = a.velocity
local p = q
q = p
x1 = x2
x2 = x1
--== the same twice
m1 = f(c1)
m1 = f(c1)
x = y
x = y
local r2 = g(c2)

local r2 = g(c2)
--== a field at the start
a.position = 1
x.a.position = 2
a.position.x = b.radius
c.velocity, d.velocity, e.velocity = 1, 2, 3
f.radius = g.radius
--== four circles in a line
x = a.radius + b.radius + c.radius + d.radius
y = 1
--== numbers with names
local speed, e = 4, -0.5
local half = 0.5 -- of it
count = 0
count = count + 1
if count < 3 then count = count - 2 end
if speed > 3 then speed = 1.5 end
while half <= count do half = half + 0.25 end
--== what is called
local function mass(c) return c.density * c.radius ^ 3 end
local function inverse_mass(c) return 1 / mass(c) end
function on_update(h)
  local m1 = mass(a)
  local m2 = mass(a)
  local inv1, inv2 = inverse_mass(a), inverse_mass(b)
  if touches(a, b) then return end
  return mass(b)
end
local function touches(c, d) return mass(c) > mass(d) end
--== what is handed on
local function apply(c, v, w)
  c.velocity = v
  c.position = c.position + w
  c.velocity = -v
  c.velocity = v * 2
  c.velocity = 3
  c.velocity, c.position = v, w
  x = v
  c.velocity = f(v)
end
--== indices of all kinds
function on_load()
  local i, k, j = 1, 2, 3
  bodies[i] = circles[k]
  bodies[k].m = bodies[i].m * bodies[j].m
  if bodies[i] == circles[1] then bodies[1], bodies[2] = bodies[2], bodies[1] end
end
--== brackets that come twice
x = (a.radius + b.radius) * (a.radius + b.radius)
y = f(((u - w) / 2), 1) + f(((u - w) / 2), 1)
z = (u + w)
--== terms that come twice
x = x + u * h + u * h
y = y - g - g
z = z + u + w
if true then x = 1 end
elseif false then y = 2 end
--== helpers of vectors
local function len(v)
  return (v.x ^ 2 + v.y ^ 2) ^ 0.5
end
local function along(v, n)
  return v:dot(n)
end
local function three(u, v, w)
  return u + v + w
end
local function none()
  return circles[1].position
end
--== fields of tables
function on_load()
  for i = 1, #circles do
    local c = circles[i]
    bodies[i] = {p = c.position, v = c.velocity, r = c.radius, rho = c.density}
    bodies[i].m = bodies[i].rho * bodies[i].r ^ 3
  end
end
function on_update(h)
  for _, b in ipairs(bodies) do
    b.p = b.p + h * b.v
    if b.p.x + b.r > 4 then b.v = vec(-b.v.x, b.v.y) end
  end
  local one, two = bodies[1], bodies[2]
  local n, m_a, m_b, rad_1 = (two.p - one.p):normalized(), one.m, two.m, one.r
  one.v = one.v - m_b / (m_a + m_b) * n
  local reach = rad_1 + two.r
  local dirx, unit = n.x, reach * n
end
--== parameters that go together
local function hit(a, b)
  local M1, M2, Mass = mass(a), mass(b), 3
  a.velocity = a.velocity * M1
end
local function hit2(p1, p2, normal, m1, m2)
  p1.velocity = p1.velocity + normal * m1
end
local function ends(c, d, i)
  for _, c in ipairs(circles) do c.position = c.position end
  for k, other in ipairs(circles) do
    if other.radius > d.radius then c.velocity = other.velocity end
  end
  return mass_one * mass_two * r_a * radius(c)
end
