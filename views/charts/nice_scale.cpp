// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/nice_scale.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Of the scale of the run; rounding of sums over an hour stays below.
constexpr double scaleNoise = 1e-9;
/// Bounds of a range are multiples of its nice step for this many steps.
constexpr double boundSteps = 8.0;
/// A range that is used less than this is made anew: seldom, so that the picture rests.
constexpr double shrinkBelow = 1.0 / 3.0;

/// A zoom reaches no deeper: the digits of a double end soon after.
constexpr double deepest = 1e-9;

} // namespace

std::optional<ValueSpan> zoomed(const ValueSpan &span, double factor, double about)
{
    const ValueSpan zoom{about + factor * (span.low - about), about + factor * (span.high - about)};
    const double size = std::max(std::abs(zoom.low), std::abs(zoom.high));
    const bool holds = zoom.high - zoom.low > deepest * size && std::isfinite(size);
    return holds ? std::optional(zoom) : std::nullopt;
}

double niceStep(double rough)
{
    if (!(rough > 0.0) || !std::isfinite(rough))
        return 1.0;
    const double decade = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * decade >= rough * (1.0 - 1e-9))
            return digit * decade;
    }
    return 10.0 * decade;
}

std::vector<double> AxisScale::ticks() const
{
    std::vector<double> all;
    const double slack = 1e-9 * step;
    const double first = std::ceil((low - slack) / step);
    for (int i = 0; i < 100; ++i) {
        const double tick = (first + i) * step;
        if (tick > high + slack)
            break;
        all.push_back(tick);
    }
    return all;
}

void SteadyRange::fit(double low, double high, double reference)
{
    const double floor = scaleNoise * reference;
    if (std::abs(low) < floor)
        low = 0.0;
    if (std::abs(high) < floor)
        high = 0.0;
    low = std::min(low, 0.0);
    high = std::max(high, 0.0);
    if (!(low < high)) {
        low = -reference;
        high = reference;
    }
    if (high - low < shrinkBelow * (m_high - m_low))
        reset();
    if (low >= m_low && high <= m_high)
        return;
    m_low = std::min(m_low, low);
    m_high = std::max(m_high, high);
    const double grain = niceStep((m_high - m_low) / boundSteps);
    m_low = std::floor(m_low / grain + 1e-9) * grain;
    m_high = std::ceil(m_high / grain - 1e-9) * grain;
}

AxisScale SteadyRange::scale(int ticks, double margin) const
{
    double low = m_low;
    double high = m_high;
    if (!(low < high)) {
        low = -1.0;
        high = 1.0;
    }
    const double room = margin * (high - low);
    const double step = niceStep((high - low) / std::max(1, ticks));
    return {low - room, high + room, step};
}

} // namespace cradle
