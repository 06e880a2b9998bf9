local m = {}

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
  for i, c in ipairs(circles) do
    m[i] = c.density * 4 / 3 * math.pi * c.radius ^ 3
  end
end

-- turns a vector by the angle a
local function turn(v, a)
  local c, s = math.cos(a), math.sin(a)
  return vec(v.x * c - v.y * s, v.x * s + v.y * c)
end

local function edge(q, old, speed, low, high)
  if q < low and speed < 0 or q > high and speed > 0 then
    return old, -restitution * speed
  end
  return q, speed
end

local function advance(c, dt)
  local old = c.position
  local v = c.velocity + gravity * dt
  local q = old + v * dt
  local x, vx = edge(q.x, old.x, v.x, square.left + c.radius, square.right - c.radius)
  local y, vy = edge(q.y, old.y, v.y, square.bottom + c.radius, square.top - c.radius)
  if math.abs(vy) < 0.5 then vy = 0 end
  c.position = vec(x, y)
  c.velocity = vec(vx, vy)
end

function on_update(dt)
  advance(circle1, dt)
  advance(circle2, dt)
  local d = circle2.position - circle1.position
  if d:length() < circle1.radius + circle2.radius then
    local alpha = math.atan(d.y, d.x)
    -- in the turned picture the line of centres is the x axis
    local a = turn(circle1.velocity, -alpha)
    local b = turn(circle2.velocity, -alpha)
    if a.x > b.x then
      local mean = (m[1] * a.x + m[2] * b.x) / (m[1] + m[2])
      local ax = mean + restitution * m[2] / (m[1] + m[2]) * (b.x - a.x)
      local bx = mean + restitution * m[1] / (m[1] + m[2]) * (a.x - b.x)
      a, b = vec(ax, a.y), vec(bx, b.y)
      circle1.velocity = turn(a, alpha)
      circle2.velocity = turn(b, alpha)
    end
  end
end
