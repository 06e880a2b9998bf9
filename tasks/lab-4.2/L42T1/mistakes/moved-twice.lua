-- The circle moves twice in every step
--
-- In one step your circle covers 0.0667 m, and after 1 s it is at $x = 2$ m instead of 0. Its
-- velocity says 2 m/s, but it travels at 4 m/s: what you see and what the velocity says must
-- agree. Count how often `on_update` changes the position.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
