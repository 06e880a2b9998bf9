// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/standstill.h"

#include "tasks/checks/figures.h"
#include "tasks/checks/motion.h"
#include "tasks/checks/wall_turn.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle::motion {

namespace {

struct StandstillText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// Steps in which a circle may stand still behind a hit.
constexpr int patience = 2;
/// Of the way that its velocity takes a circle. Gravity makes it a third shorter at most, for what
/// it pulls back at once does not count.
constexpr double leastWay = 0.6;

/// Whether nothing near is in the way of circle \p i in the step after \p k: it moves away from
/// each.
bool isLeaving(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const Circle &c = o.circle(i, k);
    // What gravity pulls back at once may be held.
    const double slack = kinds::stopped + kinds::restingSteps * quickLength(gravity) * o.timestep();
    const double way = travel(o, i, k, gravity);
    const bool walls = std::all_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
        return wallGap(o, c, wall) > way || dot(c.velocity, outwardNormal(wall)) < -slack;
    });
    if (!walls || quickLength(c.velocity) <= slack)
        return false;
    for (int j = 0; j < o.circleCount(); ++j) {
        const Circle &other = o.circle(j, k);
        const Vec2 d = other.position - c.position;
        const bool isNear =
            quickLength(d) - c.radius - other.radius <= way + travel(o, j, k, gravity);
        const double apart = dot(normalized(d), other.velocity - c.velocity);
        if (j != i && isNear && apart <= slack)
            return false;
    }
    return true;
}

bool fallsShort(const Observation &o, int i, qint64 k)
{
    const Circle &c = o.circle(i, k);
    const Vec2 made = o.circle(i, k + 1).position - c.position;
    return dot(made, c.velocity) < leastWay * o.timestep() * lengthSquared(c.velocity);
}

} // namespace

std::optional<Fault> standstillAfter(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const qint64 last = k + 1 + patience;
    if (last >= o.steps())
        return std::nullopt;
    double way = 0.0; // that its velocities take it, m
    for (qint64 step = k + 1; step <= last; ++step) {
        way += o.timestep() * quickLength(o.circle(i, step).velocity);
        // Who stands still may also keep gravity out.
        const bool isHit = isKicked(o, i, step, gravity) && isKicked(o, i, step, {});
        if (isHit || !fallsShort(o, i, step) || !isLeaving(o, i, step, gravity))
            return std::nullopt;
    }
    // Who goes another way in the open, too, is told that by checks of the motion.
    if (steadyFault(o, i, gravity))
        return std::nullopt;
    const double made = quickLength(o.circle(i, last + 1).position - o.circle(i, k + 1).position);
    return Fault{
        .message = StandstillText::tr("After a hit at step %1 circle %2 has a velocity of %3 m/s, "
                                      "away from what it hit. From there to step %4 it moved by "
                                      "%5 m; with its velocity it comes %6 m far")
                       .arg(QString::number(k + 1), QString::number(i + 1),
                            figure(o.circle(i, k + 1).velocity), QString::number(last + 1),
                            figureBeside(made, way), figureBeside(way, made)),
        .expected = way,
        .observed = made,
        .unit = QStringLiteral("m"),
        .step = k + 2,
        .circle = i};
}

} // namespace cradle::motion
