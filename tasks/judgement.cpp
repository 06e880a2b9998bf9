// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judgement.h"

#include "tasks/checks/check_library.h"
#include "tasks/checks/integrator_matching.h"
#include "tasks/diagnosis.h"
#include "tasks/locks.h"
#include "tasks/script/student_script.h"
#include "tasks/variant.h"

#include "model/stepper.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <algorithm>
#include <map>
#include <utility>

namespace cradle {

namespace {

struct CheckerText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// Bounds of what a check runs, so that a verdict comes in time: a step of a lab has a handful of
/// circles and some thousand steps.
constexpr std::size_t mostCircles = 100;
constexpr double mostSteps = 100'000;
/// Of a whole judgement: a hundred times what the slowest sound program needs.
constexpr qint64 mostMilliseconds = 30'000;
/// Scenes of a failed check in which its cause is looked for.
constexpr std::size_t mostScenes = 6;

/// A check with the scenes that it runs, or the reason why it can run none.
struct Plan {
    const CheckSpec *check = nullptr;
    std::vector<Variant> variants{};
    QString missing{};
};

Plan planOf(const CheckSpec &check, const Preset &submission, const QStringList &locked,
            qint64 seed)
{
    Plan plan{&check, {}, {}};
    const int last = *std::max_element(check.circles.begin(), check.circles.end());
    const bool pair = check.scene.value(QStringLiteral("kind")) == QLatin1String("encounters")
                      || check.kind == QLatin1String("passes_through");
    const int needed = std::max(last + 1, pair ? 2 : 1);
    if (submission.circles.size() < static_cast<std::size_t>(needed)) {
        plan.missing = CheckerText::tr("There is no circle %1; add one").arg(needed);
        return plan;
    }
    if (submission.circles.size() > mostCircles) {
        plan.missing = CheckerText::tr("A check runs at most %1 circles; there are %2")
                           .arg(mostCircles)
                           .arg(submission.circles.size());
        return plan;
    }
    plan.variants = makeVariants(submission, check, seed);
    for (Variant &variant : plan.variants)
        variant.locked = locked;
    for (const Variant &variant : plan.variants) {
        if (variant.duration / variant.preset.timestep > mostSteps) {
            plan.missing = CheckerText::tr("The timestep %1 s is too short to be judged; %2 s or "
                                           "more is right")
                               .arg(variant.preset.timestep)
                               .arg(variant.duration / mostSteps);
            plan.variants.clear();
            break;
        }
    }
    return plan;
}

CheckOutcome outcomeOf(const Plan &plan)
{
    CheckOutcome outcome{.id = plan.check->id, .title = plan.check->title};
    outcome.passed = plan.missing.isEmpty();
    outcome.message = plan.missing;
    outcome.points = plan.check->points;
    return outcome;
}

/// The line of the program that last moved the circle of \p fault, or any if it is of none alone,
/// in that step of that scene; 0 if none did.
int lineOf(const Submission &submission, const Variant &variant, const Fault &fault)
{
    if (!submission.script || fault.step < 1)
        return 0;
    StudentScript program(*submission.script,
                          {.pinned = variant.pinned, .quiet = true, .locked = {}});
    Preset scene = variant.preset;
    if (program.begin(scene) || !program.moves())
        return 0;
    World world = initialWorld(scene);
    for (; world.step < fault.step - 1; ++world.step) {
        world.time = static_cast<double>(world.step) * scene.timestep;
        if (program.advance(world, scene.timestep))
            return 0;
    }
    int line = 0;
    for (const Assignment &assignment : program.trace(world, scene.timestep)) {
        if (fault.circle < 0 || assignment.circle == fault.circle)
            line = assignment.line;
    }
    return line;
}

/// Judges one submission; used once.
class Judgement
{
public:
    Judgement(const Task &task, const Submission &submission, qint64 seed, const JudgeHooks &hooks)
        : m_task(task)
        , m_submission(submission)
        , m_seed(seed)
        , m_hooks(hooks)
    {
        m_timer.start();
    }

