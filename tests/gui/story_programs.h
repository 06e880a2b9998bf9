// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What an author types in the story of test_author_story, and what two students do.
namespace cradle::story {

/// A mistake as its author makes it: what is read, and what is put in place of what.
struct Mistake {
    const char *comment;
    const char *right;
    const char *wrong;
};

inline constexpr const char *rackText = R"lua(# Break the rack

Seven equal balls without friction. Write `on_update`: two that meet swap the parts of their velocities
along the line of centres.
)lua";
inline constexpr const char *rackSolution =
    R"lua(-- Billiards. Lengths in m, times in s, velocities in m/s.

-- Two balls that overlap and come nearer go back, and swap their speeds along the line of centres.
local function collide(a, b, old)
  local normal = (old[b] - old[a]):normalized()
  local closing = dot(a.velocity - b.velocity, normal)
  if (b.position - a.position):length() >= a.radius + b.radius or closing <= 0 then
    return
  end
  a.position, b.position = old[a], old[b]
  a.velocity = a.velocity - closing * normal
  b.velocity = b.velocity + closing * normal
end

function on_update(timestep)
  local old = {}
  for _, ball in ipairs(circles) do
    old[ball] = ball.position
    ball.position = ball.position + ball.velocity * timestep
  end
  for i = 1, #circles do
    for j = i + 1, #circles do
      collide(circles[i], circles[j], old)
    end
  end
end
)lua";
inline constexpr const char *rackStarter =
    R"lua(-- Billiards. Lengths in m, times in s, velocities in m/s.

function on_update(timestep)
  for _, ball in ipairs(circles) do
    ball.position = ball.position + ball.velocity * timestep
  end
end
)lua";
inline constexpr const char *rackCheck =
    R"lua(-- Seven equal balls: the sum of velocities and that of their squares stay, and the last is hit.
function check(run)
  local first = run:step(0)
  for state in run:steps() do
    local sum, start, squares, begun = vec(0, 0), vec(0, 0), 0, 0
    for i, ball in ipairs(state.circles) do
      sum = sum + ball.velocity
      start = start + first.circles[i].velocity
      squares = squares + ball.velocity:length_squared()
      begun = begun + first.circles[i].velocity:length_squared()
    end
    if (sum - start):length() > 1e-9 or math.abs(squares - begun) > 1e-9 then
      return false, string.format("At %.2f s the seven balls together have (%.3f, %.3f) times their mass, and %.3f at the start",
        state.time, sum.x, sum.y, start.x), {time = state.time, expected = start.x, observed = sum.x, unit = "m/s"}
    end
  end
  if run:circle(1):at(run.duration).velocity:length() > 2.9 then
    return false, string.format("Ball 1 is as fast after %g s as at the start: it met none", run.duration)
  end
  return true
end
)lua";
inline constexpr Mistake wholeVelocity{
    R"lua(-- The balls swap all of their velocities
--
-- Your balls swap their whole velocities, also the part across the line of centres. Look at which
-- part a hit changes.
)lua",
    R"lua(  a.velocity = a.velocity - closing * normal
  b.velocity = b.velocity + closing * normal)lua",
    R"lua(  a.velocity, b.velocity = b.velocity, a.velocity)lua"};
inline constexpr Mistake oneSided{R"lua(-- Only the ball that is hit changes
--
-- The ball that hits goes on as before, so momentum comes from nowhere. Look at what a hit takes
-- from it.
)lua",
                                  R"lua(  a.velocity = a.velocity - closing * normal
)lua",
                                  R"lua()lua"};
/// Other words, and the whole velocities change hands.
inline constexpr const char *rackOfAStudent = R"lua(function on_update(h)
  local before = {}
  for i = 1, #circles do
    before[i] = circles[i].position
    circles[i].position = before[i] + h * circles[i].velocity
  end
  for i = 2, #circles do
    for j = 1, i - 1 do
      local a, b = circles[i], circles[j]
      local gap = (a.position - b.position):length() - a.radius - b.radius
      if gap < 0 and (b.velocity - a.velocity):dot(before[i] - before[j]) > 0 then
        a.position, b.position = before[i], before[j]
        local kept = a.velocity
        a.velocity = b.velocity
        b.velocity = kept
      end
    end
  end
end
)lua";
inline constexpr const char *dragText = R"lua(# Slow it down

Something thick brakes the ball: $a = -k v$ with $k = {{k}}$ 1/s, so that its speed falls as
$e^{-kt}$.
)lua";
inline constexpr const char *dragSolution =
    R"lua(-- Drag. Lengths in m, times in s, velocities in m/s.
local k = {{k}} -- 1/s

function on_update(timestep)
  local acceleration = -k * circle1.velocity
  circle1.velocity = circle1.velocity + acceleration * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
)lua";
inline constexpr const char *dragStarter =
    R"lua(-- Drag. Lengths in m, times in s, velocities in m/s.
local k = {{k}} -- 1/s

