// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_verifier.h"

#include "tasks/checker.h"

#include <QCoreApplication>
#include <QtConcurrent>

#include <algorithm>

namespace cradle {

namespace {

struct VerifyText {
    Q_DECLARE_TR_FUNCTIONS(LabVerifier)
};

using Role = VerifiedProgram::Role;

constexpr int seeds = 5; ///< with which a solution must pass

/// One judgement to make, and where its report belongs.
struct Job {
    const Task *task = nullptr;
    QString source;
    qint64 seed = 1;
    CheckReport *report = nullptr;
};

void addProgram(VerifiedTask &verified, std::vector<QString> &sources, Role role,
                const QString &name, const QString &source)
{
    if (source.isEmpty())
        return;
    VerifiedProgram program{role, name, {}};
    program.reports.resize(role == Role::Solution ? seeds : 1);
    verified.programs.push_back(program);
    sources.push_back(source);
}

bool isFailedBy(const CheckReport &report, const QString &check)
{
    return std::any_of(report.checks.begin(), report.checks.end(),
                       [&](const CheckOutcome &c) { return c.id == check && !c.passed; });
}

QString firstFailure(const CheckReport &report)
{
    const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                    [](const CheckOutcome &check) { return !check.passed; });
    return found == report.checks.end() ? QString()
                                        : QStringLiteral("%1: %2").arg(found->id, found->message);
}

/// What is wrong with one report; empty if it is as it should be.
QString problemOf(const VerifiedProgram &program, const CheckReport &report)
{
    if (report.error)
        return VerifyText::tr("stops with an error at line %1: %2")
            .arg(report.error->line)
            .arg(report.error->message);
    switch (program.role) {
    case Role::Starter:
        return report.passed ? VerifyText::tr("passes; a starter should fail by a check")
                             : QString();
    case Role::Solution:
        return report.passed ? QString()
                             : VerifyText::tr("fails with seed %1 by %2")
                                   .arg(report.seed)
                                   .arg(firstFailure(report));
    case Role::Mistake:
        if (report.passed)
            return VerifyText::tr("passes; a mistake should fail by a check");
        if (!report.diagnosis)
            return VerifyText::tr("is not recognised");
        return report.diagnosis->mistake == program.name
                   ? QString()
                   : VerifyText::tr("is taken for %1").arg(report.diagnosis->mistake);
    case Role::Remark:
        break;
    }
    if (!report.passed)
        return VerifyText::tr("fails by %1; work that gets a remark passes")
            .arg(firstFailure(report));
    const bool seen = std::any_of(report.remarks.begin(), report.remarks.end(),
                                  [&](const Remark &remark) { return remark.id == program.name; });
    return seen ? QString() : VerifyText::tr("is not recognised");
}

QString roleName(const VerifiedProgram &program)
{
    switch (program.role) {
    case Role::Starter:
        return QStringLiteral("starter");
    case Role::Solution:
        return QStringLiteral("solution");
    case Role::Remark:
        return QStringLiteral("remarks/") + program.name;
    case Role::Mistake:
        break;
    }
    return QStringLiteral("mistakes/") + program.name;
}

void findProblems(const Task &task, VerifiedTask &verified)
{
    for (const VerifiedProgram &program : verified.programs) {
        for (const CheckReport &report : program.reports) {
            if (const QString problem = problemOf(program, report); !problem.isEmpty()) {
                verified.problems.append(roleName(program) + QLatin1Char(' ') + problem);
                break;
            }
        }
    }
    if (task.solution.isEmpty())
        verified.problems.append(VerifyText::tr("there is no solution.lua"));
    for (const QString &check : verified.checks) {
        const bool caught = std::any_of(
            verified.programs.begin(), verified.programs.end(), [&](const VerifiedProgram &p) {
                return p.role == Role::Mistake && isFailedBy(p.reports.front(), check);
            });
        if (!caught)
            verified.problems.append(VerifyText::tr("no mistake fails the check %1").arg(check));
    }
}

/// "x . x": which checks failed.
QString rowOf(const VerifiedTask &task, const CheckReport &report)
{
    QStringList marks;
    for (const QString &check : task.checks)
        marks.append(isFailedBy(report, check) ? QStringLiteral("x") : QStringLiteral("."));
    return marks.join(QStringLiteral("  "));
}

} // namespace

std::vector<VerifiedTask> verifyLab(const Lab &lab, const QString &only)
{
    std::vector<VerifiedTask> result;
    std::vector<std::vector<QString>> sources;
    std::vector<const Task *> tasks;
    for (const Task &task : lab.tasks) {
        if (!only.isEmpty() && task.id != only)
            continue;
        VerifiedTask verified{task.id, task.title, {}, {}, {}};
        std::vector<QString> own;
        for (const CheckSpec &check : task.checks)
            verified.checks.append(check.id);
        const auto add = [&](Role role, const QString &name, const QString &source) {
            addProgram(verified, own, role, name, source);
        };
        add(Role::Starter, QStringLiteral("starter"), task.starter);
        add(Role::Solution, QStringLiteral("solution"), task.solution);
        for (const KnownScript &mistake : task.mistakes)
            add(Role::Mistake, mistake.name, mistake.source);
        for (const RemarkSpec &remark : task.remarks)
            add(Role::Remark, remark.script.name, remark.script.source);
        result.push_back(verified);
        sources.push_back(own);
        tasks.push_back(&task);
    }
    std::vector<Job> jobs;
    for (std::size_t t = 0; t < result.size(); ++t) {
        for (std::size_t p = 0; p < result[t].programs.size(); ++p) {
            qint64 seed = 1;
            for (CheckReport &report : result[t].programs[p].reports)
                jobs.push_back({tasks[t], sources[t][p], seed++, &report});
        }
    }
    QtConcurrent::blockingMap(jobs, [&lab](const Job &job) {
        *job.report =
            *judgeTask(lab, *job.task, Submission(job.task->preset, job.source), job.seed);
    });
    for (std::size_t t = 0; t < result.size(); ++t)
        findProblems(*tasks[t], result[t]);
    return result;
}

QString describeVerified(const VerifiedTask &task)
{
    QString text = QStringLiteral("%1  %2\n").arg(task.id, task.title);
    for (qsizetype i = 0; i < task.checks.size(); ++i)
        text += QStringLiteral("  %1 %2\n").arg(i + 1, 36).arg(task.checks[i]);
    for (const VerifiedProgram &program : task.programs) {
        const CheckReport &report = program.reports.front();
        QString note;
        if (program.role == Role::Mistake)
            note = report.diagnosis ? report.diagnosis->mistake : QStringLiteral("-");
        else if (program.role == Role::Remark)
            note = report.remarks.empty() ? QStringLiteral("-") : report.remarks.front().id;
        text += QStringLiteral("  %1 %2   %3\n")
                    .arg(roleName(program), -36)
                    .arg(rowOf(task, report), note);
    }
    for (const QString &problem : task.problems)
        text += QStringLiteral("  ! %1\n").arg(problem);
    return text;
}

} // namespace cradle
