// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle::kinds {

namespace {

struct BounceText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// A circle that comes to the wall slower than gravity makes it in so many steps is about to rest:
/// then a program may well keep it there.
constexpr double restingSteps = 3.0;
/// What a wall only holds falls for less than so many steps before it is stopped again.
constexpr double heldSteps = 1.5;
/// A circle that comes to a wall slower than this has been stopped by it, m/s.
constexpr double stopped = 1e-6;
/// Steps within which a circle at a wall must be turned: one may show it beyond the wall, and the
/// next answer.
constexpr int patience = 3;

/// One look at a circle that changed its velocity by more than gravity.
struct Turn {
    const Observation &o;
    int circle;
    qint64 step;
    Vec2 gravity;
    double restitution;
    double tolerance;

    [[nodiscard]] std::optional<Fault> faultAlong(Wall low, Wall high) const;
    /// Whether a wall turned or stopped it, and not only held what rests there.
    [[nodiscard]] bool isHit() const;

private:
    /// Whether the way of one step, along its normal, takes the rim to that wall.
    [[nodiscard]] bool reaches(Wall wall) const;
    [[nodiscard]] std::optional<Fault> faultAt(Wall wall) const;
    [[nodiscard]] Fault fault(const QString &text, double expected, double observed) const;
};

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
    return motion::wallGap(o, before, wall) <= way + motion::samePosition;
}

/// Judges what happened on one axis, between the walls \p low and \p high.
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
    const Wall nearest =
        motion::wallGap(o, before, low) < motion::wallGap(o, before, high) ? low : high;
    const bool hitsOther = std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
        return wall != low && wall != high && reaches(wall);
    });
    if (hitsOther || (!turned && motion::isNearWall(o, circle, step, gravity))) {
        return fault(BounceText::tr("At step %1 circle %2 hit a wall and its velocity along the "
                                    "wall changed from %3 to %4 m/s; only the part into the wall "
                                    "should change")
                         .arg(QString::number(step + 1), QString::number(circle + 1),
                              motion::figureBeside(kept, after), motion::figureBeside(after, kept)),
                     kept, after);
    }
    return fault(BounceText::tr("At step %1 circle %2 turned round although its rim was still %3 m "
                                "from the %4; it should touch first")
                     .arg(QString::number(step + 1), QString::number(circle + 1),
                          motion::figure(motion::wallGap(o, before, nearest)),
                          motion::wallName(nearest)),
                 kept, after);
}

/// Judges a bounce off \p wall: v_n' = −e v_n, with gravity's part of the step before or after it.
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
    if (std::max(into, into + pull) <= slack) {
        return fault(BounceText::tr("At step %1 circle %2 was already leaving the %3 with %4 m/s "
                                    "and was turned round again; it should be left alone")
                         .arg(QString::number(step + 1), QString::number(circle + 1),
                              motion::wallName(wall), motion::figure(-into)),
                     into, after);
    }
    const double first = -restitution * into + pull;
    const double last = -restitution * (into + pull);
    if (after >= std::min(first, last) - slack && after <= std::max(first, last) + slack)
        return std::nullopt;
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
        return into > held + stopped && -dot(kick, n) > 0.5 * into
               && motion::wallGap(o, before, wall) <= motion::travel(o, circle, step, gravity);
    });
}

/// What was too little to judge walls by.
Fault tooFewHits(const Observation &o, int seen, int wanted)
{
    return {.message = BounceText::tr("In %1 s the walls turned a circle round %2 times; at least "
                                      "%3 must be seen to judge them")
                           .arg(motion::figure(o.states.time(o.steps())), QString::number(seen),
                                QString::number(wanted)),
            .expected = wanted,
            .observed = seen,
            .step = o.steps()};
}

/// How often circle \p i came to a wall, having been away from all of them.
int visitsOf(const Observation &o, int i, Vec2 gravity)
{
    int visits = 0;
    bool wasNear = false;
    for (qint64 k = 0; k <= o.steps(); ++k) {
        const bool isNear = motion::isNearWall(o, i, k, gravity);
        visits += isNear && !wasNear ? 1 : 0;
        wasNear = isNear;
    }
    return visits;
}

