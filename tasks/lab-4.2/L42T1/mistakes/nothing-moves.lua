-- Nothing moves the circle
--
-- Whatever velocity your circle has, after a step it is where it was before. A velocity by itself
-- moves nothing: in every step somebody has to work out how far the circle gets. That is the work
-- of `on_update`, so look at what happens to the position there.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
end
