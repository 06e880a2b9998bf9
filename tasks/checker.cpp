// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checker.h"

#include "tasks/checks/check_library.h"
#include "tasks/checks/integrator_matching.h"
#include "tasks/variant.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QtConcurrent>

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

/// A check with the scenes that it runs, or the reason why it can run none.
struct Plan {
    const CheckSpec *check = nullptr;
    std::vector<Variant> variants{};
    QString missing{};
};

Plan planOf(const CheckSpec &check, const Preset &submission, qint64 seed)
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
    return outcome;
}

void fail(CheckOutcome &outcome, const Fault &fault, const Variant &variant)
{
    outcome.passed = false;
    outcome.message = fault.message;
    outcome.expected = fault.expected;
    outcome.observed = fault.observed;
    outcome.unit = fault.unit;
    outcome.step = fault.step;
    outcome.variant = variant.name;
    outcome.scene = variant.preset;
}

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
QString commitOf(const Task &task, const Preset &submission)
{
    QString commit = task.id + QLatin1Char(' ') + task.commit;
    const QString wanted = QStringLiteral("{integrator}");
    if (!commit.contains(wanted) || submission.circles.empty())
        return commit;
    const Observation run = observe({QStringLiteral("preset"), submission, 2.0});
    return commit.replace(wanted,
                          englishNames(matchingIntegrators({}, run, 0, submission.gravity)));
}

} // namespace

std::optional<CheckReport> judgeTask(const Lab &lab, const Task &task, const Preset &submission,
                                     qint64 seed, const JudgeHooks &hooks)
{
    QElapsedTimer timer;
    timer.start();
    std::vector<Plan> plans;
    int total = 0;
    for (const CheckSpec &check : task.checks) {
        plans.push_back(planOf(check, submission, seed));
        total += static_cast<int>(plans.back().variants.size());
    }
    CheckReport report{
        .labId = lab.id, .labHash = lab.hash, .taskId = task.id, .seed = seed, .passed = true};
    int done = 0;
    for (const Plan &plan : plans) {
        CheckOutcome outcome = outcomeOf(plan);
        for (const Variant &variant : plan.variants) {
            if (hooks.cancelled && hooks.cancelled())
                return std::nullopt;
            // After the first scene that shows the fault the others say nothing new.
            if (outcome.passed) {
                if (const auto fault = judge(*plan.check, observe(variant)))
                    fail(outcome, *fault, variant);
            }
            if (hooks.progress)
                hooks.progress(++done, total);
        }
        report.passed = report.passed && outcome.passed;
        report.checks.push_back(outcome);
    }
    report.commit = commitOf(task, submission);
    report.elapsedMs = timer.elapsed();
    return report;
}

Checker::Checker(QObject *parent)
    : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::finished, this, [this] {
        // A cancelled one has nothing more to say, even if it was done just before.
        if (!std::exchange(m_running, false))
            return;
        if (const std::optional<CheckReport> report = m_watcher.result())
            emit finished(*report);
    });
    connect(&m_watcher, &QFutureWatcherBase::progressValueChanged, this, [this](int done) {
        if (m_running)
            emit progressed(done, m_watcher.progressMaximum());
    });
}

Checker::~Checker()
{
    cancel();
    m_watcher.waitForFinished();
}

void Checker::start(const Lab &lab, const Task &task, const Preset &submission, qint64 seed)
{
    cancel();
    m_watcher.waitForFinished();
    m_stop = std::make_shared<std::atomic_bool>(false);
    const auto work = [lab, task, submission, seed,
                       stop = m_stop](QPromise<std::optional<CheckReport>> &promise) {
        const JudgeHooks hooks{.progress =
                                   [&promise](int done, int total) {
                                       promise.setProgressRange(0, total);
                                       promise.setProgressValue(done);
                                   },
                               .cancelled = [stop] { return stop->load(); }};
        promise.addResult(judgeTask(lab, task, submission, seed, hooks));
    };
    m_running = true;
    m_watcher.setFuture(QtConcurrent::run(work));
}

void Checker::cancel()
{
    if (!std::exchange(m_running, false))
        return;
    m_stop->store(true);
    emit cancelled();
}

} // namespace cradle
