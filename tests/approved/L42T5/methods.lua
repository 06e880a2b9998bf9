-- right
function on_load()
  gravity = vec(0, -9.81)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(-2, 2)
  circle2.velocity = vec(2, 0)
end

local methods = {
  euler = function(p, v, a, dt)
    local new_p = p + v * dt
    local new_v = v + a * dt
    return new_p, new_v
  end,
  symplectic = function(p, v, a, dt)
    local new_v = v + a * dt
    local new_p = p + new_v * dt
    return new_p, new_v
  end,
}
local chosen = {"euler", "symplectic"}

local function turn(x, vx, low, high)
  if x < low and vx < 0 then return -vx, true end
  if x > high and vx > 0 then return -vx, true end
  return vx, false
end

local function walls(p, v, old, r)
  local vx, hit_x = turn(p.x, v.x, square.left + r, square.right - r)
  local vy, hit_y = turn(p.y, v.y, square.bottom + r, square.top - r)
  if hit_x or hit_y then
    p = old
  end
  return p, vec(vx, vy)
end

function on_update(dt)
  for i, c in ipairs(circles) do
    local name = chosen[i]
    local old = c.position
    local p, v = methods[name](c.position, c.velocity, gravity, dt)
    p, v = walls(p, v, old, c.radius)
    c.position = p
    c.velocity = v
  end
end
