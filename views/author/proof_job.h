// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/mutations.h"
#include "tasks/proof/lab_verifier.h"

#include <QFutureWatcher>
#include <QObject>

#include <atomic>
#include <memory>

namespace cradle {

/// Verifies a lab, or looks for mistakes that it does not know, off the GUI thread; one at a time.
class ProofJob final : public QObject
{
    Q_OBJECT
public:
    explicit ProofJob(QObject *parent = nullptr);
    ~ProofJob() override; ///< cancels and waits

    [[nodiscard]] bool isRunning() const { return m_running; }
    /// \param only  the id of one step; empty for all
    void verify(const Lab &lab, const QString &only);
    void suggest(const Lab &lab, const Task &task);

public slots:
    void cancel();

signals:
    void progressed(int done, int total);
    void verified(const std::vector<cradle::VerifiedTask> &tasks);
    void suggested(const cradle::Suggestions &suggestions);
    void ended(); ///< done or cancelled

private:
    struct Outcome {
        bool suggesting = false;
        std::vector<VerifiedTask> tasks{};
        Suggestions suggestions{};
    };

    [[nodiscard]] JudgeHooks begin();
    void finish();

    QFutureWatcher<Outcome> m_watcher;
    std::shared_ptr<std::atomic_bool> m_stop;
    bool m_running = false;
};

} // namespace cradle
