-- Lab 4.2. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2.3)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, 2)
  circle2.velocity = vec(0, 0)
end

-- Symplectic Euler: the velocity from the end of the step moves the circle.
local function integrate(circle, timestep)
  circle.velocity = circle.velocity + gravity * timestep
  circle.position = circle.position + circle.velocity * timestep
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

-- Circles overlap when their centres are nearer than the sum of the radii, in any direction.
local function overlap(a, b)
  return (b.position - a.position):length() < a.radius + b.radius
end

-- A hit pushes along the line of centres only: there the parts of the two velocities change hands.
-- What each has across that line it keeps. Circles that move apart have been hit already.
local function collide(a, b, old_a, old_b)
  local normal = (old_b - old_a):normalized()  -- from a to b, before they overlapped
  local u_a, u_b = dot(a.velocity, normal), dot(b.velocity, normal)
  if not overlap(a, b) or u_a <= u_b then
    return
  end
  a.position, b.position = old_a, old_b
  a.velocity = a.velocity - u_a * normal + u_b * normal
  b.velocity = b.velocity - u_b * normal + u_a * normal
end

-- Runs every step.
function on_update(timestep)
  if time > 8 then -- a wind comes up late
    circle1.velocity = circle1.velocity + vec(0.5, 0) * timestep
  end
  local old_position1 = circle1.position
  local old_position2 = circle2.position
  integrate(circle1, timestep)
  integrate(circle2, timestep)
  bounce_off_walls(circle1, old_position1)
  bounce_off_walls(circle2, old_position2)
  collide(circle1, circle2, old_position1, old_position2)
end
