-- The velocity at the start points up, not to the right
--
-- Your circle starts with the velocity (0, 2) m/s. A velocity has two parts: the first counts to
-- the right, the second upward. Look at the order of the two numbers that you give the circle.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(0, 2)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * timestep
end