    /// \return false if it was cancelled
    bool run(CheckReport &report)
    {
        findEarlyError(report);
        findChangedLock(report);
        std::vector<Plan> plans;
        int total = 0;
        for (const CheckSpec &check : m_task.checks) {
            plans.push_back(planOf(check, m_submission.preset, m_task.locked, m_seed));
            total += static_cast<int>(plans.back().variants.size());
        }
        int done = 0;
        for (const Plan &plan : plans) {
            report.checks.push_back(outcomeOf(plan));
            CheckOutcome &outcome = report.checks.back();
            for (std::size_t i = 0; i < plan.variants.size(); ++i) {
                if (isCancelled())
                    return false;
                // After the first scene that shows the fault the others say nothing new.
                if (outcome.passed && !report.error)
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
    [[nodiscard]] bool isLate() const { return m_timer.elapsed() > mostMilliseconds; }

    /// A program that does not load is told so before anything is judged.
    void findEarlyError(CheckReport &report) const
    {
        if (!m_submission.script)
            return;
        StudentScript program(*m_submission.script,
                              {.pinned = false, .quiet = true, .locked = m_task.locked});
        Preset scene = m_submission.preset;
        report.error = program.begin(scene);
    }

    /// What the step fixes is as the step has it; only a breach is told.
    void findChangedLock(CheckReport &report) const
    {
        const auto field = firstChangedLock(m_task.preset, m_submission.preset, m_task.locked);
        if (!field)
            return;
        report.passed = false;
        report.checks.push_back(
            {.id = QStringLiteral("locked"),
             .title = CheckerText::tr("What the step fixes is as the step has it"),
             .message = lockReason(*field, m_task.preset)});
    }

    void judgeScene(const Plan &plan, std::size_t i, CheckOutcome &outcome, CheckReport &report)
    {
        const Variant &variant = plan.variants[i];
        Observation run =
            observe(variant, m_submission.program(), [this] { return isCancelled() || isLate(); });
        if (!run.error && isLate())
            run.error = ProgramError{
                .message = CheckerText::tr("the check took more than %1 s and was stopped; an "
                                           "update should take less than a millisecond")
                               .arg(mostMilliseconds / 1000),
                .kind = ProgramError::Kind::Time,
                .step = run.steps(),
                .time = run.states.time(run.steps())};
        if (isCancelled())
            return;
        if (run.error) {
            report.error = run.error;
            outcome.message = run.error->message;
            fail(outcome, Fault{.message = run.error->message, .step = run.error->step}, variant);
            return;
        }
        const auto fault = judge(*plan.check, run);
        if (!fault)
            return;
        fail(outcome, *fault, variant);
        if (m_submission.script) {
            outcome.line = lineOf(m_submission, variant, *fault);
            keep(plan, i, std::move(run));
        }
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
    }

    /// Keeps the failed scene, and a few more of the check in which mistakes can be told apart.
    void keep(const Plan &plan, std::size_t i, Observation run)
    {
        FailedCheck failed{plan.check, {plan.variants[i]}, {}};
        failed.runs.push_back(std::move(run));
        // From all over the check: a scene in which the student is right speaks, too.
        const std::size_t all = plan.variants.size();
        const std::size_t most = std::min(all, mostScenes);
        for (std::size_t n = 1; n < most; ++n) {
            const std::size_t j = (i + n * all / most) % all;
            Observation more = observe(plan.variants[j], m_submission.program(),
                                       [this] { return isCancelled() || isLate(); });
            if (more.error)
                break;
            failed.scenes.push_back(plan.variants[j]);
            failed.runs.push_back(std::move(more));
        }
        m_failed.push_back(std::move(failed));
    }

    void comment(CheckReport &report)
    {
        if (!report.error && !m_task.solution.isEmpty())
            report.diagnosis = diagnose(m_task, m_failed);
        if (report.passed)
            report.remarks = remarksOn(m_task, m_submission, m_seed);
    }

    const Task &m_task;
    const Submission &m_submission;
    qint64 m_seed;
    const JudgeHooks &m_hooks;
    QElapsedTimer m_timer;
    std::vector<FailedCheck> m_failed;
    bool m_cancelled = false;
};

/// The lab's commit messages are English, whatever language the student reads.
QString englishNames(const std::vector<Integrator> &integrators)
{
    static const std::map<Integrator, QString> names{
        {Integrator::Euler, QStringLiteral("Euler")},
        {Integrator::SymplecticEuler, QStringLiteral("symplectic Euler")},
        {Integrator::Verlet, QStringLiteral("velocity Verlet")},
        {Integrator::RungeKutta4, QStringLiteral("Runge-Kutta 4")}};
    QStringList found;
    for (const Integrator integrator : integrators)
        found.append(names.at(integrator));
    return found.join(QStringLiteral(" or "));
}

/// The commit message, with the integrator that the submission was seen to use.
QString commitOf(const Task &task, const Submission &submission)
{
    QString commit = task.id + QLatin1Char(' ') + task.commit;
    const QString wanted = QStringLiteral("{integrator}");
    if (!commit.contains(wanted) || submission.preset.circles.empty())
        return commit;
    const Observation run =
        observe({QStringLiteral("preset"), submission.preset, 2.0}, submission.program());
    return commit.replace(
        wanted, englishNames(matchingIntegrators({}, run, 0, run.variant.preset.gravity)));
}

} // namespace

std::optional<CheckReport> judgeTask(const Lab &lab, const Task &task, const Submission &submission,
                                     qint64 seed, const JudgeHooks &hooks)
{
    QElapsedTimer timer;
    timer.start();
    CheckReport report{
        .labId = lab.id, .labHash = lab.hash, .taskId = task.id, .seed = seed, .passed = true};
    if (!Judgement(task, submission, seed, hooks).run(report))
        return std::nullopt;
    report.passed = report.passed && !report.error;
    report.commit = commitOf(task, submission);
    report.elapsedMs = timer.elapsed();
    return report;
}

} // namespace cradle
