local function fall(y, v, g, dt)
  v = v + g * dt
  return y + v * dt, v
end

local function floor_hit(y, v, low, old)
  if y < low and v < 0 then
    return old, -restitution * v
  end
  return y, v
end

function on_load()
  gravity = vec(0, -9.81)
  restitution = 0.8
end

function on_update(dt)
  local c = circle1
  local old = c.position.y
  local y, vy = fall(old, c.velocity.y, gravity.y, dt)
  y, vy = floor_hit(y, vy, square.bottom + c.radius, old)
  local vx = c.velocity.x + gravity.x * dt
  c.position = vec(c.position.x + vx * dt, y)
  c.velocity = vec(vx, vy)
end
