function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle1.radius = 0.2
  circle2.radius = 0.252
  circle1.density = 7.8
  circle2.density = 7.8
end

-- one coordinate between two walls: what is beyond the wall comes back
local function mirror(place, speed, low, high)
  if place < low and speed < 0 then
    return 2 * low - place, -speed
  end
  if place > high and speed > 0 then
    return 2 * high - place, -speed
  end
  return place, speed
end

local function walls(c)
  local x, vx = mirror(c.position.x, c.velocity.x, square.left + c.radius, square.right - c.radius)
  local y, vy = mirror(c.position.y, c.velocity.y, square.bottom + c.radius, square.top - c.radius)
  c.position = vec(x, y)
  c.velocity = vec(vx, vy)
end

local function step_circle(c, dt)
  c.velocity = c.velocity + dt * gravity
  c.position = c.position + dt * c.velocity
end

local function mass(c)
  local r = c.radius
  return c.density * 4 / 3 * math.pi * r * r * r
end

local function pair(a, b)
  local d = b.position - a.position
  local reach = a.radius + b.radius
  if d:length_squared() >= reach * reach then return end
  local normal = d:normalized()
  local closing = dot(a.velocity - b.velocity, normal)
  if closing <= 0 then return end
  local ma, mb = mass(a), mass(b)
  local j = 2 * closing / (1 / ma + 1 / mb)
  a.velocity = a.velocity - j / ma * normal
  b.velocity = b.velocity + j / mb * normal
end

function on_update(dt)
  for _, c in ipairs(circles) do
    step_circle(c, dt)
    walls(c)
  end
  for i = 1, #circles do
    for j = i + 1, #circles do
      pair(circles[i], circles[j])
    end
  end
end
