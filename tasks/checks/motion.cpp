// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/motion.h"

#include "tasks/checks/check_kinds.h"

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

/// Least distance of two centres while both go straight for \p seconds from their state. Gravity
/// acts on both alike and takes no part.
double nearestCentres(const Circle &a, const Circle &b, double seconds)
{
    const Vec2 d = b.position - a.position;
    const Vec2 v = b.velocity - a.velocity;
    const double speed2 = lengthSquared(v);
    const double s = speed2 > 0.0 ? std::clamp(-dot(d, v) / speed2, 0.0, seconds) : 0.0;
    return quickLength(d + s * v);
}

constexpr int enoughDigits = 4;
constexpr int mostDigits = 16; ///< where two numbers differ by no more than the last bits

QString figureOf(double value, int digits)
{
    // The rounding noise of a sum that should be zero is not worth a reader's time.
    const double size = std::abs(value);
    if (size < 1e-12)
        return QStringLiteral("0");
    // None that a circle's energy may have is written with an exponent.
    if (size >= 1e3 && size < 1e6 && size >= std::pow(10.0, digits - 1))
        return QString::number(value, 'f', 0);
    return QString::number(value, 'g', digits);
}

/// With how many digits the two are not written alike; nothing if only noise of rounding is between
/// them.
std::optional<int> digitsThatTell(double value, double other)
{
    if (std::abs(value - other) <= 1e-9 * (1.0 + std::abs(other)))
        return std::nullopt;
    for (int digits = enoughDigits; digits < mostDigits; ++digits) {
        if (figureOf(value, digits) != figureOf(other, digits))
            return digits;
    }
    return std::nullopt;
}

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
    const bool x = std::abs(after.x - asked.x) > std::abs(after.y - asked.y);
    return Fault{.message =
                     MotionText::tr("At step %1 the velocity of circle %2 went from %3 to %4 m/s "
                                    "where gravity alone makes it %5 m/s. It changes in the same "
                                    "way at step %6, where it touches nothing: look at its motion "
                                    "first. Hits are judged when that is right")
                         .arg(QString::number(k + 1), QString::number(i + 1), figure(before),
                              figureBeside(after, asked), figureBeside(asked, after),
                              QString::number(*like + 1)),
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

namespace {

/// Whether all that circle \p i gets in the step after \p k may be the push of a wall it is at.
bool isOfWall(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const Vec2 push = kick(o, i, k, gravity);
    return std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
        const Vec2 n = outwardNormal(wall);
        return wallGap(o, o.circle(i, k), wall) <= travel(o, i, k, gravity) && dot(push, n) < 0.0
               && dot(o.circle(i, k).velocity, n) > 0.0
               && std::abs(cross(push, n)) <= sameVelocity * (1.0 + quickLength(push));
    });
}

} // namespace

std::vector<Contact> contactsOf(const Observation &o, int a, int b, Vec2 gravity)
{
    std::vector<Contact> contacts;
    for (qint64 k = 0; k < o.steps(); ++k) {
        const bool kickedA = isKicked(o, a, k, gravity);
        const bool kickedB = isKicked(o, b, k, gravity);
        if (!kickedA && !kickedB)
            continue;
        const Circle &ca = o.circle(a, k);
        const Circle &cb = o.circle(b, k);
        const double dt = o.timestep();
        const double sum = ca.radius + cb.radius;
        Contact contact{.step = k};
        const Vec2 movedA = ca.position + dt * ca.velocity;
        const Vec2 movedB = cb.position + dt * cb.velocity;
        contact.nearest = std::min({nearestCentres(ca, cb, dt), quickLength(cb.position - movedA),
                                    quickLength(movedB - ca.position)})
                          - sum;
        // What happens at a wall, far from the other circle, is not theirs.
        const bool wall = (!kickedA || isNearWall(o, a, k, gravity))
                          && (!kickedB || isNearWall(o, b, k, gravity));
        if (wall && contact.nearest > travel(o, a, k, gravity) + travel(o, b, k, gravity))
            continue;
        // Nor is what they get along the normals of walls that they are at.
        if ((!kickedA || isOfWall(o, a, k, gravity)) && (!kickedB || isOfWall(o, b, k, gravity)))
            continue;
        contact.beforeA = ca.velocity;
        contact.beforeB = cb.velocity;
        contact.afterA = o.circle(a, k + 1).velocity - dt * gravity;
        contact.afterB = o.circle(b, k + 1).velocity - dt * gravity;
        // A program that sees the hit late may still use the step before.
        const qint64 early = std::max<qint64>(0, k - 1);
        const Circle &ea = o.circle(a, early);
        const Circle &eb = o.circle(b, early);
        contact.normalFirst = normalized(eb.position - ea.position);
        contact.normalLast = normalized(movedB - movedA);
        contact.normalA = normalized(cb.position - movedA);
        contact.normalB = normalized(movedB - ca.position);
        contacts.push_back(contact);
    }
    return contacts;
}

