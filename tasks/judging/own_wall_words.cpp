// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/own_wall_words.h"

#include "tasks/checks/figures.h"
#include "tasks/checks/motion.h"
#include "tasks/judging/asked_laws.h"
#include "tasks/judging/check_plan.h"
#include "tasks/judging/wall_comparison.h"
#include "tasks/runs/scene_spec.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// A wall that turned a circle round: with which speed it came, and with which it left, m/s.
struct WallRebound {
    int circle = 0;
    qint64 step = 0;
    Wall wall = Wall::Bottom;
    double came = 0.0;
    double left = 0.0;
    bool isRight = false; ///< it gives e back
    double blur = 0.0;    ///< of the share: whether gravity acts before the hit is not known

    [[nodiscard]] double share() const { return left / came; }
};

constexpr double sameShare = 0.02;

/// Off that wall, in the step after \p k, so fast that gravity hardly counts; nothing if there is
/// none.
std::optional<WallRebound> wallReboundOf(const Observation &o, int i, qint64 k, Wall wall)
{
    const Vec2 n = outwardNormal(wall);
    const double pull = dot(o.variant.preset.gravity, n) * o.timestep();
    // In that step gravity acts before the hit, as in most programs, or after it.
    const double before = dot(o.circle(i, k).velocity, n);
    const double after = -dot(o.circle(i, k + 1).velocity, n);
    WallRebound first{i, k + 1, wall, before + pull, after};
    const WallRebound last{i, k + 1, wall, before, after + pull};
    constexpr double fast = 20.0; // times what gravity makes in a step
    const double least = std::max(0.1, fast * std::abs(pull));
    if (std::min(first.came, last.came) < least || std::min(first.left, last.left) <= 0.0
        || motion::isNearCircle(o, i, k, o.variant.preset.gravity)
        || motion::wallGap(o, o.circle(i, k), wall)
               > motion::travel(o, i, k, o.variant.preset.gravity) + motion::samePosition)
        return std::nullopt;
    const double e = o.variant.preset.restitution;
    first.blur = std::abs(last.share() - first.share());
    first.isRight = std::min(std::abs(first.share() - e), std::abs(last.share() - e)) <= sameShare;
    return first;
}

std::vector<WallRebound> wallReboundsOf(const Observation &o)
{
    std::vector<WallRebound> all;
    for (qint64 k = 0; k < o.steps(); ++k) {
        for (int i = 0; i < o.circleCount(); ++i) {
            for (const Wall wall : allWalls) {
                if (const auto rebound = wallReboundOf(o, i, k, wall))
                    all.push_back(*rebound);
            }
        }
    }
    return all;
}

/// Whether walls are known to be wrong in other scenes, too.
bool failsElsewhere(const Task &task, const std::vector<CheckOutcome> &checks)
{
    return std::any_of(checks.begin(), checks.end(), [&](const CheckOutcome &outcome) {
        const auto spec =
            std::find_if(task.checks.begin(), task.checks.end(),
                         [&](const CheckSpec &check) { return check.id == outcome.id; });
        return !outcome.passed && spec != task.checks.end() && !showsOwnScene(*spec)
               && isOneOf(spec->kind, {"bounces", "bounce_heights", "settles", "stays_inside"});
    });
}

QString toldOf(const WallRebound &rebound, double e)
{
    return WallText::tr("Circle %1 came to the %2 with %3 m/s and left it with %4 m/s, which is "
                        "about %5 times as much, and `restitution` is %6.")
        .arg(QString::number(rebound.circle + 1), motion::wallName(rebound.wall),
             brief(rebound.came), brief(rebound.left), brief(rebound.share()), brief(e));
}

/// What is wrong with some of \p all.
/// \param isKept  with each the e came back that the scene had before the program, and other
///                scenes are right
LawDeviation otherShares(const std::vector<WallRebound> &all, const WallRebound &shown, double e,
                         bool isKept, const Preset &scene)
{
    const auto right =
        std::count_if(all.begin(), all.end(), [](const WallRebound &each) { return each.isRight; });
    const QString message =
        isKept ? WallText::tr("In your own scene the walls do not use the e that it has")
                     + QStringLiteral("\n\n") + toldOf(shown, e) + QLatin1Char(' ')
                     + WallText::tr("Other scenes come out right. A copy of e that is made before "
                                    "e is set keeps the old value.")
               : WallText::tr("In your own scene walls give another share of the speed back than e")
                     + QStringLiteral("\n\n") + toldOf(shown, e) + QLatin1Char(' ')
                     + WallText::tr("Of %1 fast hits in that run, %2 came out right. Look at what "
                                    "the new velocity is worked out from, and at what is asked "
                                    "before.")
                           .arg(all.size())
                           .arg(right);
    return {Aspect::Walls,
            message,
            {{scene, false}, shown.step, {shown.circle}, false},
            isKept ? Suspect::Copy : Suspect::Formula};
}

