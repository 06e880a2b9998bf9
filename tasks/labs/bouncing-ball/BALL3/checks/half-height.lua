-- After its third bounce the ball rises to half of the height from which it fell. Discrete steps
-- tell of a hit up to one step late, which may cost or give a few centimetres in every bounce.
local bounces_asked = 3
local part_asked = 0.5
local allowed = 0.35 -- m

local texts = {
  en = {
    few = "The ball comes off the floor %d times in %g s; %d times are right",
    height = "After bounce %d the ball rises to %.2f m; half of %.2f m is %.2f m",
  },
  de = {
    few = "Der Ball springt %d-mal in %g s vom Boden hoch; richtig sind %d Male",
    height = "Nach Aufprall %d steigt der Ball auf %.2f m; die Hälfte von %.2f m sind %.2f m",
  },
}

-- Of the rim above the floor, in m.
local function height(run, circle)
  return circle.position.y - circle.radius - run.square.bottom
end

function check(run)
  local text = texts[run.language] or texts.en
  local first = height(run, run:circle(1):at(0))
  local bounces, was_falling = 0, false
  local top, top_time = 0, 0
  for state in run:steps() do
    local ball = state.circles[1]
    local falls = ball.velocity.y < 0
    if was_falling and not falls then
      bounces = bounces + 1
    end
    was_falling = falls
    if bounces == bounces_asked and height(run, ball) > top then
      top, top_time = height(run, ball), state.time
    end
  end
  if bounces < bounces_asked then
    return false, string.format(text.few, bounces, run.duration, bounces_asked)
  end
  local asked = part_asked * first
  if math.abs(top - asked) <= allowed then
    return true
  end
  return false, string.format(text.height, bounces_asked, top, first, asked),
    {time = top_time, expected = asked, observed = top, unit = "m"}
end
