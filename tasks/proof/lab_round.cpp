// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/lab_round.h"

#include "tasks/authoring/text_gaps.h"
#include "tasks/proof/lab_findings.h"

#include <QMutex>
#include <QtConcurrentMap>

namespace cradle {

namespace {

using Role = VerifiedProgram::Role;

/// One program to judge, and where its reports belong: one for each seed, from 1.
struct Job {
    const Task *task = nullptr;
    const Submission *submission = nullptr;
    std::vector<CheckReport> *reports = nullptr;
};

/// One tolerance to judge.
struct ToleranceJob {
    std::size_t task = 0; ///< index of its step
    const CheckSpec *check = nullptr;
    std::optional<TightTolerance> tight{};
    std::optional<Sensitivity> sensitivity{};
};

/// Lets the caller's hooks be called from many threads, one at a time.
class Watch
{
public:
    Watch(const JudgeHooks &hooks, std::size_t total)
        : m_hooks(hooks)
        , m_total(static_cast<int>(total))
    {
    }

    void advance()
    {
        const QMutexLocker lock(&m_mutex);
        ++m_done;
        if (m_hooks.progress && !m_cancelled)
            m_hooks.progress(m_done, m_total);
    }

    /// Once said, it holds.
    [[nodiscard]] bool isCancelled()
    {
        const QMutexLocker lock(&m_mutex);
        m_cancelled = m_cancelled || (m_hooks.cancelled && m_hooks.cancelled());
        return m_cancelled;
    }

private:
    const JudgeHooks &m_hooks;
    int m_total;
    int m_done = 0;
    bool m_cancelled = false;
    QMutex m_mutex;
};

} // namespace

std::vector<Candidate> candidatesOf(const Task &task)
{
    std::vector<Candidate> found;
    const auto add = [&](Role role, const QString &name, const QString &source) {
        if (!source.isEmpty())
            found.push_back({role, name, answered(task, Submission(task.preset, source))});
    };
    add(Role::Starter, QStringLiteral("starter"), task.starter);
    add(Role::Solution, QStringLiteral("solution"), task.solution);
    if (task.solutionScene)
        found.push_back({Role::Solution, QStringLiteral("solution-preset"),
                         answered(task, *task.solutionScene)});
    for (const KnownScript &mistake : task.mistakes)
        add(Role::Mistake, mistake.name, mistake.source);
    for (const RemarkSpec &remark : task.remarks)
        add(Role::Remark, remark.script.name, remark.script.source);
    return found;
}

std::vector<VerifiedTask> verifyOne(const Lab &lab, const QString &only, const JudgeHooks &hooks,
                                    int seeds)
{
    std::vector<VerifiedTask> result;
    std::vector<const Task *> tasks;
    std::vector<std::vector<Candidate>> candidates;
    for (const Task &task : lab.tasks) {
        if (!only.isEmpty() && task.id != only)
            continue;
        VerifiedTask verified{.id = task.id, .title = task.title};
        for (const CheckSpec &check : task.checks)
            verified.checks.append(check.id);
        candidates.push_back(candidatesOf(task));
        for (const Candidate &candidate : candidates.back()) {
            VerifiedProgram program{candidate.role, candidate.name, {}};
            program.reports.resize(
                candidate.role == Role::Solution ? static_cast<std::size_t>(seeds) : 1);
            verified.programs.push_back(program);
        }
        result.push_back(verified);
        tasks.push_back(&task);
    }
    std::vector<Job> jobs;
    std::size_t judgements = 0;
    std::vector<ToleranceJob> tolerances;
    for (std::size_t t = 0; t < result.size(); ++t) {
        for (std::size_t p = 0; p < result[t].programs.size(); ++p) {
            std::vector<CheckReport> &reports = result[t].programs[p].reports;
            jobs.push_back({tasks[t], &candidates[t][p].submission, &reports});
            judgements += reports.size();
        }
        for (const CheckSpec &check : tasks[t]->checks)
            tolerances.push_back({t, &check, {}});
    }
    Watch watch(hooks, judgements + tolerances.size());
    const JudgeHooks cancel{.cancelled = [&watch] { return watch.isCancelled(); },
                            .provesLines = false};
    QtConcurrent::blockingMap(jobs, [&](const Job &job) {
        SubmissionRuns runs(*job.submission);
        qint64 seed = 1;
        for (CheckReport &report : *job.reports) {
            if (auto judged = judgeTask(lab, *job.task, runs, seed++, cancel))
                report = std::move(*judged);
            watch.advance();
        }
    });
    QtConcurrent::blockingMap(tolerances, [&](ToleranceJob &job) {
        job.tight = findTightTolerance(*tasks[job.task], *job.check, cancel.cancelled);
        job.sensitivity = sensitivityOf(*tasks[job.task], *job.check, cancel.cancelled);
        watch.advance();
    });
    if (watch.isCancelled())
        return {};
    const std::vector<Error> gaps = lab.files ? textGaps(*lab.files) : std::vector<Error>();
    for (std::size_t t = 0; t < result.size(); ++t)
        findProblems(lab, *tasks[t], gaps, result[t]);
    for (const ToleranceJob &job : tolerances) {
        result[job.task].sensitivity.push_back(job.sensitivity);
        if (job.tight)
            result[job.task].findings.push_back(tooTight(*tasks[job.task], *job.check, *job.tight));
    }
    return result;
}

} // namespace cradle
