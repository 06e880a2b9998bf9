// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/step_desk.h"

#include "app/panes.h"
#include "app/room.h"
#include "app/workbench.h"
#include "views/charts/speed_histogram.h"
#include "views/task_pane/task_pane.h"
#include "views/transport_bar.h"
#include "views/values/values_table.h"

#include <QAction>
#include <QDockWidget>
#include <QSettings>
#include <QTabWidget>

namespace cradle {

StepDesk::StepDesk(Workbench &workbench, Panes &panes, Room &room, QSettings &settings)
    : m_workbench(workbench)
    , m_panes(panes)
    , m_room(room)
    , m_settings(settings)
{
    Workbench *bench = &workbench;
    connect(bench, &Workbench::labChanged, this,
            [this] { m_panes.task->setLab(m_workbench.lab()); });
    connect(bench, &Workbench::taskChanged, this, &StepDesk::showTask);
    connect(bench, &Workbench::modeChanged, this, &StepDesk::showMode);
    // Who has passed is shown what was to be predicted.
    for (const auto counted : {&WorkCheck::countedLater, &WorkCheck::reported}) {
        connect(&bench->check(), counted, this, &StepDesk::showProgress);
        connect(&bench->check(), counted, this, &StepDesk::showGuess);
    }
    connect(&bench->progress(), &KeptProgress::guessChanged, this, &StepDesk::showGuess);
    connect(&bench->document(), &PresetDocument::edited, this, &StepDesk::showProgress);
    connect(panes.transport, &TransportBar::modeChosen, this, &StepDesk::chooseMode);
    wireTaskPane();
}

void StepDesk::wireTaskPane()
{
    Workbench *bench = &m_workbench;
    KeptProgress *progress = &m_workbench.progress();
    connect(m_panes.task, &TaskPane::stepChosen, bench, &Workbench::openTaskAt);
    connect(m_panes.task, &TaskPane::hintOpened, progress, &KeptProgress::setHintsOpened);
    connect(m_panes.task, &TaskPane::predicted, progress, &KeptProgress::predict);
    connect(m_panes.task, &TaskPane::answered, progress, &KeptProgress::answer);
    connect(m_panes.task, &TaskPane::outcomeRequested, progress, &KeptProgress::revealOutcome);
    connect(m_panes.task, &TaskPane::nextStepRequested, bench, &Workbench::openNextTask);
    connect(m_panes.task, &TaskPane::passedSceneRequested, &bench->waysBack(),
            &WaysBack::takePassedScene);
}

void StepDesk::showTask()
{
    const Task *task = m_workbench.task();
    m_panes.transport->checkAction()->setEnabled(task != nullptr);
    showRoom();
    showProgress();
    if (task) {
        showInstructions();
        // An example brought the speeds to the front; the few circles of a step have none to show.
        if (m_panes.values->tabs().currentWidget() == m_panes.speeds)
            m_panes.values->tabs().setCurrentIndex(0);
    } else {
        showLooseScene();
    }
}

/// Of the open step, as the mode has them.
void StepDesk::showInstructions()
{
    m_panes.task->showTask(taskFor(m_workbench.mode(), *m_workbench.task()),
                           m_workbench.progress().hintsOpened());
    showGuess();
    m_panes.task->setAnswers(m_workbench.progress().answers());
}

void StepDesk::showGuess()
{
    m_panes.task->setGuess(m_workbench.progress().guess());
}

void StepDesk::showProgress()
{
    m_panes.task->setProgress(m_workbench.progress().passed(), m_workbench.current(),
                              m_workbench.progress().pass());
    m_panes.task->setAwaitsRun(m_workbench.check().awaitsRun());
    m_panes.task->setOffersSolution(m_workbench.mode() == Mode::Code
                                    && m_workbench.progress().mayShowSolution());
    m_panes.task->setOffersPassedScene(m_workbench.waysBack().passedScene().has_value());
}

/// An example tells what there is to see, and the tab that shows it comes to the front.
void StepDesk::showLooseScene()
{
    Task scene;
    if (const auto example = m_workbench.example()) {
        scene.title = titleOf(*example);
        scene.instructions = QStringLiteral("# %1\n\n%2").arg(scene.title, textOf(*example));
        if (showsSpeeds(*example))
            m_panes.values->tabs().setCurrentWidget(m_panes.speeds);
    } else {
        scene.title = m_workbench.document().preset().name;
        scene.instructions =
            tr("# %1\n\nThis scene belongs to no step: play with it. Choose a step "
               "above to go back to the lab.")
                .arg(scene.title.isEmpty() ? tr("A scene of your own") : scene.title);
    }
    m_panes.task->showTask(scene, 0);
}

/// The pane that the student works with comes to the front.
void StepDesk::showRoom()
{
    const Mode mode = m_workbench.mode();
    m_panes.transport->setModes(m_workbench.task() ? QStringList{tr("Explore"), tr("Code")}
                                                   : QStringList(),
                                mode == Mode::Code ? 1 : 0);
    m_room.showMode(mode);
    m_panes.workplace(mode)->raise();
}

/// The texts follow.
void StepDesk::showMode()
{
    showRoom();
    showProgress();
    if (m_workbench.task())
        showInstructions();
}

void StepDesk::chooseMode(int index)
{
    const Mode mode = index == 1 ? Mode::Code : Mode::Explore;
    m_settings.setValue(QStringLiteral("mode"), index);
    m_workbench.setMode(mode);
}

void StepDesk::focusCode()
{
    if (!m_workbench.task())
        return;
    if (m_workbench.mode() != Mode::Code)
        chooseMode(1);
    m_panes.showCode();
}

} // namespace cradle
