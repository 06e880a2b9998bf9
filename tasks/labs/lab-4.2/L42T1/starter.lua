-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
-- Here goes what the circles start with.
function on_load()
  -- Give circle1 its velocity here.
end

-- Runs every step; timestep is how long the step lasts.
-- Here goes how the circles move.
function on_update(timestep)
  -- Move circle1 here: its new position is the old one plus
  -- the way of this step.
end
