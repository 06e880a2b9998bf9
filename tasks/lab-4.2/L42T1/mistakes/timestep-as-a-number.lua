-- The length of a step is written as a number
--
-- In the scene of the step your circle moves right. In a scene with another timestep it comes too far
-- or not far enough: your program always takes $\frac{1}{60}$ s for the length of a step. Look at where
-- that length comes from; `on_update` is told it.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * (1 / 60)
end
