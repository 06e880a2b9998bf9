-- On the Moon your ball falls as on Earth
--
-- In your own scene your ball falls as it should. On the Moon, where gravity is 1.62 m/s², it
-- still gains 9.81 m/s in every second. Let `on_update` use the variable `gravity`, and give it
-- its value in `on_load` alone.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.velocity = circle1.velocity + vec(0, -9.81) * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
