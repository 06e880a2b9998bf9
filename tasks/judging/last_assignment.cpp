// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/last_assignment.h"

#include "tasks/judging/hit_at_moment.h"
#include "tasks/judging/line_guess.h"
#include "tasks/judging/program_functions.h"
#include "tasks/judging/unset_line.h"

#include <algorithm>
#include <optional>

namespace cradle {

namespace {

/// Whether a line only sets what the function in which it stands is given.
bool setsWhatIsGiven(const ProgramLines &program, int line)
{
    const std::vector<ProgramFunction> functions = functionsOf(program);
    const ProgramFunction *function = functionAt(functions, line);
    bool isGiven = false;
    for (const ProgramAssignment &each : assignmentsOf(program)) {
        if (each.line != line)
            continue;
        const QStringList values = valuesIn(program, each.from, each.to);
        isGiven = function && !values.isEmpty() && isHandedOn(program, each)
                  && std::all_of(values.begin(), values.end(), [&](const QString &value) {
                         return function->parameters.contains(value);
                     });
        if (!isGiven)
            return false;
    }
    return isGiven;
}

/// The only line of whose numbers hangs what a circle or the scene starts with, where another,
/// \p assigning, gives it on; 0 if there is none.
int numberLine(const ProgramLines &program, int assigning, const Moment &moment, const Task &task,
               const Submission &submission)
{
    constexpr int mostTried = 100;
    const int circle = moment.circles.empty() ? -1 : moment.circles.front();
    const auto startOf = [&](const QString &source) {
        StudentScript script(source, {.quiet = true, .silent = true, .locked = task.locked});
        Preset scene = submission.preset;
        const bool starts = !script.begin(scene);
        return starts ? std::optional(scene) : std::nullopt;
    };
    const auto isNumber = [](const ProgramToken &token) {
        return token.kind == ProgramToken::Kind::Number;
    };
    const auto hasNumber = [&](int line) {
        const auto &tokens = program.tokensOf(line);
        return std::any_of(tokens.begin(), tokens.end(),
                           [&](std::size_t i) { return isNumber(program.tokens()[i]); });
    };
    if (assigning == 0 || hasNumber(assigning))
        return 0;
    const auto valueOf = [&](const Preset &scene) {
        const auto i = static_cast<std::size_t>(std::max(circle, 0));
        const Circle body = i < scene.circles.size() ? scene.circles[i].body : Circle{};
        switch (*moment.start) {
        case Assignment::Field::Position:
            return body.position;
        case Assignment::Field::Velocity:
            return body.velocity;
        case Assignment::Field::Radius:
            return Vec2{body.radius, 0.0};
        case Assignment::Field::Density:
            return Vec2{body.density, 0.0};
        case Assignment::Field::Gravity:
            return scene.gravity;
        case Assignment::Field::Restitution:
            return Vec2{scene.restitution, 0.0};
        }
        return Vec2{};
    };
    const auto own = startOf(program.source());
    const auto right = task.solution.isEmpty() ? std::nullopt : startOf(task.solution);
    /// Whether \p scene has another value in what is wrong with the own one.
    const auto isOther = [&](const Preset &scene) {
        const Vec2 is = valueOf(*own);
        const Vec2 made = valueOf(scene);
        const Vec2 asked = right ? valueOf(*right) : made;
        const bool isNone = asked == is;
        return (made.x != is.x && (isNone || is.x != asked.x))
               || (made.y != is.y && (isNone || is.y != asked.y));
    };
    int found = 0;
    int tried = 0;
    for (const ProgramToken &token : program.tokens()) {
        if (!isNumber(token) || token.line == found)
            continue;
        if (++tried > mostTried)
            return 0;
        QString changed = program.source();
        changed.replace(token.start, token.end() - token.start,
                        QStringLiteral("(%1 + 0.125)").arg(token.text));
        const auto other = startOf(changed);
        if (!other || !own || !isOther(*other))
            continue;
        if (found != 0)
            return 0;
        found = token.line;
    }
    return found;
}

/// The assignment that gave a circle or the scene a wrong value before the first step, or the
/// call that told it which.
void markStart(Finding &finding, const Moment &moment, const Task &task,
               const Submission &submission)
{
    StudentScript script(*submission.script,
                         {.quiet = true, .silent = true, .locked = task.locked});
    const int circle = moment.circles.empty() ? -1 : moment.circles.front();
    for (const Assignment &assignment : script.traceStart(submission.preset)) {
        if (assignment.field != moment.start || assignment.circle != circle)
            continue;
        finding.line = assignment.line;
        finding.calls = assignment.calls;
    }
    const ProgramLines program(*submission.script);
    while (!finding.calls.empty() && setsWhatIsGiven(program, finding.line)) {
        finding.line = finding.calls.back();
        finding.calls.pop_back();
    }
    if (finding.line == 0 && circle < 0)
        finding.line = hidingLine(*submission.script, *moment.start);
    if (finding.line == 0)
        finding.line = unsetLine(program, script.traceStart(submission.preset), *moment.start);
    if (const int line = numberLine(program, finding.line, moment, task, submission)) {
        finding.line = line;
        finding.calls.clear();
    }
}

/// Whether what a hit does to both circles is wrong, or where it puts them.
bool isOfHit(const Finding &finding, const Moment &moment)
{
    return moment.circles.size() == 2
           && (finding.aspect == Aspect::Response
               || (finding.aspect == Aspect::Contact && moment.isPosition));
}

} // namespace

void markLastAssignment(Finding &finding, const Moment &moment, const Task &task,
                        const Submission &submission)
{
    if (!submission.script)
        return;
    if (moment.start)
        return markStart(finding, moment, task, submission);
    if (moment.circles.empty())
        return;
    Probe probe(submission.program(), moment.stage);
    for (qint64 k = 1; k < moment.step; ++k) {
        if (!probe.step())
            return;
    }
    const auto field =
        moment.isPosition ? Assignment::Field::Position : Assignment::Field::Velocity;
    const bool isOfBoth = isOfHit(finding, moment);
    const std::vector<int> wrong =
        isOfBoth ? HitAtMoment(*submission.script, task.solution, moment).wrongCircles()
                 : moment.circles;
    std::vector<Assignment> last; // of each circle, as they come
    for (const Assignment &assignment : probe.trace()) {
        if (assignment.field != field
            || std::find(wrong.begin(), wrong.end(), assignment.circle) == wrong.end())
            continue;
        const auto before = std::find_if(last.begin(), last.end(), [&](const Assignment &one) {
            return one.circle == assignment.circle;
        });
        if (before != last.end() && before->changed && !assignment.changed)
            continue;
        if (before != last.end())
            last.erase(before);
        last.push_back(assignment);
    }
    const bool areChanged =
        std::any_of(last.begin(), last.end(), [](const Assignment &one) { return one.changed; });
    std::erase_if(last, [&](const Assignment &one) { return areChanged && !one.changed; });
    if (last.empty())
        return;
    // Where a hit makes both wrong, it does so at the first of the two.
    const Assignment &told = isOfBoth ? last.front() : last.back();
    finding.line = told.line;
    finding.calls = told.calls;
}

int lastAssignmentLine(const Submission &submission, const Stage &scene, qint64 step, int circle)
{
    if (!submission.script || step < 1)
        return 0;
    Probe probe(submission.program(), scene);
    while (probe.world().step < step - 1) {
        if (!probe.step())
            return 0;
    }
    int line = 0;
    bool changed = false;
    for (const Assignment &assignment : probe.trace()) {
        const bool moves = assignment.field == Assignment::Field::Position
                           || assignment.field == Assignment::Field::Velocity;
        if (!moves || (circle >= 0 && assignment.circle != circle))
            continue;
        if (assignment.changed || !changed)
            line = assignment.line;
        changed = changed || assignment.changed;
    }
    return line;
}

} // namespace cradle
