-- Lab 4.2. Lengths in m, times in s, velocities in m/s, accelerations in m/s², masses in kg.

-- The mass of the ball that a circle stands for, in kg: density times volume.
local function mass(circle)
  return 1000 * circle.density * 4 / 3 * math.pi * circle.radius ^ 3
end

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, 0)
  restitution = 0.5
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle1.radius = 0.2
  circle1.density = 1  -- in 1000 kg/m³
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle2.radius = 0.2
  circle2.density = 2
  for _, circle in ipairs(circles) do
    circle.mass = mass(circle)
  end
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

-- A hit is a pair of opposite impulses along the line of centres, so the total momentum stays.
-- Their size makes the circles part e times as fast as they met. Those that move apart have
-- been hit already.
local function collide(a, b, old_a, old_b)
  local normal = (old_b - old_a):normalized()  -- from a to b, before they overlapped
  local closing_speed = dot(a.velocity - b.velocity, normal)
  if not overlap(a, b) or closing_speed <= 0 then
    return
  end
  a.position, b.position = old_a, old_b
  local reduced_mass = a.mass * b.mass / (a.mass + b.mass)
  local impulse = (1 + restitution) * reduced_mass * closing_speed  -- N s
  a.velocity = a.velocity - impulse / a.mass * normal
  b.velocity = b.velocity + impulse / b.mass * normal
end

-- Runs every step.
function on_update(timestep)
  local old_position1 = circle1.position
  local old_position2 = circle2.position
  integrate(circle1, timestep)
  integrate(circle2, timestep)
  bounce_off_walls(circle1, old_position1)
  bounce_off_walls(circle2, old_position2)
  collide(circle1, circle2, old_position1, old_position2)
end
