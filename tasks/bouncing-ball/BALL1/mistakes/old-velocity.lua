-- The old velocity moves the ball
--
-- Your ball moves with the velocity from the *beginning* of each step: from rest it does not sink
-- at all in the first one. That is Euler's method, whose energy grows in every step of a fall.
-- Symplectic Euler takes the velocity from the end: look at which one is there when the position
-- changes.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * timestep
  circle1.velocity = circle1.velocity + gravity * timestep
end
