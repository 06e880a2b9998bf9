function on_load()
  gravity = vec(0, 0)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(2, -2)
  circle2.velocity = vec(0, 2)
end

-- every wall: a normal that points out, and how far the wall is from the middle
local planes = {
  { out = vec(1, 0), far = square.half_width },
  { out = vec(-1, 0), far = square.half_width },
  { out = vec(0, 1), far = square.half_width },
  { out = vec(0, -1), far = square.half_width },
}

local function against_walls(c)
  for _, plane in ipairs(planes) do
    local depth = dot(c.position, plane.out) + c.radius - plane.far
    local speed = dot(c.velocity, plane.out)
    if depth > 0 and speed > 0 then
      c.position = c.position - depth * plane.out
      c.velocity = c.velocity - 2 * speed * plane.out
    end
  end
end

local function mover(c)
  return function(h)
    c.velocity = c.velocity + gravity * h
    c.position = c.position + c.velocity * h
    against_walls(c)
  end
end

local move1 = mover(circle1)
local move2 = mover(circle2)

local function collide(a, b)
  local between = b.position - a.position
  local overlap = a.radius + b.radius - between:length()
  if overlap <= 0 then return end
  local n = vec(between.y, between.x):normalized()
  a.position = a.position - overlap / 2 * n
  b.position = b.position + overlap / 2 * n
  local approach = dot(b.velocity - a.velocity, n)
  if approach < 0 then
    a.velocity = a.velocity + approach * n
    b.velocity = b.velocity - approach * n
  end
end

function on_update(timestep)
  move1(timestep)
  move2(timestep)
  collide(circle1, circle2)
end
