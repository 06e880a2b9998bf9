function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, -2)
  circle2.velocity = vec(0, 2)
  circle1.radius = 0.2
  circle2.radius = 0.4
end

local function bounce(c)
  local p, v, r = c.position, c.velocity, c.radius
  if (p.x < square.left + r and v.x < 0) or (p.x > square.right - r and v.x > 0) then
    v = vec(-1 * v.x, v.y)
  end
  if (p.y < square.bottom + r and v.y < 0) or (p.y > square.top - r and v.y > 0) then
    v = vec(v.x, -1 * v.y)
  end
  c.position = vec(math.max(square.left + r, math.min(square.right - r, p.x)),
                   math.max(square.bottom + r, math.min(square.top - r, p.y)))
  c.velocity = v
end

-- the share of the step after which the circles touch, nil if they do not
local function share_until_hit(d, w, reach)
  local a, b, c = w:dot(w), d:dot(w), d:dot(d) - reach * reach
  if b >= 0 then return nil end
  if c <= 0 then return 0 end
  local root = b * b - a * c
  if root < 0 then return nil end
  local s = (-b - math.sqrt(root)) / a
  if s > 1 then return nil end
  return s
end

local function answer(a, b)
  local n = (b.position - a.position):normalized()
  local u = (a.velocity - b.velocity):dot(n)
  a.velocity = a.velocity - u * n
  b.velocity = b.velocity + u * n
end

function on_update(dt)
  local a, b = circle1, circle2
  a.velocity = a.velocity + gravity * dt
  b.velocity = b.velocity + gravity * dt
  local s = share_until_hit(b.position - a.position, (b.velocity - a.velocity) * dt, a.radius + b.radius)
  if s then
    a.position = a.position + a.velocity * (s * dt)
    b.position = b.position + b.velocity * (s * dt)
    answer(a, b)
    local rest = (1 - s) * dt
    a.position = a.position + a.velocity * rest
    b.position = b.position + b.velocity * rest
  else
    a.position = a.position + a.velocity * dt
    b.position = b.position + b.velocity * dt
  end
  bounce(a)
  bounce(b)
end
