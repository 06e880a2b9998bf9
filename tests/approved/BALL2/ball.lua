-- right
function on_load()
  gravity = vec(0, -9.81)
  restitution = 0.8
end

local function fall(ball, dt)
  local old = ball.position
  local v = ball.velocity + gravity * dt
  ball.velocity = v
  ball.position = old + v * dt
  return old
end

local function height_of(ball)
  local lowest = ball.position.y - ball.radius
  return lowest - square.bottom
end

local function rebound(speed)
  local e = restitution
  return -e * speed
end

function on_update(dt)
  local old = fall(circle1, dt)
  local h = height_of(circle1)
  local v = circle1.velocity
  if h < 0 and v.y < 0 then
    local up = rebound(v.y)
    circle1.velocity = vec(v.x, up)
    circle1.position = vec(circle1.position.x, old.y)
  end
end
