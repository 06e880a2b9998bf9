-- A circle is turned round again as it leaves a wall
--
-- After a hit the rim stays beyond the wall. Gravity may make the first step of the way back shorter
-- than the last one was, and then the rim is still beyond; so the circle is turned round again and
-- goes through the wall. In fast hits that is rare, in slow ones it happens soon. Look at where a
-- circle stands after its hit, and at what your wall test asks besides the place.

-- Lab 4.2. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(-2, 2)
  circle2.velocity = vec(2, 0)
end

-- Euler: the velocity from the beginning of the step moves the circle.
local function integrate(circle, timestep)
  circle.position = circle.position + circle.velocity * timestep
  circle.velocity = circle.velocity + gravity * timestep
end

-- A circle whose rim is past a wall turns round.
local function bounce_off_walls(circle)
  local p, r = circle.position, circle.radius
  if p.x - r < square.left or p.x + r > square.right then
    circle.velocity = vec(-circle.velocity.x, circle.velocity.y)
  end
  if p.y - r < square.bottom or p.y + r > square.top then
    circle.velocity = vec(circle.velocity.x, -circle.velocity.y)
  end
end

-- Runs every step.
function on_update(timestep)
  integrate(circle1, timestep)
  integrate(circle2, timestep)
  bounce_off_walls(circle1)
  bounce_off_walls(circle2)
end
