// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/judging_request.h"

#include "tasks/grading/lockdown.h"
#include "tasks/grading/moments.h"
#include "tasks/judging/judgement.h"
#include "tasks/judging/task_laws.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/script/program_text.h"
#include "tasks/text/plain_text.h"
#include "tasks/values/lab_values.h"
#include "tasks/work/work_archive.h"
#include "tasks/workspace/kept_history.h"

#include <QCoreApplication>
#include <QDataStream>
#include <QIODevice>

#include <algorithm>

namespace cradle {

namespace {

struct RequestText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

/// A pause that is longer is no work, s.
constexpr qint64 longestPause = 600;
constexpr auto stream = QDataStream::Qt_6_4;

/// What the versions that were kept show.
void tellHistory(StepResult &result, const std::vector<KeptProgram> &versions)
{
    std::vector<qint64> times;
    for (const KeptProgram &kept : versions) {
        result.attempts += kept.version.note.passed ? 1 : 0;
        if (kept.version.when.isValid())
            times.push_back(kept.version.when.toSecsSinceEpoch());
    }
    std::sort(times.begin(), times.end());
    qint64 seconds = 0;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const qint64 gap = times[i] - times[i - 1];
        seconds += gap <= longestPause ? gap : 0;
    }
    result.minutes = static_cast<double>(seconds) / 60.0;
}

StepResult noVerdict(StepResult result, const QString &reason)
{
    result.status = StepResult::Status::NotGraded;
    result.reason = reason;
    return result;
}

StepResult unreadable(const Lab &lab, const Task &task, qint64 seed, const Error &fault)
{
    return {.taskId = task.id,
            .status = StepResult::Status::Failed,
            .report = unreadableReport(lab, task, seed, fault)};
}

/// Asks the system for the time now and then only: it is asked at every step of every run.
class TimeLimit
{
public:
    bool isOver()
    {
        if (++m_asked % often == 0 && !m_over)
            m_over = processorSeconds() - m_start > static_cast<double>(secondsPerStep);
        return m_over;
    }

private:
    static constexpr int often = 64;
    double m_start = processorSeconds();
    int m_asked = 0;
    bool m_over = false;
};

StepResult judgeStep(const Lab &lab, const Task &task, const StepWork &work,
                     const QByteArray &bytes, const JudgingRequest &request)
{
    const qint64 seed = request.seed;
    StepResult result{.taskId = task.id};
    tellHistory(result, work.versions);
    if (work.isEmpty())
        return result;
    if (!work.programFault.isEmpty()) {
        const auto read = programFrom(bytes, {});
        result.report =
            unreadableReport(lab, task, seed, read ? Error{work.programFault} : read.error());
        result.status = StepResult::Status::Failed;
        return result;
    }
    result.program = work.program.value_or(QString());
    Submission submission(work.scene.value_or(task.preset), work.program);
    submission.answers = work.answers;
    TimeLimit limit;
    JudgeHooks hooks;
    hooks.cancelled = [&limit] { return limit.isOver(); };
    result.report = judgeTask(lab, task, submission, seed, hooks);
    if (!result.report)
        return noVerdict(
            result,
            RequestText::tr("judging took more than %1 s of processor time").arg(secondsPerStep));
    if (result.report->error && result.report->error->kind == ProgramError::Kind::Machine) {
        const QString reason = result.report->error->message;
        result.report.reset();
        return noVerdict(result, reason);
    }
    result.report->elapsedMs = 0;
    result.status = result.report->passed ? StepResult::Status::Passed : StepResult::Status::Failed;
    if (request.moments)
        result.moments = momentsOf(*result.report, task, submission.program());
    return result;
}

/// Where only lab.lua was handed in, it is the program of every step.
void spreadProgram(WorkFiles &files, const Lab &lab)
{
    const auto only = files.constFind(QStringLiteral("lab.lua"));
    const bool hasSteps = std::any_of(files.keyBegin(), files.keyEnd(), [](const QString &path) {
        return path.startsWith(QLatin1String("steps/"))
               || path.startsWith(QLatin1String("presets/"));
    });
    if (only == files.constEnd() || hasSteps)
        return;
    const QByteArray program = *only;
    for (const Task &task : lab.tasks)
        files.insert(QStringLiteral("steps/%1.lua").arg(task.id), program);
}

/// Adds the versions that a repository tells of.
void addHistory(StudentWork &work, const RepositoryFiles &repository)
{
    if (repository.isEmpty())
        return;
    QStringList ids;
    for (const auto &[id, step] : work.steps)
        ids.append(id);
    for (const auto &[id, versions] : keptHistory(repository, ids)) {
        for (const Version &version : versions)
            work.steps[id].versions.push_back({version, {}});
    }
}

/// By which number the values of a student are drawn whose work has the number \p own.
QString numberOfValues(const QStringList &ofRoster, const QString &own)
{
    const auto isOwn = [&](const QString &number) {
        return !own.isEmpty() && plainNumber(number) == plainNumber(own);
    };
    return ofRoster.isEmpty() || std::any_of(ofRoster.begin(), ofRoster.end(), isOwn)
               ? own
               : ofRoster.first();
}

} // namespace

