// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_desk.h"

#include "app/notice_bar.h"
#include "app/panes.h"
#include "app/sounds.h"
#include "app/workbench.h"
#include "views/charts/chart_pane.h"
#include "views/charts/phase_chart.h"
#include "views/charts/speed_histogram.h"
#include "views/scene/scene_view.h"
#include "views/sound/tone.h"
#include "views/values/values_table.h"

#include <QFileDialog>

namespace cradle {

RunDesk::RunDesk(Workbench &workbench, Panes &panes, const RunCurves &curves, PinnedRuns &pins,
                 Sounds &sounds)
    : m_workbench(workbench)
    , m_panes(panes)
    , m_curves(curves)
    , m_pins(pins)
    , m_sounds(sounds)
{
    wireCharts();
}

void RunDesk::wireCharts()
{
    Simulation *simulation = &m_workbench.simulation();
    for (PlotPane *pane : m_panes.plotPanes()) {
        connect(pane, &PlotPane::seekRequested, simulation, [simulation](double time) {
            simulation->seek(simulation->recording().indexAt(time));
        });
        connect(pane, &PlotPane::curvePlayed, this, [this](const std::vector<double> &values) {
            m_sounds.play(samplesOfCurve(values));
        });
        connect(pane, &PlotPane::runRequested, simulation, &Simulation::start);
        connect(pane, &PlotPane::pinRequested, this, &RunDesk::pinRun);
        connect(pane, &PlotPane::failed, this,
                [this](const Error &error) { m_panes.notice->showNotice(error.toString()); });
    }
    connect(m_panes.speeds, &SpeedHistogram::curvePlayed, this,
            [this](const std::vector<double> &shares) { m_sounds.play(samplesOfCurve(shares)); });
    connect(simulation, &Simulation::restarted, this, [this] { m_pins.setNow(runSource()); });
    connect(&m_workbench, &Workbench::taskChanged, this, [this] { m_pins.clear(); });
    connect(m_panes.scene, &SceneView::newRunRequested, this, &RunDesk::startNewRunHere);
    m_pins.setNow(runSource());
}

RunSource RunDesk::runSource()
{
    return {m_workbench.simulation().preset(), m_workbench.code().run().text()};
}

void RunDesk::pinRun()
{
    if (m_pins.isFull()) {
        m_panes.notice->showNotice(tr("%n runs are pinned; remove one of them first.", nullptr,
                                      static_cast<int>(PinnedRuns::most)));
        return;
    }
    if (m_workbench.simulation().recording().last() == 0) {
        m_panes.notice->showNotice(tr("There is no run yet: press Run, then pin it."));
        return;
    }
    m_pins.add(PinnedRuns::keep(m_curves.whole(PinnedRuns::curveBytes),
                                m_workbench.simulation().recording(), m_pins.now()));
}

/// What came after the moment shown is kept, so that the new run can be compared with it.
void RunDesk::startNewRunHere()
{
    const Simulation &simulation = m_workbench.simulation();
    if (simulation.atStart())
        return;
    const bool wentOn = simulation.current() < simulation.recording().last();
    const std::vector<Circle> wanted = simulation.recording().world(simulation.current()).circles;
    PinnedRun old = PinnedRuns::keep(m_curves.whole(PinnedRuns::curveBytes), simulation.recording(),
                                     m_pins.now(), simulation.time());
    if (!m_workbench.document().startFromMoment())
        return;
    if (wentOn)
        m_pins.add(std::move(old));
    const auto &circles = simulation.preset().circles;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        if (circles[i].body == wanted[i])
            continue;
        m_panes.notice->showNotice(
            tr("Your program sets values of circles when it is loaded: the new run "
               "starts with those."));
        return;
    }
}

void RunDesk::exportRun(RunTable table)
{
    const QString names[] = {QStringLiteral("states.csv"), QStringLiteral("totals.csv"),
                             QStringLiteral("events.csv")};
    const QString path =
        QFileDialog::getSaveFileName(m_panes.values->window(), tr("Save the data of the run"),
                                     names[static_cast<int>(table)], tr("Tables (*.csv)"));
    if (path.isEmpty())
        return;
    const Simulation &simulation = m_workbench.simulation();
    if (const auto error = saveRunTable(table, simulation.recording(), simulation.preset(), path))
        m_panes.notice->showNotice(error->toString());
}

void RunDesk::resetCharts()
{
    for (PlotPane *pane : m_panes.plotPanes())
        pane->resetZoom();
}

} // namespace cradle
