// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>
#include <QJsonArray>

namespace cradle::kinds {

namespace {

struct StartText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

Fault wrongValue(const QString &what, const QString &observed, const QString &expected,
                 const QString &unit)
{
    return {.message = StartText::tr("%1 is %2 %4 at the start; %3 %4 is asked for")
                           .arg(what, observed, expected, unit)
                           .trimmed(),
            .unit = unit,
            .step = 0};
}

std::optional<Fault> wrongNumber(const QString &what, double observed, const QJsonValue &value,
                                 const QString &unit, double tolerance)
{
    const double expected = value.toDouble();
    if (!value.isDouble()
        || std::abs(observed - expected) <= tolerance * (1.0 + std::abs(expected)))
        return std::nullopt;
    Fault fault = wrongValue(what, motion::figureBeside(observed, expected),
                             motion::figureBeside(expected, observed), unit);
    fault.observed = observed;
    fault.expected = expected;
    return fault;
}

std::optional<Fault> wrongVector(const QString &what, Vec2 observed, const QJsonValue &value,
                                 const QString &unit, double tolerance)
{
    const QJsonArray list = value.toArray();
    const Vec2 expected{list.at(0).toDouble(), list.at(1).toDouble()};
    if (list.size() != 2 || length(observed - expected) <= tolerance)
        return std::nullopt;
    Fault fault = wrongValue(what, motion::figureBeside(observed, expected),
                             motion::figureBeside(expected, observed), unit);
    const bool x = observed.x != expected.x;
    fault.observed = x ? observed.x : observed.y;
    fault.expected = x ? expected.x : expected.y;
    return fault;
}

/// How far circle \p i came in the whole run, m.
double wayOf(const Observation &o, int i)
{
    double way = 0.0;
    for (qint64 k = 0; k < o.steps(); ++k)
        way += length(o.circle(i, k + 1).position - o.circle(i, k).position);
    return way;
}

} // namespace

std::optional<Fault> start(const CheckSpec &check, const Observation &o)
{
    const auto wanted = [&](const char *key) { return check.parameters.value(QLatin1String(key)); };
    const double tolerance = motion::toleranceOf(check);
    for (const int i : check.circles) {
        const Circle &c = o.circle(i, 0);
        const QString number = QString::number(i + 1);
        if (auto f = wrongVector(StartText::tr("The position of circle %1").arg(number), c.position,
                                 wanted("position"), QStringLiteral("m"), tolerance))
            return f;
        if (auto f = wrongVector(StartText::tr("The velocity of circle %1").arg(number), c.velocity,
                                 wanted("velocity"), QStringLiteral("m/s"), tolerance))
            return f;
        if (auto f = wrongNumber(StartText::tr("The radius of circle %1").arg(number), c.radius,
                                 wanted("radius"), QStringLiteral("m"), tolerance))
            return f;
        if (auto f = wrongNumber(StartText::tr("The density of circle %1").arg(number), c.density,
                                 wanted("density"), QStringLiteral("· 1000 kg/m³"), tolerance))
            return f;
    }
    const QJsonValue count = wanted("count");
    if (count.isDouble() && o.circleCount() != count.toInt()) {
        return Fault{.message = StartText::tr("There are %1 circles; %2 are asked for")
                                    .arg(o.circleCount())
                                    .arg(count.toInt()),
                     .expected = count.toInt(),
                     .observed = o.circleCount(),
                     .step = 0};
    }
    return std::nullopt;
}

std::optional<Fault> together(const CheckSpec &check, const Observation &o)
{
    const int a = check.circles.front();
    const int b = check.circles.back();
    const double tolerance = motion::toleranceOf(check);
    for (qint64 k = 0; k <= o.steps(); ++k) {
        const Circle &ca = o.circle(a, k);
        const Circle &cb = o.circle(b, k);
        const double apart = length(cb.position - ca.position);
        if (apart > tolerance || !motion::isSame(ca.velocity, cb.velocity, tolerance)) {
            return Fault{.message =
                             StartText::tr("At step %1 circle %2 is at %3 m with %4 m/s and circle "
                                           "%5 at %6 m with %7 m/s; they should be in the same "
                                           "place with the same velocity")
                                 .arg(QString::number(k), QString::number(a + 1),
                                      motion::figureBeside(ca.position, cb.position),
                                      motion::figureBeside(ca.velocity, cb.velocity),
                                      QString::number(b + 1),
                                      motion::figureBeside(cb.position, ca.position),
                                      motion::figureBeside(cb.velocity, ca.velocity)),
                         .expected = 0.0,
                         .observed = apart,
                         .unit = QStringLiteral("m"),
                         .step = k};
        }
    }
    const double way = wayOf(o, a);
    const double wanted = 2.0 * o.circle(a, 0).radius;
    if (way < wanted)
        return Fault{.message =
                         StartText::tr("Circle %1 came %2 m far in %3 s; at least its diameter of "
                                       "%4 m must be seen to judge whether they stay together")
                             .arg(QString::number(a + 1), motion::figureBeside(way, wanted),
                                  motion::figure(o.states.time(o.steps())),
                                  motion::figureBeside(wanted, way)),
                     .expected = wanted,
                     .observed = way,
                     .unit = QStringLiteral("m"),
                     .step = o.steps()};
    return std::nullopt;
}

} // namespace cradle::kinds
