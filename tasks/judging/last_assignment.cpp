// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/last_assignment.h"

#include "tasks/judging/line_guess.h"
#include "tasks/judging/program_statements.h"

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
        if (!other || !own || valueOf(*other) == valueOf(*own))
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
    if (const int line = numberLine(program, finding.line, moment, task, submission)) {
        finding.line = line;
        finding.calls.clear();
    }
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
    bool changed = false;
    for (const Assignment &assignment : probe.trace()) {
        const bool isIt =
            assignment.field == field
            && std::find(moment.circles.begin(), moment.circles.end(), assignment.circle)
                   != moment.circles.end();
        if (!isIt || (changed && !assignment.changed))
            continue;
        changed = changed || assignment.changed;
        finding.line = assignment.line;
        finding.calls = assignment.calls;
    }
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