/// \param more  how much further than the way of one step is allowed, m
std::optional<Fault> outside(const CheckSpec &check, const Observation &o, double more)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    for (const int i : check.circles) {
        for (qint64 k = 1; k <= o.steps(); ++k) {
            const double allowed = motion::travel(o, i, k - 1, gravity) + more;
            for (const Wall wall : allWalls) {
                const double beyond = -motion::wallGap(o, o.circle(i, k), wall);
                if (beyond <= allowed)
                    continue;
                return Fault{.message = BounceText::tr("At step %1 the rim of circle %2 is %3 m "
                                                       "beyond the %4; at most the way of one "
                                                       "step, %5 m, is right")
                                            .arg(QString::number(k), QString::number(i + 1),
                                                 motion::figureBeside(beyond, allowed),
                                                 motion::wallName(wall),
                                                 motion::figureBeside(allowed, beyond)),
                             .expected = allowed,
                             .observed = beyond,
                             .unit = QStringLiteral("m"),
                             .step = k,
                             .circle = i};
            }
        }
    }
    return std::nullopt;
}

/// A circle that is held at a wall into which it still moves.
std::optional<Fault> stuck(const Observation &o, int i, Vec2 gravity)
{
    for (const Wall wall : allWalls) {
        const Vec2 n = outwardNormal(wall);
        int held = 0;
        for (qint64 k = 0; k < o.steps(); ++k) {
            const Circle &c = o.circle(i, k);
            const double into = dot(c.velocity, n);
            const double resting = restingSteps * quickLength(gravity) * o.timestep();
            const bool passes = motion::wallGap(o, c, wall) < into * o.timestep();
            held = passes && into > resting + stopped && !motion::isKicked(o, i, k, gravity)
                       ? held + 1
                       : 0;
            if (held < patience)
                continue;
            return Fault{.message = BounceText::tr("At step %1 circle %2 is still moving into the "
                                                   "%3 with %4 m/s, since step %5; the wall should "
                                                   "turn it round at once")
                                        .arg(QString::number(k + 1), QString::number(i + 1),
                                             motion::wallName(wall), motion::figure(into),
                                             QString::number(k + 2 - patience)),
                         .expected = -into,
                         .observed = into,
                         .unit = QStringLiteral("m/s"),
                         .step = k + 2 - patience,
                         .circle = i};
        }
    }
    return std::nullopt;
}

/// A circle that goes on somewhere else, such as at the opposite wall.
std::optional<Fault> leap(const Observation &o, int i, bool collisions, Vec2 gravity)
{
    for (qint64 k = 0; k < o.steps(); ++k) {
        if (collisions && motion::isNearCircle(o, i, k, gravity))
            continue;
        if (auto fault = motion::leap(o, i, k, motion::recentTravel(o, i, k, gravity)))
            return fault;
    }
    return std::nullopt;
}

} // namespace

std::optional<Fault> staysInside(const CheckSpec &check, const Observation &o)
{
    if (auto fault = outside(check, o, motion::toleranceOf(check)))
        return fault;
    const Vec2 gravity = motion::gravityOf(check, o);
    const int wanted = valueOf(check, QStringLiteral("visits")).toInt();
    for (const int i : check.circles) {
        const int seen = visitsOf(o, i, gravity);
        if (seen >= wanted)
            continue;
        return Fault{.message =
                         BounceText::tr("In %1 s circle %2 came to a wall %3 times; at least "
                                        "%4 must be seen to judge whether it stays inside")
                             .arg(motion::figure(o.states.time(o.steps())), QString::number(i + 1),
                                  QString::number(seen), QString::number(wanted)),
                     .expected = wanted,
                     .observed = seen,
                     .step = o.steps(),
                     .circle = i};
    }
    return std::nullopt;
}

std::optional<Fault> bounces(const CheckSpec &check, const Observation &o)
{
    if (auto fault = outside(check, o, 0.0))
        return fault;
    const double tolerance = motion::toleranceOf(check);
    const Vec2 gravity = motion::gravityOf(check, o);
    const bool collisions = valueOf(check, QStringLiteral("collisions")).toBool();
    const double restitution = motion::restitutionOf(check, o);
    int hits = 0;
    for (const int i : check.circles) {
        if (auto fault = stuck(o, i, gravity))
            return fault;
        if (auto fault = leap(o, i, collisions, gravity))
            return fault;
        for (qint64 k = 0; k < o.steps(); ++k) {
            if (!motion::isKicked(o, i, k, gravity, tolerance)
                || (collisions && motion::isNearCircle(o, i, k, gravity)))
                continue;
            const Turn turn{o, i, k, gravity, restitution, tolerance};
            if (auto fault = turn.faultAlong(Wall::Left, Wall::Right))
                return fault;
            if (auto fault = turn.faultAlong(Wall::Bottom, Wall::Top))
                return fault;
            hits += turn.isHit() ? 1 : 0;
        }
    }
    const int wanted = valueOf(check, QStringLiteral("hits")).toInt();
    return hits < wanted ? std::optional(tooFewHits(o, hits, wanted)) : std::nullopt;
}

} // namespace cradle::kinds
