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

function on_update(timestep)
  local old1 = circle1.position
  local old2 = circle2.position
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
  circle2.velocity = circle2.velocity + gravity * timestep
  circle2.position = circle2.position + circle2.velocity * timestep

  -- walls for circle 1
  if circle1.position.x + circle1.radius > square.right or circle1.position.x - circle1.radius < square.left then
    circle1.position = vec(old1.x, circle1.position.y)
    circle1.velocity = vec(-circle1.velocity.x, circle1.velocity.y)
  end
  if circle1.position.y + circle1.radius > square.top or circle1.position.y - circle1.radius < square.bottom then
    circle1.position = vec(circle1.position.x, old1.y)
    circle1.velocity = vec(circle1.velocity.x, -circle1.velocity.y)
  end

  -- walls for circle 2
  if circle2.position.x + circle2.radius > square.right or circle2.position.x - circle2.radius < square.left then
    circle2.position = vec(old2.x, circle2.position.y)
    circle2.velocity = vec(-circle2.velocity.x, circle2.velocity.y)
  end
  if circle2.position.y + circle2.radius > square.top or circle2.position.y - circle2.radius < square.bottom then
    circle2.position = vec(circle2.position.x, old2.y)
    circle2.velocity = vec(circle2.velocity.x, -circle2.velocity.y)
  end

  -- do the circles touch?
  local line = circle2.position - circle1.position
  local distance = line:length()
  if distance < circle1.radius + circle2.radius then
    local n = line / distance
    local u1 = dot(circle1.velocity, n)
    local u2 = dot(circle2.velocity, n)
    if u1 > u2 then
      circle1.position = old1
      circle2.position = old2
      local m1 = 4 / 3 * math.pi * circle1.radius ^ 3 * circle1.density * 1000
      local m2 = 4 / 3 * math.pi * circle2.radius ^ 3 * circle2.density * 1000
      local v1 = (m1 - m2) / (m1 + m2) * u1 + 2 * m2 / (m1 + m2) * u2
      local v2 = (m2 - m1) / (m1 + m2) * u2 + 2 * m1 / (m1 + m2) * u1
      circle1.velocity = circle1.velocity + (v1 - u1) * n
      circle2.velocity = circle2.velocity + (v2 - u2) * n
    end
  end
end
