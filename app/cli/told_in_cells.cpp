// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/told_in_cells.h"

#include "tasks/grading/descriptors.h"
#include "tasks/grading/judging_request.h"
#include "tasks/grading/lockdown.h"
#include "tasks/grading/worker_server.h"
#include "tasks/lab_report/told_step_bytes.h"

#include <QCoreApplication>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <exception>
#include <thread>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cradle::cli {

namespace {

struct CellText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

constexpr qint64 mostToldBytes = 64 * 1024 * 1024; ///< of one step

/// Tells one step and ends.
[[noreturn]] void beCell(const Lockdown &lockdown, int results, pid_t parent, const Lab &lab,
                         const StudentWork &work, int index, qint64 seed)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent || dup2(results, Lockdown::outputDescriptor) < 0)
        _exit(1);
    close_range(Lockdown::outputDescriptor + 1, ~0U, 0);
    (void)lockdown.enter(secondsPerStep);
    try {
        const QByteArray told = bytesOf(tellStep(lab, work, index, seed));
        _exit(writeAll(Lockdown::outputDescriptor, told) ? 0 : 1);
    } catch (const std::exception &) {
        _exit(1);
    }
}

QString wordsForEnd(int status)
{
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return CellText::tr("It was stopped after %1 s of processor time.").arg(secondsPerStep);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGSYS)
        return CellText::tr("It was stopped: it asked the system for what no program needs.");
    return CellText::tr("The process that judged it broke down.");
}

ToldStep stopped(const Lab &lab, const StudentWork &work, int index, const QString &reason)
{
    const Task &task = lab.tasks[static_cast<std::size_t>(index)];
    const StepWork &step = work.step(task.id);
    ToldStep told;
    told.report.id = task.id;
    told.report.title = task.title;
    told.report.byProgram = step.program.has_value();
    told.report.note = step.note;
    told.report.verdict = StepVerdict::Stopped;
    told.report.explanation = reason;
    return told;
}

/// What the cell of step \p index has told.
ToldStep hear(Descriptor results, pid_t cell, const Lab &lab, const StudentWork &work, int index)
{
    const auto bytes = readAll(results.number(), mostToldBytes);
    results.close();
    if (!bytes) // more than any step has to tell
        kill(cell, SIGKILL);
    int status = 0;
    waitpid(cell, &status, 0);
    auto told = bytes ? toldStepFrom(*bytes) : std::nullopt;
    const Task &task = lab.tasks[static_cast<std::size_t>(index)];
    if (told && told->report.id == task.id)
        return std::move(*told);
    return stopped(lab, work, index, wordsForEnd(status));
}

} // namespace

LabReport reportFromCells(const Lab &lab, const StudentWork &work, qint64 seed,
                          const QDateTime &when)
{
    const Lockdown lockdown(mostWorkerMemory);
    const int count = static_cast<int>(lab.tasks.size());
    const auto atOnce = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    struct Cell {
        int index;
        pid_t process;
        Descriptor results;
    };
    std::vector<Cell> running;
    std::vector<ToldStep> told(lab.tasks.size());
    int next = 0;
    const pid_t parent = getpid();
    while (next < count || !running.empty()) {
        while (next < count && static_cast<int>(running.size()) < atOnce) {
            const int index = next++;
            auto pipe = openPipe();
            const pid_t cell = pipe ? fork() : -1;
            if (cell == 0)
                beCell(lockdown, pipe->second.number(), parent, lab, work, index, seed);
            if (cell < 0)
                told[static_cast<std::size_t>(index)] =
                    stopped(lab, work, index, CellText::tr("No process could be had to judge it."));
            else
                running.push_back({index, cell, std::move(pipe->first)});
        }
        if (running.empty())
            continue;
        Cell first = std::move(running.front());
        running.erase(running.begin());
        told[static_cast<std::size_t>(first.index)] =
            hear(std::move(first.results), first.process, lab, work, first.index);
    }
    return reportOf(lab, work, when, std::move(told));
}

} // namespace cradle::cli
