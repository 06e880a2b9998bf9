// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/proof_job.h"

#include <QtConcurrentRun>

namespace cradle {

ProofJob::ProofJob(QObject *parent)
    : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &ProofJob::finish);
}

ProofJob::~ProofJob()
{
    if (m_stop)
        m_stop->store(true);
    m_watcher.waitForFinished();
}

/// Another job is stopped first, so that two never share the processors.
JudgeHooks ProofJob::begin()
{
    if (m_stop)
        m_stop->store(true);
    m_watcher.waitForFinished();
    m_stop = std::make_shared<std::atomic_bool>(false);
    m_running = true;
    const auto stop = m_stop;
    JudgeHooks hooks;
    hooks.cancelled = [stop] { return stop->load(); };
    hooks.progress = [this, stop](int done, int total) {
        QMetaObject::invokeMethod(this, [this, stop, done, total] {
            if (!stop->load())
                emit progressed(done, total);
        });
    };
    return hooks;
}

void ProofJob::verify(const Lab &lab, const QString &only)
{
    const JudgeHooks hooks = begin();
    m_watcher.setFuture(QtConcurrent::run([lab, only, hooks] {
        return Outcome{false, verifyLab(lab, only, hooks), {}};
    }));
}

void ProofJob::suggest(const Lab &lab, const Task &task)
{
    const JudgeHooks hooks = begin();
    m_watcher.setFuture(QtConcurrent::run([lab, task, hooks] {
        return Outcome{true, {}, suggestMistakes(lab, task, hooks)};
    }));
}

void ProofJob::cancel()
{
    if (m_stop)
        m_stop->store(true);
}

void ProofJob::finish()
{
    m_running = false;
    if (!m_stop->load()) {
        const Outcome outcome = m_watcher.result();
        if (outcome.suggesting)
            emit suggested(outcome.suggestions);
        else
            emit verified(outcome.tasks);
    }
    emit ended();
}

} // namespace cradle
