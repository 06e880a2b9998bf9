// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/figures.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"
#include "tasks/checks/standstill.h"
#include "tasks/checks/wall_turn.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle::kinds {

namespace {

struct WallHitText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// Steps within which a circle at a wall must be turned: one may show it beyond the wall, and the
/// next answer.
constexpr int patience = 3;

/// The first step from which on no circle goes anywhere.
qint64 restingFrom(const Observation &o)
{
    qint64 from = o.steps();
    const auto rest = [&] {
        for (int i = 0; i < o.circleCount(); ++i) {
            if (!(o.circle(i, from - 1).position == o.circle(i, from).position))
                return false;
        }
        return true;
    };
    while (from > 0 && rest())
        --from;
    return from;
}

/// What was too little to judge walls by.
/// \param apart  turns near another circle do not count
Fault tooFewHits(const Observation &o, int seen, int wanted, bool apart)
{
    const QString text =
        apart
            ? WallHitText::tr("Turns at walls, away from the other circle, in %1 s: %2; at least "
                              "%3 must be seen to judge them")
            : WallHitText::tr("Turns at walls in %1 s: %2; at least %3 must be seen to judge them");
    QString said = text.arg(motion::figure(o.states.time(o.steps())), QString::number(seen),
                            QString::number(wanted));
    const qint64 rest = restingFrom(o);
    if (rest == 0)
        said += WallHitText::tr(". Nothing moved");
    else if (rest + 1 < o.steps()) // a wall may put them back in the last step alone
        said += WallHitText::tr(". From %1 s on nothing moved")
                    .arg(motion::figure(o.states.time(rest)));
    return {.message = said, .expected = wanted, .observed = seen, .step = o.steps()};
}

/// That the rim of circle \p i is further beyond \p wall than \p allowed, m.
Fault beyondWall(int i, qint64 step, Wall wall, double beyond, double allowed)
{
    // Less is only rounding.
    constexpr double noWay = 1e-6;
    const QString text =
        allowed < noWay
            ? WallHitText::tr("At step %1 the rim of circle %2 is %3 m beyond the %4, where it was "
                              "without any speed; it should not be beyond it")
            : WallHitText::tr("At step %1 the rim of circle %2 is %3 m beyond the %4; at most the "
                              "way of one step, %5 m, is right");
    const QString said = text.arg(QString::number(step), QString::number(i + 1),
                                  motion::figureBeside(beyond, allowed), motion::wallName(wall));
    return {.message = allowed < noWay ? said : said.arg(motion::figureBeside(allowed, beyond)),
            .expected = allowed,
            .observed = beyond,
            .unit = QStringLiteral("m"),
            .step = step,
            .circle = i};
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
                return beyondWall(i, k, wall, beyond, allowed);
            }
        }
    }
    return std::nullopt;
}

/// A circle that is held at a wall into which it still moves.
/// \param collisions  whether another circle may push it back to the wall
std::optional<Fault> stuck(const Observation &o, int i, bool collisions, Vec2 gravity,
                           double restitution)
{
    for (const Wall wall : allWalls) {
        const Vec2 n = outwardNormal(wall);
        int held = 0;
        for (qint64 k = 0; k < o.steps(); ++k) {
            const Circle &c = o.circle(i, k);
            const double into = dot(c.velocity, n);
            const double resting = restingSteps * quickLength(gravity) * o.timestep();
            const bool passes = motion::wallGap(o, c, wall) < into * o.timestep();
            const bool isPushed = collisions && motion::isNearCircle(o, i, k, gravity);
            held = passes && into > resting + stopped && !isPushed
                           && !motion::isKicked(o, i, k, gravity)
                       ? held + 1
                       : 0;
            if (held < patience)
                continue;
            const QString text =
                restitution == 1.0
                    ? WallHitText::tr(
                        "At step %1 circle %2 still has %4 m/s into the %3, as it has "
                        "since step %5; the wall should turn it round at once")
                    : WallHitText::tr(
                        "At step %1 circle %2 still has %4 m/s into the %3, as it has "
                        "since step %5; with e = %6 the wall should answer at once");
            const QString said =
                text.arg(QString::number(k + 1), QString::number(i + 1), motion::wallName(wall),
                         motion::figure(into), QString::number(k + 2 - patience));
            return Fault{.message =
                             restitution == 1.0 ? said : said.arg(motion::figure(restitution)),
                         .expected = -into,
                         .observed = into,
                         .unit = QStringLiteral("m/s"),
                         .step = k + 2 - patience,
                         .circle = i};
        }
    }
    return std::nullopt;
}

/// Whether circle \p i and another change their velocities in the step after \p k, both far from
/// all walls, and not in most steps: then they answer each other, if too early, and no wall.
bool isAnswerInTheOpen(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const auto changesInTheOpen = [&](int j) {
        return motion::isKicked(o, j, k, gravity) && !motion::isNearWall(o, j, k, gravity);
    };
    for (int j = 0; j < o.circleCount(); ++j) {
        if (j != i && changesInTheOpen(i) && changesInTheOpen(j))
            return !motion::steadyFault(o, i, gravity);
    }
    return false;
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
                         WallHitText::tr("In %1 s circle %2 came to a wall %3 times; at least "
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
    // Where they are thrown at each other, checks of hits tell what comes too early.
    const bool meet =
        collisions && check.scene.value(QStringLiteral("kind")) == QLatin1String("encounters");
    int hits = 0;
    for (const int i : check.circles) {
        if (auto fault = stuck(o, i, collisions, gravity, restitution))
            return fault;
        if (auto fault = leap(o, i, collisions, gravity))
            return fault;
        for (qint64 k = 0; k < o.steps(); ++k) {
            if (!motion::isKicked(o, i, k, gravity, tolerance)
                || (collisions && motion::isNearCircle(o, i, k, gravity)))
                continue;
            if (meet && isAnswerInTheOpen(o, i, k, gravity))
                continue;
            const Turn turn{o, i, k, gravity, restitution, tolerance};
            if (auto fault = turn.faultAlong(Wall::Left, Wall::Right))
                return fault;
            if (auto fault = turn.faultAlong(Wall::Bottom, Wall::Top))
                return fault;
            if (auto fault = turn.misplaced())
                return fault;
            if (auto fault = motion::standstillAfter(o, i, k, gravity))
                return fault;
            hits += turn.isHit() ? 1 : 0;
        }
    }
    const int wanted = valueOf(check, QStringLiteral("hits")).toInt();
    return hits < wanted ? std::optional(tooFewHits(o, hits, wanted, collisions)) : std::nullopt;
}

} // namespace cradle::kinds
