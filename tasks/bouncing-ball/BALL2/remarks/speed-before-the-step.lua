-- The speed from before the step comes back
--
-- Your ball turns round with $e$ times the velocity that it had *before* the step. The share of
-- gravity in that step is lost, and so every hit gives back a little too little speed. With a
-- shorter timestep the loss gets smaller.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
  restitution = 0.8
end

-- The floor does not move, so the ball leaves it with e times the speed it came with, upward, and
-- goes back to where it was before the step. Only a ball that moves down: one that is on its way
-- up has been turned already.
local function bounce_off_floor(ball, old_position, old_velocity)
  local p, v = ball.position, ball.velocity
  if p.y - ball.radius < square.bottom and v.y < 0 then
    ball.position = vec(p.x, old_position.y)
    ball.velocity = vec(v.x, -restitution * old_velocity.y)
  end
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  local old_position, old_velocity = circle1.position, circle1.velocity
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
  bounce_off_floor(circle1, old_position, old_velocity)
end