qint64 missedContact(const Observation &o, int a, int b)
{
    int inside = 0;
    for (qint64 k = 0; k <= o.steps(); ++k) {
        const Circle &ca = o.circle(a, k);
        const Circle &cb = o.circle(b, k);
        const Vec2 d = cb.position - ca.position;
        const double sum = ca.radius + cb.radius;
        // Two that stay in touch (e = 0) come nearer by rounding only.
        const double noise =
            sameVelocity * (1.0 + quickLength(ca.velocity) + quickLength(cb.velocity));
        const bool nearer = dot(normalized(d), ca.velocity - cb.velocity) > noise;
        const bool in = quickLength(d) < sum * (1.0 - 1e-9);
        inside = in && nearer ? inside + 1 : 0;
        // One state may show the overlap that the next step answers.
        if (inside > 2)
            return k - 2;
    }
    return -1;
}

bool leavesInside(const Observation &o, int a, int b, Vec2 gravity)
{
    const std::vector<Contact> contacts = contactsOf(o, a, b, gravity);
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        const Circle &ca = o.circle(a, contact.step + 1);
        const Circle &cb = o.circle(b, contact.step + 1);
        const Vec2 d = cb.position - ca.position;
        const double sum = ca.radius + cb.radius;
        const double parting = dot(normalized(d), cb.velocity - ca.velocity);
        return quickLength(d) < sum * (1.0 - samePosition)
               && parting
                      > sameVelocity * (1.0 + quickLength(ca.velocity) + quickLength(cb.velocity));
    });
}

QString wallName(Wall wall)
{
    switch (wall) {
    case Wall::Left:
        return MotionText::tr("left wall");
    case Wall::Right:
        return MotionText::tr("right wall");
    case Wall::Bottom:
        return MotionText::tr("floor");
    case Wall::Top:
        break;
    }
    return MotionText::tr("ceiling");
}

QString integratorName(Integrator integrator)
{
    switch (integrator) {
    case Integrator::Euler:
        return MotionText::tr("Euler");
    case Integrator::SymplecticEuler:
        return MotionText::tr("symplectic Euler");
    case Integrator::Verlet:
        return MotionText::tr("velocity Verlet");
    case Integrator::RungeKutta4:
        break;
    }
    return MotionText::tr("Runge-Kutta 4");
}

QString figure(double value)
{
    return figureOf(value, enoughDigits);
}

QString figure(Vec2 value)
{
    return QStringLiteral("(%1, %2)").arg(figure(value.x), figure(value.y));
}

QString figureBeside(double value, double other)
{
    return figureOf(value, digitsThatTell(value, other).value_or(enoughDigits));
}

QString figureBeside(Vec2 value, Vec2 other)
{
    // As soon as one of them tells, the other has no need to.
    const int digits = std::min(digitsThatTell(value.x, other.x).value_or(mostDigits),
                                digitsThatTell(value.y, other.y).value_or(mostDigits));
    const int used = digits < mostDigits ? digits : enoughDigits;
    return QStringLiteral("(%1, %2)").arg(figureOf(value.x, used), figureOf(value.y, used));
}

QString circleName(int index)
{
    return MotionText::tr("circle %1").arg(index + 1);
}

} // namespace cradle::motion
