// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_desk.h"

#include "app/notice_bar.h"
#include "app/panes.h"
#include "app/workbench.h"
#include "views/console_view.h"
#include "views/inspector/inspector.h"
#include "views/scene/scene_view.h"
#include "views/values/values_table.h"

namespace cradle {

SceneDesk::SceneDesk(Workbench &workbench, Panes &panes)
    : m_workbench(workbench)
    , m_panes(panes)
{
    PresetDocument *document = &workbench.document();
    connect(panes.scene, &SceneView::selectionChanged, panes.inspector, &Inspector::select);
    connect(panes.inspector, &Inspector::selectionChanged, panes.scene, &SceneView::select);
    connect(document, &PresetDocument::visitingChanged, this, &SceneDesk::showVisit);
    connect(&workbench.moment(), &FaultMoment::ghostChanged, this, &SceneDesk::showGhost);
    connect(&workbench.code().run(), &CodeRun::paused, this, &SceneDesk::showPause);
    connect(&workbench.code().run(), &CodeRun::steppingEnded, this, &SceneDesk::showGhost);
    wireValues();
}

void SceneDesk::wireValues()
{
    Simulation *simulation = &m_workbench.simulation();
    connect(simulation, &Simulation::frameReady, this, [this] {
        if (m_saidFault && *m_saidFault != m_workbench.moment().isShown())
            showVisit(true);
    });
    connect(simulation, &Simulation::noHitFound, this, [this] {
        m_panes.notice->showNotice(tr("Nothing hits anything within the next minute."));
    });
    connect(m_panes.values, &ValuesPane::seekRequested, simulation, &Simulation::seek);
    connect(m_panes.console, &ConsoleView::seekRequested, simulation, &Simulation::seek);
    connect(m_panes.console, &ConsoleView::lineActivated, this,
            [this](int line) { m_panes.showCode(line); });
    connect(m_panes.console, &ConsoleView::errorShown, this,
            [this](bool shown) { m_panes.values->markTab(m_panes.console, shown); });
}

void SceneDesk::showGhost()
{
    m_panes.scene->setGhost(m_workbench.moment().ghost(), tr("reference"));
}

/// In the middle of an update the circles are where the program has put them so far.
void SceneDesk::showPause(const StudentScript::Pause &pause)
{
    auto soFar = std::make_shared<Recording>();
    soFar->append({.time = m_workbench.simulation().time(), .step = 0, .circles = pause.circles});
    m_panes.scene->setGhost(soFar, tr("so far in this step"));
}

/// Of the moment only while it is the one shown.
void SceneDesk::showVisit(bool visiting)
{
    m_saidFault = visiting ? std::optional(m_workbench.moment().isShown()) : std::nullopt;
    if (visiting)
        m_panes.notice->showNotice(
            *m_saidFault ? tr("This is a scene of the check, at the moment where it went wrong.")
                         : tr("This is a scene of the check."),
            {{tr("Back to my scene"), [d = &m_workbench.document()] { d->leave(); }}});
    else
        m_panes.notice->clearNotice();
}

} // namespace cradle
