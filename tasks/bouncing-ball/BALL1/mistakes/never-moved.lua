-- It gets faster and stays where it is
--
-- After 1 s your ball has $v_y = -9.81$ m/s and is still at $y = 1.2$ m. Since `on_update`
-- exists, it alone moves the ball. Look for a line that changes the position.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.velocity = circle1.velocity + gravity * timestep
end
