function on_load()
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(0, 0)
end

function on_update(timestep)
  circle1.position = circle1.position + circle1.velocity * timestep
end
