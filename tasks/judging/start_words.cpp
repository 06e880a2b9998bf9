// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/start_words.h"

#include "tasks/checks/check_kinds.h"
#include "tasks/checks/check_library.h"
#include "tasks/checks/motion.h"
#include "tasks/judging/check_plan.h"
#include "tasks/judging/line_guess.h"
#include "tasks/runs/observation.h"
#include "tasks/runs/scene_spec.h"
#include "tasks/script/student_script.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

struct StartText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

bool failed(const CheckSpec &check, const std::vector<CheckOutcome> &checks)
{
    return std::any_of(checks.begin(), checks.end(), [&](const CheckOutcome &outcome) {
        return outcome.id == check.id && !outcome.passed;
    });
}

/// The first value that is not as \p check, of the kind start, asks for.
Moment momentOf(const CheckSpec &check, const Preset &start)
{
    using enum Assignment::Field;
    const double tolerance = motion::toleranceOf(check);
    const auto isOff = [&](const char *key, Vec2 value) {
        const QJsonValue wanted = check.parameters.value(QLatin1String(key));
        const QJsonArray list = wanted.toArray();
        const Vec2 asked{(list.isEmpty() ? wanted : list[0]).toDouble(), list.at(1).toDouble()};
        return !wanted.isUndefined() && length(value - asked) > tolerance * (1.0 + length(asked));
    };
    for (const int i : check.circles) {
        if (i >= static_cast<int>(start.circles.size()))
            break;
        const Circle &c = start.circles[static_cast<std::size_t>(i)].body;
        const std::pair<bool, Assignment::Field> values[]{
            {isOff("position", c.position), Position},
            {isOff("velocity", c.velocity), Velocity},
            {isOff("radius", {c.radius, 0.0}), Radius},
            {isOff("density", {c.density, 0.0}), Density}};
        for (const auto &[off, field] : values) {
            if (off)
                return {.circles = {i}, .start = field};
        }
    }
    return {};
}

/// What a program calls it.
QString nameOf(Assignment::Field field, int circle)
{
    const auto of = [&](const char *name) {
        return QStringLiteral("`circle%1.%2`").arg(circle + 1).arg(QLatin1String(name));
    };
    switch (field) {
    case Assignment::Field::Position:
        return of("position");
    case Assignment::Field::Velocity:
        return of("velocity");
    case Assignment::Field::Radius:
        return of("radius");
    case Assignment::Field::Density:
        return of("density");
    case Assignment::Field::Gravity:
        return QStringLiteral("`gravity`");
    case Assignment::Field::Restitution:
        break;
    }
    return QStringLiteral("`restitution`");
}

/// Where a value of the scene, or of \p circle unless that is -1, comes from.
QString whoSet(const Task &task, const Submission &submission, Assignment::Field field,
               int circle = -1)
{
    if (!submission.script)
        return StartText::tr("It is the value that the scene has.");
    StudentScript script(*submission.script,
                         {.quiet = true, .silent = true, .locked = task.locked});
    const std::vector<Assignment> made = script.traceStart(submission.preset);
    const QString name = nameOf(field, circle);
    if (std::any_of(made.begin(), made.end(), [&](const Assignment &each) {
            return each.field == field && each.circle == circle;
        }))
        return StartText::tr("Look at what your program assigns to %1 before the first step.")
            .arg(name);
    if (circle < 0 && hidingLine(*submission.script, field) > 0)
        return StartText::tr("Behind `local`, %1 is the name of another variable: the scene keeps "
                             "its own value.")
            .arg(name);
    return StartText::tr("Nothing in your program assigns to %1 before the first step: it is the "
                         "value that the scene has.")
        .arg(name);
}

/// A number of the scene that is not as the checks have it.
std::optional<LawDeviation> wrongGravity(const Task &task, const Submission &submission,
                                         const Preset &start,
                                         const std::vector<CheckOutcome> &checks)
{
    for (const CheckSpec &check : task.checks) {
        const auto asked = showsOwnScene(check) ? motion::askedGravity(check) : std::nullopt;
        if (!asked || *asked == start.gravity || !failed(check, checks))
            continue;
        return LawDeviation{
            Aspect::Start,
            StartText::tr("Gravity is %1 m/s², not %2\n\nSo it is when the run begins.")
                    .arg(brief(start.gravity), brief(*asked))
                + QLatin1Char(' ') + whoSet(task, submission, Assignment::Field::Gravity),
            {.start = Assignment::Field::Gravity}};
    }
    return std::nullopt;
}

} // namespace

