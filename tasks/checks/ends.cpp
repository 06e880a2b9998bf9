// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>
#include <QJsonArray>

namespace cradle::kinds {

namespace {

struct EndText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

struct Wanted {
    QString text; ///< "At 2 s circle 1 is at %1 m; %2 m is right"
    QString unit;
    Vec2 observed{};
    const QJsonArray &list; ///< what is asked for, one [x, y] for each circle
};

/// \param place  of the circle among those of the check
std::optional<Fault> differs(const Wanted &wanted, int place, double tolerance, qint64 step)
{
    if (place >= wanted.list.size())
        return std::nullopt;
    const QJsonArray pair = wanted.list.at(place).toArray();
    const Vec2 expected{pair.at(0).toDouble(), pair.at(1).toDouble()};
    const Vec2 error = wanted.observed - expected;
    if (length(error) <= tolerance)
        return std::nullopt;
    const bool x = std::abs(error.x) > std::abs(error.y);
    return Fault{.message = wanted.text.arg(motion::figureBeside(wanted.observed, expected),
                                            motion::figureBeside(expected, wanted.observed)),
                 .expected = x ? expected.x : expected.y,
                 .observed = x ? wanted.observed.x : wanted.observed.y,
                 .unit = wanted.unit,
                 .step = step};
}

} // namespace

std::optional<Fault> endsAt(const CheckSpec &check, const Observation &o)
{
    const double end = o.states.time(o.steps());
    const double time = std::min(end, check.parameters.value(QStringLiteral("time")).toDouble(end));
    const auto step = static_cast<qint64>(std::ceil(time / o.timestep() - 1e-6));
    const double tolerance = motion::toleranceOf(check);
    const QJsonArray places = check.parameters.value(QStringLiteral("positions")).toArray();
    const QJsonArray velocities = check.parameters.value(QStringLiteral("velocities")).toArray();
    int place = 0;
    for (const int i : check.circles) {
        const Circle circle = o.circleAt(i, time);
        const QString at = motion::figure(time);
        const QString number = QString::number(i + 1);
        const Wanted position{EndText::tr("At %1 s circle %2 is at %3 m; %4 m is right")
                                  .arg(at, number, QStringLiteral("%1"), QStringLiteral("%2")),
                              QStringLiteral("m"), circle.position, places};
        if (auto fault = differs(position, place, tolerance, step))
            return fault;
        const Wanted velocity{EndText::tr("At %1 s circle %2 moves with %3 m/s; %4 m/s is right")
                                  .arg(at, number, QStringLiteral("%1"), QStringLiteral("%2")),
                              QStringLiteral("m/s"), circle.velocity, velocities};
        if (auto fault = differs(velocity, place, tolerance, step))
            return fault;
        ++place;
    }
    return std::nullopt;
}

} // namespace cradle::kinds
