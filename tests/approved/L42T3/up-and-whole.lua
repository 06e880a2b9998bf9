function on_load()
  gravity = vec(0, -9.81)
  circle1.velocity = vec(2, 0)
end

-- one coordinate between two walls: what is beyond the wall comes back
local function mirror(place, speed, low, high)
  if place < low and speed < 0 then
    return 2 * low - place, -speed
  end
  if place > high and speed > 0 then
    return 2 * high - place, -speed
  end
  return place, speed
end

local function walls(c)
  local x, vx = mirror(c.position.x, c.velocity.x, square.left + c.radius, square.right)
  local y, vy = mirror(c.position.y, c.velocity.y, square.bottom + c.radius, square.top - c.radius)
  c.position = vec(x, y)
  c.velocity = vec(vx, vy)
end

local function step_circle(c, dt)
  c.position = c.position + dt * c.velocity
  c.velocity = c.velocity - dt * gravity
end

function on_update(dt)
  for _, c in ipairs(circles) do
    step_circle(c, dt)
    walls(c)
  end
end
