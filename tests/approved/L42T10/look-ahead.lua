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
    vx = -vx
  end
  if not oky then
    y = c.position.y
    vy = -vy
  end
  c.position = vec(x, y)
  c.velocity = vec(vx, vy)
end

local function meet(a, b, was_a, was_b)
  local way = b.position - a.position
  if way:length() >= a.radius + b.radius then
    return false
  end
  a.position, b.position = was_a, was_b
  local keep = b.velocity
  b.velocity = a.velocity
  a.velocity = keep
  return true
end

function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, 2)
  circle2.velocity = vec(0, 0)
end

function on_update(timestep)
  local was1, was2 = circle1.position, circle2.position
  advance(circle1, timestep)
  advance(circle2, timestep)
  meet(circle1, circle2, was1, was2)
end
