// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/suspect_lines.h"

#include "tasks/judging/asked_values.h"
#include "tasks/judging/program_rows.h"

#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

/// Whether the line gives numbers as the start of what a stage sets itself: gravity = vec(0, -9.8).
bool isPinnedStart(const QString &row)
{
    static const QRegularExpression start(QStringLiteral(
        "^\\s*((gravity|restitution|[\\w\\[\\]]+\\.(radius|density|position|velocity))\\s*,?\\s*)+"
        "=[-\\d.,\\s()/*]*(vec\\s*\\([-\\d.,\\s()/*]*)*(--.*)?$"));
    return row.contains(start);
}

/// Whether the line gives a number to a variable.
bool givesNumber(const ProgramLines &program, const std::vector<ProgramAssignment> &assignments,
                 int line)
{
    return std::any_of(assignments.begin(), assignments.end(), [&](const ProgramAssignment &each) {
        return each.line == line && !each.isField && isNumber(program, each);
    });
}

/// Whether a number stands there in a list: {1, 0}, vec(0, -1).
bool isOfList(const ProgramLines &program, int line)
{
    const auto &row = program.tokensOf(line);
    return std::any_of(row.begin(), row.end(), [&](std::size_t i) {
        const std::size_t before = i > 0 && program.is(i - 1, "-") ? i - 1 : i;
        return program.tokens()[i].kind == ProgramToken::Kind::Number && before > 0
               && (program.is(before - 1, "{") || program.is(before - 1, "(")
                   || program.is(before - 1, ","));
    });
}

/// Whether something is given there that is worked out of a place or a velocity.
bool takesOver(const ProgramLines &program, int line)
{
    const auto &row = program.tokensOf(line);
    const auto stands = [&](const auto &is) { return std::any_of(row.begin(), row.end(), is); };
    return stands([&](std::size_t i) { return program.is(i, "="); }) && stands([&](std::size_t i) {
               return i > 0 && program.is(i - 1, ".")
                      && (program.is(i, "x") || program.is(i, "y") || program.is(i, "position")
                          || program.is(i, "velocity"));
           });
}

} // namespace

std::vector<int> suspectLines(const FaultQuery &query)
{
    const QStringList rows = query.program.split(QLatin1Char('\n'));
    // What never runs is not to blame.
    const ProgramLines program(query.program);
    const std::set<int> dead = deadLines(program);
    const std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    std::vector<int> lines;
    const auto add = [&](int line) {
        if (std::find(lines.begin(), lines.end(), line) == lines.end())
            lines.push_back(line);
    };
    static const QRegularExpression comparison(QStringLiteral("[<>]"));
    for (const int line : query.ran.now) {
        if (isOfQuestion(query.suspect) && rows[line - 1].contains(comparison))
            add(line);
    }
    if (isOfQuestion(query.suspect)) {
        const AskedValues asked(program);
        for (const int line : std::vector<int>(lines)) {
            for (const AskedValue &value : asked.of(line))
                add(value.line);
        }
    }
    if (query.suspect == Suspect::Answer && query.ran.now.contains(query.last))
        add(query.last);
    static const QRegularExpression masses(QStringLiteral("radius|density|mass"));
    for (int line = 1; line <= static_cast<int>(rows.size()); ++line) {
        if (query.suspect == Suspect::Masses && rows[line - 1].contains(masses)
            && !rows[line - 1].contains(comparison) && !dead.contains(line))
            add(line);
    }
    for (const int line : query.ran.special())
        add(line);
    for (const int line : query.ran.now)
        add(line);
    static const QRegularExpression quantities(
        QStringLiteral("radius|density|mass|restitution|gravity|square"));
    for (int line = 1; line <= static_cast<int>(rows.size()); ++line) {
        if (rows[line - 1].contains(quantities) && !dead.contains(line)
            && !(query.moment.stage.pinned && isPinnedStart(rows[line - 1])))
            add(line);
    }
    for (int line = 1; query.aspect != Aspect::Motion && line <= static_cast<int>(rows.size());
         ++line) {
        if (givesNumber(program, assignments, line) && !dead.contains(line)
            && !(query.moment.stage.pinned && isPinnedStart(rows[line - 1])))
            add(line);
    }
    // What was chosen or made at the start: a method, a circle.
    const std::vector<ProgramFunction> functions = functionsOf(program);
    QStringList chosen{QStringLiteral("true|false|circle[12]")};
    for (const ProgramFunction &each : functions) {
        if (!each.name.isEmpty())
            chosen.append(each.name + QStringLiteral("\\b(?!\\s*\\()"));
    }
    const QRegularExpression choice(
        QStringLiteral("\\b(%1)|[\"']").arg(chosen.join(QLatin1Char('|'))));
    for (int line = 1; line <= static_cast<int>(rows.size()); ++line) {
        if (isOfStart(functions, line) && query.aspect == Aspect::Motion
            && rows[line - 1].contains(choice) && !dead.contains(line)
            && !(query.moment.stage.pinned && isPinnedStart(rows[line - 1])))
            add(line);
    }
    // What is told there by numbers, or taken from the circles.
    for (int line = 1; line <= static_cast<int>(rows.size()); ++line) {
        if (isOfStart(functions, line) && (isOfList(program, line) || takesOver(program, line))
            && !dead.contains(line)
            && !(query.moment.stage.pinned && isPinnedStart(rows[line - 1])))
            add(line);
    }
    // A hit of two is not a matter of the walls.
    if (query.aspect == Aspect::Contact || query.aspect == Aspect::Response)
        std::stable_partition(lines.begin(), lines.end(),
                              [&](int line) { return !asksForWall(rows[line - 1]); });
    // A number with a name is at fault itself, not where the name is taken.
    if (query.aspect != Aspect::Motion)
        std::stable_partition(lines.begin(), lines.end(),
                              [&](int line) { return givesNumber(program, assignments, line); });
    // Who only hands a value on seldom gets it wrong.
    std::set<int> copies;
    std::set<int> works;
    for (const ProgramAssignment &each : assignments)
        (isHandedOn(program, each) ? copies : works).insert(each.line);
    std::stable_partition(lines.begin(), lines.end(), [&](int line) {
        return !copies.contains(line) || works.contains(line)
               || (line == query.last && query.suspect == Suspect::Answer);
    });
    return lines;
}

} // namespace cradle
