local function fits(c, x, y)
  local r = c.radius
  return x - r >= square.left and x + r <= square.right, y - r >= square.bottom and y + r <= square.top
end

local function advance(c, h)
  local nextpos = c.position + c.velocity * h
  local nextvel = c.velocity
  local okx, oky = fits(c, nextpos.x, nextpos.y)
  local x, y, vx, vy = nextpos.x, nextpos.y, nextvel.x, nextvel.y
  if not okx then
    x = c.position.x
    vx = -vx
  end
  if not oky then
    y = c.position.y
    vy = -vy
  end
  c.position = vec(x, y)
  c.velocity = vec(vx, vy)
end

function on_load()
  circle1.velocity = vec(2, 0)
end

function on_update(timestep)
  advance(circle1, timestep)
end
