-- The circle shakes at the wall
--
-- At a wall your circle is turned round, and soon afterwards, although it is on its way back, once
-- more: into the wall. So it does not get away. Two things are worth a look: the place where a hit
-- leaves the circle, and whether you ask which way it moves before you turn it.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s.

-- Runs once, when the scene is in place.
function on_load()
  circle1.velocity = vec(2, 0)
end

-- A circle whose rim is past a wall goes back to where it was before the step and turns round.
-- Only one that moves into the wall: else it could be turned back into it.
local function bounce_off_walls(circle, old_position)
  local p, r = circle.position, circle.radius
  if p.x - r < square.left then
    circle.position = vec(square.left, circle.position.y)
    circle.velocity = vec(-circle.velocity.x, circle.velocity.y)
  elseif p.x + r > square.right then
    circle.position = vec(square.right, circle.position.y)
    circle.velocity = vec(-circle.velocity.x, circle.velocity.y)
  end
  if p.y - r < square.bottom then
    circle.position = vec(circle.position.x, square.bottom)
    circle.velocity = vec(circle.velocity.x, -circle.velocity.y)
  elseif p.y + r > square.top then
    circle.position = vec(circle.position.x, square.top)
    circle.velocity = vec(circle.velocity.x, -circle.velocity.y)
  end
end

-- Runs every step; timestep is how long the step lasts.
function on_update(timestep)
  local old_position = circle1.position
  circle1.position = circle1.position + circle1.velocity * timestep
  bounce_off_walls(circle1, old_position)
end
