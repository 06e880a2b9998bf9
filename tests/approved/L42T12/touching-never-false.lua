function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, -2)
  circle2.velocity = vec(0, 2)
end

local touching = false

local function move(c, dt)
  local old = c.position
  c.position = c.position + c.velocity * dt
  local p, r = c.position, c.radius
  if p.x + r > square.right or p.x - r < square.left then
    c.position = vec(old.x, p.y)
    c.velocity = vec(-c.velocity.x, c.velocity.y)
  end
  if p.y + r > square.top or p.y - r < square.bottom then
    c.position = vec(c.position.x, old.y)
    c.velocity = vec(c.velocity.x, -c.velocity.y)
  end
end

function on_update(timestep)
  move(circle1, timestep)
  move(circle2, timestep)
  local d = circle2.position - circle1.position
  if d:length() < circle1.radius + circle2.radius and not touching then
    local n = d:normalized()
    local a = n * dot(circle1.velocity, n)
    local b = n * dot(circle2.velocity, n)
    circle1.velocity = circle1.velocity - a + b
    circle2.velocity = circle2.velocity - b + a
    touching = true
  end
end
