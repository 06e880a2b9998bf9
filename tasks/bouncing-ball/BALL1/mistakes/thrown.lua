-- Your ball is thrown, not let go
--
-- Your ball starts with $v_y = 2$ m/s: it rises by 0.2 m first and comes to the floor 0.22 s
-- later than one that is let go. A body that is let go starts at rest. Look for a line in
-- `on_load` that gives it a velocity.

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
