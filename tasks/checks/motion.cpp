// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/motion.h"

#include "tasks/checks/check_kinds.h"
#include "tasks/checks/figures.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cradle::motion {

namespace {

struct MotionText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

bool isOpen(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    return !isNearWall(o, i, k, gravity) && !isNearCircle(o, i, k, gravity);
}

/// The first step in which circle \p i meets nothing and yet is changed besides gravity, where it
/// is so in most of them.
std::optional<qint64> changedInTheOpen(const Observation &o, int i, Vec2 gravity,
                                       std::optional<Vec2> axis)
{
    qint64 open = 0;
    qint64 changed = 0;
    std::optional<qint64> first;
    for (qint64 step = 0; step < o.steps(); ++step) {
        if (!isOpen(o, i, step, gravity))
            continue;
        ++open;
        const Vec2 whole = kick(o, i, step, gravity);
        if (isSame(axis ? dot(whole, *axis) * *axis : whole, {}))
            continue;
        ++changed;
        if (!first)
            first = step;
    }
    return 2 * changed > open ? first : std::nullopt;
}

/// The first step in which circle \p i meets nothing and goes another way than any integrator takes
/// it, v Δt and up to g Δt² more, where it is so in most of them.
std::optional<qint64> strayInTheOpen(const Observation &o, int i, Vec2 gravity)
{
    const double dt = o.timestep();
    qint64 open = 0;
    qint64 stray = 0;
    std::optional<qint64> first;
    for (qint64 step = 0; step < o.steps(); ++step) {
        if (!isOpen(o, i, step, gravity))
            continue;
        ++open;
        const Circle &c = o.circle(i, step);
        const Vec2 beside = o.circle(i, step + 1).position - c.position - dt * c.velocity;
        const double fall = quickLength(gravity) * dt * dt;
        const double along = fall > 0.0 ? dot(beside, gravity) / quickLength(gravity) : 0.0;
        const double across = fall > 0.0 ? std::abs(cross(beside, gravity)) / quickLength(gravity)
                                         : quickLength(beside);
        if (across <= samePosition && along >= -samePosition && along <= fall + samePosition)
            continue;
        ++stray;
        if (!first)
            first = step;
    }
    return 2 * stray > open ? first : std::nullopt;
}

Fault strayFault(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const Circle &c = o.circle(i, k);
    const Vec2 moved = o.circle(i, k + 1).position - c.position;
    const Vec2 way = o.timestep() * c.velocity;
    const Vec2 fall = o.timestep() * o.timestep() * gravity;
    const bool x = std::abs(moved.x - way.x) > std::abs(moved.y - way.y);
    const QString text =
        fall == Vec2{}
            ? MotionText::tr("At step %1, where it touches nothing, circle %2 moved by %3 m; its "
                             "velocity times the timestep is %4 m. Hits are judged once this is "
                             "mended")
            : MotionText::tr("At step %1, where it touches nothing, circle %2 moved by %3 m; its "
                             "velocity times the timestep is %4 m, and gravity adds at most %5 m. "
                             "Hits are judged once this is mended")
                  .replace(QLatin1String("%5"), figure(fall));
    return {.message = text.arg(QString::number(k + 1), QString::number(i + 1),
                                figureBeside(moved, way), figureBeside(way, moved)),
            .expected = x ? way.x : way.y,
            .observed = x ? moved.x : moved.y,
            .unit = QStringLiteral("m"),
            .step = k + 1,
            .circle = i};
}

} // namespace

bool isSame(Vec2 a, Vec2 b, double tolerance)
{
    return quickLength(a - b) <= tolerance * (1.0 + quickLength(b));
}

double toleranceOf(const CheckSpec &check)
{
    return valueOf(check, QStringLiteral("tolerance")).toDouble();
}

double restitutionOf(const CheckSpec &check, const Observation &o)
{
    return valueOf(check, QStringLiteral("restitution")).toDouble(o.variant.preset.restitution);
}

std::optional<Vec2> askedGravity(const CheckSpec &check)
{
    const QJsonArray list = valueOf(check, QStringLiteral("gravity")).toArray();
    if (list.size() != 2)
        return std::nullopt;
    return Vec2{list.at(0).toDouble(), list.at(1).toDouble()};
}

Vec2 gravityOf(const CheckSpec &check, const Observation &o)
{
    return askedGravity(check).value_or(o.variant.preset.gravity);
}

