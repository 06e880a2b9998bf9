function on_load()
  gravity = vec(0, -9.81)
  circle1.position = vec(-2, 2)
  circle1.velocity = vec(2, 0)
  circle2.position = vec(-2, 2)
  circle2.velocity = vec(2, 0)
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

local function mover(symplectic)
  return function(c, h)
    if symplectic then
      c.velocity = c.velocity + gravity * h
      c.position = c.position + c.velocity * h
    else
      c.position = c.position + c.velocity * h
      c.velocity = c.velocity + gravity * h
    end
    against_walls(c)
  end
end

local move1, move2 = mover(true), mover(true)

function on_update(timestep)
  move1(circle1, timestep)
  move2(circle2, timestep)
end
