-- right
function on_load()
  gravity = vec(0, 0)
  restitution = 0.5
  circle1.position = vec(-2.5, 2)
  circle1.velocity = vec(1, 0)
  circle1.radius = 0.2
  circle1.density = 1
  circle2.position = vec(0, 2)
  circle2.velocity = vec(-1, 0)
  circle2.radius = 0.2
  circle2.density = 2
end

local bodies = {}

local function collect()
  for i, c in ipairs(circles) do
    local r = c.radius
    bodies[i] = {
      pos = c.position,
      vel = c.velocity,
      r = r,
      inv = 1 / (c.density * r * r * r),
    }
  end
end

local function advance(body, dt)
  body.old = body.pos
  body.vel = body.vel + gravity * dt
  body.pos = body.pos + body.vel * dt
end

local function confine(body)
  local low_x, high_x = square.left + body.r, square.right - body.r
  local low_y, high_y = square.bottom + body.r, square.top - body.r
  local vx, vy = body.vel.x, body.vel.y
  if body.pos.x < low_x and vx < 0 then vx = -vx end
  if body.pos.x > high_x and vx > 0 then vx = -vx end
  if body.pos.y < low_y and vy < 0 then vy = -vy end
  if body.pos.y > high_y and vy > 0 then vy = -vy end
  body.vel = vec(vx, vy)
end

local function resolve(p, q)
  local delta = q.pos - p.pos
  local dist = delta:length()
  local overlap = p.r + q.r - dist
  if overlap <= 0 then return end
  local normal = delta / dist
  local vn = (q.vel - p.vel):dot(normal)
  if vn >= 0 then return end
  local e = restitution
  local inv_sum = p.inv + q.inv
  local lambda = -(1 + e) * vn / inv_sum
  local impulse = lambda * normal
  p.vel = p.vel - impulse * p.inv
  q.vel = q.vel + impulse * q.inv
end

local function give_back()
  for i, c in ipairs(circles) do
    c.position = bodies[i].pos
    c.velocity = bodies[i].vel
  end
end

function on_update(dt)
  collect()
  for _, body in ipairs(bodies) do
    advance(body, dt)
    confine(body)
  end
  for i = 1, #bodies - 1 do
    for j = i + 1, #bodies do
      resolve(bodies[i], bodies[j])
    end
  end
  give_back()
end
