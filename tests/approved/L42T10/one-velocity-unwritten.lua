local pos, vel = {}, {}

function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, 2)
  circle2.velocity = vec(0, 0)
  for i, c in ipairs(circles) do
    pos[i], vel[i] = c.position, c.velocity
  end
end

local function wall(i)
  local c, p, v = circles[i], pos[i], vel[i]
  local room = square.half_width - c.radius
  if p.x > room and v.x > 0 or p.x < -room and v.x < 0 then
    p = vec(c.position.x, p.y)
    v = vec(-v.x, v.y)
  end
  if p.y > room and v.y > 0 or p.y < -room and v.y < 0 then
    p = vec(p.x, c.position.y)
    v = vec(v.x, -v.y)
  end
  pos[i], vel[i] = p, v
end

function on_update(dt)
  for i = 1, #circles do
    vel[i] = vel[i] + gravity * dt
    pos[i] = pos[i] + vel[i] * dt
    wall(i)
  end
  local d = pos[2] - pos[1]
  if d:length() < circle1.radius + circle2.radius then
    local n = d:normalized()
    local u1, u2 = vel[1]:dot(n), vel[2]:dot(n)
    if u1 > u2 then
      vel[1], vel[2] = vel[2], vel[1]
    end
  end
  circle1.position, circle1.velocity = pos[1], vel[1]
  circle2.position = pos[2]
end
