-- There is no gravity
--
-- The gravity of your scene is (0, 0) m/s². It takes two things to fall: a value in m/s², and a
-- step that lets it change the velocity. Look for the first: what does gravity get at the start? In
-- a program a `local gravity` would be a variable of its own, which nobody else sees.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, 0)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
