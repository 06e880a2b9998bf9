// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/wall_turn.h"

#include "tasks/checks/figures.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle::kinds {

namespace {

struct BounceText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// What a wall only holds falls for less than so many steps before it is stopped again.
constexpr double heldSteps = 1.5;
/// Relative: what is turned round keeps its part along the wall, and gets no faster.
constexpr double turnedTolerance = 1e-6;

QString beforeTouching(const Observation &o, int circle, qint64 step, Wall ahead)
{
    return BounceText::tr("At step %1 circle %2 turned round although its rim was still %3 m "
                          "from the %4; it should touch first")
        .arg(QString::number(step + 1), QString::number(circle + 1),
             motion::figure(motion::wallGap(o, o.circle(circle, step), ahead)),
             motion::wallName(ahead));
}

} // namespace

Fault Turn::fault(const QString &text, double expected, double observed) const
{
    return {.message = text,
            .expected = expected,
            .observed = observed,
            .unit = QStringLiteral("m/s"),
            .step = step + 1,
            .circle = circle};
}

bool Turn::reaches(Wall wall) const
{
    const Circle &before = o.circle(circle, step);
    const Vec2 n = outwardNormal(wall);
    const double dt = o.timestep();
    const double way = (std::abs(dot(before.velocity, n)) + std::abs(dot(gravity, n)) * dt) * dt;
    return motion::wallGap(o, before, wall) <= way + motion::samePosition
           || motion::wallGap(o, o.circle(circle, step + 1), wall) <= motion::samePosition;
}

std::optional<Fault> Turn::faultAlong(Wall low, Wall high) const
{
    const Vec2 axis = outwardNormal(high);
    const Circle &before = o.circle(circle, step);
    const double change = dot(motion::kick(o, circle, step, gravity), axis);
    if (std::abs(change) <= tolerance * (1.0 + quickLength(before.velocity)))
        return std::nullopt;
    for (const Wall wall : {low, high}) {
        if (reaches(wall))
            return faultAt(wall);
    }
    const double kept = dot(before.velocity + o.timestep() * gravity, axis);
    const double after = kept + change;
    // In the open only a turn is a matter of walls; another acceleration is not.
    const bool turned =
        kept * after < 0.0 && std::abs(change) > restingSteps * quickLength(gravity) * o.timestep();
    if (!turned && !motion::isNearWall(o, circle, step, gravity))
        return std::nullopt;
    const Wall ahead = kept < 0.0 ? low : high;
    const bool hitsOther = std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
        return wall != low && wall != high && reaches(wall);
    });
    if (auto steady = motion::steadyFault(o, circle, gravity, axis))
        return steady;
    if (hitsOther || (!turned && motion::isNearWall(o, circle, step, gravity)))
        return alongWall(axis, change);
    if (!isMirrored(axis, kept, after) || isOfAnother())
        return motion::changedInOpen(o, circle, step, gravity);
    return fault(beforeTouching(o, circle, step, ahead), kept, after);
}

bool Turn::isMirrored(Vec2 axis, double kept, double after) const
{
    const double pull = dot(gravity, axis) * o.timestep();
    const double slack = turnedTolerance * (1.0 + quickLength(o.circle(circle, step).velocity));
    const auto isTurned = [&](double share) {
        // Gravity of this step may act before the turn or after it.
        const double first = pull - share * (kept - pull);
        const double last = -share * kept;
        return after >= std::min(first, last) - slack && after <= std::max(first, last) + slack;
    };
    return isTurned(1.0) || isTurned(restitution);
}

bool Turn::isOfAnother() const
{
    for (int j = 0; j < o.circleCount(); ++j) {
        const double change = quickLength(motion::kick(o, j, step, gravity));
        if (j != circle && change > tolerance * (1.0 + quickLength(o.circle(j, step).velocity)))
            return true;
    }
    return false;
}

