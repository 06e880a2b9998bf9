-- The circle goes twice as far as it should
--
-- In every step your circle covers $2 \, v \, \Delta t$: a velocity of 2 m/s takes it 4 m far in a
-- second. What you see and what the velocity says must agree. Look at how often a step moves the
-- circle, and with which factors.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
