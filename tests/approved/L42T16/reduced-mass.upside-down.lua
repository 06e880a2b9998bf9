-- move to the moment of contact, answer, use up the rest of the step
function on_load()
  gravity = vec(0, 0)
  restitution = 0.5
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle1.radius, circle2.radius = 0.2, 0.2
  circle1.density, circle2.density = 1, 2
end

-- time until the rims touch, or nil
local function time_to_touch(a, b)
  local d = b.position - a.position
  local w = b.velocity - a.velocity
  local reach = a.radius + b.radius
  local A = dot(w, w)
  local B = dot(d, w)
  local C = dot(d, d) - reach * reach
  if B >= 0 or A == 0 then return nil end
  local D = B * B - A * C
  if D < 0 then return nil end
  return (-B - math.sqrt(D)) / A
end

local function drift(t)
  for _, c in ipairs(circles) do
    c.position = c.position + c.velocity * t
  end
end

local function answer(a, b)
  local n = (b.position - a.position):normalized()
  local ma = a.density * a.radius ^ 3
  local mb = b.density * b.radius ^ 3
  local mu = (ma + mb) / (ma * mb)
  local J = mu * (1 + restitution) * dot(a.velocity - b.velocity, n)
  a.velocity = a.velocity - J / ma * n
  b.velocity = b.velocity + J / mb * n
end

local function wall(c)
  local p, v = c.position, c.velocity
  if p.x > square.right - c.radius and v.x > 0 or p.x < square.left + c.radius and v.x < 0 then
    v = vec(-v.x, v.y)
  end
  if p.y > square.top - c.radius and v.y > 0 or p.y < square.bottom + c.radius and v.y < 0 then
    v = vec(v.x, -v.y)
  end
  c.velocity = v
end

function on_update(dt)
  for _, c in ipairs(circles) do c.velocity = c.velocity + gravity * dt end
  local t = time_to_touch(circle1, circle2)
  if t and t <= dt then
    t = math.max(t, 0)
    drift(t)
    answer(circle1, circle2)
    drift(dt - t)
  else
    drift(dt)
  end
  wall(circle1)
  wall(circle2)
end
