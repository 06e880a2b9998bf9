--== numbers as text
print(1, 1.0, -0.0, 1/3, 1e15, 1e16, 1e100, 2^53, 123456789, 0.1 + 0.2, 1/0, -1/0, 7 // 2, 7.5 // 2, -7 % 3, 7 % -3)
print(math.pi, math.huge, 3 | 4, 5 & 6, 1 << 4, ~0, "10" + 5, "0x10" * 2, 10 .. 20)
--== vectors
local a, b = vec(3, 4), vec(-1, 0.5)
print(a, b, a + b, a - b, -a, a * 2, 2 * a, a / 2, a == vec(3, 4), a ~= b)
print(a:length(), a:length_squared(), a:normalized(), a:perpendicular(), a:dot(b), dot(a, b))
print(a.x, a.y, "a is " .. a, a .. "!", tostring(a), type(a), vec(0, 0), vec(1e-9, -0.0), vec(1/3, 1e6))
--== vector of nothing has no direction
print(vec(0, 0):normalized())
--== vector of one number
print(vec(1))
--== vector of a text
print(vec("1", 2), vec(1, "a"))
--== vector is not changed
local v = vec(1, 2)
v.x = 5
--== vector times vector
print(vec(1, 2) * vec(3, 4))
--== vector plus number
print(vec(1, 2) + 1)
--== number minus vector
print(1 - vec(1, 2))
--== vector over vector
print(vec(1, 2) / vec(1, 1))
--== number over vector
print(2 / vec(1, 1))
--== vector compared
print(vec(1, 2) < vec(2, 3))
--== vector of unknown field
print(vec(1, 2).z)
--== vector of unknown method
print(vec(1, 2):len())
--== vector method by a point
print(vec(1, 2).length())
--== dot of one
print(vec(1, 2):dot())
--== dot of a number
print(dot(vec(1, 2), 3))
--== dot of three
print(dot(vec(1, 2), vec(3, 4), 5))
--== operands that are missing
function on_update(dt)
  local speed
  circle1.velocity = circle1.velocity + speed * dt
end
--== field that is missing
function on_update(dt)
  circle1.speed = 3
end
--== field that is misspelt
function on_update(dt)
  circle1.velocty = circle1.velocity
end
--== field read that is misspelt
function on_update(dt)
  print(circle1.Position, circle2.radius)
end
--== circles
print(circle1, circle2, circles, #circles, circles[1] == circle1, circles[2].radius, circles[3])
for i, c in ipairs(circles) do print(i, c, c.position, c.velocity, c.radius, c.density, c.mass) end
for i, c in pairs(circles) do print(i, c) end
--== circle of number 0
print(circles[0].radius)
--== circle that is not there
print(circle3.radius)
--== list of circles is not changed
circles[1] = circle2
--== list of circles by name
print(circles.Count)
--== square
print(square, square.left, square.right, square.top, square.bottom, square.half_width)
--== square is not changed
square.left = 3
--== square of unknown field
print(square.width)
--== values of the scene
print(gravity, restitution, time, step, dt)
gravity = vec(0, -1.62)
restitution = 0.9
print(gravity, restitution)
--== gravity that is a number
gravity = -9.81
--== restitution that is a vector
restitution = vec(1, 1)
--== restitution above one
restitution = 1.5
--== timestep is set
timestep = 0.01
--== radius of nothing
circle1.radius = 0
--== radius of a text
circle1.radius = "big"
--== negative density
circle2.density = -1
--== density that is no number
circle2.density = 0/0
--== velocity that is a number
circle1.velocity = 3
--== velocity without end
circle1.velocity = vec(1/0, 0)
--== position outside
circle1.position = vec(40, 0)
--== mass is worked out
circle1.mass = 5
--== start is set
function on_load()
  circle1.position, circle1.velocity = vec(1, 1), vec(0.5, -0.25)
  circle1.radius, circle1.density = 0.3, 2.5
  circle2.position = vec(-3, -3)
end
function on_update(dt)
  circle1.position = circle1.position + circle1.velocity * dt
end
--== one step after the other
function on_update(dt)
  print(step, time, dt)
  circle1.velocity = circle1.velocity + gravity * dt
  circle1.position = circle1.position + circle1.velocity * dt
  plot("speed", circle1.velocity:length())
  plot("height", circle1.position.y)
end
--== drawings
function on_update(dt)
  draw.arrow(circle1.position, circle1.velocity)
  draw.arrow(circle1.position, circle1.velocity, "red", "v")
  draw.line(vec(0, 0), vec(1, 1), "#ff8800")
  draw.point(vec(2, 2))
  draw.point(vec(2, -2), "blue")
  draw.text(vec(0, 1), "here")
  draw.text(vec(0, 1), 42, "green")
end
--== drawing with a colour that is none
function on_update() draw.point(vec(1, 1), "reddish") end
--== drawing at a number
function on_update() draw.point(3) end
--== drawing of nothing
function on_update() draw.line(vec(0, 0)) end
--== drawing of an unknown kind
function on_update() draw.circle(vec(0, 0), 1) end
--== plot without a value
function on_update() plot("speed") end
--== plot of a vector
function on_update() plot("speed", circle1.velocity) end
--== plot of a value that is none
function on_update() plot("speed", 0/0) end
--== plot without a name
function on_update() plot(3, 4) end
--== lists
local t = {5, 3, 9, 1}
table.sort(t)
print(table.concat(t, ", "), #t, table.unpack(t, 2, 3))
table.sort(t, function(a, b) return a > b end)
table.insert(t, 7) table.insert(t, 1, 0)
print(table.concat(t, " ", 2, 4), table.remove(t), table.remove(t, 1), #t)
print(select("#", 1, nil, 3), select(2, "a", "b", "c"), select(-1, 4, 5))
--== list insert beyond its end
local t = {1} table.insert(t, 5, 2)
--== list concat of a table
print(table.concat({1, {}, 3}))
--== sort by what is no order
table.sort({3, 1, 2, 5, 4, 7, 6}, function(a, b) return true end)
--== sort of mixed values
table.sort({1, "a", vec(1, 2)})
--== sort of vectors
table.sort({vec(2, 1), vec(1, 2)})
--== pairs have an order
local t = {10, 20, x = 1, b = 2, [3.5] = "half", [-1] = "below", [true] = "yes"}
for k, v in pairs(t) do print(k, v) end
t.x = nil t.c = 3
for k, v in next, t do print(k, v) end
--== next of what is not there
print(next({a = 1}, "b"))
--== texts
print(("abc"):upper(), ("ABC"):lower(), #"abc", ("abcdef"):sub(2, -2), ("%5.2f|%-5d|%05d|%s|%q"):format(3.14159, 42, 42, vec(1, 2), "a\n"))
print(string.format("%g %e %x %c %i %%", 0.1, 12345.678, 255, 65, 3), ("x"):len(), tostring(nil), tostring(true), tonumber("0x1p4"), tonumber("1e2"), tonumber("z", 36), tonumber("9", 8), tonumber("abc"))
--== format of nothing
print(string.format("%d", "x"))
--== format of a fraction
print(string.format("%d", 1.5))
--== format without a value
print(string.format("%d %d", 1))
--== format that is unknown
print(string.format("%y", 1))
--== text library that is not there
print(("a"):rep(3))
--== text of gsub
print(("a"):gsub("a", "b"))
--== mathematics
print(math.sqrt(2), math.abs(-3), math.floor(-1.5), math.ceil(1.2), math.max(1, 5, 3), math.min(2, -1), math.fmod(7, 3))
print(math.sin(1), math.cos(1), math.tan(1), math.asin(0.5), math.acos(0.5), math.atan(1, 2), math.exp(1), math.log(8, 2), math.log(10), math.tointeger(3.0), math.type(1), math.type(1.0), math.ult(1, -1))
--== root of a negative number
print(math.sqrt(-1), 0/0)
--== mathematics misspelt
print(math.Abs(-1))
--== mathematics of a vector
print(math.abs(vec(1, 2)))
--== mathematics of nothing
print(math.floor(nil))
--== chance
print(math.random())
--== chance with a seed
math.randomseed(3) print(math.random(1, 6), math.random(1, 6), math.random(10))
--== files
io.open("x")
--== system
os.time()
--== require
require("socket")
--== load
load("x = 1")()
--== metatables
print(getmetatable(vec(1, 2)), setmetatable({}, {__index = function(_, k) return k .. "!" end}).a)
--== raw
print(rawget({a = 1}, "a"), rawlen({1, 2}), rawequal(1, 1))
--== pcall
print(pcall(function() error("inner") end))
print(pcall(error, {code = 1}))
--== error with a level
local function check(x) if x < 0 then error("negative", 2) end end
function on_update(dt)
  local x = -1
  check(x)
end
--== assertion
function on_update(dt)
  local d = (circle2.position - circle1.position):length()
  assert(d > 100, "too near")
end
--== value that is nil
function on_update(dt)
  local ball = nil
  ball.velocity = vec(0, 0)
end
--== call of a number
local n = 5
function on_update(dt) n() end
--== call of a missing function
function on_update(dt) bounce(circle1) end
--== global that is misspelt
function on_load() gravty = vec(0, 0) end
function on_update(dt) print(gravty, gravitiy) end
--== function that is misspelt
function on_upate(dt) end
--== on_load alone
function on_load() circle1.velocity = vec(1, 1) end
--== endless loop
function on_update(dt) while true do end end
--== endless recursion
local function f(x) return 1 + f(x + 1) end
function on_update(dt) f(1) end
--== much memory
local t = {}
function on_update(dt) for i = 1, 1e9 do t[i] = {i} end end
--== much output
function on_update(dt) for i = 1, 20000 do print("line", i) end end
--== long text
local s = "x"
function on_update(dt) for i = 1, 40 do s = s .. s end end
--== many steps of work
function on_update(dt)
  local sum = 0
  for i = 1, 2000 do sum = sum + i % 7 end
  print(sum)
end
--== nested work
local function inner(n) local s = 0 for i = 1, n do s = s + i end return s end
function on_update(dt)
  local total = 0
  for i = 1, 30 do total = total + inner(i) end
  print(total)
end
--== closures count
local function counter() local n = 0 return function() n = n + 1 return n end end
local c = counter()
function on_update(dt) print(c(), c()) end
--== coroutines
local co = coroutine.wrap(function() for i = 1, 3 do coroutine.yield(i) end end)
print(co(), co(), co())
--== goto
for i = 1, 3 do
  if i == 2 then goto continue end
  print(i)
  ::continue::
end
--== constants
local g <const> = 9.81
g = 1
--== to be closed
local x <close> = nil
--== many values
local function three() return 1, 2, 3 end
print(three(), three())
print((three()))
local a, b, c, d = three()
print(a, b, c, d)
--== arguments that vary
local function count(...) return select("#", ...), ... end
print(count(nil, nil), count())
--== locals at an error
function on_update(dt)
  local place, speed, name, list, on = circle1.position, 2.5, "ball", {1, 2}, true
  local work = function() end
  local missing
  print(missing.x, place, speed, name, list, on, work)
end
--== swap
function on_update(dt)
  circle1.velocity, circle2.velocity = circle2.velocity, circle1.velocity
end
--== mass by hand
function on_update(dt)
  local m = 4 / 3 * math.pi * circle2.radius ^ 3 * circle2.density * 1000
  print(m, circle2.mass, m == circle2.mass)
end
--== integer division of numbers
print(4 // 3, 1 // 0.0, 3 % 0.0)
--== integer division by nothing
print(1 // 0)
--== compare a number with a text
print(1 < "2")
--== compare two tables
print({} < {})
--== add a table
print({} + 1)
--== concatenate nil
print("a" .. nil)
--== concatenate a table
print("a" .. {})
--== length of a number
print(#5)
--== index of a function
print(print.x)
--== for with a text
for i = "a", 3 do end
--== for without a step
for i = 1, 3, 0 do end
--== for in of a list
for c in circles do end
--== for of a number
for i in 5 do end
--== unicode
print("Grüße, θ = 30°", #"ü", ("ü"):upper())
--== carriage returns
print("a\rb\tc\0d")
--== both hands are told where
function on_update(dt)
  for i, c in ipairs(circles) do
    c.velocity = c.velocity + dt
  end
end
--== script errors 1
function on_load()
  local a = 1
  a()
end
--== script errors 2
error('no mass')
--== script errors 3
error('no mass', 2)
--== script errors 4
error(42)
--== script errors 5
error()
--== script errors 6
error({})
--== script errors 7
error(print)
--== script errors 8
error(false)
--== script errors 9
error(vec(1, 2))
--== script errors 10
error(circle1)
--== script errors 11
function on_load()
if true then
end
--== script errors 12
function on_load()
end
end
--== script errors 13
x = 1
print("a)
--== script errors 14
x = 1

x += 1
--== script errors 15
x = 1
goto there
--== script errors 16
x = nil + 1
--== script errors 17
function on_load() circle1.position = vec(9, 0) end
--== script errors 18
function on_update() end
--== script errors 19

on_update = 5
--== script errors 20
on_load = 5
--== script errors 21
function on_update() end on_update = 5
--== script errors 22
function on_update() on_update = nil end
--== script errors 23
function on_update()
on_update = 5
end
--== script language 1
v = (1, 2)
--== script language 2
print(
--== script language 3
for the dot product write a:dot(b)
--== script language 4

local function work()
--== script language 5

end
local result = work()
--== script language 6
build a new one: circle1.position = vec(3, circle1.position.y)
--== script language 7
circles[2].position = vec(1, circles[2].position.y)
--== script language 8
v = vec(v.x, 2 * v.x)
--== script language 9
local x = 1
--== script names 1

local x =
--== script names 2
function on_update()
 local x =
--== script names 3
local function work()
--== script names 4

end
local r = work()
--== script names 5
print(circle2)
--== script names 6
old_position = vec(0, 0)
print(old_positon)
--== script names 7
circle1.mass = 1
print(circle1.mas)
--== script showing 1
function on_update() print(1) plot('a', 1) draw.point(vec(0, 0)) end
--== script showing 2
print(('%062d'):format(i) .. 'x')
--== student script 1
print(circle1.position, circle2.radius, gravity, restitution, square.top, #circles)
--== student script 2
function on_load() circle1.velocity = vec(3, 0) end
--== student script 3
function on_update(dt) circle2.position = circle2.position + vec(1, 0) * dt end
--== student script 4
gravity = vec(0, 0)
--== student script 5
restitution = 1
--== student script 6
time = 1
--== student script 7
step = 1
--== student script 8
square.left = 1
--== student script 9
circle1.index = 2
--== student script 10
circles[3] = circle1
--== student script 11
function on_update()
--== student script 12
n = 0
function on_update() n = n + 1 print(n) end
--== student script 13
function on_update(dt) print(step, time == step * dt, dt == 1/60) end
--== student script 14
print(1.5, string.format('%.2f', 0.25), tonumber('1,5'), 'a' < 'B', tonumber('1.5') == 1.5)
--== student script 15
print(1)
plot('a', 2)
draw.point(vec(0, 0))
--== meant 1
x = 1
if (x > 0) {
  x = 2
}
--== meant 2
x = 1
if (x > 0) { x = 2 }
--== meant 3
x = 1
if (x > 0)
{
  x = 2
}
--== meant 4
if x then
  y = 1
} else {
  y = 2
}
--== meant 5
x = 1
while (x < 5) {
  x = x + 1
}
--== meant 6
function on_update(dt) {
  x = 1
}
--== meant 7
for i = 1, 3 {
  x = i
}
--== meant 8
x = 1
for (int i = 0; i < 3; i++) {
  x = i
}
--== meant 9
for i = 0; i < 3; i++ do
end
--== meant 10
foreach (var c in circles) {
  x = c
}
--== meant 11
x = 1
float y = 1.5;
--== meant 12
function on_update(dt)
  var speed = 2
end
--== meant 13
int i = 0
--== meant 14
double d = 0.5;
--== meant 15
const float g = 9.81f;
--== meant 16
float[] masses = {1, 2};
--== meant 17
Vector2 v = new Vector2(1, 2);
--== meant 18
List<float> masses = x;
--== meant 19
Circle c = circles[1];
--== meant 20
x = 1
void on_update()
end
--== meant 21
function on_update(float timestep)
end
--== meant 22
x = 1
x++
--== meant 23
x = 1
x--
y = 2
--== meant 24
function f()
  x--;

end
--== meant 25
x = 1
x += 1
--== meant 26
circle1.speed *= -1;
--== meant 27
if 1 != 2 then end
--== meant 28
x = 1
if x > 0 && x < 2 then end
--== meant 29
x = 1
if !x then end
--== meant 30
x = 1
// the speed
y = 2
--== meant 31
x = 1; // the speed
y = 2
--== meant 32
x = 1 // the speed of it
y = 2
--== meant 33
x = 1
// don't move
y = 2
--== meant 34
/* move */
x = 1
--== meant 35
float y = 1; // is it right?
--== meant 36
x = 1
y = x > 0 ? 1 : 2
--== meant 37
y = true ? 1 : 2
--== meant 38
x = 1
f = (a) => a + 1
--== meant 39
for i = 1, 3 do
  continue;
end
--== meant 40
for i = 1, 3 do
  continue
end
--== meant 41
function f(x)
  if x > 1 then
    y = 1
  else if x > 0 then
    y = 2
  end
end
--== meant 42
x = 1
if x > 0
  x = 2
end
--== meant 43
x = 1
while x > 0

  x = 0
end
--== meant 44
function f()
  return 1
  x = 2
end
--== meant 45
function f()
  do return end x = 2
  return x; x = 1
end
--== meant 46
function f()
  return
  x = 2
end
--== meant 47
if x = 1 then end
--== meant 48

circles[0].velocity = vec(1, 0)
--== meant 49
for i = 0, #circles do
  circles[i].radius = 1
end
--== meant 50
for i = 1, #circles + 1 do
  circles[i].radius = 1
end
--== meant 51
local c = circles[0]
local n = 1
print(c.position)
--== meant 52
local v = new Vector2(1, 2)
--== meant 53

local v = Vector2(1, 2)
--== meant 54
local x = Math.Sqrt(2)
--== meant 55
local x = 1 +
 Math.Abs(2)
--== meant 56
local x = 4 / 3 * Math.PI
--== meant 57
local x = Math.Pow(2, 3)
--== meant 58
local x = Mathf.Max(2, 3)
--== meant 59
local x = math.Sqrt(2)
--== meant 60
local p = circle1.Position
--== meant 61

circle1.Position = vec(1, 1)
--== meant 62
local c = circle1
if c == null then end
--== meant 63
this.x = 1
--== meant 64
local x = 1 // speed
--== meant 65
local s = 'a' .. 'b'
s = s + 'c'
--== meant 66
local s = 'a' + 1
--== meant 67
local n = 3
local s = n + ' m'
--== meant 68
for i = 1, circles.Length do end
--== meant 69
local n = circles.Count
--== meant 70
local list = {1, 2}
for i = 1, list.Length do end
--== meant 71
local list = {1, 2}
local n = list.Length + 1
--== meant 72
local s = circle1.velocity.length * 2
--== meant 73
function on_load()
  bounce(circle1)
end
local function bounce(c) end
--== meant 74
local x = 1
function on_load()
  bounce(x)
end

local bounce = function(c) end
--== meant 75
function on_load()
  local old = vec(0, 0)
  go()
end
function go()
  print(old)
end
--== meant 76
if true then
  local hit = 1
end
print(hit)
--== meant 77
local old_position = 1
print(old_positon)
--== meant 78
function on_load()
  go(1)
end
function go(timestep)
  print(timestpe)
end
--== meant 79
local speed_limit = 3
function on_load()
  print(sped_limit)
end
--== meant 80
for index = 1, 2 do
  print(indx)
end
--== meant 81
local function bounce() end
buonce()
--== meant 82
local x = 1; local y = 2;
function f() return x; end
--== meant 83
local x = 1
if x > 2 then
else if x > 1 then
end
end
--== meant 84
local x = 7 // 2
--== meant 85
local c = circles[0]
assert(c == nil)
--== meant 86
print('a != b ? c : d && e') -- x += 1
--== meant 87
print('a != b' 'c')
--== meant 88
function f() return {
  1 }
end y = = 1
--== meant 89
function f()
  if x then
end
--== meant 90
local t = {}
local c = circles[1]
print(t[0].x, c)
--== meant 91
local t = {}
print(circles[1].radius + t[0].x)
--== meant 92
local n = nil
print(1 + n)
--== meant 93
local x = 1
print(quite_another)
--== locked programs 1
gravity = vec(0, -9.81) circle1.radius = 0.2
--== locked programs 2
circle2.velocity = vec(1, 0) circle2.radius = 0.3
--== locked programs 3
function on_update(dt) circle1.position = circle1.position + circle1.velocity * dt end
--== locked programs 4
circle1.mass = 5
--== locked programs 5
gravity = vec(0, 0) circle1.velocity = vec(0, 0) circle1.radius = 0.1
--== work bound 1
function on_update(dt)
 circle1.position = vec(1, 2) * dt end
--== work bound 2
local function f(x) return x end
function on_update(dt) f(f(dt)) end
--== work bound 3
for i, c in ipairs(circles) do c.mass = i end
--== work bound 4
for i = 1, #circles do circles[i].mass = i end
--== work bound 5
for i = 1, #circles - 1 do for j = i + 1, #circles do print(j) end end
--== work bound 6
local x = 0 for i = 1, 10 do x = x + i end
--== work bound 7
local function mass(c) return c.radius end
circle1.mass = mass(circle1)
print(circle1.mass)
--== work bound 8
-- while true do end
print('while', "repeat \" goto")
--== work bound 9
if step then if time then print(1) else print(2) end end
--== work bound 10
local n = 1e9 for i = 1, n do end
--== work bound 11
for i = 1, 1000000000 do end
--== work bound 12
for i = 1, 1e9 do end
--== work bound 13
for i = 1, 2, 1e-9 do end
--== work bound 14
for i = -1000000000, 2 do end
--== work bound 15
local n = -1e9 for i = n, 2 do end
--== work bound 16
local t = {1} for _, x in ipairs(t) do t[#t + 1] = x end
--== work bound 17
for k in pairs(draw) do end
--== work bound 18
local circles = {1} for _, x in ipairs(circles) do end
--== work bound 19
local function f(circles) for i = 1, #circles do end end
--== work bound 20
local ipairs = pairs for i, c in ipairs(circles) do end
--== work bound 21
for i = 1, 2 do i = -1e9 for j = i + 1, 2 do end end
--== work bound 22
for i = 1, 2 do local i, x = -1e9, 1 for j = i, 2 do end end
--== work bound 23
for i = 1, 2 do local i <const> = -1000000000 for j = i, 2 do end end
--== work bound 24
for i = 1, 2 do local function f(i) for j = i, 2 do end end f(-1000000000) end
--== work bound 25
function f() f() end
--== work bound 26
function f() g() end function g() f() end
--== work bound 27
function f() local function g() f() end g() end
--== work bound 28
local function f() end local g = f g()
--== work bound 29
local function f() end pcall(f)
--== work bound 30
local f = function() end f()
--== work bound 31
local t = {} function t.f() t.f() end
--== work bound 32
local t = {} function t:f() self:f() end
--== work bound 33
local function f() end f 'x'
--== work bound 34
function f() end function f() end
--== work bound 35
function f() _ENV['f']() end
--== work bound 36
local x = '\z
' while step do end --'
--== work bound 37
local x = [[ ' ]] while step do end --'
--== work bound 38
local x = '\
' while step do end --'
--== work bound 39
local function fall(c, dt)
  c.velocity = c.velocity + gravity * dt
  c.position = c.position + c.velocity * dt
end
function on_update(dt)
  for i = 1, #circles do fall(circles[i], dt) end
  print(step, circle1.position)
  if step == 40 then print(circle1.mass) end
end
--== work bound 40
local text = 'abcdefgh'
function on_update(dt)
  text = text .. 'abcdefgh'
end
--== work bound 41
local places = {}
function on_update(dt)
  places[#places + 1] = circle1.position
end
--== work bound 42
local list = {3, 1, 2}
function on_update(dt)
  table['sort'](list)
end
--== work bound 43
local t = {}
function on_load()
  for i = 1, 100000 do t[i + 0.5] = true end
  for i = 1, 100000 do t[i + 0.5] = nil end
end
function on_update(dt)
  for i = 1, 10000 do pairs(t) end
end
--== work bound 44
local text = 'abcdefgh'
function on_update(dt)
--== work bound 45
text = text .. text
--== work bound 46
step_text = text
--== work bound 47
local text = 'abcdefgh'
function on_update(dt)
  for i = 1, 9 do if #text < 1024 then text = text .. text end end
  circle1.position = vec(1, 1)
end
--== local names 1
local a = 1
local b, c = 2
x = 3
--== local names 2
local a <const>, b <close> = 1
--== local names 3
local function f(p, q)
  local r
end
f()
--== local names 4
function t.go(p)
end
function t:went(q)
end
--== local names 5
local f = function(p)
end
f()
--== local names 6
for i = 1, 2 do
  x = i
end
for k, v in pairs(t) do
end
--== local names 7
while f(function() local z end) do
 local a
end
--== local names 8
local a = 'local b' --[[
local c ]] local d
--== local names 9
local a = [[

]] local b
--== local names 10
function (a
--== calls without arguments
for _, name in ipairs({'assert', 'ipairs', 'pairs', 'pcall', 'print', 'select', 'tonumber', 'tostring', 'type', 'plot', 'vec'}) do
  local f = ({assert = assert, ipairs = ipairs, pairs = pairs, pcall = pcall, print = print, select = select, tonumber = tonumber, tostring = tostring, type = type, plot = plot, vec = vec})[name]
  if f then print(name, pcall(f)) end
end
--== calls of the libraries without arguments
for _, library in ipairs({string, table, draw}) do
  for name, f in pairs(library) do
    if type(f) == 'function' and name ~= 'random' then print(name, pcall(f)) end
  end
end
--== calls with nothing of use
for _, library in ipairs({table, draw}) do
  for name, f in pairs(library) do
    if type(f) == 'function' then print(name, pcall(f, {}, true, {})) end
  end
end
--== work of tonumber
function on_update(dt)
  for i = 1, 300 do local n = tonumber(('1234567'):sub(1, i % 7 + 1)) end
  local text = '12345678'
  for i = 1, 9 do text = text .. text tonumber(text) tonumber(text) tonumber(text) end
end
--== work of tonumber of values
function on_update(dt)
  for i = 1, 300 do tonumber(i) tonumber('z', 36) tonumber(nil) end
end
--== work of select
function on_update(dt)
  local t = {}
  for i = 1, 240 do t[i] = i end
  for i = 1, 240, 17 do select(i, table.unpack(t)) end
  select('#', table.unpack(t))
  select(-1, 1, 2, 3)
end
--== work of insert and remove
function on_update(dt)
  local t = {}
  for i = 1, 100 do table.insert(t, 1, i) end
  for i = 1, 100 do table.insert(t, i) end
  for i = 1, 50 do table.insert(t, 50, i) table.remove(t, 3) end
  for i = 1, 60 do table.remove(t, 1) end
  for i = 1, 60 do table.remove(t) end
  print(#t, t[1], t[#t])
end
--== work of insert at odd places
function on_update(dt)
  local t = {1, 2, 3}
  print(pcall(table.insert, t, 0, 1), pcall(table.insert, t, 5, 1), pcall(table.insert, t, 4, 1))
  print(pcall(table.remove, t, 0), pcall(table.remove, t, 5), pcall(table.remove, t, -1))
  print(#t)
end
--== work of concat
function on_update(dt)
  local t = {}
  for i = 1, 200 do t[i] = i % 10 end
  for i = 1, 20 do table.concat(t) end
  print(#table.concat(t, ', '), table.concat(t, '-', 3, 5), table.concat(t, '', 5, 3))
  print(pcall(table.concat, {1, {}, 3}))
end
--== work of unpack
function on_update(dt)
  local t = {1, 2, 3}
  for i = 1, 30 do local a = table.unpack(t, 1, 100) end
  print(select('#', table.unpack(t, -5, 5)), select('#', table.unpack(t, 3, 2)), table.unpack(t, 2))
  print(pcall(table.unpack, t, 1, 1e6), pcall(table.unpack, t, 1, 1 << 62))
end
--== work of sort
function on_update(dt)
  local t = {}
  for i = 1, 60 do t[i] = i * 37 % 61 end
  table.sort(t)
  print(t[1], t[30], t[60])
  table.sort(t, function(a, b) return a > b end)
  print(t[1], t[30], t[60])
  table.sort({})
  table.sort({1})
  print(pcall(table.sort, t, 1), pcall(table.sort), pcall(table.sort, {1, 'x'}))
end
--== sort keeps equals in their order
local t = {}
for i = 1, 33 do t[i] = {i % 4, i} end
table.sort(t, function(a, b) return a[1] < b[1] end)
for i = 1, 33, 3 do print(t[i][1], t[i][2]) end
--== work of format
function on_update(dt)
  for i = 1, 40 do string.format('%d %5.2f %s %%', i, i, i) end
  for i = 1, 40 do string.format('plain') end
  print(pcall(string.format, '%'), pcall(string.format, '%y', 1), pcall(string.format, '%-5d|%+d', 1, 2))
  print(pcall(string.format, '%d', 1.5), pcall(string.format, '%s'), pcall(string.format, '%s %s', {}, print))
  print(pcall(string.format, '%p', {}), pcall(string.format, '%q', 'a'))
end
--== work of pairs
function on_update(dt)
  local t = {}
  for i = 1, 64 do t['k' .. i] = i end
  for i = 1, 20 do for k, v in pairs(t) do break end end
  local list = {}
  for i = 1, 64 do list[i] = i end
  for i = 1, 20 do for k, v in pairs(list) do break end end
end
--== pairs in the order of keys
local t = {[3] = 'c', [1] = 'a', [2.5] = 'b', x = 1, b = 2, [-1] = 'm', [true] = 't', [false] = 'f'}
for k, v in pairs(t) do print(k, v) end
for k, v in pairs({[{}] = 1}) do print(v) end
--== pairs of two tables as keys
for k, v in pairs({[{}] = 1, [{}] = 2}) do print(v) end
--== pairs while it is changed
local t = {a = 1, b = 2, c = 3}
for k, v in pairs(t) do t[k] = nil print(k, v) end
for k, v in pairs(t) do print(k) end
--== pairs of what is none
for k, v in pairs(3) do end
--== ipairs ends at the first hole
for i, v in ipairs({1, 2, nil, 4}) do print(i, v) end
for i, c in ipairs(circles) do print(i, c.radius) end
--== work of caught errors
function on_update(dt)
  for i = 1, 30 do pcall(error, 'x') end
  for i = 1, 30 do pcall(function() local a = nil; a.b = 1 end) end
  for i = 1, 5 do pcall(function() return nothing + i end) end
end
--== work of long texts
function on_update(dt)
  local text = ('abcdefgh')
  for i = 1, 8 do text = text .. text end
  for i = 1, 50 do local c = text .. i end
  for i = 1, 50 do local c = text:upper() == text:lower() end
  for i = 1, 50 do local c = text:sub(2, -2) end
  print(#text)
end
--== work of tables that grow
function on_update(dt)
  for n = 1, 6 do
    local t = {}
    for i = 1, 4 ^ n do t[i] = i end
    for i = 1, 4 ^ n do t['x' .. i] = i end
  end
end
--== work of deep calls
local function down(n) if n > 0 then return 1 + down(n - 1) end return 0 end
function on_update(dt) print(down(10), down(1000), down(15000)) end
--== work of calls too deep
local function down(n) return 1 + down(n + 1) end
function on_update(dt) down(1) end
--== nested too deeply
local x = ((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((1))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))
--== work of new fields
function on_update(dt)
  for i = 1, 20 do circle1['f' .. i] = i end
  print(circle1.f1, circle1.f20)
end
--== too many fields
for i = 1, 101 do circle1['f' .. i] = i end
--== as many fields as there may be
for i = 1, 100 do circle1['f' .. i] = i end
print(circle1.f100)
--== work of names that are not known
function on_update(dt)
  pcall(function() return velocitty + 1 end)
  pcall(function() return circle1.velocitty + 1 end)
  pcall(function() return circle1.a_name_that_is_longer_than_any_that_is_compared_with_others_and_more + 1 end)
  pcall(function() circle1.velocity.z = 1 end)
  print(pcall(function() circle9.velocity = 1 end))
end
--== tostring of everything
print(tostring(nil), tostring(1 / 0), tostring(-0.0), tostring(vec(1, -2)), tostring(circle1), tostring(circles), tostring(2 ^ 53), tostring(print), tostring({}))
print(type(nil), type(vec(1, 2)), type(circle1), type(circles), type(print), type(draw), type(1), type('x'))
--== vectors
local a, b = vec(3, 4), vec(1, -2)
print(a + b, a - b, -a, a * 2, 2 * a, a / 2, a == vec(3, 4), a == b, a:length(), a:length_squared(), a:dot(b), vec(0, -2):normalized())
print(pcall(function() return a * b end), pcall(function() return a + 1 end), pcall(function() return a / a end), pcall(function() return a < b end))
print(pcall(function() return a.z end), pcall(function() return a[1] end), pcall(function() return a:cross(b) end), #tostring(a), a.x, a.y)
print(pcall(vec), pcall(vec, 1), pcall(vec, 'x', 1), pcall(vec, 1, 2, 3), pcall(function() a.x = 'y' end))
--== the world
print(gravity, restitution, #circles, circles[1] == circle1, circles[3], square)
print(pcall(function() gravity = 3 end), pcall(function() gravity = vec(0, 0 / 0) end), pcall(function() restitution = 2 end), pcall(function() restitution = -1 end))
print(pcall(function() circles[1] = nil end), pcall(function() circle1 = nil end), pcall(function() circles.x = 1 end), pcall(function() return circles.x end))
print(square.left, square.right, square.top, square.bottom, square.width)
--== an entry that is local
x = 1
local function on_update(dt) end
--== an entry that is a local value
local t = {}

  local on_load = function() end
--== entries beside what is local
local function on_updates(dt) end
local other, on_loaded = 1, 2
function on_update(dt) local time = dt on_update_again = true end
--== an entry in a text that is local
local text = 'local function on_update'
function on_update(dt) print(text) end
--== labels as long as they may be
local label = ''
for i = 1, 100 do label = label .. 'x' end
plot(label, 1)
print(pcall(plot, label .. 'x', 1))
print(pcall(plot, '', 1))
--== labels of drawings as long as they may be
local label = ''
for i = 1, 100 do label = label .. 'x' end
draw.text(vec(0, 0), label)
print(pcall(draw.text, vec(0, 0), label .. 'x'))
draw.arrow(vec(0, 0), vec(1, 0), 'red', label)
print(pcall(draw.arrow, vec(0, 0), vec(1, 0), 'red', label .. 'x'))
--== other languages 1
x = 'a' -- "if x = 1"
if x = 1 then end
--== other languages 2
local a = 1
local b = a ? 1 : 2
--== other languages 3
for (int i = 0; i < 3; i++) {
}
--== other languages 4
function on_update(dt)
  if circle1.radius > 0 {
    x = 1
  }
end
--== other languages 5
local s = "text with = and == in it" x == 3
--== other languages 6
function on_update(dt)
  return 1
  x = 2
end
--== other languages 7
while true
  x = 1
end
--== other languages 8
if x then
  y = 1
else if z then
  y = 2
end
--== other languages 9
function f()
{
  x = 1
}
--== a local of another block
if true then local inner = 1 end
print(inner)
--== a local of another function
local function f() local inner = 1 return inner end
function on_update(dt) print(inner + 1) end
--== a local that stands below
function on_update(dt) print(below + 1) end
local below = 1
--== nearly a local
local velocity_x = 1
function on_update(dt)
  local other_speed = 2
  print(velocity_y + 1)
end
--== nearly a local of elsewhere
local function f() local other_speed = 2 return other_speed end
function on_update(dt) print(other_sped + 1) end
--== small mistakes 1
print(pcall(function() square.left = 1 end))
print(pcall(function() square.nothing = 1 end))
print(pcall(function() return square.nothing end))
print(pcall(function() circle1.radius = -1 end))
print(pcall(function() circle1.radius = 0 end))
print(pcall(function() circle1.radius = 0/0 end))
print(pcall(function() circle1.radius = 1/0 end))
print(pcall(function() circle1.radius = 'x' end))
print(pcall(function() circle1.radius = nil end))
print(pcall(function() circle1.radius = 1e9 end))
print(pcall(function() circle1.density = 0 end))
print(pcall(function() circle1.density = -1 end))
--== small mistakes 2
print(pcall(function() circle1.density = 1e300 end))
print(pcall(function() circle1.position = 3 end))
print(pcall(function() circle1.position = vec(0/0, 0) end))
print(pcall(function() circle1.position = vec(1e300, 0) end))
print(pcall(function() circle1.velocity = vec(1/0, 0) end))
print(pcall(function() circle1.velocity = nil end))
print(pcall(function() circle1.velocity.x = 1 end))
print(pcall(function() circle1.index = 2 end))
print(pcall(function() circle1.colour = 'red' end))
print(pcall(function() circle1.name = 'x' end))
print(pcall(function() circle1[1] = 1 end))
print(pcall(function() circle1[true] = 1 end))
--== small mistakes 3
print(pcall(function() return circle1[1] end))
print(pcall(function() return circle1.nothing end))
print(pcall(function() return circle1.Position end))
print(pcall(function() return circle1.vel end))
print(pcall(function() return circle1.positon end))
print(pcall(function() circles[0].radius = 1 end))
print(pcall(function() circles[3].radius = 1 end))
print(pcall(function() circles[1.5].radius = 1 end))
print(pcall(function() circles['1'].radius = 1 end))
print(pcall(function() circles[nil] = 1 end))
print(pcall(function() return #circles[1] end))
print(pcall(function() return circles[1] + circles[2] end))
--== small mistakes 4
print(pcall(function() return circles[1] < circles[2] end))
print(pcall(function() return circles[1] == circles[2] end))
print(pcall(function() return circle1 .. 'x' end))
print(pcall(function() return -circle1 end))
print(pcall(function() return circle1() end))
print(pcall(function() return vec(1, 2) .. '' end))
print(pcall(function() return vec(1, 2)() end))
print(pcall(function() return #vec(1, 2) end))
print(pcall(function() return vec(1, 2) // 1 end))
print(pcall(function() return vec(1, 2) % 2 end))
print(pcall(function() return vec(1, 2) ^ 2 end))
print(pcall(function() return vec(1, 2) * 'x' end))
--== small mistakes 5
print(pcall(function() return 1 / vec(1, 2) end))
print(pcall(function() return vec(1, 2) / 0 end))
print(pcall(function() return vec(1, 2) + nil end))
print(pcall(function() return nil + vec(1, 2) end))
print(pcall(function() return vec(1, 2) - 1 end))
print(pcall(function() return vec(1, 2):length(3) end))
print(pcall(function() return vec(1, 2).length() end))
print(pcall(function() return vec(1, 2):dot(1) end))
print(pcall(function() return vec(1, 2):dot() end))
print(pcall(function() return vec(1, 2).dot(1, 2) end))
print(pcall(function() return vec(1, 2).w end))
print(pcall(function() return vec(0, 0):normalized() end))
--== small mistakes 6
print(pcall(function() return vec('1', 2) end))
print(pcall(function() return vec(1) end))
print(pcall(function() return vec(nil, 1) end))
print(pcall(function() return vec(0/0, 1) end))
print(pcall(function() return vec(1, 2) == {1, 2} end))
print(pcall(function() gravity = nil end))
print(pcall(function() gravity = 3 end))
print(pcall(function() gravity = vec(1e300, 0) end))
print(pcall(function() gravity.x = 1 end))
print(pcall(function() restitution = 'x' end))
print(pcall(function() restitution = 1.01 end))
print(pcall(function() restitution = nil end))
--== small mistakes 7
print(pcall(function() circles = nil end))
print(pcall(function() circles = {} end))
print(pcall(function() circle1 = circle2 end))
print(pcall(function() circle3 = 1 end))
print(pcall(function() vec = nil end))
print(pcall(function() square = nil end))
print(pcall(function() draw = nil end))
print(pcall(function() on_load = 3 end))
print(pcall(function() on_update = 3 end))
print(pcall(function() draw.point(1) end))
print(pcall(function() draw.point(vec(0, 0), 3) end))
--== small mistakes 8
print(pcall(function() draw.point(vec(0, 0), 'nocolour') end))
print(pcall(function() draw.line(vec(0, 0)) end))
print(pcall(function() draw.arrow(vec(0, 0), 1) end))
print(pcall(function() draw.text(vec(0, 0)) end))
print(pcall(function() draw.text(vec(0, 0), {}) end))
print(pcall(function() draw.circle(1) end))
print(pcall(function() plot(1, 2) end))
print(pcall(function() plot('x') end))
print(pcall(function() plot('x', 'y') end))
print(pcall(function() plot('x', 0/0) end))
print(pcall(function() plot('x', 1/0) end))
print(pcall(function() error() end))
--== small mistakes 9
print(pcall(function() error('x', 0) end))
print(pcall(function() error('x', 1) end))
print(pcall(function() error({}) end))
print(pcall(function() error(nil) end))
print(pcall(function() assert(false) end))
print(pcall(function() assert(nil, 'said') end))
print(pcall(function() assert(1 == 2, {}) end))
print(pcall(function() return nothing end))
print(pcall(function() return nothing.x end))
print(pcall(function() return nothing() end))
print(pcall(function() local t = {} return t.x.y end))
print(pcall(function() local t = {} t.x.y = 1 end))
--== small mistakes 10
print(pcall(function() local t = {} return t.x() end))
print(pcall(function() local t = {} t[nil] = 1 end))
print(pcall(function() local t = {} t[0/0] = 1 end))
print(pcall(function() return 1 < 'x' end))
print(pcall(function() return {} < {} end))
print(pcall(function() return 1 + {} end))
print(pcall(function() return 'x' + 1 end))
print(pcall(function() return 'x' .. {} end))
print(pcall(function() return #5 end))
print(pcall(function() return 1 // 0 end))
print(pcall(function() return 1 % 0 end))
print(pcall(function() return 1.5 // 0 end))
--== small mistakes 11
print(pcall(function() return 1 << 1.5 end))
print(pcall(function() return 2^53 | 0 end))
print(pcall(function() return 1e100 | 0 end))
print(pcall(function() return math.nothing end))
print(pcall(function() return string.nothing('x') end))
print(pcall(function() return ('x'):nothing() end))
print(pcall(function() return table.nothing end))
print(pcall(function() return os.time() end))
print(pcall(function() return io.write('x') end))
print(pcall(function() return require('x') end))
print(pcall(function() return load('x') end))
print(pcall(function() return setmetatable({}, {}) end))
--== small mistakes 12
print(pcall(function() return getmetatable('x') end))
print(pcall(function() return rawget({}, 1) end))
print(pcall(function() return coroutine.create end))
print(pcall(function() return debug end))
print(pcall(function() return _G.x end))
print(pcall(function() _G.x = 1 end))
print(pcall(function() for i = 1, 'x' do end end))
print(pcall(function() for i = 'x', 1 do end end))
print(pcall(function() for i = 1, 2, 0 do end end))
print(pcall(function() for i in 3 do end end))
print(pcall(function() for i in nil do end end))
print(pcall(function() goto done ::done:: end))
--== how much everything gives back
local function count(...) return select('#', ...) end
print(count(draw.point(vec(0, 0))), count(draw.line(vec(0, 0), vec(1, 1))), count(draw.arrow(vec(0, 0), vec(1, 1))), count(draw.text(vec(0, 0), 'x')))
print(count(plot('x', 1)), count(print()), count(print(1)), count(type(1)), count(tostring(1)), count(tonumber('x')), count(pairs({})), count(ipairs({})))
print(count(vec(1, 2)), count(vec(1, 2):normalized()), count(vec(1, 2):length()), count(vec(1, 2):perpendicular()), count(vec(1, 2):dot(vec(1, 2))))
print(count(table.insert({}, 1)), count(table.remove({})), count(table.sort({})), count(table.concat({})), count(table.unpack({})))
print(count(pcall(error)), count(pcall(print, 1)), count(assert(1, 2, 3)), count(select(2, 1, 2, 3)), count(string.format('x')), count(('x'):sub(1)))
