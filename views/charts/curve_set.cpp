// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/curve_set.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// When the memory is full this part of the time kept is forgotten at once.
constexpr double forgottenPart = 0.125;

/// Frames between two looks at the memory held.
constexpr qint64 framesPerLook = 512;

constexpr std::array momentumGroups{CurveGroup::MomentumX, CurveGroup::MomentumY,
                                    CurveGroup::MomentumLength};

} // namespace

/// A frame, whose values come about at its end, or at the time of its first hit if it has one.
class CurveSet::Moment
{
public:
    /// Takes the hits up to the step of frame \p index out of \p losses.
    Moment(const Recording &recording, qint64 index, Losses &losses)
        : m_time(recording.time(index))
    {
        const auto &hits = recording.hits();
        auto hit =
            static_cast<std::size_t>(std::max<qint64>(0, losses.nextHit - recording.droppedHits()));
        for (; hit < hits.size() && hits[hit].step <= recording.step(index); ++hit) {
            losses.sum += hits[hit].loss;
            if (!m_hitTime)
                m_hitTime = std::min(hits[hit].time, m_time);
        }
        losses.nextHit = recording.droppedHits() + static_cast<qint64>(hit);
    }

    void append(MinMaxPyramid &curve, double value) const
    {
        if (m_hitTime && !curve.isEmpty()) {
            curve.append(*m_hitTime, curve.lastValue());
            curve.append(*m_hitTime, value);
        }
        curve.append(m_time, value);
    }

    void appendMomentum(CurveGroups groups, MotionCurves &curves, Vec2 momentum) const
    {
        const std::array values{momentum.x, momentum.y, length(momentum)};
        for (std::size_t part = 0; part < values.size(); ++part) {
            if (groups & momentumGroups[part])
                append(curves.momentum[part], values[part]);
        }
    }

private:
    double m_time; ///< s
    std::optional<double> m_hitTime;
};

void CurveSet::begin(std::size_t circles)
{
    const CurveGroups groups = m_groups;
    *this = {};
    m_groups = groups;
    m_circles.resize(circles <= maxCircles ? circles : 0);
}

Totals CurveSet::add(CurveGroups groups, Moment &moment, std::span<const Circle> circles,
                     const Preset &preset, double lost)
{
    Totals sum;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        const Totals one = measure(circles[i], preset.gravity, preset.halfWidth);
        sum += one;
        if (i >= m_circles.size())
            continue;
        m_momentumScale = std::max(m_momentumScale, length(one.momentum));
        moment.appendMomentum(groups, m_circles[i], one.momentum);
        if (groups & CurveGroup::KineticOfEach)
            moment.append(m_circles[i].kinetic, one.kinetic);
        if (groups & CurveGroup::TotalOfEach)
            moment.append(m_circles[i].total, one.total());
        if (groups & CurveGroup::KineticUpTo)
            moment.append(m_circles[i].kineticUpTo, sum.kinetic);
    }
    moment.appendMomentum(groups, m_sum, sum.momentum);
    if (groups & CurveGroup::Kinetic)
        moment.append(m_sum.kinetic, sum.kinetic);
    if (groups & CurveGroup::Potential)
        moment.append(m_potential, sum.potential);
    if (!m_start)
        m_start = sum.total();
    if (groups & CurveGroup::Made)
        moment.append(m_made, sum.total() + lost - *m_start);
    return sum;
}

void CurveSet::read(const Recording &recording, const Preset &preset, qint64 index)
{
    Moment moment(recording, index, m_losses);
    const Totals sum = add(m_groups, moment, recording.circles(index), preset, m_losses.sum);
    moment.append(m_sum.total, sum.total());
    moment.append(m_dissipated, m_losses.sum);
    m_momentumScale = std::max(m_momentumScale, length(sum.momentum));
    m_energyScale = std::max({m_energyScale, sum.kinetic, std::abs(sum.potential)});
}

/// What hits had taken before the oldest frame that \p recording keeps.
CurveSet::Losses CurveSet::lossesBefore(const Recording &recording) const
{
    Losses before{recording.droppedHits(), 0.0};
    if (recording.droppedHits() == 0)
        return before;
    const auto &hits = recording.hits();
    const qint64 read = m_losses.nextHit - recording.droppedHits();
    before.sum = m_losses.sum;
    for (qint64 hit = 0; hit < std::min(read, static_cast<qint64>(hits.size())); ++hit)
        before.sum -= hits[static_cast<std::size_t>(hit)].loss;
    return before;
}

void CurveSet::setGroups(CurveGroups groups, const Recording &recording, const Preset &preset,
                         qint64 next)
{
    const CurveGroups missing = groups & ~m_groups;
    clear(m_groups & ~groups);
    m_groups = groups;
    if (!missing || m_sum.total.isEmpty())
        return;
    Losses losses = lossesBefore(recording);
    const double oldest = m_sum.total.firstTime();
    for (qint64 i = recording.first(); i < next; ++i) {
        Moment moment(recording, i, losses);
        if (recording.time(i) >= oldest)
            add(missing, moment, recording.circles(i), preset, losses.sum);
    }
}

CurveSet CurveSet::whole(const Recording &recording, const Preset &preset, qint64 next,
                         qint64 maxBytes) const
{
    CurveSet all;
    all.begin(recording.circleCount());
    all.m_start = m_start;
    all.m_losses = lossesBefore(recording);
    for (qint64 i = recording.first(); i < next; ++i) {
        all.read(recording, preset, i);
        if (i % framesPerLook == 0 && all.bytes() > maxBytes)
            all.dropOldest();
    }
    return all.within(maxBytes);
}

void CurveSet::clear(CurveGroups groups)
{
    const auto clearMotion = [groups](MotionCurves &curves, CurveGroup kinetic) {
        for (std::size_t part = 0; part < momentumGroups.size(); ++part) {
            if (groups & momentumGroups[part])
                curves.momentum[part].clear();
        }
        if (groups & kinetic)
            curves.kinetic.clear();
    };
    clearMotion(m_sum, CurveGroup::Kinetic);
    for (MotionCurves &curves : m_circles) {
        clearMotion(curves, CurveGroup::KineticOfEach);
        if (groups & CurveGroup::TotalOfEach)
            curves.total.clear();
        if (groups & CurveGroup::KineticUpTo)
            curves.kineticUpTo.clear();
    }
    if (groups & CurveGroup::Potential)
        m_potential.clear();
    if (groups & CurveGroup::Made)
        m_made.clear();
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
