-- On the Moon your ball falls as on Earth
--
-- Whatever `gravity` is, your ball gains 9.81 m/s in every second, also on the Moon, where 1.62 m/s
-- would be right. A number knows one place only; the variable knows where the ball is. Look at
-- where the fall takes its acceleration from.

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
