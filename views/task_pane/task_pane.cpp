// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/task_pane.h"

#include "views/task_pane/instructions_pane.h"
#include "views/task_pane/result_pane.h"
#include "views/task_pane/steps_list.h"

#include <QSplitter>
#include <QVBoxLayout>

namespace cradle {

namespace {

constexpr int narrowest = 260;        ///< px
constexpr int resultHeight = 240;     ///< px, with a report; the student may change it
constexpr int emptyResultHeight = 64; ///< px, while there is none

} // namespace

TaskPane::TaskPane(QWidget *parent)
    : QWidget(parent)
    , m_steps(new StepsList)
    , m_instructions(new InstructionsPane)
    , m_result(new ResultPane)
{
    setMinimumWidth(narrowest);
    auto *splitter = new QSplitter(Qt::Vertical, this);
    splitter->setChildrenCollapsible(false);
    for (QWidget *part : {static_cast<QWidget *>(m_steps), static_cast<QWidget *>(m_instructions),
                          static_cast<QWidget *>(m_result)})
        splitter->addWidget(part);
    splitter->setStretchFactor(0, 0);
    splitter->setStretchFactor(1, 1);
    splitter->setStretchFactor(2, 0);
    m_splitter = splitter;
    giveResult(emptyResultHeight);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(splitter);
    connect(m_steps, &StepsList::stepChosen, this, &TaskPane::stepChosen);
    connect(m_instructions, &InstructionsPane::stepRequested, this, &TaskPane::chooseById);
    connect(m_instructions, &InstructionsPane::hintOpened, this, &TaskPane::hintOpened);
    connect(m_result, &ResultPane::showMoment, this, &TaskPane::showMoment);
    connect(m_result, &ResultPane::nextStepRequested, this, &TaskPane::nextStepRequested);
}

void TaskPane::setLab(const Lab &lab)
{
    m_taskIds.clear();
    for (const Task &task : lab.tasks)
        m_taskIds.append(task.id);
    m_steps->setLab(lab);
}

void TaskPane::setProgress(const std::vector<bool> &passed, int current)
{
    m_steps->setProgress(passed, current);
}

void TaskPane::showTask(const Task &task, int hintsOpened)
{
    m_instructions->showTask(task, hintsOpened);
}

void TaskPane::setHintsOpened(int count)
{
    m_instructions->setHintsOpened(count);
}

void TaskPane::setReport(const std::optional<CheckReport> &report)
{
    m_result->setReport(report);
    if (report.has_value() != m_hasReport) {
        m_hasReport = report.has_value();
        giveResult(m_hasReport ? resultHeight : emptyResultHeight);
    }
}

/// Room that the result does not need belongs to the instructions.
void TaskPane::giveResult(int height)
{
    const int steps = m_splitter->sizes().value(0);
    m_splitter->setSizes({steps > 0 ? steps : m_steps->sizeHint().height(),
                          std::max(1, m_splitter->height() - steps - height), height});
}

void TaskPane::setChecking(bool checking, int done, int total)
{
    m_result->setChecking(checking, done, total);
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
