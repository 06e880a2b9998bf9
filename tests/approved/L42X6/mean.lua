function on_load()
  gravity = vec(0, -9.81)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(-2, 2)
  circle2.velocity = vec(2, 0)
end

local function euler(c, dt)
  c.position = c.position + c.velocity * dt
  c.velocity = c.velocity + gravity * dt
end

local function verlet(c, dt)
  local old = c.velocity
  c.velocity = old + gravity * dt
  c.position = c.position + (old + c.velocity) * dt / 2
end

local function walls(c, old)
  local p, v, r = c.position, c.velocity, c.radius
  if p.x + r > square.right or p.x - r < square.left then
    c.position = old
    v = vec(-v.x, v.y)
  end
  if p.y + r > square.top or p.y - r < square.bottom then
    c.position = old
    v = vec(v.x, -v.y)
  end
  c.velocity = v
end

function on_update(dt)
  local old1, old2 = circle1.position, circle2.position
  euler(circle1, dt)
  verlet(circle2, dt)
  walls(circle1, old1)
  walls(circle2, old2)
end
