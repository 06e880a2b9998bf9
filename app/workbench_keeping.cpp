// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workbench.h"

#include "model/files/json_schema.h"
#include "tasks/script/script_limits.h"
#include "tasks/work/student_work.h"

#include <map>

namespace cradle {

// The student's files: whose they are, what a program is begun with, where it comes back from.

void Workbench::openWorkspace(const QString &folder, bool readOnly)
{
    m_code.setWorkspace(Workspace()); // gives the lock back: this may be the same lab again
    if (folder.isEmpty())
        return;
    Workspace workspace(folder);
    std::optional<Error> error;
    if (readOnly)
        workspace.beginReading();
    else
        error = workspace.begin(m_lab, m_store.lab(m_lab.id).currentTask);
    m_code.setWorkspace(std::move(workspace));
    if (error)
        emit failed(*error);
}

void Workbench::takeOver()
{
    if (!task())
        return;
    if (const auto error = m_store.load())
        emit failed(*error);
    m_code.takeOver(m_lab, m_current);
    emit taskChanged();
}

void Workbench::convertProgram()
{
    if (task())
        m_code.replaceForeign(m_lab, m_current, true);
}

void Workbench::setProgramAside()
{
    if (task())
        m_code.replaceForeign(m_lab, m_current, false);
}

std::optional<QString> Workbench::newestVersion() const
{
    const History *history = task() ? m_code.workspace().history() : nullptr;
    const auto newest = history ? history->versions(task()->id, 1) : std::vector<Version>();
    if (newest.empty())
        return std::nullopt;
    const auto text = history->textOf(newest.front());
    return text ? std::optional(QString::fromUtf8(*text)) : std::nullopt;
}

void Workbench::recoverProgram()
{
    const auto text = newestVersion();
    if (!text)
        return;
    m_code.replaceForeign(m_lab, m_current, false);
    m_code.replace(*text);
    m_code.save();
}

std::optional<Preset> Workbench::passedScene() const
{
    if (!task() || mode() != Mode::Explore || !m_store.isPassed(m_lab.id, task()->id))
        return std::nullopt;
    const std::optional<Preset> scene = m_code.workspace().passedScene(task()->id);
    return scene && *scene != m_document.own() ? scene : std::nullopt;
}

void Workbench::backToPassedScene()
{
    if (const auto scene = passedScene())
        m_document.edit(tr("Back to the scene that passed"), *scene);
}

void Workbench::startAfresh()
{
    if (task())
        m_code.replace(m_code.workspace().startOf(m_lab, m_current));
}

const Task *Workbench::missedTask() const
{
    if (m_current <= 0 || !m_code.isEditable())
        return nullptr;
    const Task &before = m_lab.tasks[static_cast<std::size_t>(m_current) - 1];
    const bool builds = !before.solution.isEmpty() && before.solution == task()->starter;
    return builds && !m_store.isPassed(m_lab.id, before.id) && !m_code.workspace().has(before.id)
                   && !m_code.workspace().has(task()->id)
               ? &before
               : nullptr;
}

void Workbench::startFromSolution()
{
    if (const Task *before = missedTask())
        m_code.replace(before->solution);
}

void Workbench::save()
{
    m_saveSoon.stop();
    m_code.save();
    if (!mayWrite())
        return;
    if (const auto error = m_store.save())
        emit failed(*error);
    keepSaid();
}

/// Of work that came without a progress of its own, a clone or what was handed in: scenes and
/// predictions as they were left. That steps were passed is taken from the student's own history
/// only; what was handed in proves nothing.
void Workbench::takeKeptProgress()
{
    const Workspace &workspace = m_code.workspace();
    const auto work = readWork(workspace.folder(), m_lab);
    if (!work)
        return;
    auto &tasks = m_store.lab(m_lab.id).tasks;
    for (const auto &[id, step] : work->steps) {
        if (step.scene)
            tasks[id].edited = step.scene;
        if (step.guess == Guess{})
            continue;
        tasks[id].guess = step.guess;
        // Who looks at it sees what was expected beside what happens.
        tasks[id].guess.revealed = step.guess.revealed || workspace.isLookedAt();
    }
    if (workspace.isLookedAt() || !workspace.history())
        return;
    for (const Version &pass : workspace.history()->passes()) {
        if (m_lab.indexOf(pass.taskId) >= 0 && !tasks[pass.taskId].passed) {
            tasks[pass.taskId].passed = true;
            tasks[pass.taskId].pass.when = pass.when;
        }
    }
}

bool Workbench::signsAsNobody() const
{
    const History *history = m_code.workspace().history();
    return history && history->gitName().isEmpty() && m_code.workspace().info().student.isEmpty();
}

/// Beside the programs, where they are handed in with them.
void Workbench::keepSaid()
{
    std::map<QString, Guess> guesses;
    std::map<QString, Answers> answers;
    for (const auto &[id, task] : m_store.lab(m_lab.id).tasks) {
        guesses[id] = task.guess;
        answers[id] = task.answers;
    }
    const std::pair<QString, QByteArray> files[] = {
        {QStringLiteral("predictions.json"), predictionsText(guesses)},
        {QStringLiteral("answers.json"), answersText(answers)}};
    for (const auto &[name, text] : files) {
        if (const auto error = m_code.workspace().saveSaid(name, text))
            emit failed(*error);
    }
}

std::optional<Error> Workbench::takeScript(const QString &path)
{
    const Result<QByteArray> text = readFile(path, limits::sourceBytes);
    if (!text)
        return text.error();
    m_code.replace(QString::fromUtf8(*text));
    return std::nullopt;
}

bool Workbench::mayShowSolution()
{
    if (!task() || task()->solution.isEmpty())
        return false;
    return progress().passed || hintsOpened() >= taskFor(mode(), *task()).hints.size();
}

} // namespace cradle
