-- right
function on_load()
  gravity = vec(0, -9.81)
end

local function euler(pos, vel, dt)
  local ax, ay = gravity.x, gravity.y
  local x = pos.x + vel.x * dt
  local y = pos.y + vel.y * dt
  local vx = vel.x + ax * dt
  local vy = vel.y + ay * dt
  return vec(x, y), vec(vx, vy)
end

local function is_outside(value, low, high, speed)
  local below = value < low and speed < 0
  local above = value > high and speed > 0
  return below or above
end

function on_update(dt)
  local before = circle1.position
  local pos, vel = euler(circle1.position, circle1.velocity, dt)
  local r = circle1.radius
  local left, right = square.left + r, square.right - r
  local bottom, top = square.bottom + r, square.top - r
  local factor_x, factor_y = 1, 1
  if is_outside(pos.x, left, right, vel.x) then
    factor_x = -1
    pos = before
  end
  if is_outside(pos.y, bottom, top, vel.y) then
    factor_y = -1
    pos = before
  end
  circle1.position = pos
  circle1.velocity = vec(vel.x * factor_x, vel.y * factor_y)
end
