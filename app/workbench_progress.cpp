// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workbench.h"

#include <QJsonArray>

namespace cradle {

// How far the student has come: what was passed, the hints, the prediction.

TaskProgress &Workbench::progress()
{
    Q_ASSERT(task());
    return m_store.lab(m_lab.id).tasks[task()->id];
}

std::vector<bool> Workbench::passed() const
{
    std::vector<bool> result;
    for (const Task &task : m_lab.tasks)
        result.push_back(m_store.isPassed(m_lab.id, task.id));
    return result;
}

int Workbench::hintsOpened()
{
    return task() ? progress().hintsOpened : 0;
}

Pass Workbench::pass()
{
    return task() ? progress().pass : Pass{};
}

/// Who has passed knows what happens.
Guess Workbench::guess()
{
    if (!task())
        return {};
    Guess guess = progress().guess;
    guess.revealed = guess.revealed || progress().passed;
    return guess;
}

void Workbench::predict(int answer)
{
    if (!task() || guess().revealed)
        return;
    progress().guess.answer = answer;
    m_saveSoon.start();
    emit guessChanged();
}

void Workbench::revealOutcome()
{
    if (!task())
        return;
    progress().guess.revealed = true;
    m_saveSoon.start();
    emit guessChanged();
}

Answers Workbench::answers() const
{
    return task() ? m_store.answersOf(m_lab.id, task()->id) : Answers{};
}

/// What is emptied is no answer.
void Workbench::answer(const QString &question, const QJsonValue &value)
{
    if (!task())
        return;
    const bool empty = value.toString().isEmpty() && value.toArray().isEmpty() && !value.isDouble();
    if (empty)
        progress().answers.remove(question);
    else
        progress().answers.insert(question, value);
    m_saveSoon.start();
    markStale();
}

/// A pass needs a run that was seen: of this work, not of a scene of the check or of the last text
/// that could be read.
void Workbench::noteSeen()
{
    if (m_runSeen || m_simulation.atStart() || !task() || m_document.isVisiting()
        || (mode() == Mode::Code && m_code.runningText() != m_code.text()))
        return;
    m_runSeen = true;
    if (!m_awaitsRun || m_judged != submission())
        return;
    m_awaitsRun = false;
    countPass();
    emit progressChanged();
}

/// A question that waits until the scene has moved says so.
void Workbench::noteWatched()
{
    noteSeen();
    if (m_simulation.atStart() || !task() || !task()->prediction || progress().guess.watched)
        return;
    progress().guess.watched = true;
    m_saveSoon.start();
    emit guessChanged();
}

void Workbench::setHintsOpened(int count)
{
    if (!task())
        return;
    progress().hintsOpened = count;
    m_saveSoon.start();
    emit hintsChanged();
}

} // namespace cradle
