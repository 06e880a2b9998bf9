// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/check_plan.h"

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

} // namespace

CheckPlan planOf(const CheckSpec &check, const Preset &submission, const QStringList &locked,
                 qint64 seed)
{
    CheckPlan plan{&check, {}, {}};
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
