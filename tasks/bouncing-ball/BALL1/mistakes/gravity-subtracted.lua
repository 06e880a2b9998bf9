-- Gravity is subtracted, not added
--
-- In every step the velocity of your ball changes *against* gravity: where `gravity` points down,
-- it is driven up. An acceleration says what is *added* to the velocity in every second; its
-- direction is in the vector already. Look at the signs where gravity changes the velocity.

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
