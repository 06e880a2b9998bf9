// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/own_meeting_words.h"

#include "tasks/checks/motion.h"
#include "tasks/judging/check_plan.h"
#include "tasks/judging/probe.h"
#include "tasks/runs/scene_spec.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>

namespace cradle {

namespace {

struct MeetingText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// Whether \p check, of the own scene, must see a hit of circles 1 and 2.
bool waitsForHit(const CheckSpec &check)
{
    static const QStringList kinds{QStringLiteral("collides"),  QStringLiteral("rebounds"),
                                   QStringLiteral("touches"),   QStringLiteral("after_contact"),
                                   QStringLiteral("conserves"), QStringLiteral("loses_energy")};
    return showsOwnScene(check) && kinds.contains(check.kind) && check.circles == std::vector{0, 1}
           && check.parameters.value(QLatin1String("contacts")).toInt(1) > 0;
}

/// How near their rims come, and when.
struct Nearest {
    double gap = std::numeric_limits<double>::infinity(); ///< m
    qint64 step = 0;
};

/// Whether circle \p i goes on by its velocity in the step after \p k, by any integrator.
bool goesOn(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const double h = o.timestep();
    const Circle &before = o.circle(i, k);
    const Vec2 way = o.circle(i, k + 1).position - before.position;
    return length(way - h * before.velocity) <= motion::samePosition + h * h * length(gravity);
}

/// \return nothing if they touch, or are hit or held by something else than walls
std::optional<Nearest> nearestOf(const Observation &o, Vec2 gravity)
{
    Nearest nearest;
    for (qint64 k = 0; k <= o.steps(); ++k) {
        const Circle &a = o.circle(0, k);
        const Circle &b = o.circle(1, k);
        const double gap = length(b.position - a.position) - a.radius - b.radius;
        if (gap < nearest.gap)
            nearest = {gap, k};
        for (int i = 0; i < 2 && k < o.steps(); ++i) {
            const bool isFree = !motion::isKicked(o, i, k, gravity) && goesOn(o, i, k, gravity);
            if (motion::isNearCircle(o, i, k, gravity)
                || (!isFree && !motion::isNearWall(o, i, k, gravity)))
                return std::nullopt;
        }
    }
    return nearest;
}

/// The value with which a circle starts otherwise than that of the solution, as far as one does.
Moment otherStart(const Task &task, const Preset &own)
{
    if (task.solution.isEmpty())
        return {};
    const Probe right(&task.solution, {task.preset, false});
    for (int i = 0; i < 2; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Circle &is = own.circles[at].body;
        const Circle &asked = right.start().circles[at].body;
        if (!motion::isSame(is.position, asked.position, motion::samePosition))
            return {.circles = {i}, .start = Assignment::Field::Position};
        if (!motion::isSame(is.velocity, asked.velocity, motion::sameVelocity))
            return {.circles = {i}, .start = Assignment::Field::Velocity};
    }
    return {};
}

} // namespace

std::optional<LawDeviation> missedMeeting(const Task &task, SubmissionRuns &runs,
                                          const std::vector<CheckOutcome> &checks)
{
    for (const CheckSpec &check : task.checks) {
        const bool hasFailed =
            std::any_of(checks.begin(), checks.end(), [&](const CheckOutcome &outcome) {
                return outcome.id == check.id && !outcome.passed;
            });
        const CheckPlan plan = hasFailed && waitsForHit(check)
                                   ? planOf(check, runs.submission().preset, task.locked, 1)
                                   : CheckPlan{};
        if (plan.variants.empty())
            continue;
        const Observation &run = runs.of(plan.variants.front());
        const auto nearest =
            run.error ? std::nullopt : nearestOf(run, motion::gravityOf(check, run));
        if (!nearest)
            continue;
        const QString seconds = brief(run.states.time(run.steps()));
        const QString seen =
            MeetingText::tr("In its first %1 s their rims come no nearer than %2 m, at %3 s. Look "
                            "at the positions and velocities that they start with.")
                .arg(seconds, brief(nearest->gap), brief(run.states.time(nearest->step)));
        return LawDeviation{
            Aspect::Start,
            MeetingText::tr("The circles of your scene do not meet in its first %1 s").arg(seconds)
                + QStringLiteral("\n\n") + seen,
            otherStart(task, run.variant.preset)};
    }
    return std::nullopt;
}

} // namespace cradle
