function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, 2)
  circle2.velocity = vec(0, 0)
end

function on_update(timestep)
  local old1 = circle1.position
  local old2 = circle2.position

  -- move
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
  circle2.velocity = circle2.velocity + gravity * timestep
  circle2.position = circle2.position + circle2.velocity * timestep

  -- walls for circle 1
  if circle1.position.x + circle1.radius > square.right or circle1.position.x - circle1.radius < square.left then
    circle1.position = old1
    circle1.velocity = vec(-circle1.velocity.x, circle1.velocity.y)
  end
  if circle1.position.y + circle1.radius > square.top or circle1.position.y - circle1.radius < square.bottom then
    circle1.position = old1
    circle1.velocity = vec(circle1.velocity.x, -circle1.velocity.y)
  end

  -- walls for circle 2
  if circle2.position.x + circle2.radius > square.right or circle2.position.x - circle2.radius < square.left then
    circle2.position = old2
    circle2.velocity = vec(-circle2.velocity.x, circle2.velocity.y)
  end
  if circle2.position.y + circle2.radius > square.top or circle2.position.y - circle2.radius < square.bottom then
    circle2.position = old2
    circle2.velocity = vec(circle2.velocity.x, -circle2.velocity.y)
  end

  -- the two circles
  local between = circle2.position - circle1.position
  local distance = between:length()
  local sum = circle1.radius + circle2.radius
  if distance < sum and math.abs(between.y) < 0.05 then
    circle1.position = old1
    circle2.position = old2
    if dot(circle1.velocity - circle2.velocity, between) > 0 then
      local temp = circle1.velocity
      circle1.velocity = circle2.velocity
      circle2.velocity = temp
    end
  end
end
