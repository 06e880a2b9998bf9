-- right
function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2.3)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, 2)
  circle2.velocity = vec(0, 0)
end

local old = {}

local function push_all(dt)
  for i, c in ipairs(circles) do
    old[i] = c.position
    c.velocity = c.velocity + gravity * dt
    c.position = c.position + c.velocity * dt
  end
end

local function box(i)
  local c = circles[i]
  local reach = square.half_width - c.radius
  local ax, ay = math.abs(c.position.x), math.abs(c.position.y)
  local out_x = ax > reach and c.position.x * c.velocity.x > 0
  local out_y = ay > reach and c.position.y * c.velocity.y > 0
  local fx = out_x and -1 or 1
  local fy = out_y and -1 or 1
  c.velocity = vec(fx * c.velocity.x, fy * c.velocity.y)
  if out_x or out_y then c.position = old[i] end
end

local function hit_each_other()
  local dx = circle2.position.x - circle1.position.x
  local dy = circle2.position.y - circle1.position.y
  local d2 = dx * dx + dy * dy
  local s = circle1.radius + circle2.radius
  if d2 >= s * s then return false end
  local rvx = circle1.velocity.x - circle2.velocity.x
  local rvy = circle1.velocity.y - circle2.velocity.y
  return rvx * dx + rvy * dy > 0
end

local function exchange()
  local ex = old[2].x - old[1].x
  local ey = old[2].y - old[1].y
  local d = math.sqrt(ex * ex + ey * ey)
  local nx, ny = ex / d, ey / d
  local p1 = circle1.velocity.x * nx + circle1.velocity.y * ny
  local p2 = circle2.velocity.x * nx + circle2.velocity.y * ny
  local dp = p2 - p1
  circle1.velocity = vec(circle1.velocity.x + dp * nx, circle1.velocity.y + dp * ny)
  circle2.velocity = vec(circle2.velocity.x - dp * nx, circle2.velocity.y - dp * ny)
  circle1.position = old[1]
  circle2.position = old[2]
end

function on_update(dt)
  push_all(dt)
  box(1)
  box(2)
  if hit_each_other() then exchange() end
end
