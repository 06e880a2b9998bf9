local start = {
  { pos = vec(-2.5, 2), vel = vec(1, 0), r = 0.2, rho = 1 },
  { pos = vec(0, 2), vel = vec(-1, 0), r = 0.2, rho = 2 },
}

function on_load()
  gravity = vec(0, -9.81)
  restitution = 0.75
  for i, c in ipairs(circles) do
    c.position = start[i].pos
    c.velocity = start[i].vel
    c.radius = start[i].r
    c.density = start[i].rho
    c.mass = c.density * c.radius ^ 3 * math.pi * 4 / 3
  end
end

-- all circles, however many there are
local function move_all(dt)
  for _, c in ipairs(circles) do
    if c.position.y > square.bottom + c.radius then
      c.velocity = c.velocity + gravity * dt
    end
    c.position = c.position + c.velocity * dt
  end
end

local function keep_inside(c)
  local x, y = c.position.x, c.position.y
  local vx, vy = c.velocity.x, c.velocity.y
  local r = c.radius
  if x < square.left + r then
    x = square.left + r
    vx = restitution * math.abs(vx)
  end
  if x > square.right - r then
    x = square.right - r
    vx = -restitution * math.abs(vx)
  end
  if y < square.bottom + r then
    y = square.bottom + r
    vy = restitution * math.abs(vy)
  end
  if y > square.top - r then
    y = square.top - r
    vy = -restitution * math.abs(vy)
  end
  c.position = vec(x, y)
  c.velocity = vec(vx, vy)
end

local function touch(a, b)
  local d = a.position - b.position
  local reach = a.radius + b.radius
  return d:dot(d) < reach * reach
end

local function answer(a, b)
  local n = (b.position - a.position):normalized()
  local ua, ub = a.velocity:dot(n), b.velocity:dot(n)
  if ua <= ub then return end
  local M = a.mass + b.mass
  a.velocity = a.velocity + (1 + restitution) * b.mass / M * (ub - ua) * n
  b.velocity = b.velocity + (1 + restitution) * a.mass / M * (ua - ub) * n
end

function on_update(dt)
  move_all(dt)
  for _, c in ipairs(circles) do
    keep_inside(c)
  end
  for i = 1, #circles do
    for j = i + 1, #circles do
      if touch(circles[i], circles[j]) then
        answer(circles[i], circles[j])
      end
    end
  end
end
