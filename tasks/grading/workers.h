// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/descriptors.h"
#include "tasks/grading/judging_request.h"
#include "tasks/grading/lockdown.h"
#include "tasks/grading/server_process.h"
#include "tasks/lab_files/lab_files.h"

#include <map>
#include <memory>
#include <vector>

namespace cradle {

/// What was heard from a worker.
struct WorkerEvent {
    int worker = 0;
    std::optional<StepResult> step{}; ///< a result; else it has ended
    bool done = false;                ///< if it has ended: by itself, with all that it was asked
    bool killed = false;              ///< somebody killed it, which no program can bring about
    QString fault{};                  ///< if it has ended otherwise: how
};

/// The processes that judge, one for each student, in isolation; see Lockdown. They are forked by
/// a process of its own that has read the lab, in namespaces where bubblewrap can make them, and
/// die with this one. What comes from them is only data.
class Workers
{
public:
    /// \param files   of the lab, \p folder where they lie, \p lab what was read from them
    /// \param language  in which the students are told, see readLab()
    /// \param program  this program, which bubblewrap is to start with the argument judge-server;
    ///     empty to do without namespaces
    /// \param begun  one that was started by \p program in \p language while the lab was read
    static Result<std::unique_ptr<Workers>> start(const Lab &lab, const LabFiles &files,
                                                  const QString &folder, const QString &language,
                                                  const QString &program, ServerProcess begun = {});
    Workers(const Workers &) = delete;
    Workers &operator=(const Workers &) = delete;

    /// What the workers get, as one of them has tried.
    [[nodiscard]] Isolation isolation() const { return m_isolation; }
    [[nodiscard]] int busy() const { return static_cast<int>(m_running.size()); }
    /// Whether the process that forks them is there; if it was killed, all workers were.
    [[nodiscard]] bool isAlive() const { return m_alive; }

    /// Begins to judge. \param worker  a number of the caller's, of no other that runs
    void judge(int worker, const JudgingRequest &request);

    /// What the workers have told, in the order of each; waits for it at most so long. Returns at
    /// once, and may be empty, where a signal comes in between.
    [[nodiscard]] std::vector<WorkerEvent> wait(int milliseconds);

private:
    struct Running {
        Descriptor results{};
        QByteArray unread{};
        qint64 received = 0;
        qint64 seed = 1;
        QStringList expected{};      ///< steps of which nothing was heard yet
        std::optional<int> status{}; ///< as wait() tells it, once it has ended
        QString fault{};             ///< of what it sent
        double since = 0.0;          ///< when something was last heard, s
    };

    Workers() = default;
    bool startInNamespaces(const QByteArray &lab, const QString &language, const QString &program,
                           ServerProcess begun);
    bool connect(ServerProcess server);
    void stop();
    void readControl(std::vector<WorkerEvent> &events);
    void readResults(int worker, Running &running, std::vector<WorkerEvent> &events);
    void takeFrames(int worker, Running &running, std::vector<WorkerEvent> &events);
    void end(int worker, Running &running, std::vector<WorkerEvent> &events);

    ServerProcess m_server{};
    int m_endOfServer = 0; ///< as wait() tells it, of one that never said anything
    bool m_alive = false;
    Isolation m_isolation{};
    std::map<int, Running> m_running{};
};

} // namespace cradle