std::optional<Fault> turnBeforeWall(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const Vec2 kept = o.circle(i, k).velocity + o.timestep() * gravity;
    const Vec2 after = o.circle(i, k + 1).velocity;
    double widest = 0.0;
    for (int j = 0; j < o.circleCount(); ++j)
        widest = std::max(widest, 2.0 * o.circle(j, k).radius);
    for (const Wall wall : allWalls) {
        const Vec2 n = outwardNormal(wall);
        const double speed = dot(kept, n);
        const double back = -dot(after, n);
        const double slack = turnedTolerance * quickLength(kept);
        const bool isTurned = quickLength(after - (kept - (speed + back) * n)) <= slack
                              && back > slack && back <= speed + slack;
        if (isTurned && motion::wallGap(o, o.circle(i, k), wall) <= widest)
            return Fault{.message = beforeTouching(o, i, k, wall),
                         .expected = speed,
                         .observed = -back,
                         .unit = QStringLiteral("m/s"),
                         .step = k + 1,
                         .circle = i};
    }
    return std::nullopt;
}

Fault Turn::alongWall(Vec2 axis, double change) const
{
    const double before = dot(o.circle(circle, step).velocity, axis);
    const double kept = before + dot(o.timestep() * gravity, axis);
    const double after = kept + change;
    const QString text =
        kept == before
            ? BounceText::tr("At step %1 circle %2 hit a wall and its velocity along the wall "
                             "changed from %3 to %4 m/s; only the part into the wall should change")
            : BounceText::tr("At step %1, at a wall, circle %2 had %3 m/s along the wall before "
                             "the step and %4 m/s after it; with gravity alone it is %5 m/s");
    const QString said =
        text.arg(QString::number(step + 1), QString::number(circle + 1),
                 motion::figureBeside(before, after), motion::figureBeside(after, kept));
    return fault(kept == before ? said : said.arg(motion::figureBeside(kept, after)), kept, after);
}

std::optional<Fault> Turn::faultAt(Wall wall) const
{
    const Vec2 n = outwardNormal(wall);
    const double dt = o.timestep();
    const double into = dot(o.circle(circle, step).velocity, n);
    const double after = dot(o.circle(circle, step + 1).velocity, n);
    const double pull = dot(gravity, n) * dt;
    const double slack = tolerance * (1.0 + quickLength(o.circle(circle, step).velocity));
    const double resting = restingSteps * std::abs(pull) + slack;
    if (into >= -resting && into + std::max(pull, 0.0) <= resting
        && std::abs(after) <= std::abs(into) + std::abs(pull) + slack)
        return std::nullopt;
    const bool isLeaving = std::max(into, into + pull) <= slack;
    const double first = -restitution * into + pull;
    const double last = -restitution * (into + pull);
    if (!isLeaving && after >= std::min(first, last) - slack
        && after <= std::max(first, last) + slack)
        return std::nullopt;
    if (auto steady = motion::steadyFault(o, circle, gravity, n))
        return steady;
    return isLeaving ? againAt(wall) : wrongAt(wall, first, last);
}

Fault Turn::againAt(Wall wall) const
{
    const Vec2 n = outwardNormal(wall);
    const double into = dot(o.circle(circle, step).velocity, n);
    const double after = dot(o.circle(circle, step + 1).velocity, n);
    if (after > 0.0)
        return fault(BounceText::tr("At step %1 circle %2 was already leaving the %3 with %4 m/s "
                                    "and was turned round again; it should be left alone")
                         .arg(QString::number(step + 1), QString::number(circle + 1),
                              motion::wallName(wall), motion::figure(-into)),
                     into, after);
    const double asked = into + dot(gravity, n) * o.timestep();
    return fault(BounceText::tr("At step %1 circle %2 was leaving the %3, with %4 m/s before the "
                                "step and %5 m/s after it; with gravity alone it is %6 m/s")
                     .arg(QString::number(step + 1), QString::number(circle + 1),
                          motion::wallName(wall), motion::figure(-into),
                          motion::figureBeside(-after, -asked),
                          motion::figureBeside(-asked, -after)),
                 asked, after);
}

