function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, -2)
  circle2.velocity = vec(0, 2)
end

local p1, p2, v1, v2

local function limits(p, v, r)
  local x, y, vx, vy = p.x, p.y, v.x, v.y
  if x < square.left + r then x, vx = square.left + r, math.abs(vx) end
  if x > square.right - r then x, vx = square.right - r, -math.abs(vx) end
  if y < square.bottom + r then y, vy = square.bottom + r, math.abs(vy) end
  if y > square.top - r then y, vy = square.top - r, -math.abs(vy) end
  return vec(x, y), vec(vx, vy)
end

function on_update(dt)
  p1, v1 = circle1.position, circle1.velocity
  p2, v2 = circle2.position, circle2.velocity
  p1, v1 = limits(p1 + v1 * dt, v1, circle1.radius)
  p2, v2 = limits(p2 + v2 * dt, v2, circle2.radius)
  local n = (p2 - p1):normalized()
  if (p2 - p1):length() < circle1.radius + circle2.radius and dot(v1 - v2, n) > 0 then
    local along1 = dot(v1, n) * n
    local along2 = dot(v2, n) * n
    v1 = v1 - along1 + along2
    v2 = v2 - along2 + along1
  end
  circle1.position, circle1.velocity = p1, v1
  circle2.position = p2
end
