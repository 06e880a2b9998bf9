-- right
local x1, y1, x2, y2
function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, -2)
  circle2.velocity = vec(0, 2)
end

function on_update(timestep)
  x1 = circle1.position
  x2 = circle2.position
  circle1.velocity = circle1.velocity + gravity * timestep
  circle2.velocity = circle2.velocity + gravity * timestep
  circle1.position = x1 + circle1.velocity * timestep
  circle2.position = x2 + circle2.velocity * timestep

  local r1 = circle1.radius
  local r2 = circle2.radius
  if circle1.position.x + r1 > square.right and circle1.velocity.x > 0 then
    circle1.velocity = vec(-circle1.velocity.x, circle1.velocity.y)
    circle1.position = x1
  end
  if circle1.position.x - r1 < square.left and circle1.velocity.x < 0 then
    circle1.velocity = vec(-circle1.velocity.x, circle1.velocity.y)
    circle1.position = x1
  end
  if circle1.position.y + r1 > square.top and circle1.velocity.y > 0 then
    circle1.velocity = vec(circle1.velocity.x, -circle1.velocity.y)
    circle1.position = x1
  end
  if circle1.position.y - r1 < square.bottom and circle1.velocity.y < 0 then
    circle1.velocity = vec(circle1.velocity.x, -circle1.velocity.y)
    circle1.position = x1
  end
  if circle2.position.x + r2 > square.right and circle2.velocity.x > 0 then
    circle2.velocity = vec(-circle2.velocity.x, circle2.velocity.y)
    circle2.position = x2
  end
  if circle2.position.x - r2 < square.left and circle2.velocity.x < 0 then
    circle2.velocity = vec(-circle2.velocity.x, circle2.velocity.y)
    circle2.position = x2
  end
  if circle2.position.y + r2 > square.top and circle2.velocity.y > 0 then
    circle2.velocity = vec(circle2.velocity.x, -circle2.velocity.y)
    circle2.position = x2
  end
  if circle2.position.y - r2 < square.bottom and circle2.velocity.y < 0 then
    circle2.velocity = vec(circle2.velocity.x, -circle2.velocity.y)
    circle2.position = x2
  end

  local diff = circle2.position - circle1.position
  local distance = math.sqrt(diff.x ^ 2 + diff.y ^ 2)
  local limit = r1 + r2
  local relative = circle1.velocity - circle2.velocity
  local approach = relative.x * diff.x + relative.y * diff.y
  if distance < limit and approach > 0 then
    circle1.position = x1
    circle2.position = x2
    local n = (x2 - x1):normalized()
    local u1 = dot(circle1.velocity, n)
    local u2 = dot(circle2.velocity, n)
    local t1 = circle1.velocity - u1 * n
    local t2 = circle2.velocity - u2 * n
    circle1.velocity = t1 + u2 * n
    circle2.velocity = t2 + u1 * n
  end
end
