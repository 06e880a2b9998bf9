// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/scene_quantities.h"

#include <QStringList>

namespace cradle {

namespace {

/// In one line: the lines of the program behind it keep their numbers. Factors that all masses
/// have in common do not count.
constexpr const char *quantitiesText = R"(
local before = { %4 }
local function known_values(h, kind)
  local of_normal = kind == 'normal'
  local all = {}
  local function add(v)
    all[#all + 1] = v
    all[#all + 1] = -v
    if type(v) == 'vector' then add(v.x) add(v.y) end
  end
  local function add_pair(p, q, v, w)
    if p == q then return end
    local n = (q - p):normalized()
    local t = n:perpendicular()
    add(n) add(t)
    if of_normal then return end
    local function along(s) add(s) add(s * n) end
    local a, b = v:dot(n), w:dot(n)
    add(q - p) add((q - p):length())
    add((q - p):length() - circle1.radius - circle2.radius)
    if kind == 'squared' then add((q - p):length_squared()) end
    add(v) add(w) add(v - w)
    along(a) along(b) along(a - b)
    add(v:dot(t)) add(w:dot(t)) add(v - a * n) add(w - b * n)
    local m = circle1.density * circle1.radius ^ 3
    local k = circle2.density * circle2.radius ^ 3
    local c = (m * v + k * w) / (m + k)
    add(c) add(v - c) add(w - c) along(c:dot(n))
    add(m / (m + k)) add(k / (m + k)) add(m / k) add(k / m)
    local push = (1 + restitution) * m * k / (m + k) * (a - b)
    local e = restitution * (a - b)
    along(e) along(e + a - b)
    add(e * m / (m + k)) add(e * k / (m + k))
    along(push / m) along(push / k) along(a - push / m) along(b + push / k)
    for _, f in ipairs({ 1, 1000, 4 / 3 * math.pi, 4000 / 3 * math.pi }) do
      add(f * m) add(f * k) add(f * m * k / (m + k)) add(f * (m * a + k * b))
      if kind ~= 'reduced' then add(f * (m + k)) end
      add(1 / (f * m)) add(1 / (f * k)) add(1 / (f * m) + 1 / (f * k))
      along(f * push)
      if kind ~= 'push' then add(f * m * v) add(f * k * w) end
      add(e / (f * (m + k))) add((a - b) / (f * (m + k)))
      if kind ~= 'push' then add((a - b + e) / (f * (m + k))) end
      add(f * circle1.radius ^ 3) add(f * circle2.radius ^ 3)
    end
  end
  for _, c in ipairs(of_normal and {} or circles) do
    add(c.position) add(c.velocity) add(c.velocity * h) add(c.radius) add(c.density)
    add(c.velocity + gravity * h) add(square.half_width - c.radius)
  end
  if not of_normal then add(h) add(gravity * h) add(restitution) add(1 + restitution) end
  if #circles > 1 then
    local p, q, v, w = circle1.position, circle2.position, circle1.velocity, circle2.velocity
    add(circle1.radius + circle2.radius)
    add_pair(p, q, v, w)
    local x, y = before[1], before[2]
    local k, l = before[3], before[4]
    local i, j = k + gravity * h, l + gravity * h
    add_pair(x, y, k, l)
    add_pair(x, y, i, j)
    add_pair(x, y, v, w)
    add_pair(x + k * h, y + l * h, i, j)
    add_pair(x + i * h, y + j * h, i, j)
  end
  return all
end
local function as_vector(v)
  if type(v) == 'table' and (v[1] or v.x) then return vec(v[1] or v.x, v[2] or v.y) end
  return v
end
local function is_of_parts(u, a, b)
  if type(u) == 'number' then
    return type(a) == 'vector' and type(b) == 'vector' and u == a:dot(b)
      or type(a) == 'vector' and b == nil and math.abs(u - a:length()) <= 1e-9
  end
  if type(a) == 'vector' and type(b) == 'vector' then
    return u == a + b or u == a - b or u == b - a or u == a:dot(b) * b or u == a - a:dot(b) * b
  end
  if type(a) == 'number' then
    return type(b) == 'number' and u == vec(a, b) or type(b) == 'vector' and u == a * b
  end
  return type(a) == 'vector' and (type(b) == 'number' and u == a * b
    or b == nil and (u == a or a:length() > 0 and (u - a:normalized()):length() <= 1e-9))
end
local function known(a, b, v, ...)
  if step == %1 then
    local u = as_vector(v)
    local is_known = type(u) ~= 'number' and type(u) ~= 'vector' or is_of_parts(u, as_vector(a), as_vector(b))
    for _, q in ipairs(is_known and {} or known_values(%2, '%3')) do
      is_known = is_known or type(u) == type(q)
        and (type(u) == 'number' and math.abs(u - q) <= 1e-9 * (1 + math.abs(q))
          or type(u) == 'vector' and q:length() > 0 and (u - q):length() <= 1e-9)
        and (not %5 or u ~= 0)
    end
    if not is_known then error('') end
  end
  return v, ...
end
)";

} // namespace

QString knownQuantities(Known known, qint64 step, double timestep, const World &before,
                        bool isStrict)
{
    const QLatin1String kind(known == Known::Normal    ? "normal"
                             : known == Known::Reduced ? "reduced"
                             : known == Known::Push    ? "push"
                             : known == Known::Squared ? "squared"
                                                       : "any");
    const auto number = [](double value) { return QString::number(value, 'g', 17); };
    QStringList places;
    QStringList velocities;
    for (const Circle &circle : before.circles) {
        const QString vector = QStringLiteral("vec(%1, %2)");
        places.append(vector.arg(number(circle.position.x), number(circle.position.y)));
        velocities.append(vector.arg(number(circle.velocity.x), number(circle.velocity.y)));
    }
    const QStringList all = places.mid(0, 2) + velocities.mid(0, 2);
    return QString::fromLatin1(quantitiesText)
               .simplified()
               .arg(step)
               .arg(number(timestep), kind, all.join(QLatin1String(", ")),
                    isStrict ? QLatin1String("true") : QLatin1String("false"))
           + QLatin1Char(' ');
}

} // namespace cradle
