// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panes.h"

#include "app/announcer.h"
#include "app/notice_bar.h"
#include "app/workbench.h"
#include "views/charts/energy_chart.h"
#include "views/charts/momentum_chart.h"
#include "views/charts/phase_chart.h"
#include "views/charts/pinned_runs.h"
#include "views/charts/plots_chart.h"
#include "views/charts/speed_histogram.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"
#include "views/code/versions_pane.h"
#include "views/console_view.h"
#include "views/inspector/inspector.h"
#include "views/notes_pane.h"
#include "views/scene/scene_view.h"
#include "views/task_pane/task_pane.h"
#include "views/timeline.h"
#include "views/transport_bar.h"
#include "views/values/values_table.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QToolBar>
#include <QVBoxLayout>

namespace cradle {

namespace {

QToolBar *fixedBar(QMainWindow &window, Qt::ToolBarArea area, QWidget *content, const QString &name)
{
    auto *bar = new QToolBar(&window);
    bar->setObjectName(name);
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->toggleViewAction()->setEnabled(false);
    bar->addWidget(content);
    window.addToolBar(area, bar);
    return bar;
}

/// What is to be said stands across the whole window, where it takes no room from the scene.
QWidget *stacked(QWidget *upper, QWidget *lower, QWidget *parent)
{
    auto *both = new QWidget(parent);
    auto *rows = new QVBoxLayout(both);
    rows->setContentsMargins({});
    rows->setSpacing(0);
    rows->addWidget(upper);
    rows->addWidget(lower);
    return both;
}

} // namespace

Panes::Panes(QMainWindow &mainWindow, Workbench &workbench, RunCurves &curves, TimeWindow &time,
             PinnedRuns &pins)
    : window(mainWindow)
    , transport(new TransportBar(workbench.simulation(), &window))
    , notice(new NoticeBar(&window))
    , topBar(fixedBar(window, Qt::TopToolBarArea, stacked(transport, notice, &window),
                      QStringLiteral("transport")))
    , timeline(new Timeline(workbench.simulation(), &window))
    , bottomBar(fixedBar(window, Qt::BottomToolBarArea, timeline, QStringLiteral("timeline")))
    , announcer(new Announcer(&window))
    , scene(new SceneView(workbench.document(), &window))
    , task(new TaskPane(&window))
    , code(new CodePane(&window))
    , inspector(new Inspector(workbench.document(), &window))
    , versions(new VersionsPane(&window))
    , notes(new NotesPane(&window))
    , momentum(new MomentumChart(workbench.simulation(), curves, &window))
    , energy(new EnergyChart(workbench.simulation(), curves, &window))
    , values(new ValuesPane(workbench.simulation(), &window))
    , console(new ConsoleView(workbench.simulation(), &window))
    , plots(new PlotsChart(workbench.simulation(), curves, &window))
    , speeds(new SpeedHistogram(workbench.simulation(), &window))
    , phase(new PhaseChart(workbench.simulation(), &window))
    , taskDock(addDock(task, "task", Qt::LeftDockWidgetArea))
    , codeDock(addDock(code, "code", Qt::BottomDockWidgetArea))
    , inspectorDock(addDock(inspector, "inspector", Qt::BottomDockWidgetArea))
    , versionsDock(addDock(versions, "versions", Qt::BottomDockWidgetArea))
    , notesDock(addDock(notes, "notes", Qt::BottomDockWidgetArea))
    , momentumDock(addDock(momentum, "momentum", Qt::RightDockWidgetArea))
    , energyDock(addDock(energy, "energy", Qt::RightDockWidgetArea))
    , valuesDock(addDock(values, "values", Qt::RightDockWidgetArea))
{
    announcer->follow(workbench.simulation());
    window.setCentralWidget(scene);
    code->setTitle({}); // its tab tells it
    values->addTab(console, console->windowTitle());
    values->addTab(plots, plots->windowTitle());
    values->addTab(speeds, speeds->windowTitle());
    values->addTab(phase, phase->windowTitle());
    for (PlotPane *pane : plotPanes())
        pane->share(time, pins);
}

Panes::~Panes()
{
    window.hide(); // nothing is laid out anew for what is left
    for (QDockWidget *dock : docks)
        delete dock;
    delete window.takeCentralWidget();
    delete bottomBar;
    delete topBar;
    delete announcer;
}

/// By its name a kept layout knows it.
QDockWidget *Panes::addDock(QWidget *widget, const char *name, Qt::DockWidgetArea area)
{
    auto *dock = new QDockWidget(&window);
    dock->setObjectName(QLatin1String(name));
    dock->setWidget(widget);
    window.addDockWidget(area, dock);
    docks.push_back(dock);
    return dock;
}

void Panes::retranslate()
{
    taskDock->setWindowTitle(tr("Step"));
    codeDock->setWindowTitle(tr("lab.lua"));
    inspectorDock->setWindowTitle(tr("Inspector"));
    versionsDock->setWindowTitle(tr("Versions"));
    notesDock->setWindowTitle(tr("Notes"));
    momentumDock->setWindowTitle(tr("Momentum"));
    energyDock->setWindowTitle(tr("Energy"));
    valuesDock->setWindowTitle(tr("Values"));
    for (QWidget *tab : std::initializer_list<QWidget *>{console, plots, speeds, phase})
        values->setTabTitle(tab, tab->windowTitle());
}

QDockWidget *Panes::workplace(Mode mode) const
{
    return mode == Mode::Code ? codeDock : inspectorDock;
}

void Panes::showCode(int line)
{
    codeDock->show();
    codeDock->raise();
    if (line > 0)
        code->editor().goToLine(line);
    code->editor().setFocus(Qt::ShortcutFocusReason);
}

std::array<ChartPane *, 3> Panes::charts() const
{
    return {momentum, energy, plots};
}

std::array<PlotPane *, 4> Panes::plotPanes() const
{
    return {momentum, energy, plots, phase};
}

} // namespace cradle
