function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, -2)
  circle2.velocity = vec(0, 2)
  circle1.radius = 0.2
  circle2.radius = 0.4
end

local function overlap(a, b)
  local dx, dy = b.position.x - a.position.x, b.position.y - a.position.y
  return dx * dx + dy * dy < (a.radius + b.radius) ^ 2
end

local function bounce(c)
  local x, y = c.position.x, c.position.y
  local reach = 4 - 0.2
  if x > reach and c.velocity.x > 0 or x < -reach and c.velocity.x < 0 then c.velocity = vec(-c.velocity.x, c.velocity.y) end
  if y > reach and c.velocity.y > 0 or y < -reach and c.velocity.y < 0 then c.velocity = vec(c.velocity.x, -c.velocity.y) end
end

function on_update(timestep)
  for _, c in ipairs(circles) do
    c.position = c.position + c.velocity * timestep
    bounce(c)
  end
  if overlap(circle1, circle2) then
    local n = (circle2.position - circle1.position):normalized()
    local u = dot(circle1.velocity, n) - dot(circle2.velocity, n)
    if u > 0 then
      circle1.velocity = circle1.velocity - u * n
      circle2.velocity = circle2.velocity + u * n
    end
  end
end
