function Move(ball, dt)
  ball.velocity = ball.velocity + gravity * dt
  ball.position = ball.position + ball.velocity * dt
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

function Touching(a, b)
  local gap = b.position - a.position
  return gap:length() < a.radius + b.radius
end

function Approaching(a, b)
  local gap = b.position - a.position
  return dot(b.velocity - a.velocity, gap) < 0
end

function Respond(a, b)
  local normal = (b.position - a.position):normalized()
  local parA = dot(a.velocity, normal)
  local parB = dot(b.velocity, normal)
  local perpA = a.velocity - parA * normal
  local perpB = b.velocity - parB * normal
  a.velocity = perpA + parB * normal
  b.velocity = perpB + parA * normal
end

function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, -2)
  circle2.velocity = vec(0, 2)
end

function on_update(timestep)
  Move(circle1, timestep)
  Move(circle2, timestep)
  KeepInside(circle1)
  KeepInside(circle2)
  if Touching(circle1, circle2) and Approaching(circle1, circle2) then
    Respond(circle1, circle2)
  end
end