std::vector<LawDeviation> startDeviations(const Task &task, const Submission &submission,
                                          const std::vector<CheckOutcome> &checks)
{
    std::vector<LawDeviation> deviations;
    Probe probe(submission.program(), {submission.preset, false});
    const Preset &start = probe.start();
    // What was not judged because the program stopped says nothing of the start.
    const bool isSeen = probe.runs() && probe.step() && probe.step() && probe.step();
    for (const CheckSpec &check : task.checks) {
        if (check.kind != QLatin1String("start") || !isSeen)
            continue;
        for (const CheckOutcome &outcome : checks) {
            if (outcome.id != check.id || outcome.passed || outcome.variant.isEmpty())
                continue;
            const Moment moment = momentOf(check, start);
            deviations.push_back({Aspect::Start,
                                  moment.start ? outcome.message + QStringLiteral("\n\n")
                                                     + whoSet(task, submission, *moment.start,
                                                              moment.circles.front())
                                               : outcome.message,
                                  moment});
        }
    }
    if (isSeen) {
        if (auto gravity = wrongGravity(task, submission, start, checks))
            deviations.push_back(*gravity);
    }
    return deviations;
}

namespace {

/// The program with another e in place of what it sets; empty if it sets none.
QString withRestitution(QString program, double e)
{
    static const QRegularExpression assignment(QStringLiteral("^(\\s*restitution\\s*=[^=]).*$"),
                                               QRegularExpression::MultilineOption);
    if (!assignment.match(program).hasMatch())
        return {};
    return program.replace(assignment, QStringLiteral("  restitution = %1").arg(e, 0, 'g', 17));
}

/// The check in the own scene that the solution fails with that \p e: then it is wrong, whatever
/// else is; null if it passes all.
const CheckSpec *failedWith(const Task &task, double e)
{
    const Probe right(&task.solution, {task.preset, false});
    if (task.solution.isEmpty() || !right.runs() || right.start().restitution == e)
        return nullptr;
    const QString changed = withRestitution(task.solution, e);
    const QString &program = changed.isEmpty() ? task.solution : changed;
    Preset scene = task.preset;
    if (changed.isEmpty())
        scene.restitution = e;
    for (const CheckSpec &check : task.checks) {
        if (!showsOwnScene(check))
            continue;
        const CheckPlan plan = planOf(check, scene, task.locked, 1);
        if (std::any_of(plan.variants.begin(), plan.variants.end(), [&](const Variant &variant) {
                return judge(check, observe(variant, &program)).has_value();
            }))
            return &check;
    }
    return nullptr;
}

/// Why \p e is not the one that is asked for; empty if it may be.
QString whyOtherRestitution(const Task &task, double e, const std::vector<CheckOutcome> &checks)
{
    for (const CheckSpec &check : task.checks) {
        const QJsonValue asked = valueOf(check, QStringLiteral("restitution"));
        if (showsOwnScene(check) && asked.isDouble() && asked.toDouble() != e
            && failed(check, checks))
            return StartText::tr("So it is when the run begins; in this step your own scene should "
                                 "have e = %1.")
                .arg(brief(asked.toDouble()));
    }
    if (const CheckSpec *check = failedWith(task, e))
        return StartText::tr("So it is when the run begins. With that e a right program fails the "
                             "check “%1”, too.")
            .arg(check->title);
    return {};
}

} // namespace

std::optional<LawDeviation> otherRestitution(const Task &task, const Submission &submission,
                                             const std::vector<CheckOutcome> &checks)
{
    const Probe own(submission.program(), {submission.preset, false});
    if (!submission.script || !own.runs())
        return std::nullopt;
    const double e = own.start().restitution;
    const QString why = whyOtherRestitution(task, e, checks);
    if (why.isEmpty())
        return std::nullopt;
    return LawDeviation{Aspect::Start,
                        StartText::tr("e = %1 is not the value that is asked for").arg(brief(e))
                            + QStringLiteral("\n\n") + why + QLatin1Char(' ')
                            + whoSet(task, submission, Assignment::Field::Restitution),
                        {.start = Assignment::Field::Restitution}};
}

} // namespace cradle