function on_update(timestep)
  local acceleration = vec(0, 0)
  circle1.velocity = circle1.velocity + acceleration * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
)lua";
/// Within 1 % of the first speed at every step.
inline constexpr const char *dragCheck = R"lua(function check(run)
  local began = run:step(0).circles[1].velocity
  for state in run:steps() do
    local right = began * math.exp(-{{k}} * state.time)
    local seen = state.circles[1].velocity
    if (seen - right):length() > 0.01 * began:length() then
      return false, string.format("At %.2f s it moves at %.3f m/s; v₀ e^(−kt) is %.3f m/s", state.time, seen:length(), right:length()),
        {time = state.time, expected = right:length(), observed = seen:length(), unit = "m/s"}
    end
  end
  return true
end
)lua";
inline constexpr Mistake square{R"lua(-- The drag grows with the square of the speed
--
-- Your ball slows down by k v² where k v is asked for: a fast one loses too much, a slow one too
-- little. Look at the power of the speed.
)lua",
                                R"lua(-k * circle1.velocity)lua",
                                R"lua(-k * circle1.velocity:length() * circle1.velocity)lua"};
inline constexpr Mistake speedsUp{R"lua(-- The drag pushes
--
-- Your ball gets faster and faster. A drag points against the velocity. Look at its sign.
)lua",
                                  R"lua(-k * circle1)lua", R"lua(k * circle1)lua"};
/// Twice the drag, which no mistake of the author has.
inline constexpr const char *dragOfAStudent = R"lua(function on_update(h)
  local v = circle1.velocity
  v = v - %1 * h * v
  circle1.velocity = v
  circle1.position = circle1.position + h * v
end
)lua";
inline constexpr const char *springText = R"lua(# A spring

Between the two balls is a spring, 2 m long at rest. It gives each of them $a = k (l - 2)$ toward the
other, with $k = 4$ 1/s².
)lua";
inline constexpr const char *springSolution =
    R"lua(-- Spring. Lengths in m, times in s, velocities in m/s.
local stiffness, rest = 4, 2 -- 1/s², m

-- Symplectic Euler: the velocities from the end of the step move the balls.
function on_update(timestep)
  local between = circle2.position - circle1.position
  local pull = stiffness * (between:length() - rest) * between:normalized()
  circle1.velocity = circle1.velocity + pull * timestep
  circle2.velocity = circle2.velocity - pull * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
  circle2.position = circle2.position + circle2.velocity * timestep
end
)lua";
inline constexpr const char *springStarter =
    R"lua(-- Spring. Lengths in m, times in s, velocities in m/s.
local stiffness, rest = 4, 2 -- 1/s², m

-- Symplectic Euler: the velocities from the end of the step move the balls.
function on_update(timestep)
  local between = circle2.position - circle1.position
  local pull = vec(0, 0)
  circle1.velocity = circle1.velocity + pull * timestep
  circle2.velocity = circle2.velocity - pull * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
  circle2.position = circle2.position + circle2.velocity * timestep
end
)lua";
inline constexpr const char *periodCheck = R"lua(function check(run)
  local asked, rest = 2 * math.pi / math.sqrt(8), 2
  local crossings, before = {}, nil
  for state in run:steps() do
    local length = (state.circles[2].position - state.circles[1].position):length() - rest
    if before and before < 0 and length >= 0 then
      crossings[#crossings + 1] = state.time
    end
    before = length
  end
  if #crossings < 2 then
    return false, "It does not swing to and fro about 2 m"
  end
  local seen = (crossings[#crossings] - crossings[1]) / (#crossings - 1)
  if math.abs(seen - asked) > 0.05 then
    return false, string.format("Its period is %.3f s; 2π/√(2k) is %.3f s", seen, asked),
      {time = crossings[1], expected = asked, observed = seen, unit = "s"}
  end
  return true
end
)lua";
inline constexpr const char *momentumCheck = R"lua(function check(run)
  local first = run:step(0)
  local start = first.circles[1].velocity + first.circles[2].velocity
  for state in run:steps() do
    local now = state.circles[1].velocity + state.circles[2].velocity
    if (now - start):length() > 1e-9 then
      return false, string.format("At %.2f s their velocities sum up to %.3f m/s; %.3f m/s at the start", state.time, now.x, start.x),
        {time = state.time, expected = start.x, observed = now.x, unit = "m/s"}
    end
  end
  return true
end
)lua";
inline constexpr Mistake noRestLength{R"lua(-- The spring pulls at any length
--
-- Your spring pulls the balls together as if it had no length of its own. Look at how long it is
-- at rest.
)lua",
                                      R"lua((between:length() - rest))lua",
                                      R"lua(between:length())lua"};
inline constexpr Mistake oneEnd{R"lua(-- Only one ball feels the spring
--
-- The spring pulls at circle 1 alone, so momentum comes from nowhere. Look at what pulls the other.
)lua",
                                R"lua(  circle2.velocity = circle2.velocity - pull * timestep
)lua",
                                R"lua()lua"};
/// The other ball is forgotten.
inline constexpr const char *springOfAStudent = R"lua(local function pull(from, to)
  local way = to.position - from.position
  return 4 * (way:length() - 2) * way:normalized()
end

function on_update(h)
  circle1.velocity = circle1.velocity + h * pull(circle1, circle2)
  circle1.position = circle1.position + h * circle1.velocity
  circle2.position = circle2.position + h * circle2.velocity
end
)lua";

} // namespace cradle::story
