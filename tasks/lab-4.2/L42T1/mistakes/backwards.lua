-- The circle moves against its velocity
--
-- The velocity of your circle is (2, 0) m/s, to the right, but in every step it goes the other way.
-- In a timestep the velocity is added to the position as often as the step is long. Look at the
-- signs in the line that changes the position.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position - circle1.velocity * timestep
end
