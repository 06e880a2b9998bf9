// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_statements.h"

namespace cradle {

/// A function of a program, as far as it has a name.
struct ProgramFunction {
    QString name{}; ///< the last of it: push of self.push
    QStringList parameters{};
    int first = 0; ///< its lines
    int last = 0;
};

[[nodiscard]] std::vector<ProgramFunction> functionsOf(const ProgramLines &program);
/// The innermost in which \p line stands; null if it stands in none.
[[nodiscard]] const ProgramFunction *functionAt(const std::vector<ProgramFunction> &functions,
                                                int line);
/// Whether \p line runs before the first step: at the top of the file or in on_load.
[[nodiscard]] bool isOfStart(const std::vector<ProgramFunction> &functions, int line);

/// The lines of functions that nothing outside of them names: they never run.
[[nodiscard]] std::set<int> deadLines(const ProgramLines &program);

/// Whether \p line only gives a field what its function is given, or adds that to it: v of
/// `function go(v) c.velocity = v end`.
[[nodiscard]] bool appliesGiven(const ProgramLines &program, int line);

/// Whether token \p i opens a block that `end` or `until` closes.
[[nodiscard]] bool opensBlock(const ProgramLines &program, std::size_t i);
/// The token that closes the block which token \p i opens; how many there are if none does.
[[nodiscard]] std::size_t endOfBlock(const ProgramLines &program, std::size_t i);

/// Tokens from \p from to \p to without \p to.
struct TokenRange {
    std::size_t from = 0;
    std::size_t to = 0;
};
/// What a call gives the function that token \p i names, one expression each; none of f{…}.
[[nodiscard]] std::vector<TokenRange> argumentsOf(const ProgramLines &program, std::size_t i);

/// The last assignment above \p line, in the same function, that gives the variable \p name a
/// value of its own, not only another's, and that \p counts; null if there is none.
template <typename Counts>
const ProgramAssignment *lastAbove(int line, const QString &name, const ProgramLines &program,
                                   const std::vector<ProgramAssignment> &assignments,
                                   const std::vector<ProgramFunction> &functions, Counts counts)
{
    const ProgramAssignment *found = nullptr;
    for (const ProgramAssignment &each : assignments) {
        if (each.name == name && !each.isField && each.line < line && counts(each)
            && functionAt(functions, each.line) == functionAt(functions, line)
            && !isHandedOn(program, each))
            found = &each;
    }
    return found;
}

} // namespace cradle
