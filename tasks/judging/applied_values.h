// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_functions.h"
#include "tasks/judging/ran_lines.h"

#include <functional>

namespace cradle {

/// Where the value was worked out that a line only applies: the drag of v + a Δt, the number of a
/// limit that is compared, what a function returns.
class AppliedValues
{
public:
    /// All must live as long.
    /// \param calls  the lines that called the function in which the value is applied, the
    ///               innermost last
    /// \param deviation  what is wrong
    /// \param isSound  whether all that a line gives is known to be right
    AppliedValues(const ProgramLines &program, const RanLines &ran, const std::vector<int> &calls,
                  const LawDeviation &deviation, std::function<bool(int)> isSound);

    /// From one value to the next, as long as there is one alone that may be wrong; \p line if
    /// there is none, or several.
    [[nodiscard]] int originOf(int line, bool isQuestion) const;

private:
    [[nodiscard]] std::set<int> functionsAt(int line) const;
    [[nodiscard]] bool isApplied(const TokenRange &range, const ProgramAssignment *target) const;
    [[nodiscard]] std::size_t afterTarget(std::size_t i, const ProgramAssignment &target) const;
    [[nodiscard]] bool givesNumbers(int line) const;
    [[nodiscard]] bool isFlag(const ProgramAssignment &assignment) const;
    [[nodiscard]] bool isGivenByCall(const ProgramAssignment &assignment) const;
    [[nodiscard]] std::vector<TokenRange> appliedAt(int line, bool isQuestion) const;
    /// The lines in which the values that are taken there were worked out, but for those that are
    /// right; nothing if something is worked out there.
    [[nodiscard]] std::set<int> originsIn(const TokenRange &range, int line, int depth) const;
    [[nodiscard]] std::set<int> originsOf(const QString &name, bool isField, int line,
                                          int depth) const;
    [[nodiscard]] std::set<int> originsOfParameter(const ProgramFunction &function, qsizetype index,
                                                   int depth) const;
    [[nodiscard]] std::set<int> returnsOf(const QString &function) const;

    const ProgramLines &m_program;
    const RanLines &m_ran;
    std::vector<int> m_calls;
    Aspect m_aspect;
    Suspect m_suspect;
    std::function<bool(int)> m_isSound;
    std::vector<ProgramAssignment> m_assignments;
    std::vector<ProgramFunction> m_functions;
};

} // namespace cradle
