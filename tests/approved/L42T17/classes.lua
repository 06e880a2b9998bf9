-- right
local Ball = {}

function Ball.new(c)
  local self = {c = c}
  for name, method in pairs(Ball) do self[name] = method end
  self.e = function() return restitution end
  return self
end

function Ball:weight()
  return self.c.density * self.c.radius ^ 3
end

function Ball:fall(dt)
  local g = gravity
  self.c.velocity = self.c.velocity + g * dt
  self.c.position = self.c.position + self.c.velocity * dt
end

function Ball:keep_inside()
  local c = self.c
  local e = self.e()
  local x, y = c.position.x, c.position.y
  local vx, vy = c.velocity.x, c.velocity.y
  local limit = square.half_width - c.radius
  if x < -limit then
    x = -limit
    if vx < 0 then vx = -e * vx end
  elseif x > limit then
    x = limit
    if vx > 0 then vx = -e * vx end
  end
  if y < -limit then
    y = -limit
    if vy < 0 then vy = -e * vy end
  elseif y > limit then
    y = limit
    if vy > 0 then vy = -e * vy end
  end
  c.position = vec(x, y)
  c.velocity = vec(vx, vy)
end

function Ball:meet(other)
  local a, b = self.c, other.c
  local gap = b.position - a.position
  local sum = a.radius + b.radius
  if gap:length_squared() >= sum * sum then return end
  local n = gap:normalized()
  local ua = a.velocity:dot(n)
  local ub = b.velocity:dot(n)
  if ua <= ub then return end
  local ma, mb = self:weight(), other:weight()
  local total = ma + mb
  local e = restitution
  local common = (ma * ua + mb * ub) / total
  local wa = common - e * (ua - common)
  local wb = common - e * (ub - common)
  a.velocity = a.velocity + (wa - ua) * n
  b.velocity = b.velocity + (wb - ub) * n
end

local balls = {}

function on_load()
  gravity = vec(0, -9.81)
  restitution = 0.75
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle1.radius = 0.2
  circle1.density = 1
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle2.radius = 0.2
  circle2.density = 2
  for i, c in ipairs(circles) do
    balls[i] = Ball.new(c)
  end
end

function on_update(dt)
  for _, ball in ipairs(balls) do
    ball:fall(dt)
    ball:keep_inside()
  end
  balls[1]:meet(balls[2])
end
