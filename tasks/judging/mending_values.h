// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/known_values.h"
#include "tasks/judging/ran_lines.h"
#include "tasks/judging/value_solver.h"

#include <functional>
#include <set>
#include <vector>

namespace cradle {

/// Where another value would put right what a program does at a moment, whatever it would have to
/// be: what a line works out that no other value of it can mend is not at fault, nor is one that is
/// known to be right.
class MendingValues
{
public:
    /// All must live as long.
    /// \param reference  a program that is right at \p moment
    MendingValues(const ProgramLines &program, const QString &reference, const Moment &moment,
                  const RanLines &ran, Aspect aspect, std::function<bool(int)> isSound);

    /// The first line to run of those that only the moment needs, and of the functions that they
    /// call, in which another value mends all that is wrong.
    /// \return 0 if there is none
    [[nodiscard]] int line() const;
    /// Whether all that a line gives is known to be right.
    [[nodiscard]] bool knows(int line) const;

private:
    [[nodiscard]] std::set<int> suspects() const;
    [[nodiscard]] std::vector<int> placeOf(int line, int depth) const;
    [[nodiscard]] std::vector<TokenRange> valuesAt(int line) const;
    [[nodiscard]] bool isHandingOn(int line) const;

    const ProgramLines &m_program;
    const RanLines &m_ran;
    Aspect m_aspect;
    std::vector<ProgramAssignment> m_assignments;
    std::vector<ProgramFunction> m_functions;
    ValueSolver m_solver;
    KnownValues m_known;
};

} // namespace cradle
