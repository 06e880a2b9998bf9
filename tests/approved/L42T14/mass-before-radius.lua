function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle1.radius = 0.2
  circle1.density = 7.8
  circle2.density = 7.8
  circle1.mass = circle1.density * circle1.radius ^ 3
  circle2.mass = circle2.density * circle2.radius ^ 3
  circle2.radius = 0.252
end

local function wall(c, old)
  local p, v = c.position, c.velocity
  if math.abs(p.x) > square.half_width - c.radius then c.position, v = old, vec(-v.x, v.y) end
  if math.abs(p.y) > square.half_width - c.radius then c.position, v = old, vec(v.x, -v.y) end
  c.velocity = v
end

function on_update(dt)
  local o1, o2 = circle1.position, circle2.position
  circle1.position = o1 + circle1.velocity * dt
  circle2.position = o2 + circle2.velocity * dt
  wall(circle1, o1)
  wall(circle2, o2)
  local d = circle2.position - circle1.position
  local n = d:normalized()
  local close = dot(circle1.velocity - circle2.velocity, n)
  if d:length() < circle1.radius + circle2.radius and close > 0 then
    local M = circle1.mass + circle2.mass
    circle1.velocity = circle1.velocity - n * (2 * circle2.mass / M * close)
    circle2.velocity = circle2.velocity + n * (2 * circle1.mass / M * close)
  end
end
