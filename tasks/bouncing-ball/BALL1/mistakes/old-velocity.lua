-- The old velocity moved the ball
--
-- After step 1 your ball is still at $y = 1.2$ m; by symplectic Euler it has fallen by 2.7 mm.
-- Your ball moves with the velocity from the *beginning* of the step, and only then gets faster.
-- That is Euler's method, whose energy grows in every step. Look at the order of the two lines.

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
