-- Gravity pulls to the left
--
-- After step 1 your ball has $v_x = -0.1635$ m/s, while $v_y$ is still 0. Of the two parts of a
-- vector the first counts to the right and the second upward. Look at the order of the numbers
-- that you assign to `gravity`.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(-9.81, 0)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
