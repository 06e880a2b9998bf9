// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "app/code_desk.h"
#include "app/lab_drop.h"
#include "app/notice_bar.h"
#include "tasks/lab_report/lab_report.h"
#include "views/announcer.h"
#include "views/charts/phase_chart.h"
#include "views/charts/speed_histogram.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"
#include "views/console_view.h"
#include "views/inspector/inspector.h"
#include "views/scene/scene_view.h"
#include "views/task_pane/result_cards.h"
#include "views/task_pane/task_pane.h"
#include "views/timeline.h"
#include "views/transport_bar.h"
#include "views/values_table.h"

#include <QDockWidget>
#include <QSettings>

#include <algorithm>

namespace cradle {

// What follows what: the workbench, the panes and each other.

void MainWindow::wireWorkbench()
{
    Workbench *bench = &m_workbench;
    connect(bench, &Workbench::labChanged, this, [this] { m_taskPane->setLab(m_workbench.lab()); });
    connect(bench, &Workbench::taskChanged, this, &MainWindow::showTask);
    connect(bench, &Workbench::progressChanged, this, &MainWindow::showProgress);
    connect(bench, &Workbench::guessChanged, this,
            [this] { m_taskPane->setGuess(m_workbench.guess()); });
    connect(bench, &Workbench::reportChanged, this, &MainWindow::showReport);
    connect(bench, &Workbench::reportChanged, this, &MainWindow::announceVerdict);
    connect(bench, &Workbench::reportStale, m_taskPane, &TaskPane::setStale);
    connect(bench, &Workbench::checkStarted, this, [this] {
        m_transport->setChecking(true);
        m_taskPane->setChecking(true);
    });
    connect(bench, &Workbench::checkProgressed, this, [this](int done, int total) {
        m_transport->setCheckProgress(total > 0 ? double(done) / total : 0.0);
        m_taskPane->setChecking(true, done, total);
    });
    connect(bench, &Workbench::checkEnded, this, [this] {
        m_transport->setChecking(false);
        m_taskPane->setReport(m_workbench.report());
    });
    wireKeeping();
    connect(new LabDrop(this), &LabDrop::dropped, this, &MainWindow::openLab);
    connect(bench, &Workbench::modeChanged, this, &MainWindow::showMode);
    connect(bench, &Workbench::ghostChanged, this, &MainWindow::showGhost);
    connect(&bench->code(), &CodeSession::paused, this, &MainWindow::showPause);
    connect(&bench->code(), &CodeSession::steppingEnded, this, &MainWindow::showGhost);
    connect(m_transport, &TransportBar::modeChosen, this, &MainWindow::chooseMode);
    connect(m_transport, &TransportBar::checkRequested, bench, &Workbench::check);
    connect(m_transport, &TransportBar::checkCancelled, bench, &Workbench::cancelCheck);
    connect(m_taskPane, &TaskPane::stepChosen, bench, &Workbench::openTaskAt);
    connect(m_taskPane, &TaskPane::hintOpened, bench, &Workbench::setHintsOpened);
    connect(m_taskPane, &TaskPane::predicted, bench, &Workbench::predict);
    connect(m_taskPane, &TaskPane::answered, bench, &Workbench::answer);
    connect(m_taskPane, &TaskPane::outcomeRequested, bench, &Workbench::revealOutcome);
    connect(m_taskPane, &TaskPane::showMoment, bench, &Workbench::showMoment);
    connect(m_taskPane, &TaskPane::nextStepRequested, bench, &Workbench::openNextTask);
    connect(m_taskPane, &TaskPane::lineRequested, this, &MainWindow::showLine);
    connect(m_taskPane, &TaskPane::solutionRequested, m_code, &CodePane::solutionRequested);
    connect(m_taskPane, &TaskPane::passedSceneRequested, bench, &Workbench::backToPassedScene);
}

void MainWindow::wireViews()
{
    Simulation *simulation = &m_workbench.simulation();
    PresetDocument *document = &m_workbench.document();
    connect(m_scene, &SceneView::selectionChanged, m_inspector, &Inspector::select);
    connect(m_inspector, &Inspector::selectionChanged, m_scene, &SceneView::select);
    connect(document, &PresetDocument::visitingChanged, this, &MainWindow::showVisit);
    connect(document, &PresetDocument::edited, this, &MainWindow::showProgress);
    connect(simulation, &Simulation::frameReady, this, [this] {
        if (m_saidFault.value_or(false) != m_workbench.showsFault() && m_saidFault)
            showVisit(true);
    });
    connect(m_notice, &NoticeBar::actionTriggered, document, &PresetDocument::leave);
    wireCharts();
    connect(m_values, &ValuesPane::seekRequested, simulation, &Simulation::seek);
    connect(m_console, &ConsoleView::seekRequested, simulation, &Simulation::seek);
    connect(m_console, &ConsoleView::lineActivated, this, &MainWindow::showLine);
    connect(m_console, &ConsoleView::errorShown, this,
            [this](bool shown) { m_values->markTab(m_console, shown); });
    connect(simulation, &Simulation::noHitFound, this,
            [this] { m_notice->showNotice(tr("Nothing hits anything within the next minute.")); });
}

void MainWindow::showTask()
{
    const Task *task = m_workbench.task();
    m_transport->checkAction()->setEnabled(task != nullptr);
    showProgress();
    if (task) {
        showInstructions();
        // An example brought the speeds to the front; the few circles of a step have none to show.
        if (m_values->tabs().currentWidget() == m_speeds)
            m_values->tabs().setCurrentIndex(0);
    } else {
        showLooseScene();
    }
    m_notice->clearNotice();
    showTaskNotice();
    retranslate();
}

void MainWindow::showProgress()
{
    m_taskPane->setProgress(m_workbench.passed(), m_workbench.current(), m_workbench.pass());
    m_taskPane->setAwaitsRun(m_workbench.awaitsRun());
    m_taskPane->setOffersSolution(m_workbench.mode() == Mode::Code
                                  && m_workbench.mayShowSolution());
    m_taskPane->setOffersPassedScene(m_workbench.passedScene().has_value());
}

/// An example tells what there is to see, and the tab that shows it comes to the front.
void MainWindow::showLooseScene()
{
    Task scene;
    if (const auto example = m_workbench.example()) {
        scene.title = titleOf(*example);
        scene.instructions = QStringLiteral("# %1\n\n%2").arg(scene.title, textOf(*example));
        if (showsSpeeds(*example))
            m_values->tabs().setCurrentWidget(m_speeds);
    } else {
        scene.title = m_workbench.document().preset().name;
        scene.instructions =
            tr("# %1\n\nThis scene belongs to no step: play with it. Choose a step "
               "above to go back to the lab.")
                .arg(scene.title.isEmpty() ? tr("A scene of your own") : scene.title);
    }
    m_taskPane->showTask(scene, 0);
}

/// The pane that the student works with comes to the front; the texts follow.
void MainWindow::showMode()
{
    const bool code = m_workbench.mode() == Mode::Code;
    const bool hasStep = m_workbench.task() != nullptr;
    m_transport->setModes(hasStep ? QStringList{tr("Explore"), tr("Code")} : QStringList(),
                          code ? 1 : 0);
    showArrangement();
    dock(code ? "code" : "inspector")->raise();
    if (hasStep)
        showInstructions();
}

/// Of the open step, as the mode has them.
void MainWindow::showInstructions()
{
    m_taskPane->showTask(taskFor(m_workbench.mode(), *m_workbench.task()),
                         m_workbench.hintsOpened());
    m_taskPane->setGuess(m_workbench.guess());
    m_taskPane->setAnswers(m_workbench.answers());
}

void MainWindow::chooseMode(int index)
{
    const Mode mode = index == 1 ? Mode::Code : Mode::Explore;
    m_settings.setValue(QStringLiteral("mode"), index);
    m_workbench.setMode(mode);
}

void MainWindow::showGhost()
{
    m_scene->setGhost(m_workbench.ghost(), tr("reference"));
}

/// In the middle of an update the circles are where the program has put them so far.
void MainWindow::showPause(const StudentScript::Pause &pause)
{
    auto soFar = std::make_shared<Recording>();
    soFar->append({.time = m_workbench.simulation().time(), .step = 0, .circles = pause.circles});
    m_scene->setGhost(soFar, tr("so far in this step"));
}

void MainWindow::showLine(int line)
{
    dock("code")->raise();
    m_code->editor().goToLine(line);
    m_code->editor().setFocus();
}

void MainWindow::titleTabs()
{
    m_values->setTabTitle(m_console, m_console->windowTitle());
    m_values->setTabTitle(m_plots, m_plots->windowTitle());
    m_values->setTabTitle(m_speeds, m_speeds->windowTitle());
    m_values->setTabTitle(m_phase, m_phase->windowTitle());
}

/// In the words of the result's first line.
void MainWindow::announceVerdict()
{
    const std::optional<CheckReport> &report = m_workbench.report();
    if (!report)
        return;
    const Finding *found = report->diagnosis();
    const auto failed = std::find_if(report->checks.begin(), report->checks.end(),
                                     [](const CheckOutcome &check) { return !check.passed; });
    if (report->passed)
        m_announcer->say(tr("Check passed."));
    else if (report->error)
        m_announcer->say(describeError(*report->error).headline);
    else if (found)
        m_announcer->say(tr("Not yet: %1").arg(headlineOf(found->message)));
    else if (failed != report->checks.end())
        m_announcer->say(tr("Not yet: %1").arg(failed->title));
}

void MainWindow::showReport()
{
    showProgress();
    m_taskPane->setReport(m_workbench.report());
    m_desk->showReport();
    std::vector<Timeline::Mark> marks;
    const Preset &own = m_workbench.document().own();
    if (m_workbench.report()) {
        for (const CheckOutcome &check : m_workbench.report()->checks) {
            if (!check.passed && check.scene == own && !check.pinned)
                marks.push_back({.time = static_cast<double>(check.step) * own.timestep,
                                 .label = tr("Not yet: %1").arg(check.title)});
        }
    }
    m_timeline->setMarks(marks);
}

/// Of the moment only while it is the one shown.
void MainWindow::showVisit(bool visiting)
{
    m_saidFault = visiting ? std::optional(m_workbench.showsFault()) : std::nullopt;
    if (visiting)
        m_notice->showNotice(
            *m_saidFault ? tr("This is a scene of the check, at the moment where it went wrong.")
                         : tr("This is a scene of the check."),
            tr("Back to my scene"));
    else
        m_notice->clearNotice();
}

} // namespace cradle