Fault Turn::wrongAt(Wall wall, double first, double last) const
{
    const Vec2 n = outwardNormal(wall);
    const double into = dot(o.circle(circle, step).velocity, n);
    const double after = dot(o.circle(circle, step + 1).velocity, n);
    const double pull = dot(gravity, n) * o.timestep();
    const double slack = tolerance * (1.0 + quickLength(o.circle(circle, step).velocity));
    const QString place = QString::number(step + 1);
    const QString who = QString::number(circle + 1);
    if (std::abs(pull) <= slack && restitution == 1.0)
        return fault(BounceText::tr("At step %1 circle %2 came to the %3 with %4 m/s and left it "
                                    "with %5 m/s; %6 m/s is right")
                         .arg(place, who, motion::wallName(wall), motion::figure(into),
                              motion::figureBeside(after, last), motion::figureBeside(last, after)),
                     last, after);
    if (std::abs(pull) <= slack)
        return fault(BounceText::tr("At step %1 circle %2 came to the %3 with %4 m/s and left it "
                                    "with %5 m/s; −e times %4 m/s with e = %6 is %7 m/s")
                         .arg(place, who, motion::wallName(wall), motion::figure(into),
                              motion::figureBeside(after, last), motion::figure(restitution),
                              motion::figureBeside(last, after)),
                     last, after);
    // Gravity of this step may act before the hit or after it.
    return fault(
        BounceText::tr("At step %1 the velocity of circle %2 into the %3 was %4 m/s before "
                       "the step and %5 m/s after it; with e = %6 and gravity, %7 to %8 "
                       "m/s is right")
            .arg(place, who, motion::wallName(wall), motion::figure(into),
                 motion::figureBeside(after, last), motion::figure(restitution),
                 motion::figureBeside(std::min(first, last), after),
                 motion::figureBeside(std::max(first, last), after)),
        last, after);
}

bool Turn::isHit() const
{
    const Circle &before = o.circle(circle, step);
    const Vec2 kick = motion::kick(o, circle, step, gravity);
    return std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
        const Vec2 n = outwardNormal(wall);
        // Nothing falls onto a wall along which gravity pulls.
        const double held = heldSteps * std::abs(dot(gravity, n)) * o.timestep();
        const double into = dot(before.velocity, n);
        return into > held + stopped && -dot(kick, n) > 0.5 * into && reaches(wall);
    });
}

HitPlace Turn::placeAt(Wall wall) const
{
    const Circle &before = o.circle(circle, step);
    const Circle &after = o.circle(circle, step + 1);
    const double dt = o.timestep();
    const Vec2 inward = -1.0 * outwardNormal(wall);
    const double gap = motion::wallGap(o, before, wall);
    const double reached = gap + dt * dot(before.velocity, inward);
    return {.apart = inward,
            .overlap = std::max(0.0, -std::min(gap, reached)),
            .isLate = gap < 0.0,
            .free = dt * before.velocity,
            .bounced = dt * after.velocity,
            .made = after.position - before.position};
}

std::optional<Fault> Turn::misplaced() const
{
    if (!isHit())
        return std::nullopt;
    const double dt = o.timestep();
    const double slack = motion::samePosition + 2.0 * quickLength(gravity) * dt * dt;
    const auto walls = std::count_if(std::begin(allWalls), std::end(allWalls),
                                     [&](Wall wall) { return reaches(wall); });
    for (const Wall wall : allWalls) {
        const double pushed = -dot(motion::kick(o, circle, step, gravity), outwardNormal(wall));
        if (!reaches(wall) || pushed <= stopped)
            continue;
        const auto found = misplacementOf(placeAt(wall), slack);
        // In a corner the other wall may move it along this one.
        if (!found || (found->where == Misplacement::Where::Aside && walls > 1))
            continue;
        // Who goes another way in the open, too, is told that by checks of the motion.
        if (motion::steadyFault(o, circle, gravity))
            return std::nullopt;
        return misplacedAt(wall, *found);
    }
    return std::nullopt;
}

Fault Turn::misplacedAt(Wall wall, const Misplacement &found) const
{
    using Where = Misplacement::Where;
    const QString text =
        found.where == Where::Away
            ? BounceText::tr("At step %1 circle %2 was put %4 m further in from the %3 than its "
                             "velocities and twice the way of its rim beyond the wall explain; it "
                             "is enough that its rim is at the wall")
        : found.where == Where::Into
            ? BounceText::tr("At step %1 circle %2 was put %4 m further out at the %3 than its "
                             "velocity takes it; it belongs where its rim is at the wall, or back")
            : BounceText::tr("At step %1 circle %2 was put %4 m along the %3 beside the ways that "
                             "its velocities before and after it take it; a wall should move it "
                             "inward only, or back");
    Fault said = fault(text.arg(QString::number(step + 1), QString::number(circle + 1),
                                motion::wallName(wall), motion::figure(found.by)),
                       0.0, found.by);
    said.unit = QStringLiteral("m");
    return said;
}

} // namespace cradle::kinds
