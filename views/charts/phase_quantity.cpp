// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/phase_quantity.h"

#include "model/world/measurements.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct PhaseText {
    Q_DECLARE_TR_FUNCTIONS(Phase)
};

double partOf(Quantity quantity, Vec2 position, Vec2 velocity, const Totals &totals)
{
    switch (quantity) {
    case Quantity::X:
        return position.x;
    case Quantity::Y:
        return position.y;
    case Quantity::VelocityX:
        return velocity.x;
    case Quantity::VelocityY:
        return velocity.y;
    case Quantity::Speed:
        return length(velocity);
    case Quantity::MomentumX:
        return totals.momentum.x;
    case Quantity::MomentumY:
        return totals.momentum.y;
    case Quantity::MomentumSize:
        return length(totals.momentum);
    case Quantity::Kinetic:
        return totals.kinetic;
    case Quantity::Potential:
        return totals.potential;
    default:
        return totals.total();
    }
}

double ofAll(Quantity quantity, std::span<const Circle> circles, const Preset &preset)
{
    const Totals totals = measure(circles, preset.gravity, preset.halfWidth);
    Vec2 weighted;
    double all = 0.0;
    for (const Circle &circle : circles) {
        weighted += mass(circle) * circle.position;
        all += mass(circle);
    }
    return partOf(quantity, weighted / all, totals.momentum / all, totals);
}

} // namespace

bool PhaseVariable::isOfCircles() const
{
    return std::find(std::begin(quantitiesOfCircles), std::end(quantitiesOfCircles), quantity)
           != std::end(quantitiesOfCircles);
}

std::optional<double> valueOf(const PhaseVariable &variable, const PhaseMoment &moment,
                              const Preset &preset)
{
    const auto &circles = moment.circles;
    switch (variable.quantity) {
    case Quantity::Time:
        return moment.time;
    case Quantity::Distance:
        if (circles.size() < 2)
            return std::nullopt;
        return length(circles[1].position - circles[0].position);
    case Quantity::OffExact:
    case Quantity::EnergyExact: {
        if (moment.exact.empty() || moment.exact.size() != circles.size())
            return std::nullopt;
        const Deviation off = deviation(circles, moment.exact, preset.gravity, preset.halfWidth);
        return variable.quantity == Quantity::OffExact ? off.greatest : off.energy;
    }
    default:
        break;
    }
    if (variable.circle == PhaseVariable::together)
        return circles.empty() ? std::nullopt
                               : std::optional(ofAll(variable.quantity, circles, preset));
    const auto index = static_cast<std::size_t>(variable.circle);
    if (index >= circles.size())
        return std::nullopt;
    return partOf(variable.quantity, circles[index].position, circles[index].velocity,
                  measure(circles[index], preset.gravity, preset.halfWidth));
}

QString symbolOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Time:
        return QStringLiteral("t");
    case Quantity::X:
        return QStringLiteral("x");
    case Quantity::Y:
        return QStringLiteral("y");
    case Quantity::VelocityX:
        return QStringLiteral("v_x");
    case Quantity::VelocityY:
        return QStringLiteral("v_y");
    case Quantity::Speed:
        return QStringLiteral("|v|");
    case Quantity::MomentumX:
        return QStringLiteral("p_x");
    case Quantity::MomentumY:
        return QStringLiteral("p_y");
    case Quantity::MomentumSize:
        return QStringLiteral("|p|");
    case Quantity::Kinetic:
        return PhaseText::tr("kinetic");
    case Quantity::Potential:
        return PhaseText::tr("potential");
    case Quantity::Total:
        return PhaseText::tr("total");
    case Quantity::Distance:
        return PhaseText::tr("distance 1–2");
    case Quantity::OffExact:
        return PhaseText::tr("off exact");
    case Quantity::EnergyExact:
        break;
    }
    return PhaseText::tr("more than exact");
}

QString nameOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Time:
        return PhaseText::tr("Time");
    case Quantity::X:
        return PhaseText::tr("Position x");
    case Quantity::Y:
        return PhaseText::tr("Position y");
    case Quantity::VelocityX:
        return PhaseText::tr("Velocity to the right");
    case Quantity::VelocityY:
        return PhaseText::tr("Velocity upwards");
    case Quantity::Speed:
        return PhaseText::tr("Speed");
    case Quantity::MomentumX:
        return PhaseText::tr("Momentum to the right");
    case Quantity::MomentumY:
        return PhaseText::tr("Momentum upwards");
    case Quantity::MomentumSize:
        return PhaseText::tr("Size of the momentum");
    case Quantity::Kinetic:
        return PhaseText::tr("Kinetic energy");
    case Quantity::Potential:
        return PhaseText::tr("Potential energy");
    case Quantity::Total:
        return PhaseText::tr("Total energy");
    case Quantity::Distance:
        return PhaseText::tr("Distance of circles 1 and 2");
    case Quantity::OffExact:
        return PhaseText::tr("Distance from the exact motion");
    case Quantity::EnergyExact:
        break;
    }
    return PhaseText::tr("Energy more than the exact motion");
}

QString unitOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Time:
        return PhaseText::tr("s", "seconds");
    case Quantity::X:
    case Quantity::Y:
    case Quantity::Distance:
    case Quantity::OffExact:
        return PhaseText::tr("m", "metres");
    case Quantity::VelocityX:
    case Quantity::VelocityY:
    case Quantity::Speed:
        return PhaseText::tr("m/s");
    case Quantity::MomentumX:
    case Quantity::MomentumY:
    case Quantity::MomentumSize:
        return PhaseText::tr("kg m/s");
    default:
        return PhaseText::tr("J", "joules");
    }
}

QString textOf(const PhaseVariable &variable)
{
    const QString symbol = symbolOf(variable.quantity);
    if (!variable.isOfCircles())
        return symbol;
    return variable.circle == PhaseVariable::together
               ? PhaseText::tr("%1 all", "quantity, of all circles").arg(symbol)
               : QStringLiteral("%1 %2").arg(symbol).arg(variable.circle + 1);
}

} // namespace cradle
