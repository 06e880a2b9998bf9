// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kept_progress.h"

#include "tasks/lab/mode.h"
#include "tasks/work/student_work.h"

#include <QJsonArray>

#include <chrono>
#include <map>

namespace cradle {

namespace {

using namespace std::chrono_literals;

/// After the last edit; a drag makes many.
constexpr auto progressDelay = 300ms;

} // namespace

KeptProgress::KeptProgress(const LabPlace &place, CodeSession &code, const QString &file)
    : m_place(place)
    , m_code(code)
    , m_store(file)
{
    m_saveSoon.setSingleShot(true);
    m_saveSoon.setInterval(progressDelay);
    connect(&m_saveSoon, &QTimer::timeout, this, &KeptProgress::save);
}

std::optional<Error> KeptProgress::open(const QString &file)
{
    m_store = ProgressStore(file);
    return m_store.load();
}

TaskProgress &KeptProgress::ofStep()
{
    Q_ASSERT(m_place.task());
    return ofLab().tasks[m_place.task()->id];
}

/// That steps were passed is taken from the student's own history only; what was handed in proves
/// nothing.
void KeptProgress::takeFromWork()
{
    const Workspace &workspace = m_code.workspace();
    const auto work = readWork(workspace.folder(), m_place.lab);
    if (!work)
        return;
    auto &tasks = ofLab().tasks;
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
        if (m_place.lab.indexOf(pass.taskId) >= 0 && !tasks[pass.taskId].passed) {
            tasks[pass.taskId].passed = true;
            tasks[pass.taskId].pass.when = pass.when;
        }
    }
}

bool KeptProgress::isPassed(const Task &task) const
{
    return m_store.isPassed(m_place.lab.id, task.id);
}

std::vector<bool> KeptProgress::passed() const
{
    std::vector<bool> result;
    for (const Task &task : m_place.lab.tasks)
        result.push_back(isPassed(task));
    return result;
}

int KeptProgress::hintsOpened()
{
    return m_place.task() ? ofStep().hintsOpened : 0;
}

Pass KeptProgress::pass()
{
    return m_place.task() ? ofStep().pass : Pass{};
}

/// Who has passed knows what happens.
Guess KeptProgress::guess()
{
    if (!m_place.task())
        return {};
    Guess guess = ofStep().guess;
    guess.revealed = guess.revealed || ofStep().passed;
    return guess;
}

Answers KeptProgress::answers() const
{
    return m_place.task() ? m_store.answersOf(m_place.lab.id, m_place.task()->id) : Answers{};
}

std::optional<Preset> KeptProgress::scene()
{
    return m_place.task() ? ofStep().edited : std::nullopt;
}

bool KeptProgress::mayShowSolution()
{
    const Task *task = m_place.task();
    if (!task || task->solution.isEmpty())
        return false;
    const Mode mode = m_code.run().isActive() ? Mode::Code : Mode::Explore;
    return ofStep().passed || hintsOpened() >= taskFor(mode, *task).hints.size();
}

void KeptProgress::setHintsOpened(int count)
{
    if (!m_place.task())
        return;
    ofStep().hintsOpened = count;
    m_saveSoon.start();
    emit hintsChanged();
}

void KeptProgress::predict(int answer)
{
    if (!m_place.task() || guess().revealed)
        return;
    ofStep().guess.answer = answer;
    m_saveSoon.start();
    emit guessChanged();
}

void KeptProgress::revealOutcome()
{
    if (!m_place.task())
        return;
    ofStep().guess.revealed = true;
    m_saveSoon.start();
    emit guessChanged();
}

/// What is emptied is no answer.
void KeptProgress::answer(const QString &question, const QJsonValue &value)
{
    if (!m_place.task())
        return;
    const bool empty = value.toString().isEmpty() && value.toArray().isEmpty() && !value.isDouble();
    if (empty)
        ofStep().answers.remove(question);
    else
        ofStep().answers.insert(question, value);
    m_saveSoon.start();
    emit answersChanged();
}

void KeptProgress::noteOpened()
{
    ofLab().currentTask = m_place.task()->id;
    m_saveSoon.start();
}

void KeptProgress::noteScene(const std::optional<Preset> &scene)
{
    if (!m_place.task())
        return;
    ofStep().edited = scene;
    m_saveSoon.start();
}

void KeptProgress::notePassed(const Pass &pass)
{
    ofStep().passed = true;
    ofStep().pass = pass;
    m_saveSoon.start();
}

void KeptProgress::noteWatched()
{
    const Task *task = m_place.task();
    if (!task || !task->prediction || ofStep().guess.watched)
        return;
    ofStep().guess.watched = true;
    m_saveSoon.start();
    emit guessChanged();
}

void KeptProgress::saveDue()
{
    if (m_saveSoon.isActive())
        save();
}

void KeptProgress::save()
{
    m_saveSoon.stop();
    m_code.save();
    if (!m_code.workspace().mayWrite())
        return;
    if (const auto error = m_store.save())
        emit failed(*error);
    keepSaid();
}

void KeptProgress::keepSaid()
{
    std::map<QString, Guess> guesses;
    std::map<QString, Answers> answers;
    for (const auto &[id, task] : ofLab().tasks) {
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

} // namespace cradle
