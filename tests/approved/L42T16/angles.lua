-- right
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

local function weight(c)
  return 1000 * c.density * 4 / 3 * math.pi * c.radius ^ 3
end

local function step_one(c, dt)
  local from = c.position
  local speed = c.velocity + gravity * dt
  local to = from + speed * dt
  local r = c.radius
  if to.x > square.right - r and speed.x > 0 or to.x < square.left + r and speed.x < 0 then
    speed = vec(-speed.x, speed.y)
    to = from
  end
  if to.y > square.top - r and speed.y > 0 or to.y < square.bottom + r and speed.y < 0 then
    speed = vec(speed.x, -speed.y)
    to = from
  end
  c.position, c.velocity = to, speed
end

local function rotate(v, angle)
  local c, s = math.cos(angle), math.sin(angle)
  return vec(v.x * c + v.y * s, v.y * c - v.x * s)
end

local function one_dimension(m1, m2, u1, u2)
  local p = m1 * u1 + m2 * u2
  local v1 = (p + m2 * restitution * (u2 - u1)) / (m1 + m2)
  local v2 = (p + m1 * restitution * (u1 - u2)) / (m1 + m2)
  return v1, v2
end

function on_update(dt)
  step_one(circle1, dt)
  step_one(circle2, dt)
  local line = circle2.position - circle1.position
  local near = line:length() < circle1.radius + circle2.radius
  if near then
    local angle = math.atan(line.y, line.x)
    local a, b = rotate(circle1.velocity, angle), rotate(circle2.velocity, angle)
    if a.x > b.x then
      local ax, bx = one_dimension(weight(circle1), weight(circle2), a.x, b.x)
      circle1.velocity = rotate(vec(ax, a.y), -angle)
      circle2.velocity = rotate(vec(bx, b.y), -angle)
    end
  end
end
