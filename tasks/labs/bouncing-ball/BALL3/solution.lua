-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
  restitution = 0.5 ^ (1 / 6)  -- half the height after three bounces: e^(2 * 3) = 1/2
end

-- The floor does not move, so the ball leaves it with e times the speed it came with, upward, and
-- goes back to where it was before the step. Only a ball that moves down: one that is on its way
-- up has been turned already.
local function bounce_off_floor(ball, old_position)
  local p, v = ball.position, ball.velocity
  if p.y - ball.radius < square.bottom and v.y < 0 then
    ball.position = vec(p.x, old_position.y)
    ball.velocity = vec(v.x, -restitution * v.y)
  end
end

-- The height of the rim above the floor, in m.
local function height(ball)
  return ball.position.y - ball.radius - square.bottom
end

-- Prints how high the ball came whenever it begins to fall again.
local bounces, rising = 0, false
local function measure(ball)
  if ball.velocity.y > 0 and not rising then
    bounces = bounces + 1
  elseif ball.velocity.y <= 0 and rising then
    print(string.format("after bounce %d: %.3f m", bounces, height(ball)))
  end
  rising = ball.velocity.y > 0
  plot("height in m", height(ball))
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  local old_position = circle1.position
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
  bounce_off_floor(circle1, old_position)
  measure(circle1)
end
