function on_load()
  circle1.velocity = vec(2, 0)
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

function on_update(timestep)
  move1(timestep)
end
