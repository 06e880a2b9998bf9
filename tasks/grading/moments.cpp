// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/moments.h"

#include "tasks/runs/observation.h"

#include <algorithm>

namespace cradle {

namespace {

/// A longer run up to the moment would cost more than the picture tells.
constexpr qint64 mostSteps = 20'000;

bool canBeShown(const CheckOutcome &check)
{
    return !check.passed && check.scene && check.step >= 0 && check.step <= mostSteps;
}

/// The checks whose moments tell what was found.
std::vector<const CheckOutcome *> tellingChecks(const CheckReport &report)
{
    std::vector<const CheckOutcome *> telling;
    for (const Finding &finding : report.findings) {
        for (const CheckOutcome &check : report.checks) {
            if (check.id == finding.check && canBeShown(check)
                && std::find(telling.begin(), telling.end(), &check) == telling.end())
                telling.push_back(&check);
        }
    }
    if (telling.empty()) {
        const auto first = std::find_if(report.checks.begin(), report.checks.end(), canBeShown);
        if (first != report.checks.end())
            telling.push_back(&*first);
    }
    telling.resize(std::min(telling.size(), mostMoments));
    return telling;
}

} // namespace

std::vector<StepMoment> momentsOf(const CheckReport &report, const Task &task,
                                  const QString *program)
{
    std::vector<StepMoment> moments;
    for (const CheckOutcome *check : tellingChecks(report)) {
        const double duration = (static_cast<double>(check->step) + 0.5) * check->scene->timestep;
        const Variant scene{check->variant, *check->scene, duration, check->pinned, task.locked};
        const Observation run = observe(scene, program);
        if (run.states.isEmpty())
            continue;
        const qint64 index = std::clamp(check->step, run.states.first(), run.states.last());
        moments.push_back({check->id, drawnMoment(run, index)});
    }
    return moments;
}

} // namespace cradle
