-- look before you leap: would the next place be outside?
local function fits(value, c)
  return value + c.radius <= square.right and value - c.radius >= square.left
end

function on_load()
  circle1.velocity = vec(2, 0)
end

function on_update(timestep)
  local vx, vy = circle1.velocity.x, circle1.velocity.y
  local p = circle1.position
  local next_x = p.x + 2 * vx * timestep
  local next_y = p.y + vy * timestep
  if not fits(next_x, circle1) then
    vx = -vx
    vy = -vy
    next_x = p.x
  end
  if not fits(next_y, circle1) then
    vy = -vy
    next_y = p.y
  end
  circle1.velocity = vec(vx, vy)
  circle1.position = vec(next_x, next_y)
end
