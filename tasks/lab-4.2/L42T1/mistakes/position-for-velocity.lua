-- The circle was moved, not set moving
--
-- Your circle starts at (2, 0) m and stays there: its velocity is still (0, 0). A position says
-- where a body is, a velocity how fast that changes; setting the first does not touch the
-- second. Look at which field of `circle1` you assign in `on_load`.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.position = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * timestep
end