Vec2 kick(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    return o.circle(i, k + 1).velocity - o.circle(i, k).velocity - o.timestep() * gravity;
}

bool isKicked(const Observation &o, int i, qint64 k, Vec2 gravity, double tolerance)
{
    return quickLength(kick(o, i, k, gravity))
           > tolerance * (1.0 + quickLength(o.circle(i, k).velocity));
}

Fault changedInOpen(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const Vec2 before = o.circle(i, k).velocity;
    const Vec2 after = o.circle(i, k + 1).velocity;
    const Vec2 right = before + o.timestep() * gravity;
    const bool x = std::abs(after.x - right.x) > std::abs(after.y - right.y);
    // Who is moved further than asked may have been at a wall, and turned there.
    const bool isTurned = after.x * before.x < 0.0 || after.y * before.y < 0.0;
    const QString text =
        isTurned ? MotionText::tr("At step %1, which began away from the walls, the velocity of "
                                  "circle %2 went from %3 to %4 m/s; %5 m/s is "
                                  "right. Hits are judged once this is mended")
                 : MotionText::tr("At step %1, where it touches nothing, the velocity of "
                                  "circle %2 went from %3 to %4 m/s; %5 m/s is right. Hits are "
                                  "judged once this is mended");
    return {.message = text.arg(QString::number(k + 1), QString::number(i + 1),
                                figureBeside(before, after), figureBeside(after, right),
                                figureBeside(right, after)),
            .expected = x ? right.x : right.y,
            .observed = x ? after.x : after.y,
            .unit = QStringLiteral("m/s"),
            .step = k + 1,
            .circle = i};
}

std::optional<Fault> steadyFault(const Observation &o, int i, Vec2 gravity,
                                 std::optional<Vec2> axis)
{
    if (const auto changed = changedInTheOpen(o, i, gravity, axis))
        return changedInOpen(o, i, *changed, gravity);
    const auto stray = strayInTheOpen(o, i, gravity);
    return stray ? std::optional(strayFault(o, i, *stray, gravity)) : std::nullopt;
}

double travel(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const double dt = o.timestep();
    return (quickLength(o.circle(i, k).velocity) + quickLength(gravity) * dt) * dt + samePosition;
}

double recentTravel(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    return travel(o, i, k, gravity) + travel(o, i, std::max<qint64>(0, k - 1), gravity);
}

std::optional<Fault> leap(const Observation &o, int i, qint64 k, double way)
{
    const double moved = quickLength(o.circle(i, k + 1).position - o.circle(i, k).position);
    // It may go on with the velocity that the step gives it.
    const double after = quickLength(o.circle(i, k + 1).velocity) * o.timestep();
    if (moved <= std::max(longestLeap * way, after + samePosition))
        return std::nullopt;
    const double own = way > 4.0 * samePosition ? way / 2.0 : 0.0; // of rest, rounding is no way
    return Fault{.message = MotionText::tr("At step %1 circle %2 moved by %3 m at once; with its "
                                           "velocity it comes %4 m far")
                                .arg(QString::number(k + 1), QString::number(i + 1), figure(moved),
                                     figure(own)),
                 .expected = own,
                 .observed = moved,
                 .unit = QStringLiteral("m"),
                 .step = k + 1,
                 .circle = i};
}

double wallGap(const Observation &o, const Circle &c, Wall wall)
{
    return o.variant.preset.halfWidth - c.radius - dot(c.position, outwardNormal(wall));
}

bool isNearWall(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    return std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
        return wallGap(o, o.circle(i, k), wall) <= travel(o, i, k, gravity);
    });
}

bool isNearCircle(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    for (int j = 0; j < o.circleCount(); ++j) {
        const double gap = quickLength(o.circle(j, k).position - o.circle(i, k).position)
                           - o.circle(i, k).radius - o.circle(j, k).radius;
        if (j != i && gap <= travel(o, i, k, gravity) + travel(o, j, k, gravity))
            return true;
    }
    return false;
}

bool isFree(const CheckSpec &check, const Observation &o, int i, qint64 k, Vec2 gravity)
{
    if (isNearWall(o, i, k, gravity))
        return false;
    const bool collisions = valueOf(check, QStringLiteral("collisions")).toBool();
    return !collisions || !isNearCircle(o, i, k, gravity);
}

} // namespace cradle::motion
