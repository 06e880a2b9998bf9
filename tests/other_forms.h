// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"

#include <QString>

#include <functional>

/// Programs for the steps of Lab 4.2 that look nothing like the lab's own: put together from
/// parts, any of which may be exchanged for a wrong one.
namespace cradle::programs {

/// The parts. In them `c` is a circle, `h` the timestep; in a hit `p` and `q` are the circles, `n`
/// the unit vector from p to q, `closing` how fast they approach.
struct OtherForm {
    QString start{};
    QString integrate{};
    QString walls{};
    QString reach = QStringLiteral("p.radius + q.radius");
    QString touch = QStringLiteral("(q.position - p.position):length() < reach");
    QString answer{};
    QString mass = QStringLiteral("c.density * c.radius ^ 3");
    bool circlesFirst = false; ///< hits before walls

    [[nodiscard]] QString source() const
    {
        const QString text = QStringLiteral(R"lua(
function on_load()
  %1
end

local function weigh(c)
  return %2
end

local function walls(c)
  %3
end

local function hit(p, q)
  local reach = %4
  if %5 then
    local n = (q.position - p.position):normalized()
    local closing = (p.velocity - q.velocity):dot(n)
    local m1, m2 = weigh(p), weigh(q)
    %6
  end
end

function on_update(h)
  for i = 1, #circles do
    local c = circles[i]
    %7
  end
  %8
end
)lua");
        const QString bounce = QStringLiteral("for i = 1, #circles do walls(circles[i]) end ");
        const QString meet =
            answer.isEmpty() ? QString() : QStringLiteral("hit(circle1, circle2) ");
        return text.arg(start, mass, walls, reach, touch, answer, integrate,
                        circlesFirst ? meet + bounce : bounce + meet);
    }
};

namespace parts {

inline QString lab(const char *text)
{
    return QString::fromUtf8(text);
}

inline const QString euler = lab("c.position = c.position + c.velocity * h "
                                 "c.velocity = c.velocity + gravity * h");
inline const QString symplectic = lab("c.velocity = c.velocity + gravity * h "
                                      "c.position = c.position + c.velocity * h");
inline const QString verlet = lab("c.position = c.position + h * (c.velocity + h / 2 * gravity) "
                                  "c.velocity = c.velocity + h * gravity");

/// Each coordinate is put onto the wall.
inline const QString clamp = lab(R"lua(
  local room = square.half_width - c.radius
  local x, y, vx, vy = c.position.x, c.position.y, c.velocity.x, c.velocity.y
  if x > room then x, vx = room, -math.abs(vx) elseif x < -room then x, vx = -room, math.abs(vx) end
  if y > room then y, vy = room, -math.abs(vy) elseif y < -room then y, vy = -room, math.abs(vy) end
  c.position, c.velocity = vec(x, y), vec(vx, vy)
)lua");
/// Each coordinate goes as far inside as it was outside.
inline const QString mirror = QString(clamp)
                                  .replace(lab("x, vx = room,"), lab("x, vx = 2 * room - x,"))
                                  .replace(lab("x, vx = -room,"), lab("x, vx = -2 * room - x,"))
                                  .replace(lab("y, vy = room,"), lab("y, vy = 2 * room - y,"))
                                  .replace(lab("y, vy = -room,"), lab("y, vy = -2 * room - y,"));
/// With e, and only where it moves into the wall.
inline const QString clampWithE = lab(R"lua(
  local room = square.half_width - c.radius
  local x, y, vx, vy = c.position.x, c.position.y, c.velocity.x, c.velocity.y
  local e = restitution
  if math.abs(x) > room and x * vx > 0 then x, vx = x > 0 and room or -room, -e * vx end
  if math.abs(y) > room and y * vy > 0 then y, vy = y > 0 and room or -room, -e * vy end
  c.position, c.velocity = vec(x, y), vec(vx, vy)
)lua");

inline const QString stop = lab("p.velocity, q.velocity = vec(0, 0), vec(0, 0)");
inline const QString exchange = lab("if closing > 0 then p.velocity = p.velocity - closing * n "
                                    "q.velocity = q.velocity + closing * n end");
inline const QString impulse =
    lab("local j = (1 + restitution) * closing / (1 / m1 + 1 / m2) if closing > 0 then "
        "p.velocity = p.velocity - j / m1 * n q.velocity = q.velocity + j / m2 * n end");
/// The centre of mass stays, what moves against it turns round.
inline const QString aboutCentre =
    lab("local u = (m1 * p.velocity + m2 * q.velocity) / (m1 + m2) if closing > 0 then "
        "p.velocity = p.velocity + (1 + restitution) * (u - p.velocity):dot(n) * n "
        "q.velocity = q.velocity + (1 + restitution) * (u - q.velocity):dot(n) * n end");

} // namespace parts

/// Correct work for a step, in a form that is not the lab's own.
inline OtherForm otherForm(const QString &step)
{
    using namespace parts;
    OtherForm form;
    const int number = step.mid(4).toInt();
    const auto twoStarts = [](const char *p1, const char *v1, const char *p2, const char *v2) {
        return lab("circle1.position, circle1.velocity = vec(%1), vec(%2) "
                   "circle2.position, circle2.velocity = vec(%3), vec(%4) ")
            .arg(lab(p1), lab(v1), lab(p2), lab(v2));
    };
    form.integrate = number < 7 ? euler : verlet;
    form.walls = number == 1 ? QString() : number < 17 ? mirror : clampWithE;
    form.start = lab("circle1.velocity = vec(2, 0) ");
    if (number >= 3)
        form.start += lab("gravity = vec(0, -9.81) ");
    if (number >= 4)
        form.start += twoStarts("-2, 2", "2, 0", "-2, 2", "2, 0");
    if (number == 5)
        form.integrate =
            lab("if c.index == 1 then ") + euler + lab(" else ") + symplectic + lab(" end");
    if (number >= 8)
        form.start = lab("gravity = vec(0, 0) ");
    if (number == 8 || number == 9 || number == 10)
        form.start += twoStarts("-2, 2", "2, 0", "2, 2", "0, 0");
    if (number == 11)
        form.start += twoStarts("-2, 2.3", "2, 0", "2, 2", "0, 0");
    if (number == 12 || number == 13)
        form.start += twoStarts("-2, 2", "2, 0", "2, -2", "0, 2");
    if (number == 13)
        form.start += lab("circle2.radius = 0.4 ");
    if (number >= 14)
        form.start += twoStarts("-2.5, 2", "1, 0", "0, 2", "-1, 0");
    if (number == 14)
        form.start += lab("circle1.radius, circle2.radius = 0.2, 0.252 ");
    if (number >= 15)
        form.start += lab("circle1.radius, circle2.radius = 0.2, 0.2 "
                          "circle1.density, circle2.density = 1, 2 ");
    if (number >= 16)
        form.start += lab("restitution = 0.5 ");
    if (number == 17)
        form.start += lab("gravity = vec(0, -9.81) restitution = 0.75 ");
    if (number == 9)
        form.answer = stop;
    else if (number == 10)
        form.answer =
            lab("if closing > 0 then p.velocity, q.velocity = q.velocity, p.velocity end");
    else if (number >= 14)
        form.answer = impulse;
    else if (number >= 11)
        form.answer = exchange;
    return form;
}

/// What makes another form, or a mistake, of a form.
using FormChange = std::function<void(OtherForm &)>;

/// Replaces a piece of a part; it must be there.
inline void edit(QString &part, const char *before, const char *after)
{
    Q_ASSERT_X(part.contains(QString::fromUtf8(before)), "edit", before);
    part.replace(QString::fromUtf8(before), QString::fromUtf8(after));
}

/// A verdict for messages of tests.
inline QByteArray say(const CheckReport &report)
{
    QString text = report.passed ? QStringLiteral("passed") : QStringLiteral("did not pass");
    if (report.error)
        text += QStringLiteral("; line %1: %2").arg(report.error->line).arg(report.error->message);
    for (const CheckOutcome &check : report.checks) {
        if (!check.passed)
            text += QStringLiteral("; %1 (%2): %3").arg(check.id, check.variant, check.message);
    }
    for (const Finding &finding : report.findings)
        text += QStringLiteral("; found [%1] %2").arg(finding.mistake, finding.message);
    return text.toUtf8();
}

} // namespace cradle::programs
