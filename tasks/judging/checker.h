// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/judgement.h"

#include <QFutureWatcher>
#include <QObject>

#include <atomic>
#include <memory>

namespace cradle {

/// Judges off the GUI thread, one submission at a time.
class Checker final : public QObject
{
    Q_OBJECT
public:
    explicit Checker(QObject *parent = nullptr);
    ~Checker() override;

    [[nodiscard]] bool isRunning() const { return m_running; }

    /// Begins; a judgement that still runs is cancelled first.
    void start(const Lab &lab, const Task &task, const Submission &submission, qint64 seed);

public slots:
    void cancel(); ///< works at once; finished() does not follow

signals:
    void progressed(int done, int total);
    void finished(const cradle::CheckReport &report);
    void cancelled();

private:
    QFutureWatcher<std::optional<CheckReport>> m_watcher;
    std::shared_ptr<std::atomic_bool> m_stop;
    bool m_running = false; ///< started and neither finished nor cancelled
};

} // namespace cradle
