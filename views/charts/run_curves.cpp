// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/run_curves.h"

#include "model/measurements.h"

#include <algorithm>

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

RunCurves::RunCurves(const Simulation &simulation, QObject *parent, qint64 maxBytes)
    : QObject(parent)
    , m_simulation(simulation)
    , m_maxBytes(maxBytes)
{
    connect(&simulation, &Simulation::restarted, this, &RunCurves::reset);
    connect(&simulation, &Simulation::frameReady, this, &RunCurves::update);
    reset();
}

void RunCurves::reset()
{
    const std::size_t count = m_simulation.recording().circleCount();
    m_circles.assign(count <= maxCircles ? count : 0, {});
    m_sum = {};
    m_potential.clear();
    m_dissipated.clear();
    m_made.clear();
    m_nextFrame = 0;
    m_nextHit = 0;
    m_lost = 0.0;
    update();
}

void RunCurves::update()
{
    const Recording &recording = m_simulation.recording();
    if (recording.isEmpty())
        return;
    if (recording.last() + 1 < m_nextFrame)
        return reset();
    for (qint64 i = std::max(m_nextFrame, recording.first()); i <= recording.last(); ++i)
        read(i);
    m_nextFrame = recording.last() + 1;
    if (recording.hasDropped())
        dropBefore(recording.time(recording.first()));
    if (bytes() > m_maxBytes) {
        const double first = total().firstTime();
        dropBefore(first + forgottenPart * (total().lastTime() - first));
    }
}

void RunCurves::read(qint64 index)
{
    const Recording &recording = m_simulation.recording();
    const Preset &preset = m_simulation.preset();
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
        if (i < m_circles.size())
            moment.append(m_circles[i], one);
    }
    if (m_made.isEmpty())
        m_start = sum.total();
    moment.append(m_sum, sum);
    moment.append(m_potential, sum.potential);
    moment.append(m_dissipated, m_lost);
    moment.append(m_made, sum.total() + m_lost - m_start);
}

double RunCurves::momentumScale() const
{
    constexpr auto part = static_cast<std::size_t>(MomentumPart::Length);
    double scale = m_sum.momentum[part].maximum();
    for (const MotionCurves &curves : m_circles)
        scale = std::max(scale, curves.momentum[part].maximum());
    return scale;
}

template <typename Visit>
void RunCurves::forEach(Visit visit)
{
    const auto visitMotion = [&](MotionCurves &curves) {
        for (MinMaxPyramid &curve : curves.momentum)
            visit(curve);
        visit(curves.kinetic);
        visit(curves.total);
    };
    for (MotionCurves &curves : m_circles)
        visitMotion(curves);
    visitMotion(m_sum);
    visit(m_potential);
    visit(m_dissipated);
    visit(m_made);
}

void RunCurves::dropBefore(double time)
{
    forEach([time](MinMaxPyramid &curve) { curve.dropBefore(time); });
}

qint64 RunCurves::bytes() const
{
    qint64 sum = 0;
    const_cast<RunCurves *>(this)->forEach(
        [&sum](const MinMaxPyramid &curve) { sum += curve.bytes(); });
    return sum;
}

} // namespace cradle
