// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/plot_pane.h"

#include "views/charts/pinned_runs.h"
#include "views/charts/plot.h"
#include "views/charts/quiet_button.h"
#include "views/frame_throttle.h"
#include "views/menu.h"
#include "views/theme.h"

#include <QContextMenuEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <utility>

namespace cradle {

namespace {

constexpr double keyZoom = 1.5; ///< of a press of a key

} // namespace

PlotPane::PlotPane(const Simulation &simulation, Plot *plot, QWidget *parent)
    : QWidget(parent)
    , m_simulation(simulation)
    , m_heading(new QLabel)
    , m_header(new QHBoxLayout)
    , m_column(new QVBoxLayout(this))
    , m_moreButton(new QuietButton)
    , m_throttle(new FrameThrottle(simulation, this))
    , m_window(new TimeWindow(this))
    , m_base(plot)
{
    setKind(m_heading, "heading");
    m_heading->setTextFormat(Qt::PlainText);
    m_heading->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_header->setContentsMargins(headingMargins);
    m_header->setSpacing(0);
    m_header->addWidget(m_heading, 1);
    m_moreButton->setText(QStringLiteral("⋯"));
    auto *menu = new Menu(m_moreButton);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        fillMenu(*menu);
    });
    m_moreButton->setMenu(menu, false);
    m_header->addWidget(m_moreButton);
    m_column->setContentsMargins({});
    m_column->setSpacing(4);
    m_column->addLayout(m_header);
    m_column->addWidget(plot, 1);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);

    connect(m_window, &TimeWindow::changed, m_throttle, &FrameThrottle::request);
    connect(m_throttle, &FrameThrottle::due, this, [this] { redraw(); });
    connect(plot, &Plot::resized, this, [this] { redraw(); });
    connect(plot, &Plot::pickingBegan, this, &PlotPane::keepMoment);
    connect(plot, &Plot::resetRequested, this, &PlotPane::resetByClick);
    connect(plot, &Plot::zoomed, this,
            [this](QPointF about, double factor, bool upOnly) { zoomBy(about, factor, upOnly); });
    connect(plot, &Plot::played, this, &PlotPane::curvePlayed);
}

void PlotPane::share(TimeWindow &window, PinnedRuns &pins)
{
    delete m_window;
    m_window = &window;
    m_pins = &pins;
    connect(m_window, &TimeWindow::changed, m_throttle, &FrameThrottle::request);
    connect(m_pins, &PinnedRuns::changed, m_throttle, &FrameThrottle::request);
}

void PlotPane::retranslate()
{
    m_moreButton->setToolTip(tr("Zoom, pin and export"));
    m_moreButton->setAccessibleName(m_moreButton->toolTip());
}

void PlotPane::setHeadingFont()
{
    m_heading->setFont(headingFont());
}

void PlotPane::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        setHeadingFont();
    else
        return;
    m_throttle->request();
}

void PlotPane::keepMoment()
{
    m_beforeClick = BeforeClick{m_simulation.time(), m_simulation.isRunning()};
}

/// The first of the two clicks has gone to a moment, as a single one does.
void PlotPane::resetByClick()
{
    if (const auto before = std::exchange(m_beforeClick, std::nullopt)) {
        emit seekRequested(before->time);
        if (before->ran)
            emit runRequested();
    }
    resetZoom();
}

void PlotPane::zoomIn()
{
    zoomBy(placeShown(), 1.0 / keyZoom, false);
}

void PlotPane::zoomOut()
{
    zoomBy(placeShown(), keyZoom, false);
}

void PlotPane::contextMenuEvent(QContextMenuEvent *event)
{
    Menu menu(this);
    fillMenu(menu);
    menu.exec(event->globalPos());
}

void PlotPane::fillMenu(QMenu &menu)
{
    menu.addAction(tr("Zoom &in"), this, &PlotPane::zoomIn)->setEnabled(m_base->showsRun());
    menu.addAction(tr("Zoom &out"), this, &PlotPane::zoomOut)->setEnabled(m_base->showsRun());
    menu.addAction(tr("&Reset zoom"), this, &PlotPane::resetZoom)->setEnabled(isZoomed());
    if (m_pins) {
        menu.addSeparator();
        QAction *pin = menu.addAction(tr("&Pin this run"), this, &PlotPane::pinRequested);
        pin->setEnabled(!m_pins->isFull() && m_simulation.recording().last() > 0);
        for (const PinnedRun &run : m_pins->runs())
            menu.addAction(tr("Remove %1", "a kept run").arg(run.name()), m_pins,
                           [pins = m_pins, number = run.number] { pins->remove(number); });
    }
    menu.addSeparator();
    addExports(menu);
}

void PlotPane::addExports(QMenu &menu)
{
    redraw(); // which may be due, or never was while the pane was hidden
    const ChartExports exports{this, [this] { return picture(); }, [this] { return table(); },
                               [this](const Error &error) { emit failed(error); }};
    addExportActions(menu, exports, m_base->showsRun());
}

} // namespace cradle
