-- The circle falls upward
--
-- After one second your circle moves up at 9.81 m/s. The second part of a vector counts upward,
-- and gravity pulls down. Look at its sign.

-- Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, 9.81)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
