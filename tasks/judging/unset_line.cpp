// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/unset_line.h"

#include "tasks/judging/program_functions.h"

#include <QRegularExpression>

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

QLatin1String nameOf(Assignment::Field field)
{
    switch (field) {
    case Assignment::Field::Position:
        return QLatin1String("position");
    case Assignment::Field::Velocity:
        return QLatin1String("velocity");
    case Assignment::Field::Radius:
        return QLatin1String("radius");
    case Assignment::Field::Density:
        return QLatin1String("density");
    case Assignment::Field::Gravity:
        return QLatin1String("gravity");
    case Assignment::Field::Restitution:
        break;
    }
    return QLatin1String("restitution");
}

/// Whether a line names a circle by a variable: circles[i].
bool isOfEach(const ProgramLines &program, int line)
{
    const auto &tokens = program.tokensOf(line);
    return std::any_of(tokens.begin(), tokens.end(), [&](std::size_t i) {
        return program.is(i, "circles") && program.is(i + 1, "[")
               && program.tokens()[i + 2].kind == ProgramToken::Kind::Name;
    });
}

/// Whether a line names a circle by its number: circle1 or circles[1].
bool isOfOne(const ProgramLines &program, int line)
{
    static const QRegularExpression named(QStringLiteral("\\bcircles?\\[?\\d"));
    return program.row(line).contains(named);
}

/// Whether a line of \p function may be meant to set \p name: it does not run, or sets what a
/// variable names.
bool mayBeMeant(const ProgramLines &program, const ProgramFunction &function, QLatin1String name)
{
    const auto isWithin = [&](const ProgramAssignment &each) {
        return each.line >= function.first && each.line <= function.last;
    };
    const std::vector<ProgramAssignment> named = assignmentsOf(program);
    const std::vector<ProgramAssignment> rows = rowAssignmentsOf(program);
    return std::any_of(named.begin(), named.end(),
                       [&](const auto &each) { return isWithin(each) && each.name == name; })
           || std::any_of(rows.begin(), rows.end(), [&](const auto &each) {
                  return isWithin(each) && program.is(each.target, "circles");
              });
}

} // namespace

int unsetLine(const ProgramLines &program, const std::vector<Assignment> &made,
              Assignment::Field field)
{
    std::vector<std::pair<int, int>> set; // lines, and the circles for which they set it
    for (const Assignment &each : made) {
        const std::pair<int, int> one(each.line, each.circle);
        if (each.field == field && std::find(set.begin(), set.end(), one) != set.end())
            return each.line;
        if (each.field == field)
            set.push_back(one);
    }
    const std::vector<ProgramFunction> functions = functionsOf(program);
    const auto start =
        std::find_if(functions.begin(), functions.end(), [](const ProgramFunction &each) {
            return each.name == QLatin1String("on_load");
        });
    if (start == functions.end())
        return 0;
    if (set.empty())
        return mayBeMeant(program, *start, nameOf(field)) ? 0 : start->first;
    const int line = set.front().first;
    if (line < start->first || line > start->last)
        return 0;
    if (isOfOne(program, line))
        return start->first;
    if (!isOfEach(program, line))
        return 0;
    for (int at = line; at > start->first; --at) {
        if (program.row(at).trimmed().startsWith(QLatin1String("for ")))
            return at;
    }
    return 0;
}

} // namespace cradle
