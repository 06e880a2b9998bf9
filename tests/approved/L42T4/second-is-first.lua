local Ball = {}

function Ball.new(circle)
  local ball = { circle = circle, before = circle.position }
  for name, method in pairs(Ball) do ball[name] = method end
  return ball
end

function Ball:euler(dt)
  local c = self.circle
  self.before = c.position
  c.position = c.position + c.velocity * dt
  c.velocity = c.velocity + gravity * dt
end

function Ball:bounce()
  local c, old = self.circle, self.before
  local p, v = c.position, c.velocity
  if math.abs(p.x) + c.radius > square.half_width and p.x * v.x > 0 then
    p = vec(old.x, p.y)
    v = vec(-v.x, v.y)
  end
  if math.abs(p.y) + c.radius > square.half_width and p.y * v.y > 0 then
    p = vec(p.x, old.y)
    v = vec(v.x, -v.y)
  end
  c.position = p
  c.velocity = v
end

local first, second

function on_load()
  gravity = vec(0, -9.81)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(-2, 2)
  circle2.velocity = vec(2, 0)
  first = Ball.new(circle1)
  second = Ball.new(circle1)
end

function on_update(dt)
  first:euler(dt)
  second:euler(dt)
  first:bounce()
  second:bounce()
end
