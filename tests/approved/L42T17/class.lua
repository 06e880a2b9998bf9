local Ball = {}

function Ball.new(circle)
  local ball = { circle = circle, before = circle.position }
  for name, method in pairs(Ball) do ball[name] = method end
  return ball
end

function Ball:move(dt)
  local c = self.circle
  self.before = c.position
  c.velocity = c.velocity + gravity * dt
  c.position = c.position + c.velocity * dt
end

function Ball:bounce()
  local c, old = self.circle, self.before
  local p, v = c.position, c.velocity
  if math.abs(p.x) + c.radius > square.half_width and p.x * v.x > 0 then
    p = vec(old.x, p.y)
    v = vec(-restitution * v.x, v.y)
  end
  if math.abs(p.y) + c.radius > square.half_width and p.y * v.y > 0 then
    p = vec(p.x, old.y)
    v = vec(v.x, -restitution * v.y)
  end
  c.position = p
  c.velocity = v
end

function Ball:mass()
  return self.circle.density * self.circle.radius ^ 3
end

function Ball:touches(other)
  local reach = self.circle.radius + other.circle.radius
  return (self.circle.position - other.circle.position):length() < reach
end

function Ball:hit(other)
  local a, b = self.circle, other.circle
  local n = (other.before - self.before):normalized()
  local ua, ub = dot(a.velocity, n), dot(b.velocity, n)
  if ua - ub <= 0 then return end
  a.position, b.position = self.before, other.before
  local ma, mb = self:mass(), other:mass()
  local common = (ma * ua + mb * ub) / (ma + mb)
  local va = common - restitution * (ua - common)
  local vb = common - restitution * (ub - common)
  a.velocity = a.velocity + (va - ua) * n
  b.velocity = b.velocity + (vb - ub) * n
end

local first, second

function on_load()
  gravity = vec(0, -9.81)
  restitution = 0.75
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle1.radius = 0.2
  circle2.radius = 0.2
  circle1.density = 1
  circle2.density = 2
  first = Ball.new(circle1)
  second = Ball.new(circle2)
end

function on_update(dt)
  first:move(dt)
  second:move(dt)
  first:bounce()
  second:bounce()
  if first:touches(second) then
    first:hit(second)
  end
end
