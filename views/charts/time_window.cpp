// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/time_window.h"

#include "views/charts/nice_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cradle {

namespace {

/// The end of the time axis goes ahead by this part of the run, so that it need not move with
/// every frame.
constexpr double aheadPart = 1.0 / 16.0;

/// These parts of the last seconds are kept to the left and to the right of the moment shown.
constexpr double leastPast = 0.4;
constexpr double leastFuture = 0.2;

/// A zoomed window that follows keeps this part of itself beyond the moment.
constexpr double followPart = 0.1;

/// In and out again is where it began.
constexpr double timeRounding = 1e-9;

bool holds(const TimeWindow::Span &span, double time)
{
    return time >= span.from && time <= span.to;
}

} // namespace

void TimeWindow::show(Kind kind)
{
    m_kind = kind;
    m_before = kind;
    emit changed();
}

void TimeWindow::zoomTo(Span span, Span whole)
{
    if (span.length() >= (1.0 - timeRounding) * whole.length())
        return show(Kind::All);
    if (m_kind != Kind::Zoomed)
        m_before = m_kind;
    m_kind = Kind::Zoomed;
    const double length = std::max(span.length(), narrowest);
    m_zoom.from = std::clamp(span.from, whole.from, whole.to - length);
    m_zoom.to = m_zoom.from + length;
    emit changed();
}

void TimeWindow::zoomBy(double factor, double about, Span shown, Span whole)
{
    const double length = std::max(factor * shown.length(), narrowest);
    const double part = shown.length() > 0.0 ? (about - shown.from) / shown.length() : 0.5;
    const double from = about - part * length;
    zoomTo({from, from + length}, whole);
}

void TimeWindow::panBy(double seconds, Span shown, Span whole)
{
    zoomTo({shown.from + seconds, shown.to + seconds}, whole);
}

void TimeWindow::reset()
{
    show(m_before);
}

TimeWindow::Span TimeWindow::whole(double first, double end)
{
    const double grain = niceStep(aheadPart * (end - first));
    return {first, std::max(std::ceil(end / grain - 1e-9) * grain, first + narrowest)};
}

TimeWindow::Span TimeWindow::choose(Span run, double end, double shown)
{
    const double before = std::exchange(m_shown, shown);
    if (m_kind == Kind::Zoomed) {
        if (m_held || holds(m_zoom, shown) || !holds(m_zoom, before))
            return m_zoom;
        const double length = m_zoom.length();
        const double room = followPart * length;
        const Span all = whole(run.from, end);
        double from = shown > m_zoom.to ? shown + room - length : shown - room;
        from = std::clamp(from, all.from, std::max(all.from, all.to - length));
        m_zoom = {from, from + length};
        return m_zoom;
    }
    if (m_kind == Kind::All || run.length() <= lastSeconds) {
        m_lastStart = run.to - lastSeconds;
        return whole(run.from, m_kind == Kind::All ? end : run.to);
    }
    return lastOf(run, shown);
}

/// Moves no further than needed to hold the moment shown with what was before it and comes after
/// it.
TimeWindow::Span TimeWindow::lastOf(Span run, double shown)
{
    if (shown == run.to)
        m_lastStart = run.to - lastSeconds;
    const double past = m_held ? 0.0 : leastPast * lastSeconds;
    const double future = m_held ? 0.0 : leastFuture * lastSeconds;
    m_lastStart = std::clamp(m_lastStart, shown - lastSeconds + future, shown - past);
    m_lastStart = std::clamp(m_lastStart, run.from, run.to - lastSeconds);
    return {m_lastStart, m_lastStart + lastSeconds};
}

} // namespace cradle
