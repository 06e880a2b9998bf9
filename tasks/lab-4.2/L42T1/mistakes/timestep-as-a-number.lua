-- A number stands for the length of a step
--
-- However long a step lasts, your circle goes as far as in $\frac{1}{60}$ s. With that very
-- timestep nothing is to be seen of it; with any other the circle comes too far or not far enough.
-- Look at where your program takes the length of a step from; `on_update` is told it.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * (1 / 60)
end
