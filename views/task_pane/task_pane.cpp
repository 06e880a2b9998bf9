// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/task_pane.h"

#include "views/task_pane/instructions_pane.h"
#include "views/task_pane/result_pane.h"
#include "views/task_pane/steps_list.h"
#include "views/theme.h"

#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

constexpr int narrowestPane = 260;    ///< px
constexpr int resultHeight = 320;     ///< px, with a report; the student may change it
constexpr int passedHeight = 190;     ///< px, of a step that was passed before
constexpr double resultShare = 0.38;  ///< of the pane, at most
constexpr int emptyResultHeight = 64; ///< px, while there is none, at the usual size of texts

} // namespace

TaskPane::TaskPane(QWidget *parent)
    : QWidget(parent)
    , m_steps(new StepsList)
    , m_instructions(new InstructionsPane)
    , m_result(new ResultPane(m_instructions->renderer()))
{
    setMinimumWidth(narrowestPane);
    auto *splitter = new QSplitter(Qt::Vertical, this);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_instructions);
    splitter->addWidget(m_result);
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 0);
    m_splitter = splitter;
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_steps);
    column->addWidget(splitter, 1);
    // The open list has the room of the instructions, for a moment.
    connect(m_steps, &StepsList::openChanged, this, [this, column](bool open) {
        m_splitter->setVisible(!open);
        column->setStretchFactor(m_steps, open ? 1 : 0);
    });
    connect(splitter, &QSplitter::splitterMoved, this, [this] { m_shared = true; });
    connect(m_steps, &StepsList::stepChosen, this, &TaskPane::stepChosen);
    connect(m_instructions, &InstructionsPane::stepRequested, this, &TaskPane::chooseById);
    connect(m_instructions, &InstructionsPane::hintOpened, this, &TaskPane::hintOpened);
    connect(m_instructions, &InstructionsPane::predicted, this, &TaskPane::predicted);
    connect(m_instructions, &InstructionsPane::answered, this, &TaskPane::answered);
    connect(m_instructions, &InstructionsPane::outcomeRequested, this, &TaskPane::outcomeRequested);
    connect(m_result, &ResultPane::showMoment, this, &TaskPane::showMoment);
    connect(m_result, &ResultPane::nextStepRequested, this, &TaskPane::nextStepRequested);
    connect(m_result, &ResultPane::lineRequested, this, &TaskPane::lineRequested);
    connect(m_result, &ResultPane::solutionRequested, this, &TaskPane::solutionRequested);
    connect(m_result, &ResultPane::passedSceneRequested, this, &TaskPane::passedSceneRequested);
}

void TaskPane::setLab(const Lab &lab)
{
    m_taskIds.clear();
    for (const Task &task : lab.tasks)
        m_taskIds.append(task.id);
    m_steps->setLab(lab);
}

void TaskPane::setProgress(const std::vector<bool> &passed, int current, const Pass &pass)
{
    m_steps->setProgress(passed, current);
    QStringList stillOpen;
    for (std::size_t i = 0; i < passed.size(); ++i) {
        if (!passed[i] && static_cast<int>(i) != current)
            stillOpen.append(QString::number(i + 1));
    }
    const auto index = static_cast<std::size_t>(current);
    const bool hasPassed = current >= 0 && index < passed.size() && passed[index];
    m_result->setHasStep(current >= 0);
    m_result->setPassed(hasPassed, pass);
    if (hasPassed != m_hasPassed) {
        m_hasPassed = hasPassed;
        shareHeight();
    }
    m_result->setLast(current >= 0 && current + 1 == static_cast<int>(passed.size()), stillOpen);
}

void TaskPane::showTask(const Task &task, int hintsOpened)
{
    m_instructions->showTask(task, hintsOpened);
}

void TaskPane::setHintsOpened(int count)
{
    m_instructions->setHintsOpened(count);
}

void TaskPane::setAnswers(const QJsonObject &answers)
{
    m_instructions->setAnswers(answers);
}

void TaskPane::setGuess(const Guess &guess)
{
    m_instructions->setGuess(guess);
}

void TaskPane::setReport(const std::optional<CheckReport> &report)
{
    m_result->setReport(report);
    if (report.has_value() != m_hasReport) {
        m_hasReport = report.has_value();
        shareHeight();
    }
}

/// Room that the result does not need belongs to the instructions.
void TaskPane::shareHeight()
{
    const int most = static_cast<int>(resultShare * height());
    const int wanted = m_hasReport   ? resultHeight
                       : m_hasPassed ? passedHeight
                                     : scaledByText(emptyResultHeight);
    const int result = std::min(wanted, most);
    const int whole = m_splitter->height();
    m_splitter->setSizes({std::max(1, whole - result), result});
}

void TaskPane::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    layout()->activate();
    if (!m_shared)
        shareHeight();
}

void TaskPane::setChecking(bool checking, int done, int total)
{
    m_result->setChecking(checking, done, total);
}

void TaskPane::setOffersPassedScene(bool offers)
{
    m_result->setOffersPassedScene(offers);
}

void TaskPane::setOffersSolution(bool offers)
{
    m_result->setOffersSolution(offers);
}

void TaskPane::setAwaitsRun(bool awaits)
{
    m_result->setAwaitsRun(awaits);
}

void TaskPane::setStale(bool stale)
{
    m_result->setStale(stale);
}

void TaskPane::chooseById(const QString &taskId)
{
    const auto step = static_cast<int>(m_taskIds.indexOf(taskId));
    if (step >= 0)
        emit stepChosen(step);
}

} // namespace cradle
