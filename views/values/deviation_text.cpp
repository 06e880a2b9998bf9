// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/values/deviation_text.h"

#include "model/run/simulation.h"
#include "model/world/measurements.h"
#include "views/number_text.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle {

namespace {

struct DeviationText {
    Q_DECLARE_TR_FUNCTIONS(Deviation)
};

/// The greatest distance, with the root mean square where there are several circles.
/// \param scale  of lengths, m: what is rounding beside it is 0
QString distanceText(const Deviation &off, std::size_t circles, double scale)
{
    const QString greatest = shortNumber(off.greatest, scale);
    if (circles == 1)
        return DeviationText::tr("%1 m", "a distance").arg(greatest);
    return DeviationText::tr("up to %1 m (rms %2 m)")
        .arg(greatest, shortNumber(off.rootMeanSquare, scale));
}

/// \param scale  of energies, J
QString energyText(double energy, double scale)
{
    const QString number = shortNumber(energy, scale);
    const bool more = energy > 0.0 && number != QLatin1String("0");
    return DeviationText::tr("%1 J", "an energy, with its sign")
        .arg(more ? QLatin1Char('+') + number : number);
}

} // namespace

QString describeDeviation(const Simulation &simulation)
{
    const qint64 shown = simulation.current();
    const auto circles = simulation.recording().circles(shown);
    if (circles.empty() || !simulation.shadow() || !simulation.shadow()->isPossible())
        return {};
    const Preset &preset = simulation.preset();
    const Deviation off =
        deviation(circles, simulation.shadow()->circles(shown), preset.gravity, preset.halfWidth);
    const Totals totals = measure(circles, preset.gravity, preset.halfWidth);
    return DeviationText::tr("Off the exact motion: %1, %2.", "energy, distance")
        .arg(energyText(off.energy, totals.kinetic + std::abs(totals.potential)),
             distanceText(off, circles.size(), preset.halfWidth));
}

} // namespace cradle
