function on_load()
  gravity = vec(0, -9.81)
end

function on_update(timestep)
  local v = circle1.velocity + gravity * timestep
  circle1.velocity = v
  circle1.position = circle1.position + (v - gravity * timestep) * timestep
end
