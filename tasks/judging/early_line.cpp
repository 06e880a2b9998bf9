// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/early_line.h"

#include "tasks/judging/program_functions.h"

#include <QRegularExpression>

#include <algorithm>
#include <numeric>

namespace cradle {

namespace {

/// Whether \p field is set at the start of the program behind \p line. The top of the file runs
/// before on_load, wherever that stands.
bool isSetBehind(int line, const QString &field, const std::vector<ProgramAssignment> &assignments,
                 const std::vector<ProgramFunction> &functions)
{
    const bool isTop = !functionAt(functions, line);
    return std::any_of(assignments.begin(), assignments.end(), [&](const ProgramAssignment &each) {
        const bool isOtherTop = !functionAt(functions, each.line);
        return each.name == field && isOfStart(functions, each.line)
               && (isTop == isOtherTop ? line < each.line : isTop);
    });
}

} // namespace

int earlyLine(const ProgramLines &program, const QStringList &fields)
{
    const std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    const std::vector<ProgramFunction> functions = functionsOf(program);
    const auto takes = [&](int line, const QString &field) {
        return program.row(line).contains(
            QRegularExpression(QStringLiteral("\\b%1\\b").arg(field)));
    };
    /// Also of what a function that it calls takes.
    const auto isOf = [&](const ProgramAssignment &value, const QString &field) {
        std::vector<std::size_t> tokens(value.to - value.from);
        std::iota(tokens.begin(), tokens.end(), value.from);
        // A table is no expression: its first line is looked at.
        if (tokens.empty())
            tokens = program.tokensOf(value.line);
        for (const std::size_t i : tokens) {
            if (program.tokens()[i].text == field)
                return true;
            const auto called =
                std::find_if(functions.begin(), functions.end(), [&](const ProgramFunction &each) {
                    return each.name == program.tokens()[i].text;
                });
            for (int line = called == functions.end() ? 1 : called->first;
                 called != functions.end() && line <= called->last; ++line) {
                // What a function that it only makes takes is read when that runs.
                if (takes(line, field) && functionAt(functions, line) == &*called)
                    return true;
            }
        }
        return false;
    };
    const auto isEarly = [&](const ProgramAssignment &value) {
        return isOfStart(functions, value.line) && !fields.contains(value.name)
               && std::any_of(fields.begin(), fields.end(), [&](const QString &field) {
                      return isOf(value, field)
                             && isSetBehind(value.line, field, assignments, functions);
                  });
    };
    for (const auto &values : {assignments, rowAssignmentsOf(program)}) {
        const auto early = std::find_if(values.begin(), values.end(), isEarly);
        if (early != values.end())
            return early->line;
    }
    return 0;
}

} // namespace cradle
