// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/begun_line.h"

#include "tasks/judging/program_functions.h"

#include <algorithm>

namespace cradle {

namespace {

/// The lines that run before the first step alone: also of functions that only such lines name.
std::set<int> startLines(const ProgramLines &program, const std::vector<ProgramFunction> &functions)
{
    std::set<int> lines;
    for (int line = 1; line <= program.count(); ++line) {
        if (isOfStart(functions, line))
            lines.insert(line);
    }
    const auto isOfStartAlone = [&](const ProgramFunction &function) {
        bool isNamed = false;
        for (const ProgramToken &token : program.tokens()) {
            if (token.text != function.name
                || (function.first <= token.line && token.line <= function.last))
                continue;
            if (!lines.contains(token.line))
                return false;
            isNamed = true;
        }
        return isNamed && !function.name.startsWith(QLatin1String("on_"));
    };
    for (std::size_t before = 0; before != lines.size();) {
        before = lines.size();
        for (const ProgramFunction &function : functions) {
            for (int line = function.first; isOfStartAlone(function) && line <= function.last;
                 ++line)
                lines.insert(line);
        }
    }
    return lines;
}

/// The names in a value, as valuesIn() has them, and those of the tables of which it takes rows.
QStringList namesIn(const ProgramLines &program, const ProgramAssignment &value)
{
    QStringList names;
    int depth = 0;
    for (std::size_t i = value.from; i < value.to; ++i) {
        depth += program.is(i, "[") ? 1 : program.is(i, "]") ? -1 : 0;
        const bool goesOn =
            program.is(i + 1, ".") || program.is(i + 1, ":") || program.is(i + 1, "(")
            || (program.is(i + 1, "[") && program.is(program.afterGroup(i + 1), "."));
        if (depth == 0 && program.tokens()[i].kind == ProgramToken::Kind::Name && !goesOn)
            names.append(program.tokens()[i].text);
    }
    return names;
}

/// What \p line writes down and what that is handed on from in the steps.
QStringList writtenDown(const ProgramLines &program, int line,
                        const std::vector<ProgramAssignment> &assignments,
                        const std::set<int> &start)
{
    QStringList names;
    for (const ProgramAssignment &each : assignments) {
        if (each.line == line)
            names += namesIn(program, each);
    }
    for (qsizetype before = -1; before != names.size();) {
        before = names.size();
        for (const ProgramAssignment &each : assignments) {
            if (start.contains(each.line) || !names.contains(each.name)
                || !isHandedOn(program, each))
                continue;
            for (const QString &name : namesIn(program, each)) {
                if (!names.contains(name))
                    names.append(name);
            }
        }
    }
    return names;
}

} // namespace

int begunLine(const ProgramLines &program, int line, bool isPosition)
{
    const std::vector<ProgramFunction> functions = functionsOf(program);
    std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    const std::vector<ProgramAssignment> ofRows = rowAssignmentsOf(program);
    assignments.insert(assignments.end(), ofRows.begin(), ofRows.end());
    std::stable_sort(assignments.begin(), assignments.end(),
                     [](const auto &a, const auto &b) { return a.from < b.from; });
    const std::set<int> start = startLines(program, functions);
    const QStringList names = writtenDown(program, line, assignments, start);
    const auto field = isPosition ? QLatin1String("position") : QLatin1String("velocity");
    const auto isOwnValue = [&](const ProgramAssignment &each) {
        const QStringList values = namesIn(program, each);
        return values.isEmpty() || (values.contains(field) && !isHandedOn(program, each));
    };
    // What the circle itself starts with is taken over, or not.
    const auto isOfCircle = [&](const ProgramAssignment &each) {
        return program.tokens()[each.target].text.startsWith(QLatin1String("circle"))
               || (each.name == field && each.target != each.last);
    };
    constexpr int together = 3; // x and y, each on its own
    int found = 0;
    for (const ProgramAssignment &each : assignments) {
        if (!start.contains(each.line) || !names.contains(each.name) || each.from == each.to
            || program.is(each.from, "nil") || isOfCircle(each) || !isOwnValue(each))
            continue;
        if (found != 0 && each.line > found + together)
            return 0;
        found = found == 0 ? each.line : found;
    }
    return found;
}

} // namespace cradle
