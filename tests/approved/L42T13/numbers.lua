function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, -2)
  circle2.velocity = vec(0, 2)
  circle1.radius = 0.2
  circle2.radius = 0.4
end

function on_update(dt)
  local x1, y1 = circle1.position.x, circle1.position.y
  local vx1, vy1 = circle1.velocity.x, circle1.velocity.y
  local r1 = circle1.radius
  local ox1, oy1 = x1, y1
  vx1 = vx1 + gravity.x * dt
  vy1 = vy1 + gravity.y * dt
  x1 = x1 + vx1 * dt
  y1 = y1 + vy1 * dt
  local x2, y2 = circle2.position.x, circle2.position.y
  local vx2, vy2 = circle2.velocity.x, circle2.velocity.y
  local r2 = circle2.radius
  local ox2, oy2 = x2, y2
  vx2 = vx2 + gravity.x * dt
  vy2 = vy2 + gravity.y * dt
  x2 = x2 + vx2 * dt
  y2 = y2 + vy2 * dt
  if x1 > square.right - r1 or x1 < square.left + r1 then
    x1 = ox1
    vx1 = -vx1
  end
  if y1 > square.top - r1 or y1 < square.bottom + r1 then
    y1 = oy1
    vy1 = -vy1
  end
  if x2 > square.right - r2 or x2 < square.left + r2 then
    x2 = ox2
    vx2 = -vx2
  end
  if y2 > square.top - r2 or y2 < square.bottom + r2 then
    y2 = oy2
    vy2 = -vy2
  end
  local dx, dy = x2 - x1, y2 - y1
  if dx * dx + dy * dy < (r1 + r2) * (r1 + r2) then
    local distance = math.sqrt(dx * dx + dy * dy)
    local nx, ny = dx / distance, dy / distance
    local tx, ty = -ny, nx
    local n1 = vx1 * nx + vy1 * ny
    local t1 = vx1 * tx + vy1 * ty
    local n2 = vx2 * nx + vy2 * ny
    local t2 = vx2 * tx + vy2 * ty
    if n1 > n2 then
      x1, y1, x2, y2 = ox1, oy1, ox2, oy2
      n1, n2 = n2, n1
      vx1 = n1 * nx + t1 * tx
      vy1 = n1 * ny + t1 * ty
      vx2 = n2 * nx + t2 * tx
      vy2 = n2 * ny + t2 * ty
    end
  end
  circle1.position = vec(x1, y1)
  circle1.velocity = vec(vx1, vy1)
  circle2.position = vec(x2, y2)
  circle2.velocity = vec(vx2, vy2)
end