/// The runs of the own scene in which a failed check of walls looks.
std::vector<const Observation *> failedRuns(const Task &task, SubmissionRuns &runs,
                                            const std::vector<CheckOutcome> &checks)
{
    std::vector<const Observation *> all;
    for (const CheckSpec &check : task.checks) {
        const bool hasFailed =
            std::any_of(checks.begin(), checks.end(), [&](const CheckOutcome &outcome) {
                return outcome.id == check.id && !outcome.passed;
            });
        if (!hasFailed || check.kind != QLatin1String("bounces") || !showsOwnScene(check))
            continue;
        const CheckPlan plan = planOf(check, runs.submission().preset, task.locked, 1);
        if (!plan.variants.empty())
            all.push_back(&runs.of(plan.variants.front()));
    }
    return all;
}

/// A step in which a circle turned round at a wall: how far from it the centre was at its start,
/// and would have come without the wall, m.
struct WallTurn {
    qint64 step = 0;
    Wall wall = Wall::Bottom;
    double before = 0.0;
    double reached = 0.0;

    /// Whether a rim at \p radius from the centre comes to the wall in this step.
    [[nodiscard]] bool fits(double radius) const
    {
        return reached - motion::samePosition <= radius && radius <= before + motion::samePosition;
    }
};

/// Those of circle \p i, far from other circles and no farther from the wall than \p most, m.
std::vector<WallTurn> wallTurnsOf(const Observation &o, int i, double most)
{
    std::vector<WallTurn> all;
    const Preset &scene = o.variant.preset;
    for (qint64 k = 0; k < o.steps(); ++k) {
        const Circle &now = o.circle(i, k);
        const Vec2 free = now.velocity + o.timestep() * scene.gravity;
        for (const Wall wall : allWalls) {
            const Vec2 n = outwardNormal(wall);
            const double before = scene.halfWidth - dot(n, now.position);
            const double way = motion::travel(o, i, k, scene.gravity);
            if (dot(free, n) <= 0.0 || dot(o.circle(i, k + 1).velocity, n) >= 0.0
                || before > most + way || motion::isNearCircle(o, i, k, scene.gravity))
                continue;
            all.push_back({k + 1, wall, before, before - way});
        }
    }
    return all;
}

/// That circle \p i of \p o turns where the radius \p old brings it.
std::optional<LawDeviation> oldRadius(const Observation &o, int i, double old, const Preset &scene)
{
    const double radius = o.circle(i, 0).radius;
    const std::vector<WallTurn> turns = wallTurnsOf(o, i, std::max(old, radius));
    const auto wrong = std::find_if(turns.begin(), turns.end(),
                                    [&](const WallTurn &turn) { return !turn.fits(radius); });
    if (wrong == turns.end() || !std::all_of(turns.begin(), turns.end(), [&](const WallTurn &turn) {
            return turn.fits(old);
        }))
        return std::nullopt;
    const QString headline =
        (old < radius ? WallText::tr("In your own scene circle %1 turns too late at the walls")
                      : WallText::tr("In your own scene circle %1 turns too early at the walls"))
            .arg(i + 1);
    const QString body =
        WallText::tr("Its radius is %1 m, and at the %2 it turned in a step that would have "
                     "brought its centre from %3 to %4 m from the wall. In scenes that have their "
                     "radii before your program begins it turns in time. Look at when your program "
                     "reads the radii: what is read before `on_load` sets them is an old value.")
            .arg(brief(radius), motion::wallName(wrong->wall), brief(wrong->before),
                 brief(wrong->reached));
    return LawDeviation{Aspect::Walls,
                        headline + QStringLiteral("\n\n") + body,
                        {{scene, false}, wrong->step, {i}, false},
                        Suspect::Copy};
}

} // namespace

std::optional<LawDeviation> ownWallRadius(const Task &task, SubmissionRuns &runs,
                                          const std::vector<CheckOutcome> &checks)
{
    if (failsElsewhere(task, checks))
        return std::nullopt;
    const Preset &scene = runs.submission().preset;
    for (const Observation *run : failedRuns(task, runs, checks)) {
        for (int i = 0; !run->error && i < run->circleCount(); ++i) {
            const double old = scene.circles[static_cast<std::size_t>(i)].body.radius;
            auto found =
                old != run->circle(i, 0).radius ? oldRadius(*run, i, old, scene) : std::nullopt;
            if (found)
                return found;
        }
    }
    return std::nullopt;
}

std::optional<LawDeviation> ownWallShare(const Task &task, SubmissionRuns &runs,
                                         const std::vector<CheckOutcome> &checks)
{
    for (const Observation *shown : failedRuns(task, runs, checks)) {
        const Observation &run = *shown;
        const std::vector<WallRebound> all = wallReboundsOf(run);
        const auto wrong = std::find_if(all.begin(), all.end(),
                                        [](const WallRebound &each) { return !each.isRight; });
        if (wrong == all.end())
            continue;
        const double old = runs.submission().preset.restitution;
        const bool isKept = !failsElsewhere(task, checks)
                            && std::all_of(all.begin(), all.end(), [&](const WallRebound &each) {
                                   return std::abs(each.share() - old) <= sameShare + each.blur;
                               });
        return otherShares(all, *wrong, run.variant.preset.restitution, isKept,
                           runs.submission().preset);
    }
    return std::nullopt;
}

} // namespace cradle
