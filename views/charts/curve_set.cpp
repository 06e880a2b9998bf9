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
    /// Takes the hits from number \p nextHit up to the step of frame \p index.
    Moment(const Recording &recording, qint64 index, qint64 &nextHit)
        : m_time(recording.time(index))
    {
        const auto &hits = recording.hits();
        m_begin = static_cast<std::size_t>(std::max<qint64>(0, nextHit - recording.droppedHits()));
        m_end = m_begin;
        for (; m_end < hits.size() && hits[m_end].step <= recording.step(index); ++m_end) {
            if (!m_hitTime)
                m_hitTime = std::min(hits[m_end].time, m_time);
        }
        nextHit = recording.droppedHits() + static_cast<qint64>(m_end);
    }

    [[nodiscard]] double time() const { return m_time; }
    /// Its hits, as indices into those that the recording keeps.
    [[nodiscard]] std::size_t begin() const { return m_begin; }
    [[nodiscard]] std::size_t end() const { return m_end; }

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
    std::size_t m_begin = 0;
    std::size_t m_end = 0;
    std::optional<double> m_hitTime;
};

void CurveSet::begin(std::size_t circles)
{
    const CurveGroups groups = m_groups;
    *this = {};
    m_groups = groups;
    m_circles.resize(circles <= maxCircles ? circles : 0);
}

Totals CurveSet::add(CurveGroups groups, const Moment &moment, std::span<const Circle> circles,
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

/// What hits take in the step of \p moment. A hit within the step takes kinetic energy. One at its
/// end is of a step that puts circles back and turns them, so that all that becomes of their energy
/// in that step is the hit's doing; and while a circle rests on something, in the steps between
/// too.
void CurveSet::countLosses(const Recording &recording, const Preset &preset, qint64 index,
                           const Moment &moment)
{
    const std::span<const Circle> circles = recording.circles(index);
    std::vector<Losses::Touch> &touches = m_losses.touches;
    touches.resize(circles.size());
    const qint64 step = recording.step(index);
    const auto touch = [&](int circle) {
        Losses::Touch &one = touches[static_cast<std::size_t>(circle)];
        if (one.last < step && step - one.last <= EncounterLog::restingSteps)
            one.until = step + EncounterLog::restingSteps;
        one.last = step;
    };
    for (std::size_t i = moment.begin(); i < moment.end(); ++i) {
        const Hit &hit = recording.hits()[i];
        if (hit.time < moment.time()) {
            m_losses.sum += hit.loss;
            continue;
        }
        touch(hit.a);
        if (hit.kind == Hit::Kind::Circle)
            touch(hit.b);
    }
    const std::span<const Circle> before = recording.circles(index - 1);
    for (std::size_t i = 0; i < circles.size(); ++i) {
        if (touches[i].last == step || touches[i].until >= step)
            m_losses.sum += measure(before[i], preset.gravity, preset.halfWidth).total()
                            - measure(circles[i], preset.gravity, preset.halfWidth).total();
    }
}

void CurveSet::read(const Recording &recording, const Preset &preset, qint64 index)
{
    const Moment moment(recording, index, m_losses.nextHit);
    // What the first frame lost is not to be seen in it.
    if (!m_sum.total.isEmpty() && index > recording.first())
        countLosses(recording, preset, index, moment);
    const Totals sum = add(m_groups, moment, recording.circles(index), preset, m_losses.sum);
    moment.append(m_sum.total, sum.total());
    moment.append(m_dissipated, m_losses.sum);
    m_momentumScale = std::max(m_momentumScale, length(sum.momentum));
    m_energyScale = std::max({m_energyScale, sum.kinetic, std::abs(sum.potential)});
}

void CurveSet::setGroups(CurveGroups groups, const Recording &recording, const Preset &preset,
                         qint64 next)
{
    const CurveGroups missing = groups & ~m_groups;
    clear(m_groups & ~groups);
    m_groups = groups;
    if (!missing || m_sum.total.isEmpty())
        return;
    qint64 nextHit = recording.droppedHits();
    const double oldest = m_sum.total.firstTime();
    for (qint64 i = recording.first(); i < next; ++i) {
        const Moment moment(recording, i, nextHit);
        if (moment.time() >= oldest)
            add(missing, moment, recording.circles(i), preset, m_dissipated.valueAt(moment.time()));
    }
}

CurveSet CurveSet::whole(const Recording &recording, const Preset &preset, qint64 next,
                         qint64 maxBytes) const
{
    CurveSet all;
    all.begin(recording.circleCount());
    all.m_start = m_start;
    if (m_dissipated.isEmpty())
        return all;
    qint64 first = recording.indexAt(m_dissipated.firstTime());
    if (recording.time(first) < m_dissipated.firstTime())
        ++first;
    all.m_losses.nextHit = recording.droppedHits();
    all.m_losses.sum = m_dissipated.valueAt(recording.time(first));
    for (qint64 i = first; i < next; ++i) {
        all.read(recording, preset, i);
        if (i % framesPerLook == 0 && all.bytes() > maxBytes)
            all.dropOldest();
    }
    return all.within(maxBytes);
}

/// Visits each curve with the group that it is of; none for those that are always kept.
template <typename Visit>
void CurveSet::forEach(Visit visit)
{
    const auto visitMotion = [&](MotionCurves &curves, CurveGroups kinetic, CurveGroups total) {
        for (std::size_t part = 0; part < momentumGroups.size(); ++part)
            visit(curves.momentum[part], momentumGroups[part]);
        visit(curves.kinetic, kinetic);
        visit(curves.total, total);
        visit(curves.kineticUpTo, CurveGroup::KineticUpTo);
    };
    for (MotionCurves &curves : m_circles)
        visitMotion(curves, CurveGroup::KineticOfEach, CurveGroup::TotalOfEach);
    visitMotion(m_sum, CurveGroup::Kinetic, {});
    visit(m_potential, CurveGroup::Potential);
    visit(m_dissipated, CurveGroups());
    visit(m_made, CurveGroup::Made);
}

void CurveSet::clear(CurveGroups groups)
{
    forEach([groups](MinMaxPyramid &curve, CurveGroups group) {
        if (groups & group)
            curve.clear();
    });
}

void CurveSet::dropBefore(double time)
{
    forEach([time](MinMaxPyramid &curve, CurveGroups) { curve.dropBefore(time); });
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
        [&sum](const MinMaxPyramid &curve, CurveGroups) { sum += curve.bytes(); });
    return sum;
}

} // namespace cradle
