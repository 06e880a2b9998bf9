-- right
function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, 2)
  circle2.velocity = vec(0, 0)
end

local function go(c, dt)
  local was = c.position
  c.velocity = c.velocity + gravity * dt
  c.position = c.position + c.velocity * dt
  return was
end

local function past(c)
  local p, r = c.position, c.radius
  local out_x = p.x - r < square.left or p.x + r > square.right
  local out_y = p.y - r < square.bottom or p.y + r > square.top
  return out_x, out_y
end

local function walls(c, was)
  local out_x, out_y = past(c)
  local v = c.velocity
  if out_x then v = vec(-v.x, v.y) end
  if out_y then v = vec(v.x, -v.y) end
  if out_x or out_y then
    c.position = was
    c.velocity = v
  end
end

local function gap_between(a, b)
  local dx = b.position.x - a.position.x
  local dy = b.position.y - a.position.y
  local centres = math.sqrt(dx * dx + dy * dy)
  return centres - a.radius - b.radius
end

local function are_approaching(a, b)
  local to_b = b.position - a.position
  local relative = a.velocity - b.velocity
  return dot(relative, to_b) > 0
end

function on_update(dt)
  local was1 = go(circle1, dt)
  local was2 = go(circle2, dt)
  walls(circle1, was1)
  walls(circle2, was2)
  local gap = gap_between(circle1, circle2)
  local coming = are_approaching(circle1, circle2)
  if gap < 0 and coming then
    circle1.position = was1
    circle2.position = was2
    local v1, v2 = circle1.velocity, circle2.velocity
    circle1.velocity = v2
    circle2.velocity = v1
  end
end
