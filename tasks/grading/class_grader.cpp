// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_grader.h"

#include "model/files/json_schema.h"
#include "tasks/grading/handed_in.h"
#include "tasks/grading/student_result_json.h"
#include "tasks/grading/student_seed.h"

#include <QCoreApplication>
#include <QDataStream>
#include <QIODevice>

#include <algorithm>

namespace cradle {

namespace {

struct GraderText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr int mostKills = 5;   ///< of the worker at one step, before there is no verdict
constexpr int mostDeaths = 10; ///< in a row
constexpr int look = 250;      ///< ms between two looks at what the user wants

/// All that students/ID.json follows from, besides what ResultsVersion says.
QString workHashOf(const StudentResult &student, const JudgingRequest &request)
{
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out.setVersion(QDataStream::Qt_6_4);
    out << student.id << student.name << student.number << student.email << student.lateDays
        << student.remark << bytesOf(request);
    return sha256(bytes);
}

} // namespace

std::optional<Error> ClassGrader::run(const std::vector<FoundStudent> &students, int jobs,
                                      std::unique_ptr<Workers> workers)
{
    m_workers = std::move(workers);
    m_isolation = m_workers->isolation();
    m_progress.students = static_cast<int>(students.size());
    std::size_t next = 0;
    while (next < students.size() || !m_jobs.empty()) {
        if (m_hooks.stopped && m_hooks.stopped())
            return std::nullopt;
        if (next < students.size() && static_cast<int>(m_jobs.size()) < jobs) {
            const int number = static_cast<int>(next++);
            if (auto error = begin(students[static_cast<std::size_t>(number)], number))
                return error;
            continue;
        }
        for (WorkerEvent &event : m_workers->wait(look)) {
            if (auto error = take(std::move(event)))
                return error;
        }
        if (m_hooks.idle)
            m_hooks.idle(m_progress);
    }
    return std::nullopt;
}

bool ClassGrader::isDone(const QString &id, const QString &workHash) const
{
    const auto &students = m_journal.manifest().students;
    const auto done = students.find(id);
    if (done == students.end() || done->second.workHash != workHash || done->second.notGraded > 0)
        return false;
    const auto bytes = readFile(m_journal.studentPath(id), mostResultBytes);
    return bytes && sha256(*bytes) == done->second.resultHash;
}

std::optional<Error> ClassGrader::begin(const FoundStudent &student, int number)
{
    Job job;
    HandedIn handedIn = readHandedIn(student, m_classRoot, m_lab);
    job.request = std::move(handedIn.request);
    job.request.seed = studentSeed(m_secret, student.id);
    for (const QString &each : student.rosterNumbers)
        job.request.numbers.append(each.left(mostNumberLetters));
    job.result = cutToFit({.id = student.id,
                           .name = student.name,
                           .number = student.number,
                           .email = student.email,
                           .platform = student.platform,
                           .seed = job.request.seed,
                           .lateDays = student.lateDays,
                           .remark = handedIn.remark});
    job.workHash = workHashOf(job.result, job.request);
    if (isDone(student.id, job.workHash)) {
        ++m_progress.kept;
        ++m_progress.done;
        return std::nullopt;
    }
    if (auto error = revive())
        return error;
    m_workers->judge(number, job.request);
    m_jobs[number] = std::move(job);
    return std::nullopt;
}

/// Somebody may kill the process that forks workers, with all of them: it is begun anew.
std::optional<Error> ClassGrader::revive()
{
    // One that has less of isolation would make the index untrue.
    while (!m_workers->isAlive() || m_workers->isolation() != m_isolation) {
        if (++m_deaths > mostDeaths)
            return Error{.message = GraderText::tr("the process that judges was killed %1 times "
                                                   "without getting anything done")
                                        .arg(m_deaths - 1)};
        auto workers = m_hooks.startWorkers();
        if (!workers)
            return workers.error();
        m_workers = std::move(*workers);
    }
    return std::nullopt;
}

std::optional<Error> ClassGrader::take(WorkerEvent event)
{
    Job &job = m_jobs[event.worker];
    if (event.step) {
        m_deaths = 0;
        StepResult &step = *event.step;
        if (step.report) {
            step.report->labId = m_lab.id;
            step.report->labHash = m_lab.hash;
            step.report->taskId = step.taskId;
        }
        job.kills = 0;
        job.request.steps.removeFirst();
        job.result.steps.push_back(std::move(step));
        return std::nullopt;
    }
    if (event.done || job.request.steps.isEmpty())
        return finish(event.worker);
    // The step that it was at gets no verdict; the others get another worker.
    if (!event.killed || ++job.kills >= mostKills) {
        job.result.steps.push_back({.taskId = job.request.steps.takeFirst(),
                                    .status = StepResult::Status::NotGraded,
                                    .reason = GraderText::tr("the process that judged it gave no "
                                                             "verdict: %1")
                                                  .arg(event.fault)});
        job.kills = 0;
    }
    if (job.request.steps.isEmpty())
        return finish(event.worker);
    if (auto error = revive())
        return error;
    m_workers->judge(event.worker, job.request);
    return std::nullopt;
}

std::optional<Error> ClassGrader::finish(int number)
{
    const auto found = m_jobs.find(number);
    Job &job = found->second;
    QByteArray content = writeStudentResult(job.result, m_lab);
    // What cannot be read back would leave the whole class without its pages.
    if (const auto read = readStudentResult(content, {}); !read) {
        for (StepResult &step : job.result.steps)
            step = {.taskId = step.taskId,
                    .status = StepResult::Status::NotGraded,
                    .reason = GraderText::tr("what judging found cannot be kept: %1")
                                  .arg(read.error().message)};
        content = writeStudentResult(job.result, m_lab);
    }
    const auto count = [&](StepResult::Status status) {
        return static_cast<int>(
            std::count_if(job.result.steps.begin(), job.result.steps.end(),
                          [&](const StepResult &step) { return step.status == status; }));
    };
    const int failed = count(StepResult::Status::Failed);
    const DoneStudent done{.workHash = job.workHash,
                           .notGraded = count(StepResult::Status::NotGraded),
                           .notPassed = failed + count(StepResult::Status::Missing)};
    m_progress.passed += count(StepResult::Status::Passed);
    m_progress.failed += failed;
    m_progress.notGraded += done.notGraded;
    m_progress.steps += static_cast<int>(job.result.steps.size());
    ++m_progress.done;
    if (auto error = m_journal.keep(job.result.id, content, done))
        return error;
    if (m_hooks.done)
        m_hooks.done(m_progress, job.result);
    m_jobs.erase(found);
    return std::nullopt;
}

} // namespace cradle
