// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/runs/observation.h"

#include <QFutureWatcher>
#include <QObject>

#include <atomic>
#include <memory>

namespace cradle {

/// Runs a program in a scene off the GUI thread, one at a time, to be seen beside another run.
class ReferenceRun final : public QObject
{
    Q_OBJECT
public:
    explicit ReferenceRun(QObject *parent = nullptr);
    ~ReferenceRun() override;

    /// Begins; a run that still goes on is cancelled first.
    void start(const Variant &scene, const QString &program);
    void cancel(); ///< works at once; finished() does not follow

signals:
    /// The states of a program that has not stopped, and kept the circles of its scene.
    void finished(std::shared_ptr<const cradle::Recording> states);

private:
    using States = std::shared_ptr<const Recording>;

    QFutureWatcher<States> m_watcher;
    std::shared_ptr<std::atomic_bool> m_stop;
    bool m_running = false; ///< started and neither finished nor cancelled
};

} // namespace cradle
