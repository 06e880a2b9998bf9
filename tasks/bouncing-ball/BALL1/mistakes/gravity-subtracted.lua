-- Gravity is subtracted, not added
--
-- After step 1 your ball has $v_y = +0.1635$ m/s and rises, although `gravity` points down. An
-- acceleration says what is *added* to the velocity in every second; its direction is in the
-- vector already. Look at the sign in front of `gravity` in `on_update`.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.velocity = circle1.velocity - gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
