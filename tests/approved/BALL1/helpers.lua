local ball = circle1

local function accelerate(body, a, dt)
  body.velocity = body.velocity + a * dt
end

local function drift(body, dt)
  body.position = body.position + body.velocity * dt
end

function on_load()
  gravity = vec(0, -9.81)
end

function on_update(dt)
  accelerate(ball, gravity, dt)
  drift(ball, dt)
end
