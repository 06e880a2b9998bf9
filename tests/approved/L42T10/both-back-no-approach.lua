function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, 2)
  circle2.velocity = vec(0, 0)
end

function on_update(dt)
  local a, b = circle1.position, circle2.position
  for _, c in ipairs { circle1, circle2 } do
    local p = c.position + c.velocity * dt
    local v = c.velocity
    if p.x > square.right - c.radius or p.x < square.left + c.radius then v, p = vec(-v.x, v.y), c.position end
    if p.y > square.top - c.radius or p.y < square.bottom + c.radius then v, p = vec(v.x, -v.y), c.position end
    c.position, c.velocity = p, v
  end
  if (circle1.position - circle2.position):length() < circle1.radius + circle2.radius then
    circle1.position, circle2.position = a, b
    circle1.velocity, circle2.velocity = circle2.velocity, circle1.velocity
  end
end
