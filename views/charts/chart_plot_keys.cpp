// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Keyboard of ChartPlot: from curve to curve; the window's keys go from moment to moment.
#include "views/charts/chart_plot.h"

#include "views/charts/number_text.h"
#include "views/charts/plot_focus.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr std::size_t playedValues = 400; ///< of a curve that is heard

} // namespace

QString ChartPlot::toldCurve() const
{
    if (!m_showsRun || m_told < 0 || m_told >= static_cast<int>(m_curves.size()))
        return {};
    const ChartCurve &curve = m_curves[static_cast<std::size_t>(m_told)];
    const double value = curve.samples->valueAt(m_moment.shown + curve.shift);
    return tr("%1: %2", "curve, value").arg(curve.label, shortNumber(value, m_moment.scale));
}

/// Those without a name are no curves to speak of.
void ChartPlot::tellNext(int direction)
{
    const int count = static_cast<int>(m_curves.size());
    int next = m_told < 0 ? (direction > 0 ? -1 : count) : m_told;
    do {
        next += direction;
    } while (next >= 0 && next < count && m_curves[static_cast<std::size_t>(next)].label.isEmpty());
    if (next < 0 || next >= count)
        return;
    m_told = next;
    viewport()->update();
    emit curveTold();
}

/// Of what the run has recorded: beyond that there is nothing to hear.
void ChartPlot::playTold()
{
    if (toldCurve().isEmpty() || m_curves[static_cast<std::size_t>(m_told)].samples->isEmpty())
        return;
    const ChartCurve &curve = m_curves[static_cast<std::size_t>(m_told)];
    std::vector<double> values(playedValues);
    const double from = std::max(m_moment.from, curve.samples->firstTime() - curve.shift);
    const double length = std::min(m_moment.to, curve.samples->lastTime() - curve.shift) - from;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(values.size() - 1);
        values[i] = curve.samples->valueAt(from + share * length + curve.shift);
    }
    emit curvePlayed(values);
}

void ChartPlot::keyPressEvent(QKeyEvent *event)
{
    if (const int way = wayOf(*event))
        tellNext(way);
    else if (asksToHear(*event))
        playTold();
    else
        event->ignore(); // nothing here is scrolled
}

void ChartPlot::focusInEvent(QFocusEvent *event)
{
    QChartView::focusInEvent(event);
    if (toldCurve().isEmpty()) {
        m_told = -1;
        tellNext(1);
    }
    viewport()->update();
}

void ChartPlot::focusOutEvent(QFocusEvent *event)
{
    QChartView::focusOutEvent(event);
    viewport()->update();
}

} // namespace cradle
