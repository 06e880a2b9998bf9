-- The velocity is taken for a distance
--
-- After step 1 your ball is 0.1635 m lower, sixty times too far: it moved by the whole velocity.
-- A velocity says how far it goes in a *second*, and a step takes $\frac{1}{60}$ s. Compare the
-- units on both sides of the line that changes the position.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity
end
