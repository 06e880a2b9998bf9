function MoveEuler(ball, dt)
  ball.position = ball.position + ball.velocity * dt
  ball.velocity = ball.velocity + gravity * dt
end

function KeepInside(ball)
  local x, y = ball.position.x, ball.position.y
  local vx, vy = ball.velocity.x, ball.velocity.y
  local r = ball.radius
  if x - r < square.left and vx < 0 then
    x = square.left + r
    vx = -vx
  elseif x + r > square.right and vx > 0 then
    x = square.right - r
    vx = -vx
  end
  if y - r < square.bottom and vy < 0 then
    y = square.bottom + r
    vy = -vy
  elseif y + r > square.top and vy > 0 then
    y = square.top - r
    vy = -vy
  end
  ball.position = vec(x, y)
  ball.velocity = vec(vx, vy)
end

function on_load()
  gravity = vec(0, -9.81)
  circle1.velocity = vec(2, 0)
end

function on_update(timestep)
  MoveEuler(circle1, timestep)
  KeepInside(circle1)
end
