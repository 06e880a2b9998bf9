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

struct UnitWords {
    const char *source = nullptr;
    const char *comment = nullptr; ///< for translators
};

/// What is written and said of a quantity.
struct QuantityWords {
    const char *symbol = nullptr;
    const char *name = nullptr;
    UnitWords unit{};
};

constexpr UnitWords ofTime = QT_TRANSLATE_NOOP3("Phase", "s", "seconds");
constexpr UnitWords ofLength = QT_TRANSLATE_NOOP3("Phase", "m", "metres");
constexpr UnitWords ofVelocity{QT_TRANSLATE_NOOP("Phase", "m/s")};
constexpr UnitWords ofMomentum{QT_TRANSLATE_NOOP("Phase", "kg m/s")};
constexpr UnitWords ofEnergy = QT_TRANSLATE_NOOP3("Phase", "J", "joules");

const QuantityWords &wordsOf(Quantity quantity)
{
    // In the order of the quantities.
    static constexpr QuantityWords words[] = {
        {"t", QT_TRANSLATE_NOOP("Phase", "Time"), ofTime},
        {"x", QT_TRANSLATE_NOOP("Phase", "Position x"), ofLength},
        {"y", QT_TRANSLATE_NOOP("Phase", "Position y"), ofLength},
        {"v_x", QT_TRANSLATE_NOOP("Phase", "Velocity to the right"), ofVelocity},
        {"v_y", QT_TRANSLATE_NOOP("Phase", "Velocity upwards"), ofVelocity},
        {"|v|", QT_TRANSLATE_NOOP("Phase", "Speed"), ofVelocity},
        {"p_x", QT_TRANSLATE_NOOP("Phase", "Momentum to the right"), ofMomentum},
        {"p_y", QT_TRANSLATE_NOOP("Phase", "Momentum upwards"), ofMomentum},
        {"|p|", QT_TRANSLATE_NOOP("Phase", "Size of the momentum"), ofMomentum},
        {QT_TRANSLATE_NOOP("Phase", "kinetic"), QT_TRANSLATE_NOOP("Phase", "Kinetic energy"),
         ofEnergy},
        {QT_TRANSLATE_NOOP("Phase", "potential"), QT_TRANSLATE_NOOP("Phase", "Potential energy"),
         ofEnergy},
        {QT_TRANSLATE_NOOP("Phase", "total"), QT_TRANSLATE_NOOP("Phase", "Total energy"), ofEnergy},
        {QT_TRANSLATE_NOOP("Phase", "distance 1–2"),
         QT_TRANSLATE_NOOP("Phase", "Distance of circles 1 and 2"), ofLength},
        {QT_TRANSLATE_NOOP("Phase", "off exact"),
         QT_TRANSLATE_NOOP("Phase", "Distance from the exact motion"), ofLength},
        {QT_TRANSLATE_NOOP("Phase", "more than exact"),
         QT_TRANSLATE_NOOP("Phase", "Energy more than the exact motion"), ofEnergy},
    };
    static_assert(std::size(words) == static_cast<std::size_t>(Quantity::EnergyExact) + 1);
    return words[static_cast<std::size_t>(quantity)];
}

/// Whether its symbol is a word, which other languages have another for.
bool isWord(Quantity quantity)
{
    return quantity >= Quantity::Kinetic;
}

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
    const char *symbol = wordsOf(quantity).symbol;
    return isWord(quantity) ? PhaseText::tr(symbol) : QLatin1String(symbol);
}

QString nameOf(Quantity quantity)
{
    return PhaseText::tr(wordsOf(quantity).name);
}

QString unitOf(Quantity quantity)
{
    const UnitWords &unit = wordsOf(quantity).unit;
    return PhaseText::tr(unit.source, unit.comment);
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
