-- Bouncing ball.
-- Lengths in m, times in s, velocities in m/s, accelerations
-- in m/s².

-- Runs once, when the scene is in place.
function on_load()
  -- Give gravity its value here.
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  -- First let gravity change the velocity of circle1, then
  -- let that velocity move it.
end
