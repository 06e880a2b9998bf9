// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reference_run.h"

#include <QtConcurrentRun>

#include <utility>

namespace cradle {

ReferenceRun::ReferenceRun(QObject *parent)
    : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::finished, this, [this] {
        // A cancelled one has nothing more to say, even if it was done just before.
        if (!std::exchange(m_running, false))
            return;
        if (const States states = m_watcher.result())
            emit finished(states);
    });
}

ReferenceRun::~ReferenceRun()
{
    cancel();
    m_watcher.waitForFinished();
}

void ReferenceRun::start(const Variant &scene, const QString &program)
{
    cancel();
    m_watcher.waitForFinished();
    m_stop = std::make_shared<std::atomic_bool>(false);
    m_running = true;
    m_watcher.setFuture(QtConcurrent::run([scene, program, stop = m_stop]() -> States {
        Observation run = observe(scene, &program, [&stop] { return stop->load(); });
        const bool isWhole = !stop->load() && !run.error
                             && run.circleCount() == static_cast<int>(scene.preset.circles.size());
        return isWhole ? std::make_shared<const Recording>(std::move(run.states)) : nullptr;
    }));
}

void ReferenceRun::cancel()
{
    if (std::exchange(m_running, false))
        m_stop->store(true);
}

} // namespace cradle
