-- Your ball is thrown, not let go
--
-- Your ball starts with the velocity (0, 2) m/s, upward. A body that is let go starts at rest. Look
-- for what gives it a velocity at the start.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
  circle1.velocity = vec(0, 2)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
