// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/check_plan.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct PlanText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// Bounds of what a check runs, so that a verdict comes in time: a step of a lab has a handful of
/// circles and some thousand steps.
constexpr std::size_t mostCircles = 100;
constexpr double mostSteps = 100'000;
/// Hits that are looked at before circles that part are judged: each timestep with each way to
/// meet, and the time in which they have all happened, s.
constexpr int causes = 15;
constexpr double secondsOfHits = 0.7;

/// The hits that may lead to what a check of parting circles shows, with its own circles.
std::vector<Variant> causesOf(const CheckSpec &check, const Preset &submission, qint64 seed)
{
    if (check.scene.value(QStringLiteral("kind")) != QLatin1String("parting"))
        return {};
    CheckSpec hits = check;
    hits.scene.insert(QStringLiteral("kind"), QStringLiteral("encounters"));
    hits.scene.insert(QStringLiteral("count"), causes);
    hits.scene.insert(QStringLiteral("duration"), secondsOfHits);
    hits.scene.insert(QStringLiteral("offset"), 0.9);
    hits.scene.insert(QStringLiteral("both_move"), true);
    return makeVariants(submission, hits, seed);
}

} // namespace

CheckPlan planOf(const CheckSpec &check, const Preset &submission, const QStringList &locked,
                 qint64 seed)
{
    CheckPlan plan{&check, {}, {}, {}};
    const int last = *std::max_element(check.circles.begin(), check.circles.end());
    const bool pair = check.scene.value(QStringLiteral("kind")) == QLatin1String("encounters")
                      || check.kind == QLatin1String("passes_through");
    const int needed = std::max(last + 1, pair ? 2 : 1);
    if (submission.circles.size() < static_cast<std::size_t>(needed)) {
        plan.missing = PlanText::tr("There is no circle %1; add one").arg(needed);
        return plan;
    }
    if (submission.circles.size() > mostCircles) {
        plan.missing = PlanText::tr("A check runs at most %1 circles; there are %2")
                           .arg(mostCircles)
                           .arg(submission.circles.size());
        return plan;
    }
    plan.variants = makeVariants(submission, check, seed);
    plan.causes = causesOf(check, submission, seed);
    for (Variant &variant : plan.causes)
        variant.locked = locked;
    for (Variant &variant : plan.variants)
        variant.locked = locked;
    for (const Variant &variant : plan.variants) {
        if (variant.duration / variant.preset.timestep > mostSteps) {
            plan.missing = PlanText::tr("The timestep %1 s is too short to be judged; %2 s or "
                                        "more is right")
                               .arg(variant.preset.timestep)
                               .arg(variant.duration / mostSteps);
            plan.variants.clear();
            break;
        }
    }
    return plan;
}

CheckOutcome outcomeOf(const CheckPlan &plan)
{
    CheckOutcome outcome{.id = plan.check->id, .title = plan.check->title};
    outcome.passed = plan.missing.isEmpty();
    outcome.message = plan.missing;
    outcome.points = plan.check->points;
    return outcome;
}

} // namespace cradle
