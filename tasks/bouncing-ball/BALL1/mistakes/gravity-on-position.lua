-- The ball sinks, it does not fall
--
-- In every step your ball goes down by the same 0.1635 m, and $v_y$ stays 0. What falls gets
-- *faster*: an acceleration changes the velocity, and only the velocity changes the position.
-- Look at what you add $g \, \Delta t$ to.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.position = circle1.position + gravity * timestep
end
