-- The circle starts without a velocity
--
-- Your circle starts with the velocity (0, 0) m/s, as it stands in the scene. Without a force
-- nothing changes a velocity: what a circle shall start with has to be said once, before the first
-- step. Look at what gives your circle its velocity, and when.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * timestep
end
