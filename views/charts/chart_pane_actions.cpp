// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Zoom and menu of ChartPane.
#include "views/charts/chart_pane.h"

#include "views/charts/chart_export.h"
#include "views/charts/frame_throttle.h"
#include "views/menu.h"

#include <QContextMenuEvent>

#include <utility>

namespace cradle {

namespace {

constexpr double keyZoom = 1.5; ///< of a press of a key

} // namespace

void ChartPane::wirePlot()
{
    connect(m_plot, &Plot::pickingBegan, this, &ChartPane::keepMoment);
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
    connect(m_plot, &Plot::zoomed, this, [this](QPointF about, double factor, bool upOnly) {
        if (!upOnly)
            m_window->zoomBy(factor, about.x(), m_plot->timeSpan(), whole());
        else if (const auto values = zoomed(m_plot->upSpan(), factor, about.y()))
            zoomTo(values);
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
    connect(m_plot, &Plot::resetRequested, this, &ChartPane::resetByClick);
    connect(m_plot, &Plot::toldChanged, this, &ChartPane::describe);
    connect(m_plot, &Plot::played, this, &ChartPane::curvePlayed);
    connect(m_plot, &Plot::resized, this, &ChartPane::redraw);
}

void ChartPane::zoomTo(const std::optional<ValueSpan> &values)
{
    m_valueZoom = values;
    m_throttle->request();
}

void ChartPane::zoomIn()
{
    m_window->zoomBy(1.0 / keyZoom, m_simulation.time(), m_plot->timeSpan(), whole());
}

void ChartPane::zoomOut()
{
    m_window->zoomBy(keyZoom, m_simulation.time(), m_plot->timeSpan(), whole());
}

void ChartPane::keepMoment()
{
    m_beforeClick = BeforeClick{m_simulation.time(), m_simulation.isRunning()};
}

/// The first of the two clicks has gone to a moment, as a single one does.
void ChartPane::resetByClick()
{
    if (const auto before = std::exchange(m_beforeClick, std::nullopt)) {
        emit seekRequested(before->time);
        if (before->ran)
            emit runRequested();
    }
    resetZoom();
}

void ChartPane::resetZoom()
{
    zoomTo(std::nullopt);
    m_window->reset();
}

void ChartPane::contextMenuEvent(QContextMenuEvent *event)
{
    Menu menu(this);
    fillMenu(menu);
    menu.exec(event->globalPos());
}

void ChartPane::fillMenu(QMenu &menu)
{
    const bool isZoomed = m_window->kind() == TimeWindow::Kind::Zoomed || m_valueZoom;
    menu.addAction(tr("Zoom &in"), this, &ChartPane::zoomIn)->setEnabled(m_plot->showsRun());
    menu.addAction(tr("Zoom &out"), this, &ChartPane::zoomOut)->setEnabled(m_plot->showsRun());
    menu.addAction(tr("&Reset zoom"), this, &ChartPane::resetZoom)->setEnabled(isZoomed);
    if (m_pins) {
        menu.addSeparator();
        QAction *pin = menu.addAction(tr("&Pin this run"), this, &ChartPane::pinRequested);
        pin->setEnabled(!m_pins->isFull() && m_simulation.recording().last() > 0);
        for (const PinnedRun &run : m_pins->runs())
            menu.addAction(tr("Remove %1", "a kept run").arg(run.name()), m_pins,
                           [pins = m_pins, number = run.number] { pins->remove(number); });
    }
    menu.addSeparator();
    addExports(menu);
}

void ChartPane::addExports(QMenu &menu)
{
    const ChartExports exports{this, [this] { return picture(); }, [this] { return table(); },
                               [this](const Error &error) { emit failed(error); }};
    addExportActions(menu, exports, m_plot->showsRun());
}

} // namespace cradle
