// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/curve_set.h"

#include "model/measurements.h"

#include <algorithm>
#include <optional>

namespace cradle {

namespace {

/// When the memory is full this part of the time kept is forgotten at once.
constexpr double forgottenPart = 0.125;

/// A value that comes about at the end of a step, or at hitTime if that has a hit.
struct Moment {
    double time;
    std::optional<double> hitTime;

    void append(MinMaxPyramid &curve, double value) const
    {
        if (hitTime && !curve.isEmpty()) {
            curve.append(*hitTime, curve.lastValue());
            curve.append(*hitTime, value);
        }
        curve.append(time, value);
    }

    void append(MotionCurves &curves, const Totals &totals) const
    {
        append(curves.momentum[0], totals.momentum.x);
        append(curves.momentum[1], totals.momentum.y);
        append(curves.momentum[2], length(totals.momentum));
        append(curves.kinetic, totals.kinetic);
        append(curves.total, totals.total());
    }
};

} // namespace

void CurveSet::begin(std::size_t circles)
{
    *this = {};
    m_circles.resize(circles <= maxCircles ? circles : 0);
}

void CurveSet::read(const Recording &recording, const Preset &preset, qint64 index)
{
    const auto circles = recording.circles(index);
    const auto &hits = recording.hits();
    Moment moment{recording.time(index), {}};
    auto hit = static_cast<std::size_t>(std::max<qint64>(0, m_nextHit - recording.droppedHits()));
    for (; hit < hits.size() && hits[hit].step <= recording.step(index); ++hit) {
        m_lost += hits[hit].loss;
        if (!moment.hitTime)
            moment.hitTime = std::min(hits[hit].time, moment.time);
    }
    m_nextHit = recording.droppedHits() + static_cast<qint64>(hit);

    Totals sum;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        const Totals one = measure(circles[i], preset.gravity, preset.halfWidth);
        sum += one;
        if (i < m_circles.size()) {
            moment.append(m_circles[i], one);
            moment.append(m_circles[i].kineticUpTo, sum.kinetic);
        }
    }
    if (m_made.isEmpty())
        m_start = sum.total();
    moment.append(m_sum, sum);
    moment.append(m_potential, sum.potential);
    moment.append(m_dissipated, m_lost);
    moment.append(m_made, sum.total() + m_lost - m_start);
}

double CurveSet::momentumScale() const
{
    constexpr auto part = static_cast<std::size_t>(MomentumPart::Length);
    double scale = m_sum.momentum[part].maximum();
    for (const MotionCurves &curves : m_circles)
        scale = std::max(scale, curves.momentum[part].maximum());
    return scale;
}

template <typename Visit>
void CurveSet::forEach(Visit visit)
{
    const auto visitMotion = [&](MotionCurves &curves) {
        for (MinMaxPyramid &curve : curves.momentum)
            visit(curve);
        visit(curves.kinetic);
        visit(curves.total);
        visit(curves.kineticUpTo);
    };
    for (MotionCurves &curves : m_circles)
        visitMotion(curves);
    visitMotion(m_sum);
    visit(m_potential);
    visit(m_dissipated);
    visit(m_made);
}

void CurveSet::dropBefore(double time)
{
    forEach([time](MinMaxPyramid &curve) { curve.dropBefore(time); });
}

void CurveSet::dropOldest()
{
    const double first = total().firstTime();
    dropBefore(first + forgottenPart * (total().lastTime() - first));
}

CurveSet CurveSet::within(qint64 maxBytes) const
{
    CurveSet copy = *this;
    while (copy.bytes() > maxBytes && copy.total().lastTime() > copy.total().firstTime())
        copy.dropOldest();
    return copy;
}

qint64 CurveSet::bytes() const
{
    qint64 sum = 0;
    const_cast<CurveSet *>(this)->forEach(
        [&sum](const MinMaxPyramid &curve) { sum += curve.bytes(); });
    return sum;
}

} // namespace cradle
