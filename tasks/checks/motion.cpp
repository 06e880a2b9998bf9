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

/// Changes of velocity that differ by less than this share are one law's: drag, for one, changes
/// with the speed.
constexpr double alike = 0.1;

/// A step in which circle \p i meets nothing and is changed as in the step after \p k, in a run in
/// which it mostly is; see steadyFault().
std::optional<qint64> sameInTheOpen(const Observation &o, int i, qint64 k, Vec2 gravity,
                                    std::optional<Vec2> axis)
{
    const auto change = [&](qint64 step) {
        const Vec2 whole = kick(o, i, step, gravity);
        return axis ? dot(whole, *axis) * *axis : whole;
    };
    const Vec2 wanted = change(k);
    qint64 open = 0;
    qint64 changed = 0;
    std::optional<qint64> like;
    for (qint64 step = 0; step < o.steps(); ++step) {
        if (isNearWall(o, i, step, gravity) || isNearCircle(o, i, step, gravity))
            continue;
        ++open;
        const Vec2 now = change(step);
        changed += isSame(now, {}) ? 0 : 1;
        if (step != k && !like && quickLength(now - wanted) < alike * quickLength(wanted))
            like = step;
    }
    return 2 * changed > open ? like : std::nullopt;
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

std::optional<Fault> steadyFault(const Observation &o, int i, qint64 k, Vec2 gravity,
                                 std::optional<Vec2> axis)
{
    const auto like = sameInTheOpen(o, i, k, gravity, axis);
    if (!like)
        return std::nullopt;
    const Vec2 before = o.circle(i, k).velocity;
    const Vec2 after = o.circle(i, k + 1).velocity;
    const Vec2 asked = before + o.timestep() * gravity;
    const Vec2 error = after - asked;
    const bool x = axis ? axis->x != 0.0 : std::abs(error.x) > std::abs(error.y);
    const auto part = [&](Vec2 v, Vec2 other) {
        const Vec2 along = x ? Vec2{1, 0} : Vec2{0, 1};
        return axis ? figureBeside(dot(v, along), dot(other, along)) : figureBeside(v, other);
    };
    const QString text =
        axis ? MotionText::tr("At step %1 the velocity of circle %2 in %7 went from %3 to %4 m/s "
                              "where gravity alone makes it %5 m/s. It changes in the same way at "
                              "step %6, where it touches nothing: look at its motion first. Hits "
                              "are judged when that is right")
             : MotionText::tr("At step %1 the velocity of circle %2 went from %3 to %4 m/s where "
                              "gravity alone makes it %5 m/s. It changes in the same way at step "
                              "%6, where it touches nothing: look at its motion first. Hits are "
                              "judged when that is right");
    const QString said =
        text.arg(QString::number(k + 1), QString::number(i + 1), part(before, after),
                 part(after, asked), part(asked, after), QString::number(*like + 1));
    return Fault{.message = axis ? said.arg(x ? QStringLiteral("x") : QStringLiteral("y")) : said,
                 .expected = x ? asked.x : asked.y,
                 .observed = x ? after.x : after.y,
                 .unit = QStringLiteral("m/s"),
                 .step = k + 1,
                 .circle = i};
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
    if (moved <= longestLeap * way)
        return std::nullopt;
    return Fault{.message = MotionText::tr("At step %1 circle %2 moved by %3 m at once; with its "
                                           "velocity it comes %4 m far")
                                .arg(QString::number(k + 1), QString::number(i + 1), figure(moved),
                                     figure(way / 2.0)),
                 .expected = way / 2.0,
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
