-- It has a velocity and stays where it is
--
-- Your circle has the velocity (2, 0) m/s, yet after 60 steps it is still at $x = -2$ m. A
-- velocity by itself moves nothing: in every step somebody has to work out how far the circle
-- gets. From the moment that `on_update` exists, that is its work, so look there.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
end
