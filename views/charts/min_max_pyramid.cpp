// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/min_max_pyramid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace cradle {

/// The first of the samples [\p from, \p to) of which \p isBefore does not hold, as it does of all
/// before it.
template <class IsBefore>
qint64 MinMaxPyramid::firstNot(IsBefore isBefore, qint64 from, qint64 to) const
{
    const auto begin = m_samples.begin() + (from - m_first);
    return from + (std::partition_point(begin, begin + (to - from), isBefore) - begin);
}

void MinMaxPyramid::append(double time, double value)
{
    if (!std::isfinite(time) || !std::isfinite(value))
        return;
    const std::size_t size = m_samples.size();
    if (size > 0)
        time = std::max(time, m_samples.back().x());
    if (size > 1 && m_samples[size - 1].y() == value && m_samples[size - 2].y() == value) {
        m_samples.back().setX(time);
        return;
    }
    m_samples.emplace_back(time, value);
    closeGroups();
}

quint64 MinMaxPyramid::newStamp()
{
    static std::atomic<quint64> last = 0;
    return ++last;
}

void MinMaxPyramid::clear()
{
    *this = MinMaxPyramid();
}

void MinMaxPyramid::dropBefore(double time)
{
    if (isEmpty() || firstTime() >= time)
        return;
    qint64 keep = firstNotBefore(time, m_first);
    const bool crosses =
        keep < end() && sample(keep).x() > time && sample(keep - 1).y() == sample(keep).y();
    if (crosses) {
        --keep;
        m_samples[static_cast<std::size_t>(keep - m_first)].setX(time);
    }
    m_samples.erase(m_samples.begin(), m_samples.begin() + (keep - m_first));
    m_first = keep;
    m_stamp = newStamp();
    qint64 span = 1;
    for (Level &level : m_levels) {
        span *= groupSize;
        // A group that has lost some of its samples would still name them.
        while (!level.groups.empty() && level.first * span < m_first) {
            level.groups.pop_front();
            ++level.first;
        }
    }
}

double MinMaxPyramid::valueAt(double time) const
{
    return isEmpty() ? 0.0 : sample(std::max(firstAfter(time, m_first) - 1, m_first)).y();
}

std::pair<double, double> MinMaxPyramid::bounds(double t0, double t1) const
{
    if (isEmpty())
        return {};
    const qint64 from = std::max(firstNotBefore(t0, m_first) - 1, m_first);
    const qint64 to = std::min(firstAfter(t1, from) + 1, end());
    const Extremes e = extremes(from, to);
    return {sample(e.least).y(), sample(e.greatest).y()};
}

double MinMaxPyramid::minimum() const
{
    return isEmpty() ? 0.0 : sample(extremes(m_first, end()).least).y();
}

double MinMaxPyramid::maximum() const
{
    return isEmpty() ? 0.0 : sample(extremes(m_first, end()).greatest).y();
}

QList<QPointF> MinMaxPyramid::decimate(double t0, double t1, int columns) const
{
    Window window;
    decimate(window, t0, t1, columns);
    return window.m_points;
}

void MinMaxPyramid::decimate(Window &window, double t0, double t1, int columns) const
{
    const bool goesOn = window.m_stamp == m_stamp && window.m_t0 == t0 && window.m_t1 == t1
                        && window.m_columns == columns && window.m_settled > 0;
    if (!goesOn) {
        window = {};
        window.m_stamp = m_stamp;
        window.m_t0 = t0;
        window.m_t1 = t1;
        window.m_columns = columns;
    }
    QList<QPointF> &points = window.m_points;
    points.resize(window.m_settled);
    if (isEmpty() || columns <= 0 || !(t0 < t1))
        return;
    const qint64 from = goesOn ? window.m_next : firstNotBefore(t0, m_first);
    const qint64 to = firstAfter(t1, from);
    const qint64 after = std::min(to + 1, end());
    if (!goesOn) {
        const qint64 before = std::max(from - 1, m_first);
        points.reserve(std::min(after - before, qint64{2} * (columns + 2)));
        if (to - from <= qint64{2} * columns) {
            for (qint64 i = before; i < after; ++i)
                points.append(sample(i));
            return;
        }
        if (before < from)
            points.append(sample(before));
    }
    const double width = (t1 - t0) / columns;
    const double last = std::floor(t0 / width) + columns; // t1 may round into one more
    const auto columnOf = [&](const QPointF &s) {
        return std::min(std::floor(s.x() / width), last);
    };
    for (qint64 i = from; i < to;) {
        // By the samples' columns, not by the time of its edge: that would round otherwise.
        const qint64 next = firstNot(
            [&, column = columnOf(sample(i))](const QPointF &s) { return columnOf(s) <= column; },
            i, to);
        if (next < end()) {
            window.m_settled = points.size();
            window.m_next = i;
        }
        const Extremes e = extremes(i, next);
        points.append(sample(std::min(e.least, e.greatest)));
        if (e.least != e.greatest)
            points.append(sample(std::max(e.least, e.greatest)));
        i = next;
    }
    if (to < after)
        points.append(sample(to));
}

qint64 MinMaxPyramid::bytes() const
{
    std::size_t sum = m_samples.size() * sizeof(QPointF);
    for (const Level &level : m_levels)
        sum += level.groups.size() * sizeof(Extremes);
    return static_cast<qint64>(sum);
}

qint64 MinMaxPyramid::firstNotBefore(double time, qint64 from) const
{
    return firstNot([time](const QPointF &s) { return s.x() < time; }, from, end());
}

qint64 MinMaxPyramid::firstAfter(double time, qint64 from) const
{
    return firstNot([time](const QPointF &s) { return s.x() <= time; }, from, end());
}

MinMaxPyramid::Extremes MinMaxPyramid::extremes(qint64 from, qint64 to, std::size_t levels) const
{
    Extremes sum{from, from};
    for (qint64 i = from; i < to;) {
        qint64 span = 1;
        const Level *level = nullptr;
        for (std::size_t l = 0; l < levels; ++l) {
            const qint64 wider = span * groupSize;
            if (i % wider != 0 || i + wider > to)
                break;
            span = wider;
            level = &m_levels[l];
        }
        join(sum, level ? level->groups[static_cast<std::size_t>(i / span - level->first)]
                        : Extremes{i, i});
        i += span;
    }
    return sum;
}

void MinMaxPyramid::join(Extremes &sum, const Extremes &part) const
{
    if (sample(part.least).y() < sample(sum.least).y())
        sum.least = part.least;
    if (sample(part.greatest).y() > sample(sum.greatest).y())
        sum.greatest = part.greatest;
}

void MinMaxPyramid::closeGroups()
{
    qint64 span = 1;
    for (std::size_t l = 0;; ++l) {
        span *= groupSize;
        if (end() % span != 0)
            return;
        const qint64 start = end() - span;
        if (l == m_levels.size())
            m_levels.emplace_back();
        Level &level = m_levels[l];
        if (start < m_first) { // its first samples were dropped: nobody will ask for it
            level.first = end() / span;
            continue;
        }
        level.groups.push_back(extremes(start, end(), l));
    }
}

} // namespace cradle
