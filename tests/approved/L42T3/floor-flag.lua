function on_load()
  gravity = vec(0, -9.81)
  circle1.velocity = vec(2, 0)
end

local on_floor = false

function on_update(timestep)
  local old1 = circle1.position

  -- move
  circle1.position = circle1.position + circle1.velocity * timestep
  if not on_floor then
    circle1.velocity = circle1.velocity + gravity * timestep
  end
  on_floor = false

  -- walls circle 1
  if circle1.position.x + circle1.radius > square.right then
    circle1.position = old1
    circle1.velocity = vec(-circle1.velocity.x, circle1.velocity.y)
  end
  if circle1.position.x - circle1.radius < square.left then
    circle1.position = old1
    circle1.velocity = vec(-circle1.velocity.x, circle1.velocity.y)
  end
  if circle1.position.y + circle1.radius > square.top then
    circle1.position = old1
    circle1.velocity = vec(circle1.velocity.x, -circle1.velocity.y)
  end
  if circle1.position.y - circle1.radius < square.bottom then
    on_floor = true
    circle1.position = old1
    circle1.velocity = vec(circle1.velocity.x, -circle1.velocity.y)
  end
end
