-- The circle jumps 2 m in every step
--
-- In the first step your circle went from $x = -2$ m to $x = 0$; one step at 2 m/s is 0.0333 m.
-- A velocity says how many metres a circle covers in one *second*, and a step lasts
-- $\frac{1}{60}$ s. Compare the units on both sides of the line in `on_update` that changes the
-- position.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity
end
