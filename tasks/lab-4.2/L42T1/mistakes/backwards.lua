-- The circle moves against its velocity
--
-- In every step your circle covers the right distance to the wrong side: a velocity to the right
-- carries it to the left. A velocity points where a body goes, and in a timestep the way
-- $v \, \Delta t$ comes to the position. Look at the signs where the position changes.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position - circle1.velocity * timestep
end
