// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/draws.h"

#include <QRegularExpression>
#include <QString>

/// Programs that answer walls and other circles by other laws, with numbers in them that are wrong
/// by a little or much.
namespace cradle::approved::answers {

/// In all of them A is drawn, and F is 1 + A. Of walls: how near a circle of radius r counts, what
/// else is asked, what comes back and what stays, and where it is put.
inline constexpr const char *reaches[] = {"r",   "r * F", "r + A", "0",
                                          "0.2", "r / 2", "2 * r", "r * r"};
inline constexpr const char *asks[] = {
    "true",           "out > 0",   "out > A", "out < 0",          "steps % 2 == 0",
    "v:length() < 2", "steps > 8", "i == 1",  "c.velocity.y < A", "restitution > 0.4"};
inline constexpr const char *backs[] = {"e",     "e * F",      "1", "e ^ 2",        "1 - e",
                                        "F",     "-1",         "0", "math.sqrt(e)", "r * 5",
                                        "e + A", "(1 + e) / 2"};
inline constexpr const char *stays[] = {"1", "F", "e", "0", "-1", "1 + A * e"};
inline constexpr const char *puts[] = {"c.position",
                                       "x",
                                       "x + A * v",
                                       "c.position + h * c.velocity",
                                       "x + F * h * c.velocity",
                                       ("vec(math.max(-w + r, math.min(w - r, c.position.x)), "
                                        "math.max(-w + r, math.min(w - r, c.position.y)))"),
                                       "vec(math.max(-w, math.min(w, c.position.x)), c.position.y)",
                                       "c.position * F",
                                       "vec(0, 0)"};
/// Of two circles p and q: when they are near, which line, mass and push they take, and where to.
inline constexpr const char *nears[] = {"p.radius + q.radius",
                                        "(p.radius + q.radius) * F",
                                        "p.radius + q.radius + A",
                                        "2 * p.radius",
                                        "0.4",
                                        "p.radius * F",
                                        "2 * math.max(p.radius, q.radius)"};
inline constexpr const char *comes[] = {
    "u > 0", "u > A", "true", "u < 0", "u > 0.3", "steps % 3 > 0", "p.position.x > q.position.x"};
inline constexpr const char *lines[] = {"d:normalized()",
                                        "(d + vec(A, 0)):normalized()",
                                        "d",
                                        "vec(d.y, d.x):normalized()",
                                        "d:normalized() * F",
                                        "(p.velocity - q.velocity):normalized()",
                                        "vec(1, 0)",
                                        "(oldq - oldp):normalized()"};
inline constexpr const char *masses[] = {"c.density * c.radius ^ 3",
                                         "c.density * c.radius ^ 3 + A",
                                         "c.density * c.radius ^ (3 * F)",
                                         "c.density * c.radius ^ 2",
                                         "1",
                                         "c.radius ^ 3",
                                         "c.density ^ F * c.radius ^ 3"};
inline constexpr const char *pushes[] = {"(1 + e) * u",     "(1 + e) * u * F",
                                         "2 * u",           "(1 + e * F) * u",
                                         "(1 + e ^ 2) * u", "u",
                                         "(1 + e) * u + A", "(1 + e) * math.abs(u)",
                                         "(2 - e) * u",     "(1 + e) * p.velocity:dot(n)"};
inline constexpr const char *places[] = {
    "p.position, q.position", "oldp, oldq", "oldp, q.position",
    "p.position - A * n, q.position + A * n",
    "p.position + h * p.velocity, q.position + h * q.velocity"};

inline constexpr const char *text = R"lua(
local steps = 0
local function mass(c) return MASS end
function on_update(h)
  steps = steps + 1
  local e, w, olds = restitution, square.half_width, {}
  for i, c in ipairs(circles) do
    local x, v, r = c.position, c.velocity, c.radius
    olds[i] = x
    c.velocity = v + gravity * h
    c.position = x + h * VELOCITY
    for _, n in ipairs({vec(1, 0), vec(0, 1), vec(-1, 0), vec(0, -1)}) do
      local out = c.velocity:dot(n)
      local isOdd = ODD
      local reach, asked, back, stay = r, out > 0, e, 1
      if isOdd then reach, asked, back, stay = REACH, ASK, BACK, STAY end
      if c.position:dot(n) + reach > w and asked then
        c.velocity = stay * (c.velocity - out * n) - back * out * n
        c.position = PUT
      end
    end
  end
  local p, q = circles[1], circles[2]
  if not q then return end
  local oldp, oldq, d = olds[1], olds[2], q.position - p.position
  local n = LINE
  local u = (p.velocity - q.velocity):dot(n)
  if d:length() < NEAR and COME then
    local j = PUSH
    local m1, m2 = mass(p), mass(q)
    p.velocity, q.velocity = p.velocity - j * m2 / (m1 + m2) * n, q.velocity + j * m1 / (m1 + m2) * n
    p.position, q.position = PLACE
  end
end
)lua";
inline constexpr const char *odds[] = {"true",    "i == 1",   "n.x > 0",
                                       "n.y < 0", "n.x ~= 0", "steps > 5"};

inline QString program(Draws &draws)
{
    QString all = QString::fromLatin1(text);
    const auto fill = [&](const char *word, const auto &of) {
        // Most are right, so that a fault is often alone.
        all.replace(QLatin1String(word),
                    QString::fromLatin1(of[draws.oneOf(3) ? draws.below(std::size(of)) : 0]));
    };
    fill("MASS", masses);
    fill("REACH", reaches);
    fill("ASK", asks);
    fill("BACK", backs);
    fill("STAY", stays);
    fill("PUT", puts);
    fill("LINE", lines);
    fill("NEAR", nears);
    fill("COME", comes);
    fill("PUSH", pushes);
    fill("PLACE", places);
    fill("ODD", odds);
    all.replace(QLatin1String("VELOCITY"), QLatin1String(draws.oneOf(2) ? "v" : "c.velocity"));
    const double by = draws.amount();
    static const QRegularExpression one(QStringLiteral("\\bA\\b"));
    static const QRegularExpression other(QStringLiteral("\\bF\\b"));
    return all.replace(one, QStringLiteral("(%1)").arg(by))
        .replace(other, QStringLiteral("(1 + (%1))").arg(by));
}

} // namespace cradle::approved::answers
