function on_load()
  gravity = vec(0, -9.81)
  restitution = 0.8
end

function on_update(timestep)
  local before = circle1.position
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
  local rim = circle1.position.y - circle1.radius
  if rim < square.bottom and circle1.velocity.y < 0 then
    circle1.velocity = vec(circle1.velocity.x, -restitution * circle1.velocity.y)
    circle1.position = vec(circle1.position.x, before.y)
  end
end
