// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/lab_verifier.h"

#include "model/world/shortest_number.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/text_gaps.h"
#include "tasks/proof/lab_findings.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/values/value_ranges.h"

#include <QCoreApplication>
#include <QMutex>
#include <QtConcurrentMap>

#include <algorithm>

namespace cradle {

namespace {

struct VerifierText {
    Q_DECLARE_TR_FUNCTIONS(LabVerifier)
};

using Role = VerifiedProgram::Role;

constexpr int fewestStudents = 10; ///< whose values are tried, where the lab draws some
constexpr int mostStudents = 24;

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

/// A program or scene of a step before it is judged.
struct Candidate {
    Role role = Role::Mistake;
    QString name;
    Submission submission{};
};

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

/// Whether \p known tells of the same, with other values perhaps.
bool isTold(const std::vector<LabFinding> &known, const LabFinding &finding)
{
    return std::any_of(known.begin(), known.end(), [&](const LabFinding &each) {
        return each.kind == finding.kind && each.program == finding.program
               && each.check == finding.check;
    });
}

/// Adds \p finding, which shows with the values of \p student, unless it is told already.
void addDrawn(VerifiedTask &task, LabFinding finding, const QString &student)
{
    if (isTold(task.findings, finding))
        return;
    finding.message =
        VerifierText::tr("with the values of the student %1: %2").arg(student, finding.message);
    task.findings.push_back(finding);
}

/// Adds what of the values of \p student is no number where one is needed.
void addValueFaults(const Lab &lab, const Lab &own, const QString &student,
                    std::vector<VerifiedTask> &result)
{
    for (const Error &fault : own.findings) {
        if (std::find(lab.findings.begin(), lab.findings.end(), fault) != lab.findings.end())
            continue;
        const auto owner = std::find_if(result.begin(), result.end(), [&](const VerifiedTask &t) {
            const Task &task = lab.tasks[static_cast<std::size_t>(lab.indexOf(t.id))];
            return fault.file.startsWith(task.folder + QLatin1Char('/'));
        });
        VerifiedTask &task = owner == result.end() ? result.front() : *owner;
        const QString file = fault.file.mid(lab.folder.size() + 1);
        addDrawn(task,
                 {.kind = LabFinding::Kind::ValueFails,
                  .task = task.id,
                  .message = QStringLiteral("%1: %2").arg(file, fault.message)},
                 student);
    }
}

/// The languages of the lab and of Cradle that \p lab was not read in.
QStringList otherLanguages(const Lab &lab)
{
    QStringList languages;
    if (lab.files)
        languages = languagesOf(*lab.files);
    languages +=
        {QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("fr"), QStringLiteral("ar")};
    languages.removeDuplicates();
    languages.removeAll(lab.readIn);
    return lab.files ? languages : QStringList();
}

/// Adds what checks in Lua stop with where a student reads another language than the lab's own:
/// they may answer in the student's.
void addSpokenStops(const Lab &lab, const QString &language, const QString &only,
                    const JudgeHooks &hooks, std::vector<VerifiedTask> &result)
{
    const Result<Lab> spoken = readLab(*lab.files, lab.folder, language);
    if (!spoken)
        return;
    for (VerifiedTask &verified : result) {
        const int index = spoken->indexOf(verified.id);
        if (index < 0 || (!only.isEmpty() && verified.id != only))
            continue;
        const Task &task = spoken->tasks[static_cast<std::size_t>(index)];
        if (std::none_of(task.checks.begin(), task.checks.end(),
                         [](const CheckSpec &check) { return !check.source.isEmpty(); }))
            continue;
        for (const Candidate &candidate : candidatesOf(task)) {
            SubmissionRuns runs(candidate.submission);
            const auto report = judgeTask(*spoken, task, runs, 1, hooks);
            if (!report)
                return; // cancelled
            const VerifiedProgram program{candidate.role, candidate.name, {}};
            auto finding = stoppedCheck(task, program, *report);
            if (!finding || isTold(verified.findings, *finding))
                continue;
            finding->message =
                VerifierText::tr("in the language %1: %2").arg(language, finding->message);
            verified.findings.push_back(*finding);
        }
    }
}

/// Hooks for one of several rounds, whose progress is a part of the whole.
JudgeHooks partOf(const JudgeHooks &hooks, int round, int rounds)
{
    JudgeHooks part = hooks;
    if (rounds == 1 || !hooks.progress)
        return part;
    part.progress = [&hooks, round, rounds](int done, int total) {
        constexpr int share = 1000;
        hooks.progress(round * share + share * done / std::max(total, 1), rounds * share);
    };
    return part;
}

} // namespace

QStringList studentsTried(const Lab &lab)
{
    return lab.drawsValues ? studentsToTry(*lab.files, fewestStudents, mostStudents)
                           : QStringList();
}

QString describeTried(const Lab &lab)
{
    QString text;
    if (!lab.drawsValues)
        return text;
    for (const TriedRange &range : triedRanges(*lab.files, studentsTried(lab)))
        text += VerifierText::tr("%1: %2 of %3 values, %4 to %5", "of a range")
                    .arg(range.step.isEmpty() ? range.name
                                              : QStringLiteral("%1 %2").arg(range.step, range.name))
                    .arg(range.tried)
                    .arg(range.count)
                    .arg(shortestNumber(range.least), shortestNumber(range.most))
                + QLatin1Char('\n');
    return text;
}

std::vector<VerifiedTask> verifyLab(const Lab &lab, const QString &only, const JudgeHooks &hooks,
                                    int seeds)
{
    const QStringList students = studentsTried(lab);
    const int rounds = 1 + static_cast<int>(students.size());
    std::vector<VerifiedTask> result = verifyOne(lab, only, partOf(hooks, 0, rounds), seeds);
    for (int i = 1; i < rounds && !result.empty(); ++i) {
        const QString &student = students[i - 1];
        const Lab own = forStudent(lab, student);
        const auto drawn = verifyOne(own, only, partOf(hooks, i, rounds), std::min(seeds, 5));
        if (hooks.cancelled && hooks.cancelled())
            return {};
        addValueFaults(lab, own, student, result);
        for (const VerifiedTask &task : drawn) {
            const auto known = std::find_if(result.begin(), result.end(),
                                            [&](const auto &each) { return each.id == task.id; });
            for (const LabFinding &finding : task.findings) {
                if (known != result.end())
                    addDrawn(*known, finding, student);
            }
        }
    }
    const JudgeHooks quiet{.cancelled = hooks.cancelled, .provesLines = false};
    for (const QString &language : otherLanguages(lab))
        addSpokenStops(lab, language, only, quiet, result);
    if (hooks.cancelled && hooks.cancelled())
        return {};
    return result;
}

} // namespace cradle
