function on_update(timestep)
  circle1.position = circle1.position + vec(0.001, 0)
end
