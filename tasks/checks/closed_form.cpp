// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"
#include "tasks/checks/free_flight.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle::kinds {

namespace {

struct ClosedFormText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

} // namespace

std::optional<Fault> closedForm(const CheckSpec &check, const Observation &o)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    const double tolerance = motion::toleranceOf(check);
    for (const int i : check.circles) {
        const Circle &begin = o.circle(i, 0);
        qint64 k = 0;
        for (; k < o.steps() && motion::isFree(check, o, i, k, gravity); ++k) {
            const double t = o.states.time(k + 1);
            const Vec2 right = begin.position + t * begin.velocity + (0.5 * t * t) * gravity;
            const Vec2 observed = o.circle(i, k + 1).position;
            if (quickLength(observed - right) <= tolerance)
                continue;
            const bool x = std::abs(observed.x - right.x) > std::abs(observed.y - right.y);
            return Fault{.message =
                             ClosedFormText::tr("At step %1 circle %2 is at %3 m; x₀ + v₀t + ½gt² "
                                                "is %4 m")
                                 .arg(QString::number(k + 1), QString::number(i + 1),
                                      motion::figureBeside(observed, right),
                                      motion::figureBeside(right, observed)),
                         .expected = x ? right.x : right.y,
                         .observed = x ? observed.x : observed.y,
                         .unit = QStringLiteral("m"),
                         .step = k + 1,
                         .circle = i};
        }
        if (auto fault = tooLittleFlight(check, o, i, k, gravity))
            return fault;
    }
    return std::nullopt;
}

} // namespace cradle::kinds
