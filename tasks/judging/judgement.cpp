// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/judgement.h"

#include "tasks/checks/check_library.h"
#include "tasks/checks/contacts.h"
#include "tasks/judging/breaches.h"
#include "tasks/judging/check_plan.h"
#include "tasks/judging/commit_message.h"
#include "tasks/judging/findings.h"
#include "tasks/judging/last_assignment.h"
#include "tasks/judging/remarks.h"
#include "tasks/questions/answers.h"
#include "tasks/runs/submission_runs.h"
#include "tasks/script/student_script.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <algorithm>
#include <ctime>
#include <utility>

namespace cradle {

namespace {

struct CheckerText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// Of all runs of a judgement: a hundred times what a sound program needs.
constexpr qint64 mostInstructions = 500'000'000;
/// Of processor time of a judgement that the instructions do not bound; then the machine, not the
/// program, says so. How busy the machine is with other things makes no difference.
constexpr qint64 mostMilliseconds = 60'000;
/// Between two looks at the clock.
constexpr qint64 stepsPerClock = 64;

/// Of this thread.
qint64 processorMilliseconds()
{
    timespec taken{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &taken);
    return qint64(taken.tv_sec) * 1000 + qint64(taken.tv_nsec) / 1'000'000;
}

/// Judges one submission; used once.
class Judgement
{
public:
    Judgement(const Task &task, SubmissionRuns &runs, qint64 seed, const JudgeHooks &hooks)
        : m_task(task)
        , m_runs(runs)
        , m_submission(runs.submission())
        , m_seed(seed)
        , m_hooks(hooks)
    {
        m_timer.start();
    }

    /// \return false if it was cancelled
    bool run(CheckReport &report)
    {
        findEarlyError(report);
        // Only a breach is told.
        take(lockBreach(m_task, m_submission.preset), report);
        if (m_submission.script && !report.error) {
            auto mover = moverBreach(m_task, report.byProgram);
            m_wrongMover = mover.has_value();
            take(std::move(mover), report);
        }
        std::vector<CheckPlan> plans;
        int total = 0;
        for (const CheckSpec &check : m_task.checks) {
            plans.push_back(planOf(check, m_submission.preset, m_task.locked, m_seed));
            total += static_cast<int>(plans.back().variants.size());
        }
        int done = 0;
        for (const CheckPlan &plan : plans) {
            report.checks.push_back(outcomeOf(plan));
            CheckOutcome &outcome = report.checks.back();
            if (m_wrongMover && plan.check->kind != QLatin1String("start")) {
                outcome.passed = false;
                outcome.message =
                    report.byProgram
                        ? CheckerText::tr("not judged: what moves the circles is not what the step "
                                          "asks for")
                        : CheckerText::tr("not judged: your program does not move the circles");
                done += static_cast<int>(plan.variants.size());
                continue;
            }
            const bool shows = canHappen(plan);
            for (std::size_t i = 0; i < plan.variants.size(); ++i) {
                if (isCancelled())
                    return false;
                // After the first scene that shows the fault the others say nothing new.
                if (shows && outcome.passed && !report.error)
                    judgeScene(plan, i, outcome, report);
                if (m_hooks.progress)
                    m_hooks.progress(++done, total);
            }
            if (report.error && outcome.passed) {
                outcome.passed = false;
                outcome.message = CheckerText::tr("not judged: the program stopped with an error");
            }
            report.passed = report.passed && outcome.passed;
        }
        if (isCancelled())
            return false;
        comment(report);
        return true;
    }

private:
    /// Once said, it holds.
    [[nodiscard]] bool isCancelled()
    {
        m_cancelled = m_cancelled || (m_hooks.cancelled && m_hooks.cancelled());
        return m_cancelled;
    }
    [[nodiscard]] bool isLate()
    {
        // It is asked in every step, of some microseconds each.
        if (++m_asked % stepsPerClock != 0)
            return m_late;
        // The clock on the wall costs less to read, and shows no less.
        m_late = m_timer.elapsed() > mostMilliseconds
                 && processorMilliseconds() - m_start > mostMilliseconds;
        return m_late;
    }

    /// A program that does not load is told so before anything is judged.
    void findEarlyError(CheckReport &report)
    {
        if (!m_submission.script)
            return;
        StudentScript program(*m_submission.script,
                              {.pinned = false, .quiet = true, .locked = m_task.locked});
        Preset scene = m_submission.preset;
        report.error = program.begin(scene);
        report.byProgram = report.error || program.moves();
    }

    static void take(std::optional<CheckOutcome> breach, CheckReport &report)
    {
        if (!breach)
            return;
        report.passed = false;
        report.checks.push_back(std::move(*breach));
    }

