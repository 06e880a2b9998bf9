// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/checker.h"

#include <QtConcurrentRun>

#include <utility>

namespace cradle {

Checker::Checker(QObject *parent)
    : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::finished, this, [this] {
        // A cancelled one has nothing more to say, even if it was done just before.
        if (!std::exchange(m_running, false))
            return;
        if (const std::optional<CheckReport> report = m_watcher.result())
            emit finished(*report);
    });
    connect(&m_watcher, &QFutureWatcherBase::progressValueChanged, this, [this](int done) {
        if (m_running)
            emit progressed(done, m_watcher.progressMaximum());
    });
}

Checker::~Checker()
{
    cancel();
    m_watcher.waitForFinished();
}

void Checker::start(const Lab &lab, const Task &task, const Submission &submission, qint64 seed)
{
    cancel();
    m_watcher.waitForFinished();
    m_stop = std::make_shared<std::atomic_bool>(false);
    const auto work = [lab, task, submission, seed,
                       stop = m_stop](QPromise<std::optional<CheckReport>> &promise) {
        const JudgeHooks hooks{.progress =
                                   [&promise](int done, int total) {
                                       promise.setProgressRange(0, total);
                                       promise.setProgressValue(done);
                                   },
                               .cancelled = [stop] { return stop->load(); }};
        promise.addResult(judgeTask(lab, task, submission, seed, hooks));
    };
    m_running = true;
    m_watcher.setFuture(QtConcurrent::run(work));
}

void Checker::cancel()
{
    if (!std::exchange(m_running, false))
        return;
    m_stop->store(true);
    emit cancelled();
}

} // namespace cradle
