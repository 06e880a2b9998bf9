-- Each step goes as far as a whole second
--
-- In a single step your circle covers what it should cover in a second. A velocity says how many
-- metres it gets in one *second*, and a step lasts only $\Delta t$. Compare the units on both sides
-- of the line that changes the position: are they metres on both?

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity
end
