-- The circle was moved, not set moving
--
-- Your circle starts at (2, 0) m with the velocity (0, 0) m/s. A position says where a body is, a
-- velocity how fast that changes; setting the first does not touch the second. Look at which of the
-- two you give the circle.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.position = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * timestep
end
