// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/free_flight.h"

#include "tasks/checks/check_kinds.h"
#include "tasks/checks/figures.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct FlightText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// Of a scene's duration: what must be seen of the free motion where the check says nothing.
constexpr double leastShare = 0.1;

/// For how long a circle was near what it may hit, s.
struct Nearness {
    double wall = 0.0;
    double circle = 0.0;
};

Nearness nearnessOf(const Observation &o, int i, Vec2 gravity)
{
    Nearness near;
    for (qint64 k = 0; k < o.steps(); ++k) {
        near.wall += motion::isNearWall(o, i, k, gravity) ? o.timestep() : 0.0;
        near.circle += motion::isNearCircle(o, i, k, gravity) ? o.timestep() : 0.0;
    }
    return near;
}

} // namespace

qint64 freeSteps(const CheckSpec &check, const Observation &o, int i, Vec2 gravity)
{
    qint64 steps = 0;
    for (qint64 k = 0; k < o.steps(); ++k)
        steps += motion::isFree(check, o, i, k, gravity) ? 1 : 0;
    return steps;
}

std::optional<Fault> tooLittleFlight(const CheckSpec &check, const Observation &o, int i,
                                     qint64 steps, Vec2 gravity)
{
    const double seen = static_cast<double>(steps) * o.timestep();
    const double wanted =
        valueOf(check, QStringLiteral("free")).toDouble(leastShare * o.variant.duration);
    if (seen > wanted - o.timestep())
        return std::nullopt;
    const Nearness near = nearnessOf(o, i, gravity);
    const auto at = [](double seconds) { return motion::figure(seconds); };
    const QString where =
        near.wall > 0.0 && near.circle > 0.0
            ? FlightText::tr(". For %1 s it was within a step's way of a wall or beyond it, for %2 "
                             "s of another circle: look at what it does there")
                  .arg(at(near.wall), at(near.circle))
        : near.wall > 0.0 ? FlightText::tr(". For %1 s it was within a step's way of a wall or "
                                           "beyond it: look at what it does there")
                                .arg(at(near.wall))
        : near.circle > 0.0 ? FlightText::tr(". For %1 s it was within a step's way of another "
                                             "circle: look at what it does there")
                                  .arg(at(near.circle))
                            : QString();
    return Fault{.message = FlightText::tr("Circle %1 was free of walls and other circles for "
                                           "%2 s only; at least %3 s must be seen to judge its "
                                           "motion")
                                .arg(QString::number(i + 1), motion::figureBeside(seen, wanted),
                                     motion::figureBeside(wanted, seen))
                            + where,
                 .expected = wanted,
                 .observed = seen,
                 .unit = QStringLiteral("s"),
                 .step = 0,
                 .circle = i};
}

} // namespace cradle
