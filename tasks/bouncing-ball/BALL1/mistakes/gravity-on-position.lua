-- The ball sinks, it does not fall
--
-- In every step your ball goes down by the same $g \, \Delta t$, and its velocity stays as it is.
-- What falls gets *faster*: an acceleration changes the velocity, and only the velocity changes the
-- position. Look at which of the two gravity acts on.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.position = circle1.position + gravity * timestep
end
