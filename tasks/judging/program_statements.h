// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_lines.h"

namespace cradle {

/// A value that a statement gives to a name: each of `a.v, b.v = x, y` is one.
struct ProgramAssignment {
    int line = 0;
    QString name{};         ///< the last of the target: v of self.v
    bool isField = false;   ///< of a table or a circle, else a variable
    std::size_t target = 0; ///< its first token
    std::size_t from = 0;   ///< the tokens of the value, without \p to; none where a call gives
    std::size_t to = 0;     ///< several values
    std::size_t last = 0;   ///< the last token of the target
};

/// The token after the expression that begins at \p i; \p i if it is none of operands and signs.
[[nodiscard]] std::size_t afterExpression(const ProgramLines &program, std::size_t i);

/// All of \p program, in order; also what a table begins with.
[[nodiscard]] std::vector<ProgramAssignment> assignmentsOf(const ProgramLines &program);

/// The same of what is put into the rows of tables, named after the table: x of x[i].
[[nodiscard]] std::vector<ProgramAssignment> rowAssignmentsOf(const ProgramLines &program);

/// The names, of variables or in tables, that a radius or a density is copied to.
[[nodiscard]] QStringList copiesOf(const ProgramLines &program,
                                   const std::vector<ProgramAssignment> &assignments,
                                   const QStringList &fields);

/// The names in tokens \p from to \p to without \p to that stand for numbers or vectors: the last
/// of each, v of self.v; not those of functions.
[[nodiscard]] QStringList valuesIn(const ProgramLines &program, std::size_t from, std::size_t to);

/// Whether a value is one number, with a sign or without.
[[nodiscard]] bool isNumber(const ProgramLines &program, const ProgramAssignment &assignment);

/// Whether a value is only handed on: v, self.v or vec(x, self.y).
[[nodiscard]] bool isHandedOn(const ProgramLines &program, const ProgramAssignment &assignment);

} // namespace cradle
