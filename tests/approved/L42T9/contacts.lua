function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, 2)
  circle2.velocity = vec(0, 0)
end

-- the inverse mass; a wall has none
local function inverse(c)
  return c and 1 or 0
end

local function find_contacts()
  local found = {}
  local function add(a, b, normal, depth, e)
    if depth > 0 then
      table.insert(found, { a = a, b = b, normal = normal, depth = depth, e = e })
    end
  end
  for _, c in ipairs(circles) do
    local p, r = c.position, c.radius
    add(c, nil, vec(1, 0), p.x + r - square.right, 1)
    add(c, nil, vec(-1, 0), square.left - p.x + r, 1)
    add(c, nil, vec(0, 1), p.y + r - square.top, 1)
    add(c, nil, vec(0, -1), square.bottom - p.y + r, 1)
  end
  local way = circle2.position - circle1.position
  add(circle1, circle2, way:normalized(), circle1.radius + circle2.radius - way:length(), 1)
  return found
end

local function velocity(c)
  return c and c.velocity or vec(0, 0)
end

local function resolve(contact)
  local a, b, n = contact.a, contact.b, contact.normal
  local closing = dot(velocity(a) - velocity(b), n)
  if closing <= 0 then return end
  if b then
    a.velocity, b.velocity = vec(0, 0), vec(0, 0)
    return
  end
  local wa, wb = inverse(a), inverse(b)
  local impulse = (1 + contact.e) * closing / (wa + wb)
  a.velocity = a.velocity - impulse * wa * n
  if b then
    b.velocity = b.velocity + impulse * wb * n
  end
end

local function separate(contact)
  local a, b, n = contact.a, contact.b, contact.normal
  if b then
    a.position = a.position - contact.depth / 2 * n
    b.position = b.position + contact.depth / 2 * n
  else
    a.position = a.position - contact.depth * n
  end
end

function on_update(dt)
  for _, c in ipairs(circles) do
    c.velocity = c.velocity + gravity * dt
    c.position = c.position + c.velocity * dt
  end
  for _, contact in ipairs(find_contacts()) do
    resolve(contact)
    separate(contact)
  end
end
