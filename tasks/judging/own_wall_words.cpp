// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/own_wall_words.h"

#include "tasks/checks/figures.h"
#include "tasks/checks/motion.h"
#include "tasks/judging/check_plan.h"
#include "tasks/judging/wall_comparison.h"
#include "tasks/runs/scene_spec.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// A wall that turned a circle round: with which speed it came, and with which it left, m/s.
struct Rebound {
    int circle = 0;
    qint64 step = 0;
    Wall wall = Wall::Bottom;
    double came = 0.0;
    double left = 0.0;

    [[nodiscard]] double share() const { return left / came; }
};

/// Off that wall, in the step after \p k, so fast that gravity hardly counts; nothing if there is
/// none, or if it gives e back.
std::optional<Rebound> otherReboundOf(const Observation &o, int i, qint64 k, Wall wall)
{
    const Vec2 n = outwardNormal(wall);
    const double pull = dot(o.variant.preset.gravity, n) * o.timestep();
    // In that step gravity acts before the hit, as in most programs, or after it.
    const double before = dot(o.circle(i, k).velocity, n);
    const double after = -dot(o.circle(i, k + 1).velocity, n);
    const Rebound first{i, k + 1, wall, before + pull, after};
    const Rebound last{i, k + 1, wall, before, after + pull};
    constexpr double fast = 20.0; // times what gravity makes in a step
    const double least = std::max(0.1, fast * std::abs(pull));
    if (std::min(first.came, last.came) < least || std::min(first.left, last.left) <= 0.0
        || motion::isNearCircle(o, i, k, o.variant.preset.gravity)
        || motion::wallGap(o, o.circle(i, k), wall)
               > motion::travel(o, i, k, o.variant.preset.gravity) + motion::samePosition)
        return std::nullopt;
    constexpr double wrong = 0.02;
    const double e = o.variant.preset.restitution;
    const bool isRight = std::min(std::abs(first.share() - e), std::abs(last.share() - e)) <= wrong;
    return isRight ? std::nullopt : std::optional(first);
}

/// The first in the run that gives another share back than e.
std::optional<Rebound> otherRebound(const Observation &o)
{
    for (qint64 k = 0; k < o.steps(); ++k) {
        for (int i = 0; i < o.circleCount(); ++i) {
            for (const Wall wall : allWalls) {
                if (const auto rebound = otherReboundOf(o, i, k, wall))
                    return rebound;
            }
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<LawDeviation> ownWallShare(const Task &task, SubmissionRuns &runs,
                                         const std::vector<CheckOutcome> &checks)
{
    for (const CheckSpec &check : task.checks) {
        const auto failed =
            std::find_if(checks.begin(), checks.end(), [&](const CheckOutcome &outcome) {
                return outcome.id == check.id && !outcome.passed;
            });
        if (failed == checks.end() || check.kind != QLatin1String("bounces")
            || !showsOwnScene(check))
            continue;
        const CheckPlan plan = planOf(check, runs.submission().preset, task.locked, 1);
        if (plan.variants.empty())
            continue;
        const Observation &run = runs.of(plan.variants.front());
        const auto rebound = otherRebound(run);
        if (!rebound)
            continue;
        return LawDeviation{
            Aspect::Walls,
            WallText::tr("In your own scene the walls do not use the e that it has")
                + QStringLiteral("\n\n")
                + WallText::tr(
                      "Circle %1 came to the %2 with %3 m/s and left it with %4 m/s, which "
                      "is about %5 times as much, and `restitution` is %6. Other scenes come out "
                      "right. A copy of e that is made before e is set keeps the old "
                      "value.")
                      .arg(QString::number(rebound->circle + 1), motion::wallName(rebound->wall),
                           brief(rebound->came), brief(rebound->left), brief(rebound->share()),
                           brief(run.variant.preset.restitution)),
            {{runs.submission().preset, false}, rebound->step, {rebound->circle}, false},
            Suspect::Copy};
    }
    return std::nullopt;
}

} // namespace cradle
