// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/speed_distribution.h"

#include <QtGlobal>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Masses that differ less than this part are equal: radii and densities are rounded.
constexpr double equalMasses = 1e-9;

double partOf(std::size_t count, std::size_t total)
{
    return total > 0 ? static_cast<double>(count) / static_cast<double>(total) : 0.0;
}

} // namespace

double GasState::spread() const
{
    return meanMass > 0.0 ? std::sqrt(temperature / meanMass) : 0.0;
}

GasState gasState(std::span<const Circle> circles)
{
    GasState gas;
    if (circles.empty())
        return gas;
    double lightest = mass(circles.front());
    double heaviest = lightest;
    for (const Circle &circle : circles) {
        const double own = mass(circle);
        lightest = std::min(lightest, own);
        heaviest = std::max(heaviest, own);
        gas.meanMass += own;
        gas.temperature += kineticEnergy(circle);
    }
    gas.meanMass /= static_cast<double>(circles.size());
    gas.temperature /= static_cast<double>(circles.size());
    gas.isMixed = heaviest - lightest > equalMasses * heaviest;
    return gas;
}

double scaledSpeed(const Circle &circle, const GasState &gas)
{
    const double speed = length(circle.velocity);
    return gas.isMixed ? speed * std::sqrt(mass(circle) / gas.meanMass) : speed;
}

double maxwellDensity(double speed, double spread)
{
    const double ratio = speed / spread;
    return ratio / spread * std::exp(-0.5 * ratio * ratio);
}

double maxwellShareBelow(double speed, double spread)
{
    const double ratio = speed / spread;
    return -std::expm1(-0.5 * ratio * ratio);
}

double distanceFromMaxwell(std::span<const Circle> circles)
{
    const GasState gas = gasState(circles);
    const double spread = gas.spread();
    if (!(spread > 0.0))
        return 1.0;
    std::vector<double> speeds;
    speeds.reserve(circles.size());
    for (const Circle &circle : circles)
        speeds.push_back(scaledSpeed(circle, gas));
    std::sort(speeds.begin(), speeds.end());
    double distance = 0.0;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        // The share of the circles rises at each speed: both ends of the rise count.
        const double expected = maxwellShareBelow(speeds[i], spread);
        distance = std::max({distance, expected - partOf(i, speeds.size()),
                             partOf(i + 1, speeds.size()) - expected});
    }
    return distance;
}

double distanceByChance(std::size_t count)
{
    constexpr double onePercent = 1.308;
    const double n = static_cast<double>(std::max<std::size_t>(count, 1));
    const double root = std::sqrt(n);
    return std::min(1.0, onePercent / (root + 0.26 + 0.5 / root) + 0.2 / n);
}

SpeedBins::SpeedBins(double width, std::size_t count)
    : m_width(width)
    , m_counts(count)
{
    Q_ASSERT(width > 0.0);
}

void SpeedBins::add(std::span<const Circle> circles, const GasState &gas)
{
    for (const Circle &circle : circles) {
        const double bin = scaledSpeed(circle, gas) / m_width;
        if (bin < static_cast<double>(m_counts.size()))
            ++m_counts[static_cast<std::size_t>(bin)];
        else
            ++m_beyond;
    }
    m_total += circles.size();
}

std::vector<double> SpeedBins::shares() const
{
    std::vector<double> parts;
    parts.reserve(m_counts.size());
    for (const std::size_t count : m_counts)
        parts.push_back(partOf(count, m_total));
    return parts;
}

double SpeedBins::shareBeyond() const
{
    return partOf(m_beyond, m_total);
}

} // namespace cradle
