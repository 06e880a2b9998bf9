// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/step_deviations.h"

#include "tasks/checks/check_library.h"
#include "tasks/judging/check_plan.h"
#include "tasks/judging/flight_words.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/start_words.h"
#include "tasks/judging/wall_words.h"
#include "tasks/runs/submission_runs.h"
#include "tasks/script/work_limit.h"

#include <algorithm>

namespace cradle {

namespace {

/// The scenes of a changed program, and what each may take.
constexpr qint64 probeSeed = 1;
constexpr qint64 mostInstructions = 20'000'000;

/// Whether a failure of a check of that kind can come of that aspect.
bool concerns(const QString &kind, Aspect aspect)
{
    switch (aspect) {
    case Aspect::Start:
        return true;
    case Aspect::Motion:
        return kind != QLatin1String("start");
    case Aspect::Walls:
    case Aspect::Course:
        return isOneOf(kind, {"bounces", "stays_inside", "bounce_heights", "settles", "together",
                              "script", "ends_at", "integrates"});
    case Aspect::Contact:
    case Aspect::Response:
        break;
    }
    return isOneOf(kind, {"collides", "rebounds", "touches", "conserves", "after_contact",
                          "loses_energy", "passes_through", "script", "ends_at"});
}

} // namespace

StepDeviations::StepDeviations(const Task &task, const Submission &submission,
                               const std::vector<CheckOutcome> &checks, const MeasuredLaws &right,
                               const Ground &ground)
    : m_task(task)
    , m_submission(submission)
    , m_checks(checks)
    , m_right(right)
    , m_ground(ground)
    , m_asked(task.forStudents ? std::optional(askedLaws(task)) : std::nullopt)
{
}

const CheckOutcome *StepDeviations::failedOf(Aspect aspect) const
{
    for (const CheckOutcome &outcome : m_checks) {
        const CheckSpec *check = specOf(outcome);
        if (!outcome.passed && check && concerns(check->kind, aspect))
            return &outcome;
    }
    return nullptr;
}

const CheckSpec *StepDeviations::specOf(const CheckOutcome &outcome) const
{
    const auto spec = std::find_if(m_task.checks.begin(), m_task.checks.end(),
                                   [&](const CheckSpec &check) { return check.id == outcome.id; });
    return spec == m_task.checks.end() ? nullptr : &*spec;
}

bool StepDeviations::isAsked(Aspect aspect) const
{
    return failedOf(aspect) && (aspect != Aspect::Walls || !m_ground.walls.circles.empty())
           && ((aspect != Aspect::Contact && aspect != Aspect::Response) || m_ground.pair.asked)
           && isKnown(aspect);
}

/// Without a solution, what is right is what the checks themselves tell.
bool StepDeviations::isKnown(Aspect aspect) const
{
    if (!m_asked)
        return true;
    switch (aspect) {
    case Aspect::Start:
        return true;
    case Aspect::Motion:
        return m_asked->motion;
    case Aspect::Walls:
    case Aspect::Course:
        return m_asked->walls;
    case Aspect::Contact:
    case Aspect::Response:
        break;
    }
    return m_asked->pair;
}

std::vector<LawDeviation> StepDeviations::of(const MeasuredLaws &laws, Aspect aspect) const
{
    switch (aspect) {
    case Aspect::Start:
        return startDeviations(m_task, m_submission, m_checks);
    case Aspect::Motion:
        return flightDeviations(laws.flight(), m_right.flight(), m_ground);
    case Aspect::Walls:
    case Aspect::Course:
        return wallDeviations(laws.walls(), m_right.walls(), m_ground);
    case Aspect::Contact:
        return contactDeviations(laws.pair(), m_right.pair(), m_ground);
    case Aspect::Response:
        break;
    }
    return responseDeviations(laws.pair(), m_right.pair(), m_ground);
}

std::vector<LawDeviation> StepDeviations::besides(const MeasuredLaws &laws, Aspect aspect) const
{
    std::vector<LawDeviation> found = of(laws, aspect);
    if (aspect == Aspect::Response || aspect == Aspect::Contact) {
        const Aspect other = aspect == Aspect::Contact ? Aspect::Response : Aspect::Contact;
        for (LawDeviation &deviation : of(laws, other))
            found.push_back(std::move(deviation));
    }
    return found;
}

bool StepDeviations::passes(const QString &program) const
{
    const Submission changed(m_submission.preset, program);
    SubmissionRuns runs(changed);
    const auto isRight = [&](const CheckSpec &check, const Variant &variant) {
        const Observation &run = runs.of(variant, &WorkLimit::isPassed, mostInstructions);
        return !WorkLimit::isPassed() && !run.error && !judge(check, run);
    };
    std::vector<CheckPlan> plans;
    for (const CheckOutcome &outcome : m_checks) {
        const CheckSpec *check = specOf(outcome);
        if (outcome.passed || !outcome.scene || !check || check->kind == QLatin1String("start"))
            continue;
        plans.push_back(planOf(*check, m_submission.preset, m_task.locked, probeSeed));
        for (Variant variant : plans.back().variants) {
            if (variant.name != outcome.variant)
                continue;
            // What failed may be of another seed.
            variant.preset = *outcome.scene;
            if (!isRight(*check, variant))
                return false;
        }
    }
    return !plans.empty() && std::all_of(plans.begin(), plans.end(), [&](const CheckPlan &plan) {
        return std::all_of(plan.variants.begin(), plan.variants.end(),
                           [&](const Variant &each) { return isRight(*plan.check, each); });
    });
}

} // namespace cradle
