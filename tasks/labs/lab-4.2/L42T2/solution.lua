-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- A circle whose rim is past a wall goes back to where it was before the step and turns round.
-- Only one that moves into the wall: else it could be turned back into it.
local function bounce_off_walls(circle, old_position)
  local p, v, r = circle.position, circle.velocity, circle.radius
  if (p.x - r < square.left and v.x < 0) or (p.x + r > square.right and v.x > 0) then
    circle.position = old_position
    circle.velocity = vec(-circle.velocity.x, circle.velocity.y)
  end
  if (p.y - r < square.bottom and v.y < 0) or (p.y + r > square.top and v.y > 0) then
    circle.position = old_position
    circle.velocity = vec(circle.velocity.x, -circle.velocity.y)
  end
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  local old_position = circle1.position
  circle1.position = circle1.position + circle1.velocity * timestep
  bounce_off_walls(circle1, old_position)
end
