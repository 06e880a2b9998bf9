-- The velocity at the start points to the left
--
-- Your circle starts with the velocity (−2, 0) m/s. The sign of a part of the velocity says which
-- way it points along its axis, and $x$ counts to the right. Look at the sign in the velocity that
-- you give the circle.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(-2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * timestep
end
