-- Gravity acts for a whole second in every step
--
-- In one step the velocity of your ball changes by as much as gravity needs a whole second for. An
-- acceleration says how much the velocity changes per second, and a step takes only $\Delta t$.
-- Compare the units on both sides of the line that changes the velocity.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.velocity = circle1.velocity + gravity
  circle1.position = circle1.position + circle1.velocity * timestep
end
