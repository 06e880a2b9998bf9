local function fits(c, x, y)
  local r = c.radius
  return x - r >= square.left and x + r <= square.right, y - r >= square.bottom and y + r <= square.top
end

local function advance(c, h)
  local nextvel = c.velocity + gravity * h
  local nextpos = c.position + nextvel * h
  local okx, oky = fits(c, nextpos.x, nextpos.y)
  local x, y, vx, vy = nextpos.x, nextpos.y, nextvel.x, nextvel.y
  if not okx then
    x = c.position.x
    vx = -restitution * vx
  end
  if not oky then
    y = c.position.y
    vy = -restitution * vy
  end
  c.position = vec(x, y)
  c.velocity = vec(vx, vy)
end

local function m(c)
  return 1000 * c.density * (4 / 3) * math.pi * c.radius ^ 3
end

local function meet(a, b, was_a, was_b)
  local way = b.position - a.position
  if way:length() >= a.radius + b.radius then
    return false
  end
  local angle = math.atan(way.y, way.x)
  local c, s = math.cos(angle), math.sin(angle)
  -- along and across the line of centres
  local a1 = a.velocity.x * c + a.velocity.y * s
  local a2 = a.velocity.y * c - a.velocity.x * s
  local b1 = b.velocity.x * c + b.velocity.y * s
  local b2 = b.velocity.y * c - b.velocity.x * s
  if a1 <= b1 then
    return false
  end
  a.position, b.position = was_a, was_b
  local ma, mb = m(a), m(b)
  local v = (ma * a1 + mb * b1) / (ma + mb)
  local gap = restitution * (a1 - b1) / (ma + mb)
  a1 = v - mb * gap
  b1 = v + ma * gap
  a.velocity = vec(a1 * c - a2 * s, a1 * s + a2 * c)
  b.velocity = vec(b1 * c - b2 * s, b1 * s + b2 * c)
  return true
end

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
end

function on_update(timestep)
  local was1, was2 = circle1.position, circle2.position
  advance(circle1, timestep)
  advance(circle2, timestep)
  meet(circle1, circle2, was1, was2)
end
