// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// Right programs to which something is done after every step, a little or much of it: what is
/// just too little to be told, and what is told then.
namespace cradle::approved {

/// What is done to circle c, the i-th, that was at x with v, m and m/s: hit says whether more than
/// gravity turned it in this step, the steps-th.
constexpr const char *slips[] = {
    "c.velocity = c.velocity * 0.9999",
    "c.velocity = c.velocity * 1.003",
    "c.velocity = v + (c.velocity - v) * 0.9995",
    "c.velocity = v + (c.velocity - v) * 1.04",
    "if i == #circles then c.velocity = v + (c.velocity - v) * 0.5 end",
    "c.velocity = c.velocity + vec(1e-5, 0)",
    "c.velocity = c.velocity - vec(0, 2e-3)",
    "c.position = x + (c.position - x) * 1.0005",
    "if i == 1 then c.position = x + (c.position - x) * 0.98 end",
    "c.position = c.position + vec(1e-6, -1e-6)",
    "c.position = c.position + vec(0, 3e-4)",
    "if steps == 7 then c.position = c.position + vec(0.01, 0) end",
    "if steps > 40 then c.velocity = c.velocity * 0.99 end",
    "if c.velocity:length() > 2 then c.velocity = c.velocity * (2 / c.velocity:length()) end",
    "if c.velocity:length() < 0.05 then c.velocity = vec(0, 0) end",
    "if c.velocity.y > 0 then c.velocity = vec(c.velocity.x, c.velocity.y * 1.001) end",
    "if hit then c.velocity = c.velocity * 0.999 end",
    "if hit then c.velocity = c.velocity * 1.01 end",
    "if hit then c.velocity = c.velocity * 0.9 end",
    "if hit and i == 1 then c.velocity = c.velocity * 0.97 end",
    "if hit and i == 2 then c.velocity = v end",
    "if hit and i == 2 then c.velocity = -c.velocity end",
    "if hit then c.velocity = vec(c.velocity.x, v.y) end",
    "if hit then c.velocity = vec(v.x * 0.99, c.velocity.y) end",
    "if hit then c.velocity = vec(c.velocity.x - 0.002 * c.velocity.y, c.velocity.y) end",
    "if hit then c.velocity = vec(c.velocity.x, c.velocity.y + 0.1 * c.velocity.x) end",
    "if hit then c.velocity = vec(c.velocity.y, c.velocity.x) end",
    "if hit then c.position = x end",
    "if hit then c.position = c.position + 0.002 * c.velocity end",
    "if hit then c.position = x - 2 * h * v end",
    "if hit and c.radius > 0.25 then c.velocity = c.velocity * 0.95 end",
    "if hit and c.density < 3 then c.velocity = v end",
    "if hit and restitution < 0.9 then c.velocity = c.velocity * 1.05 end",
    "if hit and v:length() < 0.3 then c.velocity = v end",
    "if hit and x.y > 0 then c.velocity = v end",
    "if hit and math.abs(x.x) > 2 then c.velocity = c.velocity * 0.8 end",
    "if hit and steps > 30 then c.velocity = v end",
    "if hit and v.x < 0 then c.velocity = 0.7 * c.velocity end",
    ("if kept[i] then c.velocity = kept[i] kept[i] = nil elseif hit then kept[i] = c.velocity "
     "c.velocity = v end"),
    "if hit then kept[i] = (kept[i] or 0) + 1 if kept[i] > 1 then c.velocity = v end end",
    "if steps == 5 then error('stop') end",
    "if steps == 90 then error('stop') end",
    "if hit then error('stop') end",
    "if hit and steps % 2 == 0 then c.position = vec(0, 0) end",
};

/// \p program, and \p slip after each of its steps.
inline QString withSlip(const QString &program, const char *slip)
{
    return QStringLiteral(
               "do\n%1\nend\n"
               "local right, steps, kept = on_update, 0, {}\n"
               "function on_update(h)\n"
               "  steps = steps + 1\n"
               "  local before = {}\n"
               "  for i, c in ipairs(circles) do before[i] = {c.position, c.velocity} end\n"
               "  right(h)\n"
               "  for i, c in ipairs(circles) do\n"
               "    local x, v = before[i][1], before[i][2]\n"
               "    local hit = (c.velocity - v - h * gravity):length() > 1e-6\n"
               "    %2\n"
               "  end\n"
               "end\n")
        .arg(program, QString::fromLatin1(slip));
}

} // namespace cradle::approved