    [[nodiscard]] const Observation &runOf(const Variant &variant)
    {
        const Observation &run = m_runs.of(
            variant, [this] { return isCancelled() || isLate(); },
            mostInstructions - m_instructions);
        m_instructions += run.instructions;
        return run;
    }

    /// Whether the program itself ever leads to what the scenes of \p plan begin with.
    [[nodiscard]] bool canHappen(const CheckPlan &plan)
    {
        return plan.causes.empty()
               || std::any_of(plan.causes.begin(), plan.causes.end(), [&](const Variant &cause) {
                      const Observation &run = runOf(cause);
                      return run.error
                             || motion::leavesInside(run, 0, 1, run.variant.preset.gravity);
                  });
    }

    void judgeScene(const CheckPlan &plan, std::size_t i, CheckOutcome &outcome,
                    CheckReport &report)
    {
        const Variant &variant = plan.variants[i];
        const Observation &run = runOf(variant);
        std::optional<ProgramError> error = run.error;
        if (!error && isLate())
            error = stoppedByMachine(mostMilliseconds / 1000);
        else if (!error && m_instructions > mostInstructions)
            error = ProgramError{
                .message = CheckerText::tr("the check took more than %1 million instructions; an "
                                           "update should take a few thousand")
                               .arg(mostInstructions / 1'000'000),
                .kind = ProgramError::Kind::Time,
                .step = run.steps(),
                .time = run.states.time(run.steps())};
        if (isCancelled())
            return;
        if (error) {
            report.error = error;
            outcome.message = error->message;
            fail(outcome, Fault{.message = error->message, .step = error->step}, variant);
            return;
        }
        const auto fault = judge(*plan.check, run);
        if (!fault)
            return;
        fail(outcome, *fault, variant);
        if (m_submission.script)
            outcome.line = lastAssignmentLine(m_submission, {variant.preset, variant.pinned},
                                              fault->step, fault->circle);
    }

    static void fail(CheckOutcome &outcome, const Fault &fault, const Variant &variant)
    {
        outcome.passed = false;
        outcome.message = fault.message;
        outcome.expected = fault.expected;
        outcome.observed = fault.observed;
        outcome.unit = fault.unit;
        outcome.step = fault.step;
        outcome.variant = variant.name;
        outcome.scene = variant.preset;
        outcome.pinned = variant.pinned;
        outcome.checkStopped = fault.checkStopped;
    }

    void comment(CheckReport &report)
    {
        // A program that ran for a while before it stopped has laws that may say why.
        const bool ran =
            !report.error
            || (report.error->kind == ProgramError::Kind::Runtime && report.error->step > 1);
        if (!report.passed && ran && !m_wrongMover)
            report.findings = findingsOf(m_task, m_runs, report.checks, m_hooks.provesLines);
        if (report.passed)
            report.remarks = remarksOn(m_task, m_runs, m_seed);
    }

    const Task &m_task;
    SubmissionRuns &m_runs;
    const Submission &m_submission;
    qint64 m_seed;
    const JudgeHooks &m_hooks;
    QElapsedTimer m_timer;
    qint64 m_start = processorMilliseconds();
    qint64 m_instructions = 0; ///< of all runs that were asked for, also of those made before
    qint64 m_asked = 0;        ///< whether it is late
    bool m_late = false;
    bool m_wrongMover = false;
    bool m_cancelled = false;
};

} // namespace

ProgramError stoppedByMachine(qint64 seconds)
{
    return {.message =
                CheckerText::tr("stopped by the machine: the check took more than %1 s. This "
                                "is no verdict on the program")
                    .arg(seconds),
            .kind = ProgramError::Kind::Machine};
}

std::optional<CheckReport> judgeTask(const Lab &lab, const Task &task, const Submission &submission,
                                     qint64 seed, const JudgeHooks &hooks)
{
    SubmissionRuns runs(submission);
    return judgeTask(lab, task, runs, seed, hooks);
}

std::optional<CheckReport> judgeTask(const Lab &lab, const Task &task, SubmissionRuns &runs,
                                     qint64 seed, const JudgeHooks &hooks)
{
    QElapsedTimer timer;
    timer.start();
    CheckReport report{
        .labId = lab.id, .labHash = lab.hash, .taskId = task.id, .seed = seed, .passed = true};
    if (!Judgement(task, runs, seed, hooks).run(report))
        return std::nullopt;
    for (CheckOutcome &outcome : judgeAnswers(task.questions, runs.submission().answers)) {
        report.passed = report.passed && outcome.passed;
        report.checks.push_back(std::move(outcome));
    }
    report.passed = report.passed && !report.error;
    report.commit = commitOf(task, runs.submission());
    report.elapsedMs = timer.elapsed();
    return report;
}

Submission answered(const Task &task, Submission submission)
{
    submission.answers = rightAnswers(task.questions);
    return submission;
}

} // namespace cradle
