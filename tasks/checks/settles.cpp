// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"
#include "tasks/checks/integrator_matching.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>

namespace cradle::kinds {

namespace {

struct SettleText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// The end of the run that is looked at, s.
constexpr double lastSeconds = 5.0;
/// How much higher than the reference a circle may still hop.
constexpr double generosity = 2.0;

/// Whether circle \p i came to the floor as fast as what falls for a tenth of a second.
bool hasFallen(const Observation &o, int i, Vec2 gravity)
{
    const Vec2 down = outwardNormal(Wall::Bottom);
    for (qint64 k = 0; k <= o.steps(); ++k) {
        const Circle &c = o.circle(i, k);
        if (dot(c.velocity, down) > 0.1 * length(gravity)
            && motion::wallGap(o, c, Wall::Bottom) <= motion::travel(o, i, k, gravity))
            return true;
    }
    return false;
}

/// Whether circle \p i was ever within the way of a step from the floor.
bool cameToFloor(const Observation &o, int i, Vec2 gravity)
{
    for (qint64 k = 0; k <= o.steps(); ++k) {
        if (motion::wallGap(o, o.circle(i, k), Wall::Bottom) <= motion::travel(o, i, k, gravity))
            return true;
    }
    return false;
}

/// How high above the floor the rim of circle \p i still comes at the end, m.
double lastHeight(const Observation &o, int i)
{
    double highest = std::numeric_limits<double>::lowest();
    for (qint64 k = o.steps(); k >= 0; --k) {
        if (o.states.time(k) < o.states.time(o.steps()) - lastSeconds)
            break;
        highest = std::max(highest, motion::wallGap(o, o.circle(i, k), Wall::Bottom));
    }
    return highest;
}

/// The same of the lab's own way with \p integrator.
double referenceHeight(const Observation &o, int i, Integrator integrator)
{
    Variant reference = o.variant;
    reference.preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete};
    for (PresetCircle &circle : reference.preset.circles)
        circle.integrator = integrator;
    return lastHeight(observe(reference), i);
}

/// How high a circle may hop for ever that loses (1 - e) v in a hit and gains at most g Δt by it,
/// as one does that is turned a step before the floor, and so as high as a step's way above it, m:
///     v = g Δt / (1 - e),  h = v² / 2g + v Δt
double steadyHeight(const Observation &o, Vec2 gravity)
{
    const double g = length(gravity);
    const double loss = 1.0 - o.variant.preset.restitution;
    if (g <= 0.0 || loss <= 0.0)
        return 0.0;
    const double h = o.timestep();
    const double v = g * h / loss;
    return v * v / (2.0 * g) + v * h;
}

} // namespace

std::optional<Fault> settles(const CheckSpec &check, const Observation &o)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    for (const int i : check.circles) {
        double allowed = 0.0;
        for (const Integrator integrator : matchingIntegrators(check, o, i, gravity))
            allowed = std::max(allowed, referenceHeight(o, i, integrator));
        allowed =
            std::max({generosity * allowed, steadyHeight(o, gravity), motion::toleranceOf(check)});
        if (!hasFallen(o, i, gravity)) {
            const QString text =
                cameToFloor(o, i, gravity)
                    ? SettleText::tr("In %2 s circle %1 never came to the floor as fast as a fall "
                                     "makes it; that must be seen to judge how it comes to rest")
                    : SettleText::tr("In %2 s circle %1 never came to the floor; that must be seen "
                                     "to judge how it comes to rest");
            return Fault{.message = text.arg(i + 1).arg(motion::figure(o.variant.duration)),
                         .step = o.steps(),
                         .circle = i};
        }
        const double observed = lastHeight(o, i);
        if (observed > allowed) {
            return Fault{.message =
                             SettleText::tr("After %1 s circle %2 still comes %3 m above "
                                            "the floor with e = %4; at most %5 m is right "
                                            "for its integrator")
                                 .arg(motion::figure(o.variant.duration), QString::number(i + 1),
                                      motion::figureBeside(observed, allowed),
                                      motion::figure(o.variant.preset.restitution),
                                      motion::figureBeside(allowed, observed)),
                         .expected = allowed,
                         .observed = observed,
                         .unit = QStringLiteral("m"),
                         .step = o.steps()};
        }
    }
    return std::nullopt;
}

} // namespace cradle::kinds
