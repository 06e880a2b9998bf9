-- Gravity acts twice as strongly as it should
--
-- In one step the velocity of your ball changes by twice $g \, \Delta t$: on Earth it falls as on a
-- planet with 19.62 m/s². Look at how often a step changes the velocity, and with which factors.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