QByteArray bytesOf(const JudgingRequest &request)
{
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out.setVersion(stream);
    out << request.seed << request.steps << request.files << request.archive << request.repository
        << request.numbers << request.moments;
    return bytes;
}

std::optional<JudgingRequest> requestFrom(const QByteArray &bytes)
{
    JudgingRequest request;
    QDataStream in(bytes);
    in.setVersion(stream);
    in >> request.seed >> request.steps >> request.files >> request.archive >> request.repository
        >> request.numbers >> request.moments;
    return in.status() == QDataStream::Ok ? std::optional(request) : std::nullopt;
}

CheckReport unreadableReport(const Lab &lab, const Task &task, qint64 seed, const Error &fault)
{
    CheckReport report{
        .labId = lab.id, .labHash = lab.hash, .taskId = task.id, .seed = seed, .byProgram = true};
    for (const CheckSpec &check : task.checks)
        report.checks.push_back(
            {.id = check.id,
             .title = check.title,
             .message = RequestText::tr("not judged: the program cannot be read"),
             .points = check.points});
    for (const Question &question : task.questions)
        report.checks.push_back(
            {.id = question.id,
             .title = question.title,
             .message = RequestText::tr("not judged: the program cannot be read"),
             .points = question.kind == Question::Kind::Text ? 0.0 : question.points});
    report.error = ProgramError{
        .message = fault.message, .kind = ProgramError::Kind::Syntax, .line = fault.line};
    return report;
}

void judgeWork(const Lab &lab, const JudgingRequest &request, const std::function<void()> &begin,
               const std::function<void(const StepResult &)> &done)
{
    begin();
    WorkFiles files = request.files;
    QString fault;
    if (!request.archive.isEmpty()) {
        auto unpacked = unpackWork(request.archive, {});
        if (unpacked)
            files = std::move(*unpacked);
        else
            fault = unpacked.error().message;
    }
    spreadProgram(files, lab);
    StudentWork work = workFrom(files, lab);
    addHistory(work, request.repository);
    const QString ownNumber = printable(work.info.studentId).simplified().left(mostNumberLetters);
    const QString drawnBy = numberOfValues(request.numbers, ownNumber);
    const Lab own = forStudent(lab, drawnBy);
    for (const QString &id : request.steps) {
        begin();
        const int index = own.indexOf(id);
        StepResult result{.taskId = id};
        if (index < 0)
            result = noVerdict(result, RequestText::tr("the lab has no step %1").arg(id));
        else if (!fault.isEmpty())
            result = unreadable(own, own.tasks[static_cast<std::size_t>(index)], request.seed,
                                {.message = RequestText::tr("the file that was handed in cannot be "
                                                            "read: %1")
                                                .arg(fault)});
        else
            result = judgeStep(own, own.tasks[static_cast<std::size_t>(index)], work.step(id),
                               files.value(QStringLiteral("steps/%1.lua").arg(id)), request);
        if (lab.drawsValues) {
            result.drawnBy = drawnBy;
            result.ownNumber = ownNumber;
        }
        done(result);
    }
}

void prepareJudging(const Task &task)
{
    if (!task.solution.isEmpty())
        lawsOf(task)->measureAll();
}

} // namespace cradle
