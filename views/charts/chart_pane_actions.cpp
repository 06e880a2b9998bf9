// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Pointer and zoom of ChartPane.
#include "views/charts/chart_pane.h"

#include "views/frame_throttle.h"

namespace cradle {

void ChartPane::wirePlot()
{
    connect(m_plot, &ChartPlot::timePicked, this, [this](double time) {
        m_window->setHeld(true);
        emit seekRequested(time);
    });
    connect(m_plot, &ChartPlot::hitPicked, this, [this](qint64 step) {
        m_window->setHeld(true);
        const Recording &recording = m_simulation.recording();
        const qint64 frame = recording.first() + step - recording.step(recording.first());
        if (frame >= recording.first() && frame <= recording.last())
            emit seekRequested(recording.time(frame));
    });
    connect(m_plot, &Plot::pickingEnded, this, [this] {
        m_window->setHeld(false);
        m_throttle->request();
    });
    connect(m_plot, &Plot::boxChosen, this,
            [this](const ValueSpan &times, const std::optional<ValueSpan> &values) {
                if (values)
                    zoomTo(values);
                m_window->zoomTo({times.low, times.high}, whole());
            });
    connect(m_plot, &Plot::panned, this, [this](QPointF way) {
        if (m_valueZoom)
            zoomTo(ValueSpan{m_valueZoom->low + way.y(), m_valueZoom->high + way.y()});
        m_window->panBy(way.x(), m_plot->timeSpan(), whole());
    });
    connect(m_plot, &Plot::toldChanged, this, &ChartPane::describe);
}

void ChartPane::zoomTo(const std::optional<ValueSpan> &values)
{
    m_valueZoom = values;
    m_throttle->request();
}

void ChartPane::zoomBy(QPointF about, double factor, bool upOnly)
{
    if (!upOnly)
        m_window->zoomBy(factor, about.x(), m_plot->timeSpan(), whole());
    else if (const auto values = zoomed(m_plot->upSpan(), factor, about.y()))
        zoomTo(values);
}

void ChartPane::resetZoom()
{
    zoomTo(std::nullopt);
    m_window->reset();
}

bool ChartPane::isZoomed() const
{
    return m_window->kind() == TimeWindow::Kind::Zoomed || m_valueZoom;
}

} // namespace cradle
